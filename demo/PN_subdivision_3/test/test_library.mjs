// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The library in Node.js and in a browser, against the command:
//   node --test test_library.mjs      with PN_LIBRARY, its folder, and PN_SUBDIVIDE, the command, in the environment
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cp, mkdir, readFile, symlink, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import path from "node:path";
import { before, test } from "node:test";
import { pathToFileURL } from "node:url";
import * as three from "three";
import { hasBrowser, withBrowser } from "./browser.mjs";
import { folder, largestDifference, quads, readPly } from "./page_actions.mjs";

const library = path.resolve(process.env.PN_LIBRARY);
const command = path.resolve(process.env.PN_SUBDIVIDE);
const fromLibrary = (name) => import(pathToFileURL(path.join(library, "library", name)));
let subdivision;
before(async () => (subdivision = await (await fromLibrary("index.js")).load()));

// --- meshes ---

const cube = {
  positions: [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [i & 1, (i >> 1) & 1, i >> 2].map((x) => 2 * x - 1)),
  faces: quads,
};
/** What is at the top is sharp. */
const creased = { ...cube, creases: [4, 5, 5, 7, 7, 6, 6, 4] };
const octahedron = {
  positions: [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1],
  faces: [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]],
};
/** Uneven normals of length 1. */
const normals = ({ positions }) => {
  const result = positions.map((x, i) => x + 0.3 * Math.sin(i));
  for (let i = 0; i < result.length; i += 3) {
    const length = Math.hypot(...result.slice(i, i + 3));
    for (let k = 0; k < 3; ++k) result[i + k] /= length;
  }
  return result;
};

function plyOf({ positions, faces, normals = [], roundness = [] }) {
  const n = positions.length / 3;
  const names = ["x", "y", "z", ...(normals.length > 0 ? ["nx", "ny", "nz"] : []), ...(roundness.length > 0 ? ["roundness"] : [])];
  const rows = Array.from({ length: n }, (_, v) => [...positions.slice(3 * v, 3 * v + 3), ...normals.slice(3 * v, 3 * v + 3),
    ...roundness.slice(v, v + 1)].join(" "));
  return ["ply", "format ascii 1.0", "comment control normals", `element vertex ${n}`, ...names.map((name) => `property double ${name}`),
    `element face ${faces.length}`, "property list uchar int vertex_indices", "end_header", ...rows,
    ...faces.map((face) => `${face.length} ${face.join(" ")}`), ""].join("\n");
}

async function ofCommand(mesh, words) {
  const [input, output] = [path.join(folder, "in.ply"), path.join(folder, "out.ply")];
  await writeFile(input, plyOf(mesh));
  execFileSync(command, ["surface", input, output, "--quiet", ...words]);
  return readPly(await readFile(output));
}

// --- the tests ---

test("all schemes, linear and point-normal, make what the command makes, in every byte", async () => {
  const schemes = subdivision.schemes();
  assert.equal(schemes.length, 12);
  for (const { name, takesTriangles } of schemes)
    for (const linear of [false, true]) {
      const mesh = { ...(takesTriangles ? octahedron : cube) };
      mesh.normals = normals(mesh);
      const refined = subdivision.subdivide(mesh, { scheme: name, levels: 3, linear });
      const theirs = await ofCommand(mesh, ["--scheme", name, "--levels", "3", ...(linear ? ["--linear"] : [])]);
      assert.equal(refined.faces.degrees.length, theirs.faces);
      // what transfers curvature takes functions that another C library computes
      const allowed = name.startsWith("ct-") ? 1e-14 : 0;
      assert.ok(largestDifference([...refined.positions], theirs.points) <= allowed, name);
      assert.equal(refined.normals.length, linear ? 0 : refined.positions.length);
    }
});

test("every scheme takes every roundness, and makes what the command makes", async () => {
  for (const { name, takesTriangles, hasLimitPoints } of subdivision.schemes()) {
    const mesh = { ...(takesTriangles ? octahedron : cube) };
    mesh.normals = normals(mesh);
    mesh.roundness = mesh.positions.slice(0, mesh.positions.length / 3).map((_, v) => [0, 0.5, 1, 0.75][v % 4]);
    const options = { scheme: name, levels: 2 };
    const words = ["--scheme", name, "--levels", "2"];
    const varied = subdivision.subdivide(mesh, options);
    const theirs = await ofCommand(mesh, [...words, "--output-normals", "control"]);
    for (const [ours, expected] of [["positions", "points"], ["normals", "normals"], ["roundness", "roundness"]])
      assert.ok(largestDifference([...varied[ours]], theirs[expected]) < 1e-14, `${ours} of ${name}`);
    const linear = subdivision.subdivide(mesh, { ...options, linear: true });
    assert.ok(largestDifference([...subdivision.subdivide(mesh, { ...options, roundness: 0 }).positions], [...linear.positions]) < 1e-14, name);
    for (const roundness of [0.5, 1, "estimate"]) {
      const refined = subdivision.subdivide(mesh, { ...options, roundness });
      assert.ok(largestDifference([...refined.positions], (await ofCommand(mesh, [...words, "--roundness", String(roundness)])).points) < 1e-14, name);
      if (!hasLimitPoints) continue;
      const limit = subdivision.subdivide(mesh, { ...options, roundness, limit: true });
      const theirLimit = await ofCommand(mesh, [...words, "--roundness", String(roundness), "--limit", "--surface-normals", "--limit-tolerance", "1e-7"]);
      assert.ok(largestDifference([...limit.positions], theirLimit.points) < 1e-12, name);
    }
    const plain = { positions: mesh.positions, faces: mesh.faces };
    assert.ok(largestDifference([...subdivision.subdivide(plain, options).positions], (await ofCommand(plain, words)).points) < 1e-14, name);
  }
});

test("creases are those of the command", async () => {
  const selection = path.join(folder, "top.txt");
  await writeFile(selection, `\n\n${creased.creases.join(" ")}\n`);
  const theirs = await ofCommand(cube, ["--scheme", "catmull-clark", "--levels", "2", "--sharp", selection]);
  assert.ok(largestDifference([...subdivision.subdivide(creased, { levels: 2 }).positions], theirs.points) < 1e-14);
});

test("what results is what further rounds begin with: creases and their sides, roundness 1 and linear surfaces, too", () => {
  const mesh = { ...cube, normals: normals(cube) };
  const ofSides = { ...creased, roundness: Array.from({ length: 24 }, (_, c) => (c % 3) / 2) };
  const points = ({ positions }) => Array.from({ length: positions.length / 3 }, (_, i) => [...positions.slice(3 * i, 3 * i + 3)]);
  for (const [given, linear] of [[mesh, false], [mesh, true], [{ ...mesh, roundness: [1, 0, 0.5, 1, 0.2, 0.9, 0, 1] }, false], [ofSides, false]]) {
    const [first, once] = [1, 2].map((levels) => subdivision.subdivide(given, { levels, linear }));
    const twice = subdivision.subdivide(first, { levels: 1, linear });
    assert.equal(twice.creases.length, once.creases.length);
    const all = points(twice); // in another order
    assert.equal(all.length, 98);
    for (const p of points(once)) assert.ok(all.some((q) => Math.hypot(...p.map((x, k) => x - q[k])) < 1e-14), `${p}`);
  }
  const first = subdivision.subdivide(ofSides, { levels: 1 });
  assert.equal(first.creases.length, 2 * 8);
  assert.ok(first.creases.every((v) => first.positions[3 * v + 2] > 0.5), "they are on top");
  for (const values of [first.normals, first.roundness]) assert.equal(values.length % first.faces.corners.length, 0);
});

test("OBJ and PLY files are read", async () => {
  const mesh = { ...cube, normals: normals(cube), roundness: [1, 0, 0.5, 1, 0.2, 0.9, 0, 1] };
  const read = subdivision.read(plyOf(mesh), "ply");
  assert.deepEqual([...subdivision.subdivide(read, { levels: 2 }).positions], [...subdivision.subdivide(mesh, { levels: 2 }).positions]);
  const box = await readFile(path.resolve(import.meta.dirname, "../../../data/meshes/parts/bolt.obj"));
  assert.ok(subdivision.read(box, "obj").creases.length > 20);
  assert.throws(() => subdivision.read("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "obj"), /nan/);
  assert.throws(() => subdivision.read("", "gif"), Error);
});

test("programs in TypeScript are checked", async () => {
  const at = path.join(folder, "typed");
  await mkdir(path.join(at, "node_modules/@types"), { recursive: true });
  const installed = path.resolve(import.meta.dirname, "../node_modules");
  await symlink(library, path.join(at, "node_modules/pn-subdivision"));
  await symlink(path.join(installed, "@types/three"), path.join(at, "node_modules/@types/three"));
  const programs = {
    "plain.ts": `import { load, type Mesh, type SchemeTraits } from "pn-subdivision";
const { subdivide, schemes, read } = await load();
const mesh: Mesh = read("", "obj");
const names: SchemeTraits["name"][] = schemes().map(({ name }) => name);
export const first = subdivide(mesh, { scheme: names[0], levels: 1 });
export const second = subdivide(first, { scheme: "loop", limit: true, roundness: "estimate" }).creases.length;
// @ts-expect-error: no such scheme
subdivide(mesh, { scheme: "lop" });
// @ts-expect-error: no such option
subdivide(mesh, { level: 2 });`,
    "worker.ts": `import { startWorker } from "pn-subdivision/worker";
const worker = startWorker();
export const { geometry } = await worker.subdivide({ positions: [0, 0, 0], faces: [[0, 0, 0]] });
worker.terminate();`,
    "drawn.ts": `import * as THREE from "three";
import { load } from "pn-subdivision";
import { bufferGeometry, meshOf } from "pn-subdivision/three";
const { subdivide } = await load();
export const box: THREE.BufferGeometry = bufferGeometry(THREE, subdivide(meshOf(new THREE.BoxGeometry())));`,
  };
  for (const [name, text] of Object.entries(programs)) await writeFile(path.join(at, name), text);
  await writeFile(path.join(at, "package.json"), '{ "type": "module" }');
  await writeFile(path.join(at, "tsconfig.json"), JSON.stringify({ compilerOptions: { module: "nodenext", moduleResolution: "nodenext",
    target: "es2022", lib: ["es2023", "dom", "dom.iterable"], strict: true, noEmit: true, skipLibCheck: false, types: [], preserveSymlinks: true }, include: ["*.ts"] }));
  assert.ok(JSON.parse(await readFile(path.join(library, "package.json"), "utf8")).peerDependencies.three);
  const { status, stdout } = spawnSync(path.join(installed, ".bin/tsc"), ["-p", at], { encoding: "utf8" });
  const ours = stdout.split("\n").filter((line) => /error TS/.test(line) && !/@types/.test(line));
  assert.deepEqual([status !== 0 && ours.length > 0, ours], [false, []]);
});

test("texture coordinates follow the mesh, and seams stay", async () => {
  // each face of the cube has a texture of its own: all edges are seams
  const uv = cube.faces.flatMap((_, f) => [0, 0, 1, 0, 1, 1, 0, 1].map((x) => x + 2 * f));
  const mesh = { ...cube, normals: normals(cube), uv };
  const obj = [
    ...Array.from({ length: 8 }, (_, v) => `v ${cube.positions.slice(3 * v, 3 * v + 3).join(" ")}`),
    ...Array.from({ length: 24 }, (_, c) => `vt ${uv[2 * c]} ${uv[2 * c + 1]}`),
    ...Array.from({ length: 8 }, (_, v) => `vn ${mesh.normals.slice(3 * v, 3 * v + 3).join(" ")}`),
    ...cube.faces.map((face, f) => `f ${face.map((v, k) => `${v + 1}/${4 * f + k + 1}/${v + 1}`).join(" ")}`),
  ];
  const [input, output] = [path.join(folder, "in.obj"), path.join(folder, "out.obj")];
  await writeFile(input, `${obj.join("\n")}\n`);
  execFileSync(command, ["surface", input, output, "--quiet", "--scheme", "catmull-clark", "--levels", "2", "--normals", "file"]);
  const lines = (await readFile(output, "utf8")).split("\n").map((line) => line.split(" "));
  const rows = (word) => lines.filter(([first]) => first === word).map((words) => words.slice(1).map(Number));
  const textures = rows("vt");
  // by the middle of their faces: a reader may begin a face at any of its corners
  const cornersOfCommand = lines.filter(([first]) => first === "f").map((words) => words.slice(1).map((word) => {
    const [v, t] = word.split("/").map(Number);
    return [...rows("v")[v - 1], ...textures[t - 1]];
  }));
  const refined = subdivision.subdivide(mesh, { levels: 2 });
  assert.equal(refined.uv.length, 2 * refined.faces.corners.length);
  const sorted = (corners) => corners.map((corner) => corner.map((x) => (x + 0).toFixed(9)).join()).sort();
  const ours = Array.from(refined.faces.corners, (v, c) => [...refined.positions.slice(3 * v, 3 * v + 3), ...refined.uv.slice(2 * c, 2 * c + 2)]);
  assert.deepEqual(sorted(ours), sorted(cornersOfCommand.flat()));
  // what is drawn is cut along the seams: six squares of 5 times 5 vertices
  const { geometry } = refined;
  assert.equal(geometry.positions.length, 3 * 6 * 25);
  assert.equal(geometry.uv.length, 2 * 6 * 25);
  const { bufferGeometry, meshOf } = await fromLibrary("three.js");
  const welded = meshOf(bufferGeometry(three, refined));
  assert.equal(welded.positions.length, refined.positions.length);
  assert.equal(welded.uv.length, 2 * 3 * 6 * 32);
  // of vertices: no seams; linear is the same
  const ofVertices = Array.from({ length: 16 }, (_, i) => Math.cos(i));
  const smooth = subdivision.subdivide({ ...mesh, uv: ofVertices }, { levels: 1 });
  assert.equal(smooth.geometry.uv.length, 2 * 26);
  const straight = subdivision.subdivide({ ...mesh, uv: ofVertices }, { levels: 1, linear: true });
  assert.ok(largestDifference([...straight.uv], [...smooth.uv]) < 1e-15);
  assert.ok(largestDifference([...subdivision.subdivide({ ...mesh, uv: undefined }, { levels: 1 }).positions], [...smooth.positions]) < 1e-15);
  assert.throws(() => subdivision.subdivide({ ...mesh, uv: [1, 2, 3] }), /uv must be two numbers/);
  assert.throws(() => subdivision.subdivide(mesh, { scheme: "kobbelt" }), /kobbelt subdivision takes no texture coordinates/);
  assert.equal(subdivision.subdivide({ ...mesh, uv: ofVertices }, { scheme: "doo-sabin", linear: true }).geometry.uv.length, 2 * 24);
});

test("what is given is left alone, and what is wrong is named", () => {
  const mesh = { positions: Float64Array.from(cube.positions), faces: cube.faces, normals: Float64Array.from(normals(cube)) };
  const before = structuredClone(mesh);
  const first = subdivision.subdivide(mesh, { levels: 2 });
  const kept = first.positions.slice();
  subdivision.subdivide(mesh, { levels: 5 }); // memory grows
  assert.deepEqual(mesh, before);
  assert.deepEqual(first.positions, kept);
  const refuses = (wrong, options, expected) =>
    assert.throws(() => subdivision.subdivide({ ...cube, ...wrong }, options), (error) => error instanceof Error && expected.test(error.message));
  refuses({}, { scheme: "none" }, /no scheme 'none': it must be one of catmull-clark, /);
  refuses({}, { scheme: "loop" }, /loop takes triangles only/);
  refuses({}, { levels: -1 }, /levels/);
  refuses({}, { roundness: 2 }, /roundness must be from 0 to 1/);
  refuses({ faces: [[0, 1, 8]] }, {}, /8 is out of range/);
  refuses({ faces: [[0, 1, 2 ** 32 + 2]] }, {}, /4294967298 is no number of a vertex/);
  refuses({ faces: [[0, 1, -1]] }, {}, /-1 is no number of a vertex/);
  refuses({ faces: [[0, 1, 2], [0, 1, 3], [0, 1, 4]] }, {}, /no oriented manifold: .*edge/);
  refuses({ positions: [...cube.positions.slice(0, -1), NaN] }, {}, /finite|nan/i);
  refuses({ normals: [1, 2] }, {}, /normals must be three numbers/);
  refuses({ roundness: [1] }, {}, /8 vertices, and the roundness of 1/);
  refuses({}, { level: 2 }, /no option 'level': it must be one of scheme, levels, /);
  refuses({ faces: undefined }, {}, /the mesh has no faces/);
  refuses({ faces: cube.faces.flat() }, {}, /face 0 is no list of vertices/);
  refuses({ faces: { degrees: [4] } }, {}, /corners must be a list of numbers/);
  refuses({ positions: undefined }, {}, /positions must be three numbers/);
  refuses({ positions: cube.positions.map((x) => [x, x, x]) }, {}, /positions must be three numbers for each vertex, one after the other/);
  refuses({ creases: [0, 1, 0, 7] }, {}, /no edge from vertex 0 to vertex 7/);
  refuses({ creases: [0, 99] }, {}, /no edge from vertex 0 to vertex 99/);
  refuses({ creases: [0, 1, 2] }, {}, /creases must be pairs/);
  refuses({ creases: [[4, 5], [5, 7]] }, {}, /creases: 4,5 is no number of a vertex/);
});

test("what is drawn has the surface's vertices, those on creases for each side", async () => {
  const refined = subdivision.subdivide(cube, { levels: 1 });
  const smooth = refined.geometry;
  const cut = subdivision.subdivide(creased, { levels: 1 }).geometry;
  assert.equal(smooth.positions.length / 3, 26);
  assert.equal(cut.positions.length / 3, 26 + 8);
  assert.equal(smooth.triangles.length, 3 * 2 * 24);
  const { bufferGeometry } = await fromLibrary("three.js");
  const geometry = bufferGeometry(three, refined);
  geometry.computeBoundingBox();
  assert.equal(geometry.boundingBox.max.x, Math.fround(Math.max(...refined.positions.filter((_, i) => i % 3 === 0))));
  assert.equal(geometry.index.count, 144);
});

test("the example subdivides a glTF model in twenty lines", async () => {
  // an octahedron whose faces share no vertices
  const corners = octahedron.faces.flat();
  const positions = Float32Array.from(corners.flatMap((v) => octahedron.positions.slice(3 * v, 3 * v + 3)));
  const indices = Uint16Array.from(corners.keys());
  const bytes = Buffer.concat([Buffer.from(positions.buffer), Buffer.from(indices.buffer)]);
  const model = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ name: "gem", primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 24, type: "VEC3", min: [-1, -1, -1], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5123, count: 24, type: "SCALAR" },
    ],
    bufferViews: [{ buffer: 0, byteLength: 288 }, { buffer: 0, byteOffset: 288, byteLength: 48 }],
    buffers: [{ uri: `data:application/octet-stream;base64,${bytes.toString("base64")}`, byteLength: bytes.length }],
  };
  const [input, output] = [path.join(folder, "model.gltf"), path.join(folder, "model.obj")];
  await writeFile(input, JSON.stringify(model));
  // as if both packages were installed
  await mkdir(path.join(folder, "node_modules"));
  await symlink(library, path.join(folder, "node_modules/pn-subdivision"));
  await symlink(path.resolve(import.meta.dirname, "../node_modules/three"), path.join(folder, "node_modules/three"));
  const example = path.join(folder, "example.mjs");
  await cp(path.join(library, "example.mjs"), example);
  const code = (await readFile(example, "utf8")).split("\n").filter((line) => line !== "" && !line.startsWith("//"));
  assert.ok(code.length <= 20, `${code.length} lines`);
  assert.equal(execFileSync("node", [example, input, output], { encoding: "utf8" }), "gem: 128 triangles\n");
  const lines = (await readFile(output, "utf8")).trim().split("\n");
  assert.equal(lines.filter((line) => line.startsWith("f ")).length, 128);
  const theirs = await ofCommand(octahedron, ["--scheme", "loop", "--levels", "2"]);
  const ours = lines.filter((line) => line.startsWith("v ")).flatMap((line) => line.split(" ").slice(1).map(Number));
  assert.equal(ours.length, theirs.points.length);
  const triples = (values) => Array.from({ length: values.length / 3 }, (_, i) => values.slice(3 * i, 3 * i + 3));
  for (const p of triples(ours)) assert.ok(triples(theirs.points).some((q) => Math.hypot(...p.map((x, k) => x - q[k])) < 1e-6), `${p}`);
});

test("browsers make the same as Node.js", { skip: !hasBrowser }, async () => {
  const types = { ".js": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };
  const server = createServer(async (request, response) => {
    const name = request.url === "/" ? undefined : path.join(library, path.normalize(request.url));
    response.setHeader("Content-Type", types[path.extname(name ?? ".html")] ?? "text/plain");
    response.end(name === undefined ? "<!doctype html>" : await readFile(name).catch(() => ""));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  await withBrowser(async (browser) => {
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    const mesh = { ...cube, normals: normals(cube) };
    const theirs = await page.evaluate(async (given) => {
      const { load } = await import("/library/index.js");
      return Array.from((await load()).subdivide(given, { levels: 3 }).positions);
    }, mesh);
    const ours = [...subdivision.subdivide(mesh, { levels: 3 }).positions];
    assert.equal(largestDifference(theirs, ours), 0);
    const ofWorker = await page.evaluate(async (given) => {
      const { startWorker } = await import("/library/worker.js");
      const worker = startWorker();
      const refusal = worker.subdivide(given, { scheme: "loop" }).catch((error) => error.message);
      const [one, three] = await Promise.all([1, 3].map((levels) => worker.subdivide(given, { levels })));
      const result = [await refusal, one.positions.length, Array.from(three.positions), three.geometry.triangles.length];
      worker.terminate();
      return result;
    }, mesh);
    assert.deepEqual(ofWorker, ["loop takes triangles only", 3 * 26, ours, 6 * 384]);
    await page.close();
  }).finally(() => server.close());
});
