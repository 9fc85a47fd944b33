// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Makes the npm package of the library: node build_library.mjs FOLDER_OF_MODELER OUTPUT_FOLDER
import { execFileSync } from "node:child_process";
import { cp, mkdir, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { licencesOfLibrary, requireNoGpl } from "./licences.mjs";

const [, , modeler, output] = process.argv;
const here = path.dirname(fileURLToPath(import.meta.url));

await requireNoGpl(modeler);
await rm(output, { recursive: true, force: true });
await mkdir(path.join(output, "library"), { recursive: true });
execFileSync(path.join(here, "node_modules/.bin/tsc"), ["-p", path.join(here, "library"), "--outDir", path.resolve(output)],
  { stdio: "inherit" });
for (const name of ["modeler.js", "modeler.wasm"]) await cp(path.join(modeler, name), path.join(output, "library", name));
for (const name of ["package.json", "README.md", "example.mjs"]) await cp(path.join(here, "library", name), path.join(output, name));
await writeFile(path.join(output, "LICENSE"), await licencesOfLibrary());
