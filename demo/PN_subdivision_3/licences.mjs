// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The licences of what is in the page and in the library for JavaScript, in full; and that none of it is under the GPL.
import { execFileSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const ofModule = [
  ["PN_subdivision_3 and the parts of CGAL that are in it: the GNU Lesser General Public License, version 3 or later", "../../LICENSE.LGPL"],
  ["What that license adds to: the GNU General Public License, version 3", "../../LICENSE.GPL"],
  ["Eigen: the Mozilla Public License, version 2.0", "/usr/share/common-licenses/MPL-2.0"],
  ["What parts of CGAL are under, and the Boost Software License", "/usr/share/doc/libcgal-dev/copyright"],
  ["musl, the C library of Emscripten", "/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT"],
  ["libc++, libc++abi and compiler-rt of LLVM: the Apache License, version 2.0, with the LLVM exceptions", "/usr/share/common-licenses/Apache-2.0"],
];
const ofPage = [...ofModule.slice(0, 2), ["three.js", "node_modules/three/LICENSE"], ...ofModule.slice(2)];

async function read(texts) {
  return Promise.all(
    texts.map(async ([title, file]) => {
      const text = await readFile(path.resolve(here, file), "utf8").catch(() => {
        throw new Error(`${file} is missing: there must be the licence of ${title}`);
      });
      return { title, text };
    }),
  );
}

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/** Those of the page, as HTML. */
export async function licences() {
  const parts = (await read(ofPage)).map(({ title, text }) =>
    `<details><summary>${escaped(title)}</summary><pre tabindex="0">${escaped(text)}</pre></details>`);
  return parts.join("\n");
}

/** Those of the library, as text. */
export async function licencesOfLibrary() {
  return (await read(ofModule)).map(({ title, text }) => `${title}\n${"=".repeat(title.length)}\n\n${text.trim()}\n`).join("\n\n");
}

/** Throws if anything that the module is compiled from is under the GPL and not the LGPL, as parts of CGAL are. */
export async function requireNoGpl(modelerFolder) {
  const listed = execFileSync("ninja", ["-C", modelerFolder, "-t", "deps"], { encoding: "utf8", maxBuffer: 2 ** 28 });
  const files = new Set(listed.split("\n").filter((line) => /^\s/.test(line)).map((line) => path.resolve(modelerFolder, line.trim())));
  if (![...files].some((file) => /\/CGAL\/[^/]+\.h$/.test(file))) throw new Error(`${modelerFolder}: ninja knows no headers of CGAL`);
  const named = await Promise.all([...files].map(async (file) => {
    const [, licence = ""] = /SPDX-License-Identifier:(.*)/.exec(await readFile(file, "utf8")) ?? [];
    return /(^|[^L])GPL/.test(licence) ? file : undefined;
  }));
  const wrong = named.filter((file) => file !== undefined);
  if (wrong.length > 0) throw new Error(`The page and the library are under the LGPL, but include what is under the GPL:\n${wrong.sort().join("\n")}`);
}
