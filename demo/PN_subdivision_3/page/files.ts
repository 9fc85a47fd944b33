// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is taken away: meshes as PLY, pictures, text.

import type { Faces } from "./modeler";

export interface PlyVertices {
  points: Float64Array;
  /** Left out where there are none. */
  normals: Float64Array;
  /** Left out where it is 1. */
  roundness?: Float64Array;
}

/** A binary PLY file with all digits. The kind of the normals is said as the command says it. */
export function plyFile(of: PlyVertices, faces: Faces, kind: "control normals" | "normals of the surface"): Uint8Array {
  const { points, normals, roundness } = of;
  const vertices = points.length / 3;
  const hasNormals = normals.length === points.length;
  const hasShortFaces = faces.degrees.every((degree) => degree < 256);
  const hasRoundness = hasNormals && roundness?.length === vertices;
  const names = ["x", "y", "z", ...(hasNormals ? ["nx", "ny", "nz"] : []), ...(hasRoundness ? ["roundness"] : [])];
  const header = [
    "ply",
    "format binary_little_endian 1.0",
    ...(hasNormals ? [`comment ${kind}`] : []),
    `element vertex ${vertices}`,
    ...names.map((name) => `property double ${name}`),
    `element face ${faces.degrees.length}`,
    `property list ${hasShortFaces ? "uchar" : "uint"} uint vertex_indices`,
    "end_header\n",
  ].join("\n");
  const head = new TextEncoder().encode(header);
  const sizeOfDegree = hasShortFaces ? 1 : 4;
  const size =
    head.length + vertices * 8 * names.length + faces.degrees.length * sizeOfDegree + 4 * faces.corners.length;
  const bytes = new Uint8Array(size);
  bytes.set(head);
  const view = new DataView(bytes.buffer);
  let at = head.length;
  const put = (x: number): void => {
    view.setFloat64(at, x, true);
    at += 8;
  };
  for (let v = 0; v < vertices; ++v) {
    for (let k = 0; k < 3; ++k) put(points[3 * v + k]);
    if (hasNormals) for (let k = 0; k < 3; ++k) put(normals[3 * v + k]);
    if (hasRoundness) put(roundness[v]);
  }
  let corner = 0;
  for (const degree of faces.degrees) {
    if (hasShortFaces) view.setUint8(at, degree);
    else view.setUint32(at, degree, true);
    at += sizeOfDegree;
    for (let i = 0; i < degree; ++i, at += 4) view.setUint32(at, faces.corners[corner++], true);
  }
  return bytes;
}

/** Normals of corners, so that creases are there again when the file is read. */
export function objFile(points: Float64Array, cornerNormals: Float64Array, faces: Faces): string {
  const lines: string[] = [];
  const addTriples = (word: string, values: Float64Array): void => {
    for (let i = 0; i < values.length; i += 3) lines.push(`${word} ${values[i]} ${values[i + 1]} ${values[i + 2]}`);
  };
  addTriples("v", points);
  addTriples("vn", cornerNormals);
  let corner = 0;
  for (const degree of faces.degrees) {
    const places = Array.from({ length: degree }, () => {
      const vertex = faces.corners[corner++] + 1;
      return cornerNormals.length > 0 ? `${vertex}//${corner}` : String(vertex);
    });
    lines.push(`f ${places.join(" ")}`);
  }
  return `${lines.join("\n")}\n`;
}

/** The same with normals of vertices, if there are any. */
export function objOfVertices(points: Float64Array, normals: Float64Array, faces: Faces): string {
  const ofCorners = new Float64Array(normals.length === 0 ? 0 : 3 * faces.corners.length);
  if (normals.length > 0) faces.corners.forEach((v, c) => ofCorners.set(normals.subarray(3 * v, 3 * v + 3), 3 * c));
  return objFile(points, ofCorners, faces);
}

/** Triangles with normals of vertices, as they are drawn. */
export interface Drawn {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
}

/** Binary STL, which holds no more than the corners of each triangle and its normal. */
export function stlFile({ positions, triangles }: Drawn): Uint8Array {
  const n = triangles.length / 3;
  const bytes = new Uint8Array(84 + 50 * n);
  const view = new DataView(bytes.buffer);
  view.setUint32(80, n, true);
  const corner = (i: number): number[] => [...positions.subarray(3 * i, 3 * i + 3)];
  for (let t = 0; t < n; ++t) {
    const [a, b, c] = [0, 1, 2].map((k) => corner(triangles[3 * t + k]));
    const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...normal) || 1;
    [...normal.map((x) => x / length), ...a, ...b, ...c].forEach((x, k) => view.setFloat32(84 + 50 * t + 4 * k, x, true));
  }
  return bytes;
}

/** Binary glTF 2.0, one mesh. glTF has y upwards. */
export function glbFile({ positions, normals, triangles }: Drawn): Uint8Array {
  const [low, high] = [Math.min, Math.max].map((best) =>
    [0, 1, 2].map((k) => positions.reduce((least, x, i) => (i % 3 === k ? best(least, x) : least), positions[k])));
  const parts = [positions, normals, triangles];
  const offsets = [0, positions.byteLength, positions.byteLength + normals.byteLength];
  const count = positions.length / 3;
  const model = {
    asset: { version: "2.0", generator: "PN_subdivision_3" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count, type: "VEC3", min: low, max: high },
      { bufferView: 1, componentType: 5126, count, type: "VEC3" },
      { bufferView: 2, componentType: 5125, count: triangles.length, type: "SCALAR" },
    ],
    bufferViews: parts.map((part, i) => ({ buffer: 0, byteOffset: offsets[i], byteLength: part.byteLength })),
    buffers: [{ byteLength: offsets[2] + triangles.byteLength }],
  };
  const json = new TextEncoder().encode(JSON.stringify(model));
  const jsonLength = Math.ceil(json.length / 4) * 4;
  const binaryLength = model.buffers[0].byteLength;
  const bytes = new Uint8Array(28 + jsonLength + binaryLength).fill(0x20, 20, 20 + jsonLength);
  const words: [number, number][] = [[0, 0x46546c67], [4, 2], [8, bytes.length], [12, jsonLength], [16, 0x4e4f534a],
    [20 + jsonLength, binaryLength], [24 + jsonLength, 0x004e4942]];
  const view = new DataView(bytes.buffer);
  for (const [at, word] of words) view.setUint32(at, word, true);
  bytes.set(json, 20);
  parts.forEach((part, i) => bytes.set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength), 28 + jsonLength + offsets[i]));
  return bytes;
}

export function save(content: BlobPart, type: string, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
