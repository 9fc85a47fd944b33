// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Subdivides the first mesh of a glTF model whose buffer is in the file: node example.mjs MODEL.gltf OUTPUT.obj
import { readFile, writeFile } from "node:fs/promises";
import { load } from "pn-subdivision";

const [, , input, output] = process.argv;
const model = JSON.parse(await readFile(input, "utf8"));
const { attributes, indices } = model.meshes[0].primitives[0];
const arrays = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const read = ({ bufferView, componentType, count, type, byteOffset = 0 }) => {
  const view = model.bufferViews[bufferView];
  const bytes = Buffer.from(model.buffers[view.buffer].uri.split(",")[1], "base64");
  const first = (view.byteOffset ?? 0) + byteOffset;
  return new arrays[componentType](Uint8Array.from(bytes.subarray(first)).buffer, 0, count * (type === "VEC3" ? 3 : 1));
};

// models repeat vertices where normals or colors differ
const numbers = new Map();
const given = read(model.accessors[attributes.POSITION]);
const triples = Array.from({ length: given.length / 3 }, (_, v) => given.subarray(3 * v, 3 * v + 3).join());
for (const triple of triples) if (!numbers.has(triple)) numbers.set(triple, numbers.size);
const corners = Array.from(read(model.accessors[indices]), (v) => numbers.get(triples[v]));
const positions = [...numbers.keys()].flatMap((triple) => triple.split(",").map(Number));

const { subdivide } = await load();
const faces = { degrees: new Array(corners.length / 3).fill(3), corners };
const refined = subdivide({ positions, faces }, { scheme: "loop", levels: 2 });

const lines = (word, values, by) =>
  Array.from({ length: values.length / 3 }, (_, i) => `${word} ${Array.from(values.slice(3 * i, 3 * i + 3), by).join(" ")}\n`);
await writeFile(output, [...lines("v", refined.positions, String), ...lines("f", refined.faces.corners, (v) => v + 1)].join(""));
console.log(`${positions.length / 3} vertices became ${refined.positions.length / 3}`);
