// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The page in a browser, against the command pn_subdivide, which is compiled natively and shares nothing with the
// browser but the headers:
//   node --test test_page.mjs      with PN_PAGE, the HTML file, and PN_SUBDIVIDE, the command, in the environment
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { brotliCompressSync, deflateRawSync } from "node:zlib";
import { chromiumOnly, withPage } from "./browser.mjs";
import { download as downloadTo, drop, frontWedge, largestDifference, message, points, readPly, tipOf } from "./page_actions.mjs";

const file = path.resolve(process.env.PN_PAGE);
const command = path.resolve(process.env.PN_SUBDIVIDE);
let folder;
let largest = 0; // difference from the command, in sizes of the surface
before(async () => (folder = await mkdtemp(path.join(tmpdir(), "pn-page-test-"))));
after(() => {
  console.log(`largest difference between the page and the command: ${largest}`);
  return rm(folder, { recursive: true });
});

const download = (page, button) => downloadTo(page, button, folder);

/** The surface of the page and that of the command, from the control mesh that the page exports. */
async function compareWithCommand(page, options) {
  const control = await download(page, "#save-control");
  const surface = await download(page, "#save-surface");
  const native = path.join(folder, "native.ply");
  execFileSync(command, ["surface", control, native, "--quiet", ...options]);
  const [ours, theirs] = [readPly(await readFile(surface)), readPly(await readFile(native))];
  assert.equal(ours.faces, theirs.faces);
  const size = Math.max(...theirs.points.map(Math.abs));
  const difference = largestDifference(ours.points, theirs.points) / size;
  largest = Math.max(largest, difference);
  assert.ok(difference < 1e-12, `vertices differ by ${difference}`);
  return ours;
}

// --- the tests ---

test("the file is small, and holds everything", async () => {
  const sent = brotliCompressSync(await readFile(file)).length;
  assert.ok(sent <= 800_000, `${sent} bytes, compressed by brotli`);
  await withPage(file, {}, async (page) => {
    const others = await page.$$eval("[src], link[href]", (all) => all.map((e) => e.src ?? e.href));
    assert.deepEqual(others.filter((address) => !address.startsWith("data:")), []);
  });
});

test("dragging a normal moves the vertices that the command computes", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    await compareWithCommand(page, ["--scheme", "catmull-clark", "--levels", "4"]);
    const start = await points(page);
    const wedge = await frontWedge(page);
    const tip = await tipOf(page, wedge);
    await page.mouse.move(tip.x, tip.y);
    await page.mouse.down();
    await page.mouse.move(tip.x + 9, tip.y - 14, { steps: 4 });
    await page.mouse.move(tip.x + 17, tip.y - 30, { steps: 4 });
    await page.mouse.up();
    const ours = await compareWithCommand(page, ["--scheme", "catmull-clark", "--levels", "4"]);
    const moved = ours.points.filter((x, i) => x !== start[i]).length / 3;
    assert.ok(moved > 100 && moved < 0.6 * ours.vertices, `${moved} of ${ours.vertices} vertices moved`);
    assert.ok(largestDifference(ours.points, start) > 1e-3);
    await page.click("#undo");
    assert.equal(largestDifference(await points(page), start), 0);
    await page.click("#redo");
    assert.equal(largestDifference(await points(page), ours.points), 0);
  });
});

test("all schemes, linear and point-normal, make what the command makes", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    const schemes = await page.$$eval("#scheme option", (options) => options.map((o) => o.value));
    assert.equal(schemes.length, 12);
    await page.fill("#rounds", "3");
    for (const scheme of schemes)
      for (const layout of ["pn", "linear"]) {
        await page.selectOption("#scheme", scheme);
        await page.check(`input[name=layout][value=${layout}]`);
        await compareWithCommand(page,
          ["--scheme", scheme, "--levels", "3", ...(layout === "linear" ? ["--linear"] : [])]);
      }
  });
});

test("every scheme takes every roundness: made, at the limit, saved, turned", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    const slide = (w) => page.fill("#roundness", String(w));
    for (const scheme of await page.$$eval("#scheme option", (options) => options.map((o) => o.value))) {
      await page.selectOption("#example", "cube");
      await page.selectOption("#scheme", scheme);
      await page.fill("#rounds", "1");
      await page.evaluate(() => (document.getElementById("message").hidden = true)); // of faces that were split
      for (const act of [() => slide(0), () => slide(1), () => page.click("#roundness-estimate"), () => slide(0.5)]) {
        await act();
        await page.evaluate(() => window.page.editor.setNormal(0, 1, 2, 3));
        const start = await points(page);
        if (await page.isEnabled("#limit")) {
          await page.evaluate(() => window.page.editor.set({ limit: true }));
          assert.ok(largestDifference(await points(page), start) < 1); // and no NaN
          await page.evaluate(() => window.page.editor.set({ limit: false }));
        }
        assert.ok(await page.isHidden("#message"), `${scheme}: ${await page.textContent("#message span")}`);
        const label = Number(await page.textContent("#roundness-value"));
        assert.ok(Number.isNaN(label) || label === Number(await page.inputValue("#roundness")));
        await compareWithCommand(page, ["--scheme", scheme, "--levels", "1"]);
      }
    }
  });
});

test("an error that nobody has caught becomes a message", async () => {
  for (const act of ["setTimeout(() => { throw new Error('on purpose'); })", "Promise.reject(new Error('on purpose')), 0"])
    await assert.rejects(withPage(file, { hash: "#ring" }, async (page) => {
      await page.evaluate(act);
      assert.equal(await message(page), "This did not work: on purpose.");
      assert.equal(await page.getAttribute("#message", "role"), "alert");
      await page.selectOption("#example", "cube"); // the page goes on
      assert.ok(await page.isHidden("#message"));
    }), /the page reported: .*on purpose/);
});

test("a cube with the normals of a sphere is a sphere", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    const p = await points(page);
    let worst = 0;
    for (let i = 0; i < p.length; i += 3)
      worst = Math.max(worst, Math.abs(Math.hypot(p[i], p[i + 1], p[i + 2]) / Math.hypot(p[0], p[1], p[2]) - 1));
    assert.ok(worst < 4e-15, `off by ${worst}`);
  });
});

test("creases are what the command makes of them", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.fill("#rounds", "3");
    await page.fill("#angle", "50");
    await page.click("#detect");
    assert.match(await message(page), /^\d+ edges are sharp\.$/);
    await page.click("#normals-estimate");
    await compareWithCommand(page,
      ["--scheme", "catmull-clark", "--levels", "3", "--sharp", "angle:50", "--normals", "estimate"]);
    const sharp = () => page.evaluate(() => window.page.editor.mesh.numberOfSharpEdges());
    const before = await sharp();
    // by a click on an edge that is not sharp
    await page.click("#mark");
    const at = await page.evaluate(() => {
      const { handles, viewer } = window.page.editor;
      const box = viewer.canvas.getBoundingClientRect();
      const p = viewer.camera.position.clone();
      let best = { depth: Infinity };
      for (let e = 0; e < handles.sharp.length; ++e) {
        if (handles.sharp[e] || handles.border[e]) continue;
        p.fromArray([0, 1, 2].map((k) =>
          (handles.points[3 * handles.edges[2 * e] + k] + handles.points[3 * handles.edges[2 * e + 1] + k]) / 2));
        const { x, y, depth } = viewer.toPixels(p);
        if (depth < best.depth) best = { depth, x: box.left + 0.75 * box.width + x, y: box.top + box.height / 2 + y };
      }
      return best;
    });
    await page.mouse.click(at.x, at.y);
    assert.equal(await sharp(), before + 1);
    await page.click("#creases-clear");
    assert.equal(await sharp(), 0);
  });
});

test("parts have the creases of their files", async () => {
  await withPage(file, { hash: "#bolt" }, async (page) => {
    assert.ok((await page.evaluate(() => window.page.editor.mesh.numberOfSharpEdges())) > 20);
    const surface = readPly(await readFile(await download(page, "#save-surface")));
    const native = path.join(folder, "bolt.ply");
    const part = path.resolve(import.meta.dirname, "../../../data/meshes/parts/bolt");
    execFileSync(command, ["surface", `${part}.obj`, native, "--quiet", "--levels", "4",
      "--sharp", `${part}.selection.txt`]);
    const theirs = readPly(await readFile(native));
    assert.ok(largestDifference(surface.points, theirs.points) < 1e-12);
  });
});

test("limit points are those of the command", async () => {
  await withPage(file, { hash: "#creature" }, async (page) => {
    await page.fill("#rounds", "2");
    await page.check("input[name=layout][value=pn]");
    await page.check("#limit");
    const ours = await points(page);
    const control = await download(page, "#save-control");
    const native = path.join(folder, "limit.ply");
    execFileSync(command, ["surface", control, native, "--quiet", "--levels", "2", "--limit", "--surface-normals",
      "--limit-tolerance", "1e-7"]);
    const theirs = readPly(await readFile(native)).points;
    assert.ok(largestDifference(ours, theirs) < 1e-12 * Math.max(...theirs.map(Math.abs)));
    await page.uncheck("#limit");
    assert.ok(largestDifference(await points(page), ours) > 1e-4);
  });
});

test("bad files are refused in one line, and nothing is lost", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    const start = await points(page);
    const bad = {
      "damaged.ply": ["ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nend_header\n0\n", /damaged\.ply: .+/],
      "index.off": ["OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", /index\.off: .*7/],
      "moebius.off": ["OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 1 2\n", /moebius\.off: this is no oriented manifold: .*edge/],
      "nan.obj": ["v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", /nan\.obj: .+/],
      "empty.stl": ["", /empty\.stl: the file is empty/],
      "picture.gif": ["GIF89a", /picture\.gif: the file name must end in one of/],
    };
    for (const [name, [content, expected]] of Object.entries(bad)) {
      await page.evaluate(() => (document.getElementById("message").hidden = true));
      await drop(page, name, content);
      const line = await message(page);
      assert.match(line, expected);
      assert.ok(!line.includes("\n") && !line.includes("--"), line);
      assert.equal(await page.getAttribute("#message", "role"), "alert");
    }
    assert.equal(largestDifference(await points(page), start), 0);
    assert.ok(await page.isDisabled("#undo"));
    // a scheme that cannot take the mesh
    await page.selectOption("#example", "tetrahedron");
    await page.selectOption("#scheme", "kobbelt");
    assert.match(await message(page), /face 0/);
    assert.equal(await page.inputValue("#scheme"), "loop");
  });
});

test("one's own file: what it is, and what can be done", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    const open = async (name, content) => {
      await drop(page, name, content);
      await page.waitForFunction((n) => window.page.editor.name === n, name);
      return (await page.textContent("#about")).replace(/\s+/g, " ");
    };
    const corner = (i) => `${i & 1} ${(i >> 1) & 1} ${i >> 2}`;
    const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    const triangles = quads.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);
    const stl = "solid cube\n" + triangles.map((f) => "facet normal 0 0 0\nouter loop\n" +
      f.map((v) => `vertex ${corner(v)}\n`).join("") + "endloop\nendfacet\n").join("") + "endsolid cube\n";
    const about = await open("cube.stl", stl);
    const below = await page.evaluate(() => window.page.editor.mesh.state().roundness.filter((w) => w < 1).length);
    assert.ok(below > 0);
    assert.equal(about, `12 faces. Normals estimated from the points. Roundness below 1 at ${below} of 8 vertices: Make it 1`);
    await page.click("#about button");
    assert.equal(await page.textContent("#about"), "12 faces. Normals estimated from the points.");
    assert.equal(await page.evaluate(() => window.page.editor.roundness), 1);
    await page.click("#undo");
    assert.equal(await page.textContent("#about"), about);
    const square = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nvt 0 0\n";
    assert.match(await open("square.obj", `${square}g part\nusemtl red\nf 1/1 2/1 3/1 4/1\n`),
      /^1 face\. Normals estimated from the points\. Not kept: materials, texture coordinates, groups, colors\./);
    const off = (after) => `OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2${after}\n`;
    assert.match(await open("colored.off", off(" 255 0 0")), /Not kept: colors\./);
    assert.doesNotMatch(await open("plain.off", off("")), /Not kept/);
    assert.match(await open("colored.stl", stl.replace("cube", "COLOR=red")), /Not kept: colors\./);
    const normals = "vn 0 0.6 0.8\nvn 0 0 1\nvn 0.6 0 0.8\n";
    assert.match(await open("normals.obj", `${square}${normals}f 1//1 2//2 3//3 4//1\n`), /Normals of the file\./);
  });
});

test("what is no manifold is repaired if that is asked for, as by the command", async () => {
  const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  const corner = (i) => `${i & 1} ${(i >> 1) & 1} ${i >> 2}`;
  const off = (points, faces) => `OFF\n${points.length} ${faces.length} 0\n${points.join("\n")}\n${faces.map((f) => `${f.length} ${f.join(" ")}`).join("\n")}\n`;
  const corners = [...Array(8).keys()].map(corner);
  const cases = {
    "flipped.off": off(corners, quads.map((f, i) => (i === 2 ? f.toReversed() : f))),
    "twice.off": off(corners, [...quads, quads[3]]),
    "degenerate.off": off(corners, [...quads, [0, 1, 0]]),
    "bow_tie.off": off([...corners, "2 3 4", "3 2 4"], [...quads, [7, 8, 9]]),
    "fin.off": off([...corners, "2 2 3"], [...quads, [5, 7, 8]]),
    "book.off": off(["0 0 0", "0 0 1", "1 0 0", "0 1 0", "-1 0 0", "0 -1 0"], [[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 1, 5]]),
  };
  await withPage(file, { hash: "#ring" }, async (page) => {
    for (const [name, content] of Object.entries(cases)) {
      await drop(page, name, content);
      assert.match(await message(page), /no oriented manifold.* Repair$/);
      await page.click("#message span button");
      await page.waitForFunction((n) => window.page.editor.name === n, name);
      assert.ok(await page.isHidden("#message"));
      assert.match(await page.textContent("#about"), /\. Repaired: /);
      const [input, output] = [path.join(folder, name), path.join(folder, "repaired.ply")];
      await writeFile(input, content);
      execFileSync(command, ["surface", input, output, "--quiet", "--repair", "--levels", "0"]);
      const theirs = readPly(await readFile(output));
      const ours = await page.evaluate(() => {
        const { points, degrees } = window.page.editor.mesh.state();
        return { points: Array.from(points), faces: degrees.length };
      });
      assert.equal(ours.faces, theirs.faces, name);
      const sorted = (p) => Array.from({ length: p.length / 3 }, (_, i) => p.slice(3 * i, 3 * i + 3).join()).sort();
      assert.deepEqual(sorted(ours.points), sorted(theirs.points), name);
    }
  });
});

test("GLB is opened as it was saved", async () => {
  await withPage(file, { hash: "#tetrahedron" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    await page.fill("#rounds", "2");
    const saved = await points(page);
    await page.selectOption("#surface-format", "glb");
    const glb = await readFile(await download(page, "#save-surface"));
    await drop(page, "again.glb", glb);
    await page.waitForFunction(() => window.page.editor.name === "again.glb");
    const again = await page.evaluate(() => Array.from(window.page.editor.mesh.state().points));
    const triples = (p) => Array.from({ length: p.length / 3 }, (_, i) => p.slice(3 * i, 3 * i + 3));
    assert.equal(again.length, saved.length);
    for (const p of triples(again)) assert.ok(triples(saved).some((q) => largestDifference(p, q) < 1e-6), `${p}`);
    // nodes that shift, turn, scale and mirror, as other programs write them
    const length = glb.readUInt32LE(12);
    const model = JSON.parse(glb.subarray(20, 20 + length).toString());
    model.nodes = [{ children: [1], translation: [10, 20, 30], scale: [2, 2, 2] }, { mesh: 0, rotation: [0, 0, 1, 0], scale: [1, 1, -1] }];
    model.materials = [{}];
    let json = Buffer.from(JSON.stringify(model));
    json = Buffer.concat([json, Buffer.alloc((4 - (json.length % 4)) % 4, 32)]);
    const head = Buffer.from(glb.subarray(0, 20));
    head.writeUInt32LE(json.length, 12);
    await drop(page, "moved.glb", Buffer.concat([head, json, glb.subarray(20 + length)]));
    await page.waitForFunction(() => window.page.editor.name === "moved.glb");
    assert.match(await page.textContent("#about"), /Not kept: materials/);
    const moved = await page.evaluate(() => Array.from(window.page.editor.mesh.state().points));
    // and it is mirrored, but not inside out
    const volume = await page.evaluate(() => {
      const { points: p, corners } = window.page.editor.mesh.state();
      let sum = 0;
      for (let c = 0; c < corners.length; c += 3) {
        const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [0, 1, 2].map((k) => p.slice(3 * corners[c + k], 3 * corners[c + k] + 3));
        sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
      }
      return sum / 6;
    });
    assert.ok(volume > 0, `${volume}`);
    // x, y, z of the file: turned by half a circle about its z, z mirrored, doubled and shifted; then y up becomes z up
    triples(saved).forEach(([x, y, z]) => {
      const expected = [10 - 2 * x, -(30 - 2 * z), 20 - 2 * y];
      assert.ok(triples(moved).some((q) => largestDifference(expected, q) < 1e-4), `${expected}`);
    });
    for (const [name, content] of [["cut.glb", glb.subarray(0, 200)], ["none.glb", Buffer.from("glTF")], ["short.glb", glb.subarray(0, glb.length - 100)]]) {
      await drop(page, name, content);
      await page.waitForFunction((n) => document.querySelector("#message span").textContent.startsWith(n), name);
    }
  });
});

test("what is exported can be read again", async () => {
  await withPage(file, { hash: "#bumps" }, async (page) => {
    await page.fill("#rounds", "1");
    const start = await points(page);
    const control = await readFile(await download(page, "#save-control"));
    await page.selectOption("#example", "cube");
    await drop(page, "again.ply", control);
    await page.waitForFunction(() => window.page.editor.name === "again.ply");
    assert.equal(await page.inputValue("#scheme"), "catmull-clark");
    await page.fill("#rounds", "1");
    assert.equal(largestDifference(await points(page), start), 0);
    const png = await readFile(await download(page, "#save-png"));
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    assert.ok(png.length > 10_000);
    for (const [name, content] of [
      ["a.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"],
      ["a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"],
      ["a.stl", "solid a\n" + [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map((f) =>
        "facet normal 0 0 0\nouter loop\n" +
        f.map((v) => `vertex ${[v === 1, v === 2, v === 3].map(Number).join(" ")}\n`).join("") +
        "endloop\nendfacet\n").join("") + "endsolid a\n"],
    ]) {
      await drop(page, name, content);
      await page.waitForFunction((n) => window.page.editor.name === n, name);
      assert.equal(await page.evaluate(() => window.page.editor.handles.points.length), 12);
      assert.equal(await page.inputValue("#scheme"), "loop");
    }
  });
});

test("what belongs to a mesh ends with it", async () => {
  await withPage(file, { hash: "#picture-cube" }, async (page) => {
    const caption = () => page.isHidden("#caption").then((hidden) => (hidden ? "" : page.textContent("#caption")));
    const rounds = () => page.inputValue("#rounds").then(Number);
    assert.match(await caption(), /its curvature is even/);
    assert.ok(await page.isChecked("input[name=shading][value=relative]"));
    // an edit that makes it false
    await page.evaluate(() => window.page.editor.setNormal(0, 1, 0, 0));
    assert.equal(await caption(), "");
    await page.click("#picture-cube");
    assert.match(await caption(), /its curvature is even/);
    await page.selectOption("#scheme", "bilinear");
    assert.equal(await caption(), "");
    await page.selectOption("#example", "ring");
    assert.ok(await page.isChecked("input[name=shading][value=smooth]"));
    // rounds of files
    const mesh = (name) => readFile(path.resolve(import.meta.dirname, "../../../data/meshes", name));
    const open = async (name, content) => {
      await drop(page, name, content);
      await page.waitForFunction((n) => window.page.editor.name === n, name);
    };
    await page.selectOption("#example", "cube");
    assert.equal(await rounds(), 5);
    await open("head.obj", await mesh("head.obj"));
    assert.equal(await rounds(), 3);
    await points(page); // it is made
    assert.match(await page.textContent("#status"), /^19.\d{3} vertices/);
    const n = 100;
    const vertices = Array.from({ length: (n + 1) ** 2 }, (_, i) => `${i % (n + 1)} ${Math.floor(i / (n + 1))} 0`);
    const faces = Array.from({ length: n * n }, (_, i) => {
      const a = (n + 1) * Math.floor(i / n) + (i % n);
      return `4 ${a} ${a + 1} ${a + n + 2} ${a + n + 1}`;
    });
    await open("large.off", `OFF\n${vertices.length} ${faces.length} 0\n${vertices.join("\n")}\n${faces.join("\n")}\n`);
    assert.equal(await rounds(), 1); // (2 n + 1)^2 vertices, of which two rounds would make 160,801
    await open("spoon.obj", await mesh("spoon.obj"));
    assert.equal(await rounds(), 3);
    await page.fill("#rounds", "2");
    await page.click("#undo"); // the mesh before, with its rounds
    assert.equal(await rounds(), 1);
    await page.click("#undo");
    assert.equal(await rounds(), 3);
    // the status is that of the surface on the screen
    await page.selectOption("#example", "tetrahedron");
    await points(page);
    assert.match(await page.textContent("#status"), /radii about the best sphere/);
    await page.fill("#rounds", "1");
    assert.match(await page.textContent("#status"), /^10 vertices .*radii/);
    await page.selectOption("#example", "ring");
    assert.doesNotMatch(await page.textContent("#status"), /radii/);
  });
});

test("what is announced has happened", async () => {
  await withPage(file, { hash: "#cube" }, async (page) => {
    const announced = () => page.textContent("#announcement");
    await page.focus("#canvas");
    for (const key of ["n", "c"]) await page.keyboard.press(key);
    assert.match(await announced(), /^The edge from \d to \d is sharp$/);
    await page.keyboard.press("Control+z");
    assert.equal(await announced(), "Undone");
    await page.selectOption("#scheme", "doo-sabin");
    await page.focus("#canvas");
    await page.keyboard.press("c");
    assert.match(await message(page), /doo-sabin subdivision has no rules for creases/);
    assert.equal(await announced(), "");
  });
});

test("an address brings back what was on the screen", async () => {
  const seen = await withPage(file, { hash: "#ring" }, async (page) => {
    await page.focus("#canvas");
    for (const key of ["n", "n", "w", "w", "a", "l", "ArrowLeft", "ArrowUp"]) await page.keyboard.press(key);
    await page.check("input[name=shading][value=zebra]");
    await page.check("#flat");
    await page.waitForTimeout(800);
    return { points: await points(page), hash: new URL(page.url()).hash,
      camera: await page.evaluate(() => window.page.editor.viewer.camera.position.toArray()) };
  });
  assert.ok(seen.hash.length < 2000, `${seen.hash.length} characters`);
  await withPage(file, { hash: seen.hash }, async (page) => {
    assert.equal(largestDifference(await points(page), seen.points), 0);
    assert.ok((await page.isChecked("input[name=shading][value=zebra]")) && (await page.isChecked("#flat")));
    const camera = await page.evaluate(() => window.page.editor.viewer.camera.position.toArray());
    assert.ok(largestDifference(camera, seen.camera) < 1e-4);
  });
  const packed = (value) => deflateRawSync(JSON.stringify(value)).toString("base64url");
  await withPage(file, { hash: `#ring=${packed({ settings: { rounds: 1e9, layout: "none", shading: 7 } })}` }, async (page) => {
    assert.ok(Number(await page.inputValue("#rounds")) <= 7);
    assert.ok((await points(page)).length > 0);
  });
  for (const value of [{ settings: { scheme: "none" } }, { edits: { points: [[1e9, 0, 0, 0]] } }, { edits: { mesh: { points: [0],
    degrees: [9], corners: [1], normals: [], sharp: [] } } }])
    await withPage(file, { hash: `#ring=${packed(value)}` }, async (page) => {
      assert.ok((await message(page)).length > 10);
      assert.ok((await points(page)).length > 0);
    });
  await withPage(file, { hash: "#ring=damaged" }, async (page) => {
    assert.match(await message(page), /^The link cannot be read/);
    assert.ok((await points(page)).length > 0);
  });
});

test("curves: masks, a circle, and the command", async () => {
  await withPage(file, {}, async (page) => {
    await page.click("#tab-curve");
    await page.selectOption("#curve-example", "circle");
    const masks = await page.$$eval("#mask option", (options) => options.map((o) => o.value));
    for (const mask of masks) {
      await page.selectOption("#mask", mask);
      await page.waitForFunction(() => document.getElementById("curve-status").textContent.includes("circle"));
      await page.waitForTimeout(60);
      const deviation = Number(/point-normal (\S+),/.exec(await page.textContent("#curve-status"))[1]);
      assert.ok(deviation < 2e-15, `${mask}: ${deviation}`);
    }
    await page.selectOption("#curve-example", "bottle");
    await page.waitForTimeout(100);
    const polygon = await download(page, "#save-text");
    const curve = path.join(folder, "curve.txt");
    execFileSync(command, ["curve", polygon, curve, "--quiet", "--closed", "--scheme", "bspline:3", "--levels", "6"]);
    const theirs = (await readFile(curve, "utf8")).trim().split("\n").filter((l) => !l.startsWith("#"))
      .flatMap((line) => line.split(/\s+/).slice(0, 2).map(Number));
    const ours = await page.evaluate(() => Array.from(window.page.curve.shownCurve.points));
    assert.ok(largestDifference(ours, theirs) < 1e-12 * 12);
    // keys: select, move, turn, remove, undo
    const state = () => page.evaluate(() => window.page.curve.state);
    const before = await state();
    await page.focus("#drawing");
    for (const key of ["n", "ArrowRight", "a"]) await page.keyboard.press(key);
    const after = await state();
    assert.ok(after.points[0] > before.points[0] && after.normals[0] !== before.normals[0]);
    await page.keyboard.press("Delete");
    assert.equal((await state()).points.length, before.points.length - 2);
    for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+z");
    assert.deepEqual((await state()).points, before.points);
    // a polygon of one's own
    await page.click("#draw");
    const box = await page.locator("#drawing").boundingBox();
    for (const [x, y] of [[0.3, 0.3], [0.7, 0.3], [0.7, 0.7], [0.3, 0.7]])
      await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await page.click("#draw");
    assert.equal((await state()).points.length, 8);
    const svg = await readFile(await download(page, "#save-svg"), "utf8");
    assert.match(svg, /^<svg[^>]+viewBox/);
  });
});

test("labels, names and contrast", async () => {
  for (const colorScheme of ["light", "dark"])
    await withPage(file, { colorScheme }, async (page) => {
      const unnamed = await page.evaluate(() =>
        [...document.querySelectorAll("button, select, input:not([type=file]), canvas, svg[role]")]
          .filter((e) => !(e.textContent.trim() && e.tagName === "BUTTON") && !e.ariaLabel && !e.labels?.length)
          .map((e) => e.outerHTML.slice(0, 80)));
      assert.deepEqual(unnamed, []);
      const least = await page.evaluate(() => {
        const style = getComputedStyle(document.documentElement);
        const luminance = (name) => {
          const [r, g, b] = style.getPropertyValue(name).trim().match(/[0-9a-f]{2}/g).map((x) => {
            const c = parseInt(x, 16) / 255;
            return c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
          });
          return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const contrast = (a, b) => {
          const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
          return (high + 0.05) / (low + 0.05);
        };
        return Math.min(contrast("--text", "--panel"), contrast("--muted", "--panel"), contrast("--muted", "--soft"),
          contrast("--muted", "--background"), contrast("--accent-text", "--accent"), contrast("--error", "--error-soft"));
      });
      assert.ok(least >= 4.5, `${colorScheme}: contrast ${least}`);
    });
});

test("a finger turns a normal, and the page fits a telephone", { skip: chromiumOnly }, async () => {
  const options = { hash: "#ring", viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  await withPage(file, options, async (page, context) => {
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
    await page.check("input[name=layout][value=pn]");
    await page.evaluate(() => window.scrollTo(0, 0));
    const start = await points(page);
    const tip = await tipOf(page, await frontWedge(page));
    const client = await context.newCDPSession(page);
    const touch = (type, dx, dy) => client.send("Input.dispatchTouchEvent",
      { type, touchPoints: type === "touchEnd" ? [] : [{ x: tip.x + dx, y: tip.y + dy }] });
    await touch("touchStart", 0, 0);
    await touch("touchMove", 6, -9);
    await touch("touchMove", 12, -20);
    await touch("touchEnd");
    assert.ok(largestDifference(await points(page), start) > 1e-3);
  });
});
