// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Makes one HTML file of the page: node build.mjs FOLDER_OF_MODELER OUTPUT.html [--url ADDRESS] [--separate]
// --url: where the package is to be found, which the page then links to; --separate: script and style are files beside it,
// for servers whose content policy allows none in the page.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { licences, requireNoGpl } from "./licences.mjs";

const [, , modelerFolder, output, ...options] = process.argv;
const url = options.includes("--url") ? new URL(options[options.indexOf("--url") + 1]).href : undefined;
const isSeparate = options.includes("--separate");
const here = path.dirname(fileURLToPath(import.meta.url));
await requireNoGpl(modelerFolder);

/** The module's code, its binary compressed, and the address of the worker, which is in the page or a file beside it. */
const modeler = {
  name: "modeler",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^modeler-code$/ }, () => ({ path: path.resolve(modelerFolder, "modeler.js") }));
    onResolve({ filter: /^modeler-wasm$/ }, () => ({ path: "wasm", namespace: "modeler" }));
    onLoad({ filter: /.*/, namespace: "modeler" }, async () => ({
      contents: gzipSync(await readFile(path.resolve(modelerFolder, "modeler.wasm")), { level: 9 }),
      loader: "binary",
    }));
    onResolve({ filter: /^surface-worker-code$/ }, () => ({ path: "code", namespace: "worker" }));
    onLoad({ filter: /.*/, namespace: "worker" }, async () => {
      const entryPoints = [path.join(here, "page/surface_worker.ts")];
      const { text } = (await build({ ...common, entryPoints, format: "iife" })).outputFiles[0];
      const address = isSeparate
        ? JSON.stringify((await fileBeside(text, "js")).name)
        : `URL.createObjectURL(new Blob([${JSON.stringify(text)}], { type: "text/javascript" }))`;
      return { contents: `export default () => ${address};`, loader: "js" };
    });
  },
};

const common = {
  bundle: true,
  minify: true,
  target: "es2022",
  legalComments: "inline",
  loader: { ".ply": "text", ".off": "text", ".obj": "text", ".txt": "text", ".webp": "dataurl" },
  // the module's loader has branches for Node.js, which a browser never takes
  external: ["module", "fs", "path", "url"],
  // a classic worker has no address
  logOverride: { "empty-import-meta": "silent" },
  plugins: [modeler],
  write: false,
};
const script = await build({ ...common, entryPoints: [path.join(here, "page/main.ts")], format: "esm" });
const style = await build({
  entryPoints: [path.join(here, "page/style.css")],
  minify: true,
  target: "es2022",
  write: false,
});

const address = url === undefined ? "" : `<meta property="og:url" content="${url}">`;
const link = url === undefined ? "" : `<a href="${url}" rel="noopener">Its sources and manual</a>. `;
/** A file beside the page, whose name and integrity are its hash. */
async function fileBeside(text, extension) {
  const hash = createHash("sha384").update(text).digest();
  const name = `${path.basename(output, ".html")}.${hash.toString("hex").slice(0, 16)}.${extension}`;
  await writeFile(path.join(path.dirname(output), name), text);
  return { name, integrity: `sha384-${hash.toString("base64")}` };
}

async function styleTag(text) {
  if (!isSeparate) return `<style>${text}</style>`;
  const { name, integrity } = await fileBeside(text, "css");
  return `<link rel="stylesheet" href="${name}" integrity="${integrity}" crossorigin="anonymous">`;
}

async function scriptTag(text) {
  if (!isSeparate) return `<script type="module">${text.replaceAll("</script", "<\\/script")}</script>`;
  const { name, integrity } = await fileBeside(text, "js");
  return `<script type="module" src="${name}" integrity="${integrity}" crossorigin="anonymous"></script>`;
}

const tags = { style: await styleTag(style.outputFiles[0].text), script: await scriptTag(script.outputFiles[0].text) };
const texts = await licences();
const html = (await readFile(path.join(here, "page/index.html"), "utf8"))
  .replaceAll("'unsafe-inline'", () => (isSeparate ? "'self'" : "'unsafe-inline'"))
  .replace("worker-src blob:", () => (isSeparate ? "worker-src 'self'" : "worker-src blob:"))
  .replace("<!-- style -->", () => tags.style)
  .replace("<!-- licences -->", () => texts)
  .replace("<!-- address -->", () => address)
  .replace("<!-- link -->", () => link)
  .replace("<!-- script -->", () => tags.script);
await writeFile(output, html);

const size = Buffer.byteLength(html);
const compressed = gzipSync(html, { level: 9 }).length;
console.log(`${output}: ${size} bytes, compressed ${compressed}`);
if (size > 2.2e6) {
  console.error("The page is larger than 2.2 MB.");
  process.exit(1);
}
