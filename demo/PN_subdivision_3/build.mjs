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
import { brotliCompressSync, gzipSync } from "node:zlib";
import { licences, requireNoGpl } from "./licences.mjs";

const [, , modelerFolder, output, ...options] = process.argv;
const url = options.includes("--url") ? new URL(options[options.indexOf("--url") + 1]).href : undefined;
const isSeparate = options.includes("--separate");
const here = path.dirname(fileURLToPath(import.meta.url));
await requireNoGpl(modelerFolder);

/** Bytes as letters, the most frequent ones as those of one byte. Whoever sends the page compresses it: brotli makes 424 kB of
 * the module in this form, and cannot make less than 648 of one that gzip has compressed before. */
function asText(bytes) {
  const letters = [...String.fromCharCode(...Array.from({ length: 0x180 - 0x20 }, (_, i) => 0x20 + i))]
    .filter((letter) => !(letter >= "\x7f" && letter < "\xc0") && !'"\\<`$'.includes(letter));
  const frequency = new Float64Array(256);
  for (const byte of bytes) ++frequency[byte];
  const alphabet = [];
  [...frequency.keys()].sort((a, b) => frequency[b] - frequency[a]).forEach((byte, i) => (alphabet[byte] = letters[i]));
  const parts = [];
  for (let i = 0; i < bytes.length; i += 1 << 16) parts.push(Array.from(bytes.subarray(i, i + (1 << 16)), (byte) => alphabet[byte]).join(""));
  return { text: parts.join(""), alphabet: alphabet.join("") };
}

/** The module's code, its binary, and the address of the worker, which is in the page or a file beside it. */
const modeler = {
  name: "modeler",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^modeler-code$/ }, () => ({ path: path.resolve(modelerFolder, "modeler.js") }));
    onResolve({ filter: /^modeler-wasm$/ }, () => ({ path: "wasm", namespace: "modeler" }));
    onLoad({ filter: /.*/, namespace: "modeler" }, async () => {
      const { text, alphabet } = asText(await readFile(path.resolve(modelerFolder, "modeler.wasm")));
      return { contents: `export const alphabet = "${alphabet}";\nexport default "${text}";`, loader: "js" };
    });
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
  charset: "utf8",
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

/** The first surfaces, for as long as the page is loaded. */
async function firstPictures() {
  const names = ["linear", "pn"].map((name) => path.join(here, `page/pictures/first_${name}.webp`));
  return (await Promise.all(names.map((name) => readFile(name, "base64"))))
    .map((bytes) => `<img src="data:image/webp;base64,${bytes}" alt="">`).join("");
}

/** What does not wait for the module: a link may be of something else, and without JavaScript nothing is loaded. */
async function earlyTag() {
  const text = `document.querySelector("#loading p").textContent="Loading …";` +
    `if(location.hash)for(const first of document.querySelectorAll("#loading img"))first.remove();`;
  return isSeparate ? `<script src="${(await fileBeside(text, "js")).name}"></script>` : `<script>${text}</script>`;
}

const tags = { style: await styleTag(style.outputFiles[0].text), script: await scriptTag(script.outputFiles[0].text) };
const [texts, first, early] = await Promise.all([licences(), firstPictures(), earlyTag()]);
const html = (await readFile(path.join(here, "page/index.html"), "utf8"))
  .replaceAll("'unsafe-inline'", () => (isSeparate ? "'self'" : "'unsafe-inline'"))
  .replace("worker-src blob:", () => (isSeparate ? "worker-src 'self'" : "worker-src blob:"))
  .replace("<!-- style -->", () => tags.style)
  .replace("<!-- first -->", () => first)
  .replace("<!-- early -->", () => early)
  .replace("<!-- licences -->", () => texts)
  .replace("<!-- address -->", () => address)
  .replace("<!-- link -->", () => link)
  .replace("<!-- script -->", () => tags.script);
await writeFile(output, html);

const [size, sent] = [html, brotliCompressSync(html)].map((content) => Buffer.byteLength(content));
console.log(`${output}: ${size} bytes, compressed by gzip ${gzipSync(html, { level: 9 }).length}, by brotli ${sent}`);
if (sent > 0.8e6 && !isSeparate) {
  console.error("The page is larger than 0.8 MB, compressed by brotli.");
  process.exit(1);
}
