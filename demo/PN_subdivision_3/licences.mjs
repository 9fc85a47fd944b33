// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The licences of what is in the page, in full.
import { readFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const texts = [
  ["This page, PN_subdivision_3 and CGAL: the GNU General Public License, version 3 or later", "../../LICENSE.GPL"],
  ["The headers of PN_subdivision_3 and of parts of CGAL: the GNU Lesser General Public License, version 3 or later", "../../LICENSE.LGPL"],
  ["three.js", "node_modules/three/LICENSE"],
  ["Eigen: the Mozilla Public License, version 2.0", "/usr/share/common-licenses/MPL-2.0"],
  ["What parts of CGAL are under, and the Boost Software License", "/usr/share/doc/libcgal-dev/copyright"],
  ["musl, the C library of Emscripten", "/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT"],
  ["libc++, libc++abi and compiler-rt of LLVM: the Apache License, version 2.0, with the LLVM exceptions", "/usr/share/common-licenses/Apache-2.0"],
];

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/** As HTML. */
export async function licences() {
  const parts = await Promise.all(
    texts.map(async ([title, file]) => {
      const text = await readFile(path.resolve(here, file), "utf8").catch(() => {
        throw new Error(`${file} is missing: the page must have the licence of ${title}`);
      });
      return `<details><summary>${escaped(title)}</summary><pre tabindex="0">${escaped(text)}</pre></details>`;
    }),
  );
  return parts.join("\n");
}
