// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is taken away, shown elsewhere, or told step by step:
//   node --test test_outputs.mjs      with PN_PAGE, the HTML file, PN_MODELER, the folder of the WebAssembly module, and
//   PN_SUBDIVIDE, the command, in the environment
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFile, mkdir, mkdtemp, readdir, readFile, rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { withBrowser, withPage } from "./browser.mjs";
import { download as downloadTo, drop, largestDifference, message, points, readPly } from "./page_actions.mjs";

const file = path.resolve(process.env.PN_PAGE);
const command = path.resolve(process.env.PN_SUBDIVIDE);
const demo = path.resolve(import.meta.dirname, "..");
let folder;
before(async () => (folder = await mkdtemp(path.join(tmpdir(), "pn-page-test-"))));
after(() => rm(folder, { recursive: true }));

const download = (page, button) => downloadTo(page, button, folder);
const build = (output, ...options) =>
  execFileSync("node", [path.join(demo, "build.mjs"), path.resolve(process.env.PN_MODELER), output, ...options]);

test("OBJ, STL and GLB hold the surface", async () => {
  await withPage(file, { hash: "#bumps" }, async (page) => {
    await page.fill("#rounds", "1");
    await page.check("input[name=layout][value=pn]");
    const start = await points(page);
    const faces = await page.evaluate(() => window.page.editor.shownSurface.faces().degrees.length);
    const saved = {};
    for (const format of ["obj", "stl", "glb"]) {
      await page.selectOption("#surface-format", format);
      saved[format] = await download(page, "#save-surface");
      assert.ok(saved[format].endsWith(`.${format}`));
    }
    // the command reads them
    const copy = path.join(folder, "copy.ply");
    execFileSync(command, ["surface", saved.obj, copy, "--quiet", "--levels", "0"]);
    assert.equal(largestDifference(readPly(await readFile(copy)).points, start), 0);
    execFileSync(command, ["surface", saved.stl, copy, "--quiet", "--levels", "0"]);
    const ofStl = readPly(await readFile(copy));
    assert.equal(ofStl.vertices, start.length / 3);
    assert.equal(ofStl.faces, 2 * faces);
    const stl = await readFile(saved.stl);
    const [normal, a, b, c] = [0, 1, 2, 3].map((k) => [0, 1, 2].map((j) => stl.readFloatLE(84 + 12 * k + 4 * j)));
    const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
    const product = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    assert.ok(largestDifference(normal, product.map((x) => x / Math.hypot(...product))) < 1e-5);
    checkGlb(await readFile(saved.glb), start, 2 * faces);
    await drop(page, "-again.obj", await readFile(saved.obj));
    await page.waitForFunction(() => window.page.editor.name === "-again.obj");
    assert.deepEqual(await page.evaluate(() => Array.from(window.page.editor.handles.points)), start);
    assert.equal(path.basename(await download(page, "#save-control")), "again_control.ply", "no option of the command");
  });
});

function checkGlb(glb, expected, triangles) {
  assert.deepEqual([glb.toString("latin1", 0, 4), glb.readUInt32LE(4), glb.readUInt32LE(8)], ["glTF", 2, glb.length]);
  const length = glb.readUInt32LE(12);
  assert.equal(length % 4, 0);
  assert.equal(glb.toString("latin1", 16, 20), "JSON");
  const model = JSON.parse(glb.toString("utf8", 20, 20 + length));
  assert.equal(glb.toString("latin1", 24 + length, 28 + length), "BIN\0");
  assert.equal(glb.readUInt32LE(20 + length), glb.length - 28 - length);
  const { POSITION, NORMAL } = model.meshes[0].primitives[0].attributes;
  const values = (i) => {
    const view = model.bufferViews[model.accessors[i].bufferView];
    return Array.from({ length: view.byteLength / 4 }, (_, k) => glb.readFloatLE(28 + length + view.byteOffset + 4 * k));
  };
  const positions = values(POSITION);
  assert.deepEqual(positions, expected.map(Math.fround));
  for (const [name, best] of [["min", Math.min], ["max", Math.max]])
    assert.deepEqual(model.accessors[POSITION][name], [0, 1, 2].map((k) => best(...positions.filter((_, i) => i % 3 === k))));
  const n = values(NORMAL);
  for (let i = 0; i < n.length; i += 3) assert.ok(Math.abs(Math.hypot(n[i], n[i + 1], n[i + 2]) - 1) < 1e-5);
  assert.equal(model.accessors[model.meshes[0].primitives[0].indices].count, 3 * triangles);
  // a scene has y upwards: z becomes y
  const [x, y, z, w] = model.nodes[0].rotation;
  assert.ok(Math.abs(2 * (y * z - x * w) - 1) < 1e-12 && Math.abs(x * x + y * y + z * z + w * w - 1) < 1e-12);
}

/** What the command makes of the control mesh that the page saves, by the line that the page shows: [its file, the page's]. */
async function bothFiles(page, format) {
  await page.selectOption("#surface-format", format);
  const control = await download(page, "#save-control");
  const surface = await download(page, "#save-surface");
  await page.click("#recipe");
  const words = (await page.textContent("#recipe-command")).split(" ");
  await page.keyboard.press("Escape");
  assert.deepEqual(words.slice(0, 4), ["pn_subdivide", "surface", path.basename(control), path.basename(surface)]);
  const apart = await mkdtemp(path.join(folder, "command-"));
  await copyFile(control, path.join(apart, path.basename(control)));
  execFileSync(command, [...words.slice(1), "--quiet"], { cwd: apart });
  return [await readFile(path.join(apart, path.basename(surface))), await readFile(surface)];
}

test("files are those of the command that is shown, to the byte", async () => {
  const cases = [
    ["#ring", { rounds: 2 }], ["#head", { rounds: 1 }], ["#bumps", { scheme: "kobbelt", rounds: 2 }], ["#tetrahedron", { rounds: 3 }],
    ["#cube", { scheme: "doo-sabin", rounds: 2 }], ["#cuboid", { rounds: 0 }], ["#bolt", { rounds: 0 }], ["#bolt", { rounds: 1 }], ["#housing", { rounds: 1 }],
    ["#ring", { rounds: 2, layout: "linear" }], ["#bolt", { rounds: 1, layout: "linear" }],
  ];
  for (const [hash, settings] of cases)
    await withPage(file, { hash }, async (page) => {
      await page.evaluate((change) => window.page.editor.set(change), settings);
      for (const format of ["ply", "obj", "stl"]) {
        const [theirs, ours] = await bothFiles(page, format);
        const first = ours.findIndex((byte, i) => byte !== theirs[i]);
        assert.ok(ours.equals(theirs), `${hash} ${JSON.stringify(settings)} ${format}: ${ours.length} and ${theirs.length} bytes, ` +
          `the first other one is ${first}`);
      }
    });
  // limits are sums that the compilers add up in other orders
  await withPage(file, { hash: "#torus" }, async (page) => {
    await page.evaluate(() => window.page.editor.set({ rounds: 1, layout: "pn", limit: true }));
    const [theirs, ours] = (await bothFiles(page, "ply")).map((bytes) => ({ header: String(bytes).split("end_header")[0], ...readPly(bytes) }));
    assert.equal(ours.header, theirs.header);
    for (const name of ["points", "normals"]) assert.ok(largestDifference(ours[name], theirs[name]) < 1e-12);
  });
});

test("surfaces with creases are saved with the normals of both sides and what is sharp, as they are after an edit", async () => {
  await withPage(file, { hash: "#bolt" }, async (page) => {
    await page.evaluate(() => window.page.editor.set({ rounds: 1, layout: "pn" }));
    const before = (await bothFiles(page, "obj"))[1];
    await page.evaluate(() => {
      const { editor } = window.page;
      const { vertices } = editor.handles;
      editor.setNormal(vertices.findIndex((v, w) => vertices.indexOf(v) < w), 0.3, 0.4, 1); // of two at a vertex
      editor.change((mesh) => mesh.setRoundness(0.75));
    });
    const [theirs, ours] = await bothFiles(page, "obj");
    assert.ok(ours.equals(theirs) && !ours.equals(before));
    const lines = (word) => String(ours).split("\n").filter((line) => line.startsWith(`${word} `)).length;
    assert.ok(lines("vn") > lines("v"));
    const sharp = await page.evaluate(() => window.page.editor.mesh.numberOfSharpEdges());
    assert.equal(lines("t"), 2 * sharp);
    const [theirPly, ourPly] = await bothFiles(page, "ply");
    assert.ok(ourPly.equals(theirPly));
    const { hasNormals, roundness, vertices } = readPly(ourPly);
    assert.ok(hasNormals && roundness.length === vertices && roundness.every((w) => w === 0.75));
    assert.match(String(ourPly.subarray(0, 1000)), new RegExp(`element edge ${2 * sharp}\n`));
  });
});

test("closed surfaces show no inside", async () => {
  const orange = (page) => page.evaluate(async () => {
    const picture = await createImageBitmap(await window.page.editor.viewer.png());
    const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, picture.width, picture.height);
    let n = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] > data[i + 2] + 40) ++n;
    return n;
  });
  await withPage(file, { hash: "#ring_edited" }, async (page) => {
    await page.uncheck("#show-control");
    await page.uncheck("#show-normals");
    for (let i = 0; i < 4; ++i) {
      assert.equal(await orange(page), 0);
      await page.focus("#canvas");
      await page.keyboard.press("ArrowLeft");
    }
    await page.selectOption("#example", "bumps");
    await page.uncheck("#show-normals");
    await page.focus("#canvas");
    for (let i = 0; i < 12; ++i) await page.keyboard.press("ArrowDown"); // from below
    assert.ok((await orange(page)) > 1000, "with a border the inside is seen");
  });
});

test("lines are about two pixels wide, and what is selected is before the surface", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    // along a row of the picture, which has two pixels for one, the runs of pixels of a kind
    const runs = (y, kind) => page.evaluate(async ([row, name]) => {
      const { viewer } = window.page.editor;
      const picture = await createImageBitmap(await viewer.png());
      const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
      context.drawImage(picture, 0, 0);
      const { data } = context.getImageData(0, Math.round(2 * row), picture.width, 1);
      const kinds = { dark: ([r, g, b]) => r + g + b < 320, selected: ([r, g, b]) => r > 190 && g < 140 && b < 60 };
      const lengths = [0];
      for (let i = 0; i < data.length; i += 4) {
        if (kinds[name](data.subarray(i, i + 3))) ++lengths[lengths.length - 1];
        else if (lengths.at(-1) > 0) lengths.push(0);
      }
      return lengths.filter((n) => n > 0);
    }, [y, kind]);
    const places = (control) => page.evaluate((inFront) => {
      const { editor } = window.page;
      const { viewer, handles } = editor;
      return [...handles.vertices].map((v) => {
        const { y, depth } = viewer.toPixels(viewer.camera.position.clone().fromArray(handles.points, 3 * v));
        return { vertex: v, y: viewer.canvas.clientHeight / 2 + y, depth };
      }).sort((a, b) => (inFront ? a.depth - b.depth : b.depth - a.depth));
    }, control);
    await page.uncheck("#show-normals");
    await page.check("input[name=layout][value=linear]"); // whose surface is far within
    const [first] = await places(true);
    const found = await runs(first.y + 60, "dark");
    assert.ok(found.length >= 2 && found.every((n) => n >= 3 && n <= 12), `${found}`);
    await page.check("input[name=layout][value=pn]");
    const [last] = await places(false);
    assert.deepEqual(await runs(last.y, "selected"), []);
    await page.evaluate((vertex) => window.page.editor.select({ vertex }), last.vertex);
    assert.ok((await runs(last.y, "selected"))[0] > 8);
  });
});

test("a page in another one is the picture alone", async () => {
  await withPage(file, { hash: "?embed=1#picture-waves" }, async (page) => {
    for (const hidden of ["header", "#surface .panel"]) assert.ok(await page.isHidden(hidden));
    const { width, height } = await page.locator("#canvas").boundingBox();
    assert.deepEqual([width, height], [1280, 800]);
    await page.waitForTimeout(700);
    const href = await page.getAttribute("#whole", "href");
    assert.ok(!href.includes("embed") && /#waves=/.test(href), href);
  });
  await withPage(file, {}, async (page) => assert.ok(await page.isHidden("#whole")));
});

test("a tour of five steps", async () => {
  await withPage(file, { hash: "#torus" }, async (page) => {
    await page.click("#tour");
    const titles = [];
    for (let i = 1; i <= 5; ++i) {
      const title = await page.textContent("#tour-title");
      assert.ok(title.startsWith(`${i} of 5: `), title);
      titles.push(title);
      if (i < 5) await page.keyboard.press("Enter"); // "Next" has the focus
    }
    assert.equal(new Set(titles).size, 5);
    assert.ok(await page.isVisible("#formula-drawing"));
    await page.keyboard.press("Escape");
    assert.ok(await page.isHidden("#tour-box"));
  });
});

test("script and style beside the page suit a strict content policy", async () => {
  const output = path.join(folder, "separate", "index.html");
  await mkdir(path.dirname(output));
  build(output, "--separate");
  const types = { ".js": "text/javascript", ".css": "text/css", ".html": "text/html" };
  const server = createServer(async (request, response) => {
    const name = path.normalize(new URL(request.url, "http://localhost").pathname);
    response.setHeader("Content-Type", types[path.extname(name)] ?? "text/plain");
    response.setHeader("Content-Security-Policy",
      "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src data: blob:");
    response.end(await readFile(path.join(path.dirname(output), name)).catch(() => ""));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  await withBrowser(async (browser) => {
    const page = await browser.newPage();
    const errors = [];
    page.on("console", (line) => line.type() === "error" && errors.push(line.text()));
    await page.goto(`http://127.0.0.1:${server.address().port}/index.html`);
    await page.waitForFunction(() => document.documentElement.dataset.ready !== undefined);
    await page.click("#picture-waves");
    assert.ok((await points(page)).length > 1000);
    assert.deepEqual(errors, []);
    await page.close();
  }).finally(() => server.close());
  const names = await readdir(path.dirname(output));
  assert.deepEqual(names.map((name) => path.extname(name)).sort(), [".css", ".html", ".js", ".js", ".js"]);
});

test("licences are there in full, and the package's address if it is given", async () => {
  const output = path.join(folder, "linked.html");
  build(output, "--url", "https://example.org/pn?a=\"b\"");
  const html = await readFile(output, "utf8");
  assert.ok(html.includes('<a href="https://example.org/pn?a=%22b%22"') && html.includes('<meta property="og:url"'));
  await withPage(file, {}, async (page) => {
    await page.click("#help");
    const texts = await page.$$eval("#licences details", (all) => all.map((e) => e.textContent));
    for (const sentence of ["GNU GENERAL PUBLIC LICENSE", "END OF TERMS AND CONDITIONS", "GNU LESSER GENERAL PUBLIC LICENSE", "three.js authors",
      "Mozilla Public License", "Boost Software License", "Rich Felker", "Apache License"])
      assert.ok(texts.some((text) => text.includes(sentence)), sentence);
    assert.equal(await page.locator("#help-dialog a[href*=example]").count(), 0);
  });
});
