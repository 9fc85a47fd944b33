// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The first view, the pictures, the slider, roundness, what the formula does, and the command for what is on the screen:
//   node --test test_pictures.mjs      with PN_PAGE, the HTML file, and PN_SUBDIVIDE, the command, in the environment
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { withPage } from "./browser.mjs";
import { download as downloadTo, drop, largestDifference, middleOf, points, readPly } from "./page_actions.mjs";

const file = path.resolve(process.env.PN_PAGE);
const command = path.resolve(process.env.PN_SUBDIVIDE);
const meshes = path.resolve(import.meta.dirname, "../../../data/meshes");
let folder;
before(async () => (folder = await mkdtemp(path.join(tmpdir(), "pn-page-test-"))));
after(() => rm(folder, { recursive: true }));

const download = (page, button) => downloadTo(page, button, folder);
const native = async (words) => {
  const output = path.join(folder, "native.ply");
  execFileSync(command, ["surface", words[0], output, "--quiet", ...words.slice(1)]);
  return readPly(await readFile(output));
};
const state = (page) => page.evaluate(() => {
  const { settings, name, viewer, mesh } = window.page.editor;
  return { ...settings, name, camera: viewer.direction, roundness: Array.from(mesh.state().roundness ?? []) };
});
const near = (ours, theirs) => {
  const size = Math.max(...theirs.map(Math.abs));
  const difference = largestDifference(ours, theirs) / size;
  assert.ok(difference < 1e-12, `vertices differ by ${difference}`);
};

// --- the first view ---

test("the first view says what it is about, and its normal can be turned", async () => {
  await withPage(file, {}, async (page) => {
    assert.match(await page.textContent("#caption"), /^Eight points, twice\. .+ sphere/);
    assert.ok(await page.isVisible("#caption"));
    assert.equal((await state(page)).shading, "relative");
    // Gaussian curvatures over their average
    const spread = await page.evaluate(() => [true, false].map((isLinear) => {
      const values = [...window.page.editor.surface(isLinear).curvature(true)];
      const mean = values.reduce((sum, x) => sum + x, 0) / values.length;
      return [Math.min(...values) / mean, Math.max(...values) / mean];
    }));
    assert.ok(spread[0][0] < 0.75 && spread[0][1] > 1.3, `linear ${spread[0]}`);
    assert.ok(spread[1][0] > 0.99 && spread[1][1] < 1.01, `point-normal ${spread[1]}`);
    // what is drawn: the right half is blank, the left one is not
    const colors = await page.evaluate(async () => {
      const { viewer } = window.page.editor;
      const picture = await createImageBitmap(await viewer.png());
      const canvas = new OffscreenCanvas(picture.width, picture.height);
      const context = canvas.getContext("2d");
      context.drawImage(picture, 0, 0);
      return [0.25, 0.75].map((share) => {
        const size = 0.08 * picture.width;
        const { data } = context.getImageData(share * picture.width - size, picture.height / 2 - size, 2 * size, 2 * size);
        let colored = 0;
        for (let i = 0; i < data.length; i += 4)
          if (Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 40) ++colored;
        return (4 * colored) / data.length;
      });
    });
    assert.ok(colors[0] > 0.3 && colors[1] < 0.1, `${colors}`);
    assert.match(await page.textContent("#status"), /radii about the best sphere: linear ±[\d.]+ %, point-normal ±[2-9]?\d?e-1\d/);
    // the sign is at a tip that can be taken hold of
    assert.ok(await page.isVisible("#turn-me span"));
    const at = await page.evaluate(() => {
      const { left, top } = document.getElementById("turn-me").getBoundingClientRect();
      return [left, top];
    });
    const start = await points(page);
    await page.mouse.move(...at);
    await page.mouse.down();
    await page.mouse.move(at[0] + 20, at[1] - 25, { steps: 4 });
    await page.mouse.up();
    assert.ok(largestDifference(await points(page), start) > 1e-3);
    await page.waitForFunction(() => document.getElementById("turn-me").hidden);
  });
});

test("radii are about the sphere that fits best, also of uneven points", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    // an octahedron whose upper half is wider than the lower one, about (5, 0, 0)
    const rings = [0.3, 1.9, 3.1, 4.9].map((a, i) => [0.95 * Math.cos(a), 0.95 * Math.sin(a), Math.sqrt(1 - 0.95 ** 2) * (i % 2 ? 1 : 0.99)]);
    const points3 = [...rings, [0, 0, 1], [0.1, 0, -1]].map((p) => p.map((x) => x / Math.hypot(...p)));
    const faces = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]];
    await drop(page, "uneven.off", `OFF\n6 8 0\n${points3.map(([x, y, z]) => `${5 + x} ${y} ${z}`).join("\n")}\n` +
      `${faces.map((face) => `3 ${face.join(" ")}`).join("\n")}\n`);
    await page.waitForFunction(() => window.page.editor.name === "uneven.off");
    await page.click("#normals-sphere");
    const [linear, pn] = (await page.textContent("#status")).match(/linear ±(\S+) %, point-normal ±(\S+)$/).slice(1).map(Number);
    assert.ok(linear > 1 && pn < 1e-11, `${linear} ${pn}`);
  });
});

test("each picture has its camera, shading and overlays", async () => {
  await withPage(file, {}, async (page) => {
    const seen = [];
    for (const name of ["bolt", "waves", "ring", "head", "cube"]) {
      await page.click(`#picture-${name}`);
      assert.equal(await page.getAttribute(`#picture-${name}`, "aria-pressed"), "true");
      assert.ok((await page.textContent("#caption")).length > 20);
      const now = await state(page);
      assert.ok(now.name.startsWith(name));
      seen.push(now.camera.map((x) => x / Math.hypot(...now.camera)).map((x) => x.toFixed(3)).join());
      assert.equal(await page.isVisible("#split"), now.layout === "split");
      assert.ok(await page.evaluate((n) => document.querySelector(`#picture-${n} img`).naturalWidth >= 120, name));
    }
    assert.equal(new Set(seen).size, seen.length, seen.join(" "));
    await page.click("#picture-bottle");
    assert.ok(await page.isVisible("#curve"));
    assert.equal(await page.inputValue("#curve-example"), "bottle");
    await page.click("#tab-surface");
    await page.selectOption("#example", "torus");
    assert.ok(await page.isHidden("#caption"));
    assert.equal(await page.getAttribute("#picture-cube", "aria-pressed"), "false");
    // the browser goes back to the picture, with its sentence
    await page.waitForTimeout(700);
    await page.click("#picture-waves");
    await page.waitForTimeout(700);
    await page.selectOption("#example", "torus");
    await page.waitForTimeout(700);
    await page.goBack();
    await page.waitForFunction(() => window.page.editor.name === "waves");
    assert.match(await page.textContent("#caption"), /one plane/);
  });
});

test("a slider moves between linear and point-normal over one view", async () => {
  await withPage(file, { hash: "#picture-bolt" }, async (page) => {
    await page.evaluate(() => (window.pictures = {}));
    const keep = (name) => page.evaluate(async (n) => {
      await window.page.editor.settled();
      const picture = await createImageBitmap(await window.page.editor.viewer.png());
      const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
      context.drawImage(picture, 0, 0);
      window.pictures[n] = context.getImageData(0, 0, picture.width, picture.height).data;
    }, name);
    /** The share of pixels that differ. */
    const difference = (...names) => page.evaluate((both) => {
      const [a, b] = both.map((name) => window.pictures[name]);
      let different = 0;
      for (let i = 0; i < a.length; i += 4) if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > 8)) ++different;
      return (4 * different) / a.length;
    }, names);
    const box = await page.locator("#canvas").boundingBox();
    const sideAt = (share) => page.evaluate((x) => window.page.editor.viewer.toPane(x, 300).isLinear, share * box.width);
    assert.deepEqual([await sideAt(0.45), await sideAt(0.55)], [true, false]);
    const slider = await page.locator("#split").boundingBox();
    const y = slider.y + slider.height / 2;
    await page.mouse.move(slider.x + slider.width / 2, y);
    await page.mouse.down();
    await page.mouse.move(slider.x + 0.8 * slider.width, y, { steps: 5 });
    await page.mouse.up();
    const { split } = await state(page);
    assert.ok(Math.abs(split - 0.8) < 0.02, `${split}`);
    assert.deepEqual([await sideAt(0.78), await sideAt(0.82)], [true, false]);
    // beside the thumb the view turns
    const camera = (await state(page)).camera;
    await page.mouse.move(slider.x + 0.3 * slider.width, y);
    await page.mouse.down();
    await page.mouse.move(slider.x + 0.4 * slider.width, y, { steps: 5 });
    await page.mouse.up();
    assert.notDeepEqual((await state(page)).camera, camera);
    for (const share of ["0", "0.5", "1"]) {
      await page.fill("#split", share);
      await keep(share);
    }
    for (const layout of ["pn", "linear"]) {
      await page.check(`input[name=layout][value=${layout}]`);
      await keep(layout);
    }
    assert.ok((await difference("0", "pn")) < 1e-4 && (await difference("1", "linear")) < 1e-4);
    assert.ok((await difference("pn", "linear")) > 1e-3 && (await difference("0.5", "pn")) > 1e-4);
  });
});

test("faces are flat or smooth, and smooth ones have the normals of the limit where it is shown", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    /** The largest difference of neighboring pixels inside the surface, along the middle row. */
    const jump = () => page.evaluate(async () => {
      const picture = await createImageBitmap(await window.page.editor.viewer.png());
      const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
      context.drawImage(picture, 0, 0);
      const { data } = context.getImageData(0, picture.height / 2, picture.width, 1);
      const green = Array.from({ length: picture.width }, (_, i) => data[4 * i + 1]);
      const inside = [...green.keys()].filter((i) => green[i] !== green[0]);
      const line = green.slice(inside[0] + 4, inside.at(-1) - 4);
      return Math.max(...line.slice(1).map((x, i) => Math.abs(x - line[i])));
    });
    await page.evaluate(() => window.page.editor.set({ rounds: 0, layout: "pn", showControl: false, showNormals: false }));
    assert.ok((await jump()) < 6);
    await page.check("#flat");
    assert.ok((await jump()) > 15);
    await page.uncheck("#flat");
    assert.ok((await jump()) < 6);
    // at the limit a sphere's are those of the sphere, which those of the faces are not
    await page.selectOption("#example", "tetrahedron");
    await page.evaluate(() => window.page.editor.set({ rounds: 1 }));
    const turned = () => page.evaluate(async () => {
      const { positions, drawnNormals: n } = await window.page.editor.content();
      const at = (k, of) => [...of.slice(k, k + 3)];
      const center = [0, 1, 2].map((k) => positions.reduce((sum, x, i) => (i % 3 === k ? sum + x : sum), 0) / (positions.length / 3));
      return Math.max(...Array.from({ length: n.length / 3 }, (_, i) => {
        const radius = at(3 * i, positions).map((x, k) => x - center[k]);
        const cosine = at(3 * i, n).reduce((sum, x, k) => sum + x * radius[k], 0) / Math.hypot(...radius);
        return Math.acos(Math.min(1, cosine));
      }));
    });
    await page.check("#limit");
    const limit = await turned();
    assert.ok(limit < 0.02, `${limit}`);
  });
});

// --- roundness ---

test("the surface has the roundness of the slider, as the command has it", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    await page.fill("#rounds", "3");
    const given = await download(page, "#save-control");
    const round = await points(page);
    for (const w of ["0.4", "0"]) {
      await page.fill("#roundness", w);
      near(await points(page), (await native([given, "--levels", "3", "--roundness", w])).points);
      assert.equal(await page.textContent("#roundness-value"), Number(w).toFixed(2));
    }
    const linear = await page.evaluate(() => window.page.editor.content(true).then(({ points }) => Array.from(points)));
    assert.equal(largestDifference(await points(page), linear), 0, "roundness 0 is linear subdivision, bit for bit");
    for (let i = 0; i < 2; ++i) await page.click("#undo");
    assert.equal(largestDifference(await points(page), round), 0);
    assert.ok(await page.isDisabled("#undo"), "a slider that moves is one change");
    await page.click("#roundness-estimate");
    near(await points(page), (await native([given, "--levels", "3", "--roundness", "estimate"])).points);
  });
});

test("files without normals get those and the roundness of the command, and keep them", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.fill("#rounds", "2");
    const ours = await points(page);
    near(ours, (await native([path.join(meshes, "head.obj"), "--scheme", "catmull-clark", "--levels", "2"])).points);
    assert.equal(await page.textContent("#roundness-value"), "varies");
    const { roundness } = await state(page);
    const mean = roundness.reduce((sum, w) => sum + w) / roundness.length;
    assert.ok(Math.abs(Number(await page.inputValue("#roundness")) - mean) < 0.01, "the slider is at their mean");
    assert.ok(Math.min(...roundness) < 0.5 && Math.max(...roundness) > 0.5);
    // in the control mesh, in the surface, in a link
    const control = await download(page, "#save-control");
    assert.deepEqual(readPly(await readFile(control)).roundness, roundness);
    near(ours, (await native([control, "--scheme", "catmull-clark", "--levels", "2"])).points);
    const surface = readPly(await readFile(await download(page, "#save-surface")));
    assert.equal(surface.roundness.length, surface.vertices);
    const theirs = await native([control, "--scheme", "catmull-clark", "--levels", "2", "--output-normals", "control"]);
    assert.ok(largestDifference(surface.roundness, theirs.roundness) < 1e-14);
    await page.click("#roundness-one");
    await page.waitForTimeout(800);
    const rounder = await points(page);
    assert.ok(largestDifference(rounder, ours) > 1e-3);
    const { hash } = new URL(page.url());
    await page.selectOption("#example", "cube");
    await page.waitForTimeout(800);
    await page.evaluate((h) => (location.hash = h), hash);
    await page.waitForFunction(() => window.page.editor.name === "head");
    assert.equal(largestDifference(await points(page), rounder), 0);
    await drop(page, "again.ply", await readFile(control));
    await page.waitForFunction(() => window.page.editor.name === "again.ply");
    await page.fill("#rounds", "2");
    assert.equal(largestDifference(await points(page), ours), 0);
  });
});

test("limit points follow the roundness", async () => {
  await withPage(file, { hash: "#creature" }, async (page) => {
    await page.fill("#rounds", "1");
    await page.check("input[name=layout][value=pn]");
    await page.fill("#roundness", "0.3");
    await page.check("#limit");
    const control = await download(page, "#save-control");
    const theirs = (await native([control, "--levels", "1", "--limit", "--surface-normals", "--limit-tolerance", "1e-7"])).points;
    near(await points(page), theirs);
  });
});

test("the roundness of a curve is that of the command", async () => {
  await withPage(file, { hash: "#picture-bottle" }, async (page) => {
    await page.fill("#curve-roundness", "0.35");
    await page.waitForTimeout(200);
    const polygon = await download(page, "#save-text");
    const curve = path.join(folder, "curve.txt");
    execFileSync(command, ["curve", polygon, curve, "--quiet", "--closed", "--scheme", "bspline:3", "--levels", "6", "--roundness", "0.35"]);
    const theirs = (await readFile(curve, "utf8")).trim().split("\n").filter((l) => !l.startsWith("#"))
      .flatMap((line) => line.split(/\s+/).slice(0, 2).map(Number));
    near(await page.evaluate(() => Array.from(window.page.curve.shownCurve.points)), theirs);
  });
});

// --- without this page ---

test("the command that is shown makes what is shown", async () => {
  const run = async (page) => {
    await page.click("#recipe");
    const words = (await page.textContent("#recipe-command")).split(" ");
    const program = await page.textContent("#recipe-program");
    await page.keyboard.press("Escape");
    await download(page, "#save-control");
    execFileSync(command, words.slice(1), { cwd: folder, stdio: "pipe" });
    near(await points(page), readPly(await readFile(path.join(folder, words[3]))).points);
    return program;
  };
  await withPage(file, { hash: "#picture-head" }, async (page) => {
    assert.match(await run(page), /subdivide\(mesh, PN::CatmullClark_scheme\(\),\n +PN::parameters::vertex_roundness_map\(roundness\)\n +\.number_of_iterations\(3\)/);
    await page.check("input[name=layout][value=linear]");
    assert.match(await run(page), /PN::linear\(PN::CatmullClark_scheme\(\)\),\n +CGAL::parameters::number_of_iterations\(3\)\);/);
  });
  await withPage(file, { hash: "#bolt" }, async (page) => {
    await page.fill("#rounds", "2");
    await page.fill("#roundness", "0.7");
    assert.match(await run(page), /roundness\(0\.7\)\s+\.[^]+edge_is_constrained_map\(creases\)/);
  });
});

// --- the formula ---

test("what the formula does is what the package does", async () => {
  await withPage(file, { hash: "#formula" }, async (page) => {
    assert.ok(await page.isVisible("#formula-drawing"));
    const polygon = () => page.evaluate(() => window.page.formula.polygon.map(({ p, n }) => [...p, ...n]));
    // the edge point of two points with cubic splines is their mean
    const compare = async (roundness) => {
      await page.click("#formula-first:not(:disabled)").catch(() => {});
      await page.evaluate(() => document.getElementById("formula-next").click());
      const [a, middle, b] = await polygon();
      const theirs = await page.evaluate(([ends, w]) => {
        const curve = window.page.modeler.refineCurve(Float64Array.from(ends.flatMap((e) => e.slice(0, 2))),
          Float64Array.from(ends.flatMap((e) => e.slice(2))), "bspline:3", false, false, 1, w);
        return [...curve.points.slice(2, 4), ...curve.normals.slice(2, 4)];
      }, [[a, b], roundness]);
      assert.ok(largestDifference(middle, theirs) < 1e-14, `${middle} and ${theirs}`);
      const shown = (await page.textContent("#formula-p")).match(/-?[\d.]+/g).map(Number);
      assert.ok(largestDifference(shown, theirs.slice(0, 2)) < 6e-4);
    };
    await page.evaluate(() => document.getElementById("formula-next").click());
    await compare(1);
    await page.fill("#formula-roundness", "0.5");
    await compare(0.5);
    await page.click("#formula-reset");
    // a normal that is dragged, also to nearly opposite ones
    for (const [dx, dy] of [[60, 30], [-30, 160], [-40, 30]]) {
      const at = await middleOf(page, "#formula-drawing .hold[data-handle='3']");
      await page.mouse.move(...at);
      await page.mouse.down();
      await page.mouse.move(at[0] + dx, at[1] + dy, { steps: 4 });
      await page.mouse.up();
      await page.evaluate(() => document.getElementById("formula-first").click());
      await page.evaluate(() => document.getElementById("formula-next").click());
      await compare(1);
    }
    // a normal that is nearly opposite to the new one takes no part, or less; Chaikin's points are at a quarter
    for (const degrees of [120, 150, 155, 170]) {
      const [ours, theirs] = await page.evaluate((angle) => {
        const { formula, modeler } = window.page;
        formula.ends = [{ p: [-2, -0.6], n: [0, 1] }, { p: [2, 0.3], n: [Math.sin(angle), Math.cos(angle)] }];
        document.getElementById("formula-share").value = "0.25";
        formula.rounds = 1;
        formula.draw();
        const ends = formula.ends;
        const curve = modeler.refineCurve(Float64Array.from(ends.flatMap(({ p }) => p)), Float64Array.from(ends.flatMap(({ n }) => n)),
          "bspline:2", false, false, 1, 1);
        return [formula.polygon[1].p, Array.from(curve.points)];
      }, (degrees * Math.PI) / 180);
      const distances = Array.from({ length: theirs.length / 2 }, (_, i) => Math.hypot(ours[0] - theirs[2 * i], ours[1] - theirs[2 * i + 1]));
      assert.ok(Math.min(...distances) < 1e-14, `${degrees} degrees: ${ours} is none of ${theirs}`);
    }
    // one circle stays one circle, from round to round
    await page.click("#formula-reset");
    await page.click("#formula-circle");
    for (let i = 0; i < 5; ++i) await page.click("#formula-next");
    const all = await polygon();
    assert.equal(all.length, 33);
    const [first, last] = [all[0], all.at(-1)];
    // centers are on all lines along normals
    const determinant = first[2] * last[3] - first[3] * last[2];
    const s = ((last[0] - first[0]) * last[3] - (last[1] - first[1]) * last[2]) / determinant;
    const center = [first[0] + s * first[2], first[1] + s * first[3]];
    for (const [x, y] of all) assert.ok(Math.abs(Math.hypot(x - center[0], y - center[1]) - Math.abs(s)) < 1e-13 * Math.abs(s));
    const heights = await Promise.all(["#formula-h0", "#formula-h1"].map((id) => page.textContent(id)));
    assert.equal(heights[0], heights[1]);
    // keys
    await page.click("#formula-reset");
    await page.focus("#formula-drawing");
    const start = (await polygon())[0];
    await page.keyboard.press("n");
    await page.keyboard.press("ArrowUp");
    const moved = (await polygon())[0];
    assert.ok(Math.abs(moved[1] - start[1] - 0.1) < 1e-12 && moved[0] === start[0]);
    assert.equal(await page.textContent("#announcement"), "point 0");
  });
});
