// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Makes one HTML file of the page: node build.mjs FOLDER_OF_MODELER OUTPUT.html [--url ADDRESS]
// ADDRESS: where the package is to be found, which the page then links to.
import { build } from "esbuild";
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const [, , modelerFolder, output, ...options] = process.argv;
const url = options[0] === "--url" ? new URL(options[1]).href : undefined;
const here = path.dirname(fileURLToPath(import.meta.url));

/** The module's code, and its binary compressed. */
const modeler = {
  name: "modeler",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^modeler-code$/ }, () => ({ path: path.resolve(modelerFolder, "modeler.js") }));
    onResolve({ filter: /^modeler-wasm$/ }, () => ({ path: "wasm", namespace: "modeler" }));
    onLoad({ filter: /.*/, namespace: "modeler" }, async () => ({
      contents: gzipSync(await readFile(path.resolve(modelerFolder, "modeler.wasm")), { level: 9 }),
      loader: "binary",
    }));
  },
};

const script = await build({
  entryPoints: [path.join(here, "page/main.ts")],
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  legalComments: "inline",
  loader: { ".ply": "text", ".off": "text", ".obj": "text", ".txt": "text", ".webp": "dataurl" },
  // the module's loader has branches for Node.js, which a browser never takes
  external: ["module", "fs", "path", "url"],
  plugins: [modeler],
  write: false,
});
const style = await build({
  entryPoints: [path.join(here, "page/style.css")],
  minify: true,
  target: "es2022",
  write: false,
});

const address = url === undefined ? "" : `<meta property="og:url" content="${url}">`;
const link = url === undefined ? "" : `<a href="${url}" rel="noopener">Its sources and manual</a>. `;
const html = (await readFile(path.join(here, "page/index.html"), "utf8"))
  .replace("<!-- style -->", () => `<style>${style.outputFiles[0].text}</style>`)
  .replace("<!-- address -->", () => address)
  .replace("<!-- link -->", () => link)
  .replace("<!-- script -->", () =>
    `<script type="module">${script.outputFiles[0].text.replaceAll("</script", "<\\/script")}</script>`);
await writeFile(output, html);

const size = Buffer.byteLength(html);
console.log(`${output}: ${size} bytes`);
if (size > 2.2e6) {
  console.error("The page is larger than 2.2 MB.");
  process.exit(1);
}
