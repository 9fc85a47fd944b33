// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The readers of files where std::size_t has 32 bits: what the command, which has 64, takes and refuses.
//   node --test test_readers.mjs      with PN_LIBRARY, the npm package's folder, and PN_SUBDIVIDE, the command, in the environment
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { folder, readPly } from "./page_actions.mjs";

const library = path.resolve(process.env.PN_LIBRARY, "library");
const command = path.resolve(process.env.PN_SUBDIVIDE);
const meshes = path.resolve(import.meta.dirname, "../../../data/meshes");
let modeler;
before(async () => {
  const { default: create } = await import(pathToFileURL(path.join(library, "modeler.js")));
  modeler = await create({ wasmBinary: await readFile(path.join(library, "modeler.wasm")) });
});

/** The control mesh's state, or the message of the one that refuses it. */
function readHere(content, format) {
  let mesh;
  try {
    mesh = modeler.readMesh(Uint8Array.from(Buffer.from(content)), format, false);
    return { state: mesh.state() };
  } catch (error) {
    assert.ok(error instanceof Error, String(error));
    return { refusal: error.message };
  } finally {
    mesh?.delete();
  }
}

async function readByCommand(content, format) {
  const [input, output] = [path.join(folder, `in.${format}`), path.join(folder, "out.ply")];
  await writeFile(input, content);
  const { status, stderr } = spawnSync(command, ["surface", input, output, "--levels", "0", "--normals", "none", "--quiet"], { encoding: "utf8" });
  if (status === 0) return { mesh: readPly(await readFile(output)) };
  return { refusal: stderr.trim() };
}

const triangle = "0 0 0\n1 0 0\n0 1 0\n";
// no texture coordinates, which the page does not read
const obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
const off = `OFF\n3 1 0\n${triangle}3 0 1 2\n`;
const ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n" +
  `element face 1\nproperty list uint uint vertex_indices\nend_header\n${triangle}3 0 1 2\n`;

/** The n-th integer of a text becomes another one. */
function withNumber(text, n, change) {
  let i = 0;
  return text.replace(/(?<![\w.])-?\d+(?![\w.])/g, (digits) => (i++ === n ? String(change(BigInt(digits))) : digits));
}
const numbersIn = (text) => text.match(/(?<![\w.])-?\d+(?![\w.])/g).length;

test("meshes of the package are read as the command reads them", async () => {
  for (const name of ["cube.off", "wheel.off", "spoon.obj", "vase.obj", "saddle_5.ply", "creased_box.ply", "parts/bolt.obj"]) {
    const format = name.split(".").pop();
    const content = await readFile(path.join(meshes, name));
    const { state } = readHere(content, format);
    const { mesh } = await readByCommand(content, format);
    assert.equal(state.degrees.length, mesh.faces, name);
    assert.deepEqual([...state.points], mesh.points, name);
  }
});

test("any number that is 2^32 or more too large is refused as by the command", async () => {
  let refused = 0;
  for (const [format, text] of [["obj", obj], ["off", off], ["ply", ply]])
    for (let n = 0; n < numbersIn(text); ++n)
      for (const change of [(i) => i + 2n ** 32n, (i) => i + 2n ** 64n, (i) => i - 2n ** 32n]) {
        const content = withNumber(text, n, change);
        const ours = readHere(content, format);
        const theirs = await readByCommand(content, format);
        const about = `${format}: ${content}\nhere: ${ours.refusal}\nby the command: ${theirs.refusal}`;
        assert.equal(ours.refusal === undefined, theirs.refusal === undefined, about);
        if (ours.refusal === undefined) assert.deepEqual([...ours.state.points], theirs.mesh.points, about); // a coordinate
        // counts that only 64 bits can hold are refused earlier, by name
        else assert.ok(theirs.refusal.includes(ours.refusal) || /is too large: \d{10,}$/.test(ours.refusal), about);
        refused += Number(ours.refusal !== undefined);
      }
  // 6 indices in OBJ; 2 counts and the 4 numbers of the face in OFF and PLY
  assert.equal(refused, 3 * (6 + 6 + 6));
});

test("counts of binary files that exceed the file, or memory, are refused in one line", () => {
  const header = (count, list) => "ply\nformat binary_little_endian 1.0\n" +
    `element vertex ${count}\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list ${list} uint vertex_indices\nend_header\n`;
  const points = Buffer.from(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer);
  const face = (degree) => Buffer.from(Uint32Array.of(degree, 0, 1, 2).buffer);
  const read = (...parts) => readHere(Buffer.concat(parts.map((part) => Buffer.from(part))), "ply");
  assert.equal(read(header(3, "uint"), points, face(3)).state.degrees.length, 1);
  // times 4 bytes these are 12 again, modulo 2^32
  for (const degree of [2 ** 30 + 3, 2 ** 31 + 3, 2 ** 32 - 1])
    assert.match(read(header(3, "uint"), points, face(degree)).refusal, /^[^\n]+$/);
  for (const count of [2 ** 32 + 3, 2 ** 32 + 4, 2 ** 32 / 12 + 3, 357913944 + 3, 2 ** 32 - 1].map(Math.floor))
    assert.match(read(header(count, "uint"), points, face(3)).refusal, /^[^\n]+$/);
  const stl = (count) => Buffer.concat([Buffer.alloc(80), Buffer.from(Uint32Array.of(count).buffer),
    Buffer.from(Float32Array.of(0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0).buffer), Buffer.alloc(2)]);
  assert.equal(readHere(stl(1), "stl").state.degrees.length, 1);
  // times 50 bytes it is 50 again, modulo 2^32
  for (const count of [2 ** 31 + 1, 2 ** 32 - 1]) assert.match(readHere(stl(count), "stl").refusal, /^[^\n]+$/);
  // and there is memory for what comes next
  assert.equal(readHere(stl(1), "stl").state.degrees.length, 1);
});
