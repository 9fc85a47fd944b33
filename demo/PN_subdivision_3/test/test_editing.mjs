// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// That editing in the page does no harm: with real clicks, double clicks and fingers.
//   node --test test_editing.mjs      with PN_PAGE, the HTML file, in the environment
import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { chromiumOnly, withPage } from "./browser.mjs";
import { download as downloadTo, drop, dropAll, frontWedge, largestDifference, loseContext, message, middleOf, points, tipOf } from "./page_actions.mjs";

const file = path.resolve(process.env.PN_PAGE);
let folder;
before(async () => (folder = await mkdtemp(path.join(tmpdir(), "pn-page-test-"))));
after(() => rm(folder, { recursive: true }));
const download = (page, button) => downloadTo(page, button, folder);

/** Tips of normals on the screen. Whether each is behind the surface, and how deep, is found by rays through all triangles. */
const tipsAndDepths = (page) =>
  page.evaluate(() => {
    const { editor } = window.page;
    const { viewer, handles, normalLength } = editor;
    viewer.draw(); // the view may have changed
    const surface = editor.shownSurface;
    const p = surface.points();
    const { degrees, corners } = surface.faces();
    const triangles = [];
    let first = 0;
    for (const degree of degrees) {
      for (let c = 2; c < degree; ++c) triangles.push([corners[first], corners[first + c - 1], corners[first + c]]);
      first += degree;
    }
    const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const at = (v) => [p[3 * v], p[3 * v + 1], p[3 * v + 2]];
    const eye = viewer.camera.position.toArray();
    const place = viewer.camera.position.clone();
    const result = [];
    for (let w = 0; w < handles.vertices.length; ++w) {
      const v = handles.vertices[w];
      const n = Array.from(handles.normals.slice(3 * w, 3 * w + 3));
      const length = Math.hypot(...n);
      const base = Array.from(handles.points.slice(3 * v, 3 * v + 3));
      const tip = base.map((x, k) => x + (normalLength * n[k]) / length);
      const ray = sub(tip, eye);
      let covered = 0; // how far the surface is before the tip, in lengths of normals
      for (const [i, j, k] of triangles) {
        const [a, b, c] = [at(i), at(j), at(k)];
        const [e, f] = [sub(b, a), sub(c, a)];
        const h = cross(ray, f);
        const determinant = dot(e, h);
        if (determinant === 0) continue;
        const s = sub(eye, a);
        const u = dot(s, h) / determinant;
        const q = cross(s, e);
        const t = dot(ray, q) / determinant;
        if (u < 0 || u > 1 || t < 0 || u + t > 1) continue;
        const distance = dot(f, q) / determinant;
        if (distance > 0 && distance < 1) covered = Math.max(covered, ((1 - distance) * Math.hypot(...ray)) / normalLength);
      }
      const pixels = viewer.toPixels(place.fromArray(tip));
      const box = viewer.canvas.getBoundingClientRect();
      result.push({ wedge: w, vertex: v, covered, looksAway: dot(n, sub(eye, base)) < 0,
        x: box.left + box.width / 2 + pixels.x, y: box.top + box.height / 2 + pixels.y });
    }
    return result;
  });

test("what is behind the surface is not taken hold of", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    await page.fill("#rounds", "2");
    await page.check("#show-normals");
    const tips = await tipsAndDepths(page);
    const byWedge = new Map(tips.map((tip) => [tip.wedge, tip]));
    const behind = tips.filter((tip) => tip.looksAway && tip.covered > 1);
    const before = tips.filter((tip) => !tip.looksAway && tip.covered === 0);
    assert.ok(behind.length > 40 && before.length > 40, `${behind.length} behind, ${before.length} before`);
    const click = async (tip) => {
      await page.evaluate(() => window.page.editor.select({}));
      await page.mouse.click(tip.x, tip.y);
      return page.evaluate(() => window.page.editor.selection);
    };
    for (const tip of behind) {
      const { wedge, vertex } = await click(tip);
      assert.ok(vertex !== tip.vertex, `the vertex ${vertex} is behind the surface`);
      // what is taken instead is not covered either
      if (wedge !== undefined) assert.ok(!(byWedge.get(wedge).looksAway && byWedge.get(wedge).covered > 1));
    }
    let taken = 0;
    for (const tip of before) if ((await click(tip)).vertex === tip.vertex) ++taken;
    assert.ok(taken > 0.9 * before.length, `${taken} of ${before.length}`);
    assert.ok(await page.isDisabled("#undo"), "clicks are no changes");
  });
});

test("a click that moves nothing is no change", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    const start = await points(page);
    const tip = await tipOf(page, await frontWedge(page));
    await page.mouse.click(tip.x, tip.y);
    assert.notEqual(await page.evaluate(() => window.page.editor.selection.wedge), undefined);
    await page.mouse.move(tip.x, tip.y);
    await page.mouse.down();
    await page.mouse.move(tip.x + 1, tip.y); // a hand that shakes
    await page.mouse.up();
    assert.ok(await page.isDisabled("#undo"));
    assert.equal(largestDifference(await points(page), start), 0);
    await page.click("#tab-curve");
    const [x, y] = await middleOf(page, "#drawing .hold[data-kind=point]");
    await page.mouse.click(x, y);
    assert.ok(await page.isDisabled("#undo"));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 20, y, { steps: 3 });
    await page.mouse.up();
    assert.ok(await page.isEnabled("#undo"));
  });
});

test("a coordinate that is entered leaves the others alone", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.focus("#canvas");
    await page.keyboard.press("n");
    const triples = () => page.evaluate(() => {
      const { handles, selection } = window.page.editor;
      return [...handles.points.slice(3 * selection.vertex, 3 * selection.vertex + 3),
        ...handles.normals.slice(3 * selection.wedge, 3 * selection.wedge + 3)];
    });
    const start = await triples();
    assert.ok(start.some((x) => x !== Number(x.toPrecision(6))), "there are more than six digits to lose");
    const enter = async (id, text) => {
      await page.fill(id, text);
      await page.press(id, "Enter");
      return triples();
    };
    assert.deepEqual(await enter("#py", "0.25"), start.with(1, 0.25));
    assert.deepEqual(await enter("#nz", "0,5"), start.with(1, 0.25).with(5, 0.5));
    for (const text of ["", "  ", "x", "1e999"]) {
      assert.deepEqual(await enter("#px", text), start.with(1, 0.25).with(5, 0.5));
      assert.equal(Number(await page.inputValue("#px")), Number(start[0].toPrecision(6)));
    }
    for (let i = 0; i < 2; ++i) await page.click("#undo");
    assert.deepEqual(await triples(), start);
    assert.ok(await page.isDisabled("#undo"));
  });
});

test("tangent creases survive export and opening, and come in selection files", async () => {
  await withPage(file, { hash: "#bolt" }, async (page) => {
    const sharp = () => page.evaluate(() => window.page.editor.mesh.numberOfSharpEdges());
    const all = await sharp();
    await page.fill("#roundness", "0.75");
    const start = await points(page);
    const control = await download(page, "#save-control");
    await page.selectOption("#example", "cube");
    await drop(page, "again.ply", await readFile(control));
    await page.waitForFunction(() => window.page.editor.name === "again.ply");
    assert.equal(await sharp(), all);
    await page.fill("#rounds", "4");
    assert.equal(largestDifference(await points(page), start), 0);
    assert.equal(await page.inputValue("#roundness"), "0.75");
    const part = path.resolve(import.meta.dirname, "../../../data/meshes/parts/bolt");
    const [mesh, selection] = await Promise.all([`${part}.obj`, `${part}.selection.txt`].map((name) => readFile(name)));
    await drop(page, "alone.obj", mesh);
    await page.waitForFunction(() => window.page.editor.name === "alone.obj");
    assert.ok((await sharp()) < all, "normals alone do not tell of tangent creases");
    await drop(page, "bolt.selection.txt", selection);
    assert.equal(await message(page), `${all} edges are sharp.`);
    assert.equal(await sharp(), all);
    await page.selectOption("#example", "cube");
    await dropAll(page, [["bolt.selection.txt", selection], ["bolt.obj", mesh]]);
    await page.waitForFunction(() => window.page.editor.name === "bolt.obj");
    assert.equal(await sharp(), all);
    for (const [content, expected] of [
      ["\n\n0 99999\n", /wrong\.txt: the mesh has no edge from vertex 0 to vertex 99999/],
      ["\n\n0 1 2\n", /wrong\.txt: line 3: the last edge has one vertex only/],
      ["\n\n0 -1\n", /wrong\.txt: line 3: -1 is no number of a vertex/],
    ]) {
      await drop(page, "wrong.txt", content);
      assert.match(await message(page), expected);
      assert.equal(await sharp(), all);
    }
  });
});

test("a double click removes a point of a curve, and adds one", async () => {
  await withPage(file, {}, async (page) => {
    await page.click("#tab-curve");
    const number = () => page.evaluate(() => window.page.curve.state.points.length / 2);
    const start = await number();
    await page.mouse.dblclick(...(await middleOf(page, "#drawing .hold[data-kind=point]")));
    assert.equal(await number(), start - 1);
    await page.mouse.dblclick(...(await middleOf(page, "#drawing .edge-hold[data-vertex='3']")));
    assert.equal(await number(), start);
    for (let i = 0; i < 2; ++i) await page.click("#undo");
    assert.equal(await number(), start);
    assert.ok(await page.isDisabled("#undo"));
  });
});

test("edges are not marked where the scheme has no creases", async () => {
  await withPage(file, { hash: "#tetrahedron" }, async (page) => {
    await page.click("#mark");
    assert.equal(await page.getAttribute("#mark", "aria-pressed"), "true");
    await page.selectOption("#scheme", "sqrt3");
    assert.ok(await page.isDisabled("#mark"));
    assert.equal(await page.getAttribute("#mark", "aria-pressed"), "false");
    const tip = await tipOf(page, await frontWedge(page));
    await page.mouse.click(tip.x, tip.y);
    assert.notEqual(await page.evaluate(() => window.page.editor.selection.wedge), undefined);
  });
});

test("a second finger does not turn the view under what the first one holds", { skip: chromiumOnly }, async () => {
  const options = { hash: "#ring", viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  await withPage(file, options, async (page, context) => {
    await page.check("input[name=layout][value=pn]");
    await page.evaluate(() => window.scrollTo(0, 0));
    const camera = () => page.evaluate(() => window.page.editor.viewer.camera.position.toArray());
    const before = await camera();
    const start = await points(page);
    const tip = await tipOf(page, await frontWedge(page));
    const client = await context.newCDPSession(page);
    const touch = (type, ...touchPoints) => client.send("Input.dispatchTouchEvent",
      { type, touchPoints: touchPoints.map(([dx, dy], id) => ({ x: tip.x + dx, y: tip.y + dy, id })) });
    await touch("touchStart", [0, 0]);
    await touch("touchMove", [8, -14]);
    await touch("touchStart", [8, -14], [60, 50]);
    await touch("touchMove", [12, -20], [90, 90]);
    await touch("touchMove", [14, -24], [30, 120]);
    await touch("touchEnd", [14, -24]);
    await touch("touchEnd");
    assert.deepEqual(await camera(), before);
    assert.ok(largestDifference(await points(page), start) > 1e-3);
    await page.click("#undo");
    assert.equal(largestDifference(await points(page), start), 0);
    // two fingers that hold nothing still zoom and turn
    await touch("touchStart", [-80, 150], [80, 150]);
    await touch("touchMove", [-120, 150], [120, 150]);
    await touch("touchEnd");
    assert.notDeepEqual(await camera(), before);
  });
});

test("what is far from the origin is shown as if it were near", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    const picture = () => page.evaluate(() => {
      const { editor } = window.page;
      editor.viewer.draw();
      return { positions: [...editor.shownSurface.positionsView()], points: [...editor.handles.points],
        pixels: [...editor.handles.vertices].map((v) => editor.viewer.toPixels(
          editor.viewer.camera.position.clone().fromArray(editor.shownHandles.points, 3 * v))) };
    });
    const cube = (x, y, z) => `OFF\n8 6 0\n${[0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
      `${x + (i & 1)} ${y + ((i >> 1) & 1)} ${z + (i >> 2)}`).join("\n")}\n` +
      "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
    const open = async (name, content) => {
      await drop(page, name, content);
      await page.waitForFunction((n) => window.page.editor.name === n, name);
      return picture();
    };
    const near = await open("near.off", cube(0, 0, 0));
    // powers of 2, so that no coordinate is rounded
    const [x, y, z] = [2 ** 24, -(2 ** 26), 2 ** 22];
    const far = await open("far.off", cube(x, y, z));
    const shift = [0, 1, 2].map((k) => near.positions[k] - far.positions[k]);
    const difference = near.positions.reduce((most, p, i) => Math.max(most, Math.abs(p - far.positions[i] - shift[i % 3])), 0);
    assert.ok(difference < 1e-6, `${difference}`);
    far.pixels.forEach((pixel, i) => assert.ok(Math.hypot(pixel.x - near.pixels[i].x, pixel.y - near.pixels[i].y) < 0.01));
    assert.deepEqual(far.points.slice(0, 3), [x, y, z]);
    // a point that is dragged stays where the pointer is, and keeps its place in the world
    await page.check("input[name=layout][value=pn]");
    const box = await page.locator("#canvas").boundingBox();
    const front = (await picture()).pixels.reduce((best, pixel) => (pixel.depth < best.depth ? pixel : best));
    const at = [box.x + box.width / 2 + front.x, box.y + box.height / 2 + front.y];
    await page.mouse.move(...at);
    await page.mouse.down();
    await page.mouse.move(at[0] + 10, at[1] - 20, { steps: 5 });
    await page.mouse.up();
    const moved = (await picture()).points.map((p, i) => p - far.points[i]);
    const length = Math.hypot(...moved);
    assert.ok(length > 0.01 && length < 1, `moved by ${length}`);
  });
});

test("numbers that do not fit into 32 bits are out of range, not small", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    const triangle = "0 0 0\n1 0 0\n0 1 0\n";
    for (const [name, content, expected] of [
      ["index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967299\n", /4294967299 is out of range/],
      ["index.off", `OFF\n3 1 0\n${triangle}3 0 1 4294967298\n`, /4294967298 is out of range/],
      ["vertices.off", `OFF\n4294967299 1 0\n${triangle}3 0 1 2\n`, /the number of vertices is too large: 4294967299/],
      ["faces.off", `OFF\n3 4294967297 0\n${triangle}3 0 1 2\n`, /the number of faces is too large: 4294967297/],
      ["count.ply", "ply\nformat ascii 1.0\nelement vertex 4294967299\nproperty double x\nproperty double y\n" +
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
        `${triangle}3 0 1 2\n`, /the number of elements is too large: 4294967299/],
    ]) {
      await page.evaluate(() => (document.getElementById("message").hidden = true));
      await drop(page, name, content);
      assert.match(await message(page), expected);
      assert.notEqual(await page.evaluate(() => window.page.editor.name), name);
    }
  });
});

test("back and forward lead through what was looked at", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    const name = () => page.evaluate(() => window.page.editor.name);
    const settle = () => page.waitForTimeout(700); // an address is written a while after the last change
    await settle();
    const length = await page.evaluate(() => history.length);
    await page.focus("#canvas");
    await page.keyboard.press("ArrowLeft"); // the same place, seen from elsewhere
    await settle();
    assert.equal(await page.evaluate(() => history.length), length);
    await page.selectOption("#example", "bolt");
    await settle();
    await page.click("#tab-curve");
    await settle();
    assert.equal(await page.evaluate(() => history.length), length + 2);
    await page.goBack();
    await page.waitForFunction(() => !document.getElementById("surface").hidden);
    assert.equal(await name(), "bolt");
    await settle();
    await page.goBack();
    await page.waitForFunction(() => window.page.editor.name === "ring");
    await settle();
    await page.goForward();
    await page.waitForFunction(() => window.page.editor.name === "bolt");
    await settle();
    await page.goForward();
    await page.waitForFunction(() => !document.getElementById("curve").hidden);
    assert.equal(await page.evaluate(() => history.length), length + 2);
  });
});

test("a link of a newer page is refused, and a large mesh has no address", async () => {
  const packed = (value) => deflateRawSync(JSON.stringify(value)).toString("base64url");
  await withPage(file, { hash: `#ring=${packed({ version: 1000 })}` }, async (page) => {
    assert.equal(await message(page), "The link cannot be read: it is of a newer version of this page.");
    const n = 120;
    const vertices = Array.from({ length: (n + 1) ** 2 }, (_, i) => `${i % (n + 1)} ${Math.floor(i / (n + 1))} 0`);
    const faces = Array.from({ length: n * n }, (_, i) => {
      const a = (n + 1) * Math.floor(i / n) + (i % n);
      return `4 ${a} ${a + 1} ${a + n + 2} ${a + n + 1}`;
    });
    await drop(page, "large.off", `OFF\n${vertices.length} ${faces.length} 0\n${vertices.join("\n")}\n${faces.join("\n")}\n`);
    await page.waitForFunction(() => window.page.editor.name === "large.off");
    await page.waitForTimeout(700);
    assert.equal(new URL(page.url()).hash, "");
    await page.click("#copy-link");
    assert.match(await message(page), /too large for a link/);
  });
});

test("curvature is computed once for a surface", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    await page.fill("#rounds", "2");
    const times = await page.evaluate(() => {
      const surface = window.page.editor.shownSurface;
      const timeOf = (isGaussian) => {
        const started = performance.now();
        const values = surface.curvature(isGaussian);
        return [performance.now() - started, Array.from(values)];
      };
      return [timeOf(true), timeOf(false), timeOf(true)];
    });
    assert.ok(times[1][0] + times[2][0] < 0.2 * times[0][0], times.map((t) => t[0]).join(" "));
    assert.deepEqual(times[0][1], times[2][1]);
    assert.notDeepEqual(times[0][1], times[1][1]);
    const changed = await page.evaluate(() => {
      const { editor } = window.page;
      const [x, y, z] = editor.handles.points;
      editor.setPoint(0, x, y, z + 0.1);
      return Array.from(editor.shownSurface.curvature(true));
    });
    assert.notDeepEqual(changed, times[0][1]);
  });
});

test("without WebGL curves work, and a lost context comes back", async () => {
  await withPage(file, { webgl: false }, async (page) => {
    assert.match(await message(page), /WebGL/);
    assert.ok(!(await page.isHidden("#curve")));
    await page.waitForSelector("#drawing .curve", { state: "attached" });
    await page.click("#tab-surface");
    await page.selectOption("#example", "ring");
    assert.ok((await points(page)).length > 0);
  });
  await withPage(file, { hash: "#ring" }, async (page) => {
    const picture = () => page.evaluate(async () => {
      const { viewer } = window.page.editor;
      return [...new Uint8Array(await (await viewer.png()).arrayBuffer())];
    });
    const before = await picture();
    await loseContext(page);
    assert.deepEqual(await picture(), before);
  });
});

test("the picture has the pixels of the screen", { skip: chromiumOnly }, async () => {
  await withPage(file, { hash: "#ring" }, async (page, context) => {
    const width = () => page.evaluate(() => window.page.editor.viewer.canvas.width);
    const one = await width();
    const client = await context.newCDPSession(page);
    await client.send("Emulation.setDeviceMetricsOverride", { width: 1280, height: 800, deviceScaleFactor: 2, mobile: false });
    await page.evaluate(() => window.page.editor.viewer.draw());
    assert.equal(await width(), 2 * one);
  });
});
