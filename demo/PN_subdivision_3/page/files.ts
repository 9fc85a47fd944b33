// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is taken away: meshes, as the command pn_subdivide writes them to the byte, pictures, text.

import type { Faces } from "./modeler";

/** Control normals and roundness of corners, which differ on the sides of creases. */
export interface Corners {
  normals: Float64Array;
  /** Left out where it is 1. */
  roundness?: Float64Array;
}

export interface MeshOfFile {
  points: Float64Array;
  /** Of vertices; left out where there are none. */
  normals: Float64Array;
  /** Of vertices; left out where it is 1. */
  roundness?: Float64Array;
  faces: Faces;
  /** For further rounds: the creases, as pairs of vertices, their tangents there, and what differs on their sides. */
  sharpEdges?: Uint32Array;
  tangents?: Float64Array;
  corners?: Corners;
}

/** What vertices have of their corners: the normalized sum of the different normals, and the least roundness. */
export function valuesOfVertices(vertices: number, { normals, roundness }: Corners, { corners }: Faces): {
  normals: Float64Array; roundness?: Float64Array; differ: boolean } {
  const values = Array.from({ length: vertices }, (): number[][] => []);
  const least = new Float64Array(vertices).fill(1);
  let differ = false;
  corners.forEach((v, c) => {
    const n = [...normals.subarray(3 * c, 3 * c + 3)];
    if (!values[v].some((other) => other.every((x, k) => x === n[k]))) values[v].push(n);
    if (roundness) least[v] = Math.min(least[v], roundness[c]);
  });
  const sums = values.flatMap((all) => {
    differ ||= all.length > 1;
    if (all.length < 2) return all[0] ?? [0, 0, 0];
    return unit(all.reduce((sum, n) => sum.map((x, k) => x + n[k])));
  });
  differ ||= roundness?.some((w, c) => w !== least[corners[c]]) ?? false;
  return { normals: Float64Array.from(sums), roundness: roundness && least, differ };
}

class Bytes {
  private bytes = new Uint8Array(1 << 16);
  private view = new DataView(this.bytes.buffer);
  private size = 0;

  get content(): Uint8Array {
    return this.bytes.subarray(0, this.size);
  }
  text(text: string): void {
    const bytes = new TextEncoder().encode(text);
    const at = this.room(bytes.length);
    this.bytes.set(bytes, at);
  }
  uint8(x: number): void {
    const at = this.room(1);
    this.view.setUint8(at, x);
  }
  uint32(x: number): void {
    const at = this.room(4);
    this.view.setUint32(at, x, true);
  }
  float64(x: number): void {
    const at = this.room(8);
    this.view.setFloat64(at, x, true);
  }
  /** Returns where it begins; the arrays may be others then. */
  private room(n: number): number {
    this.size += n;
    if (this.size > this.bytes.length) {
      const old = this.bytes;
      this.bytes = new Uint8Array(2 * this.size);
      this.bytes.set(old);
      this.view = new DataView(this.bytes.buffer);
    }
    return this.size - n;
  }
}

/** A binary PLY file with all digits. */
export function plyFile(mesh: MeshOfFile, kind: "control normals" | "normals of the surface"): Uint8Array {
  const { points, normals, roundness, faces, sharpEdges, corners } = mesh;
  const tangents = mesh.tangents ?? new Float64Array(3 * (sharpEdges?.length ?? 0));
  const hasNormals = normals.length > 0;
  const ofVertices = [points, ...(hasNormals ? [normals] : [])];
  const list = `property list ${faces.degrees.every((degree) => degree * (corners ? 3 : 1) < 256) ? "uchar" : "uint"}`;
  const out = new Bytes();
  const count = (n: number): void => (list.endsWith("uchar") ? out.uint8(n) : out.uint32(n));
  out.text([
    "ply",
    "format binary_little_endian 1.0",
    "comment written by pn_subdivide",
    ...(hasNormals ? [`comment ${kind}`] : []),
    `element vertex ${points.length / 3}`,
    ...["x", "y", "z", ...(hasNormals ? ["nx", "ny", "nz"] : []), ...(roundness ? ["roundness"] : []), ...(sharpEdges ? ["sharpness"] : [])].map((name) => `property double ${name}`),
    `element face ${faces.degrees.length}`,
    `${list} int vertex_indices`,
    ...(corners ? [`${list} double corner_control_normals`] : []),
    ...(corners?.roundness ? [`${list} double corner_roundness`] : []),
    ...(sharpEdges ? [`element edge ${sharpEdges.length / 2}`, "property int vertex1", "property int vertex2",
      ...["sharpness", "t1x", "t1y", "t1z", "t2x", "t2y", "t2z"].map((name) => `property double ${name}`)] : []),
    "end_header\n",
  ].join("\n"));
  for (let v = 0; v < points.length / 3; ++v) {
    for (const values of ofVertices) for (let k = 0; k < 3; ++k) out.float64(values[3 * v + k]);
    if (roundness) out.float64(roundness[v]);
    if (sharpEdges) out.float64(0); // no corner is sharp by itself
  }
  let first = 0;
  for (const degree of faces.degrees) {
    const end = first + degree;
    count(degree);
    for (let c = first; c < end; ++c) out.uint32(faces.corners[c]);
    for (const [values, n] of [[corners?.normals, 3], [corners?.roundness, 1]] as const) {
      if (!values) continue;
      count(n * degree);
      for (let i = n * first; i < n * end; ++i) out.float64(values[i]);
    }
    first = end;
  }
  for (let i = 0; i < tangents.length / 3; i += 2) {
    for (const v of sharpEdges!.subarray(i, i + 2)) out.uint32(v);
    out.float64(Infinity);
    for (const x of tangents.subarray(3 * i, 3 * i + 6)) out.float64(x);
  }
  return out.content;
}

/** The 17 digits that tell every number from its neighbors, as C's "%.17g" has them. */
export function seventeenDigits(x: number): string {
  if (x === 0) return Object.is(x, -0) ? "-0" : "0";
  let [digits, power] = x.toExponential(16).split("e");
  // a number in the middle of two is rounded away from zero here, and to an even digit there
  const middle = /^(-?\d\.\d{15}[02468])50*e/.exec(x.toExponential(60));
  if (middle) digits = middle[1];
  const exponent = Number(power);
  if (exponent < -4 || exponent >= 17)
    return `${digits.replace(/\.?0*$/, "")}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  const sign = x < 0 ? "-" : "";
  const all = digits.replace(/[-.]/g, "");
  const text = exponent < 0 ? `0.${"0".repeat(-exponent - 1)}${all}` : `${all.slice(0, exponent + 1)}.${all.slice(exponent + 1)}`;
  return sign + text.replace(/\.?0*$/, "");
}

/** With normals, if there are any, of vertices or corners, and what is sharp; without roundness. */
export function objFile({ points, normals, faces, sharpEdges = new Uint32Array(), corners }: MeshOfFile): string {
  const lines: string[] = [];
  const { values, numbers } = corners ? differentNormals(corners, faces) : { values: normals, numbers: faces.corners };
  for (const [word, triples] of [["v", points], ["vn", values]] as const)
    for (let i = 0; i < triples.length; i += 3) lines.push(`${word} ${[...triples.subarray(i, i + 3)].map(seventeenDigits).join(" ")}`);
  let c = 0;
  for (const degree of faces.degrees) {
    const words: string[] = [];
    for (const end = c + degree; c < end; ++c) words.push(`${faces.corners[c] + 1}${values.length > 0 ? `//${numbers[c] + 1}` : ""}`);
    lines.push(`f ${words.join(" ")}`);
  }
  // 10 rounds are for ever
  for (let i = 0; i < sharpEdges.length; i += 2) lines.push(`t crease 2/1/0 ${sharpEdges[i]} ${sharpEdges[i + 1]} 10`);
  return `${lines.join("\n")}\n`;
}

/** Those of corners, where equal ones of a vertex count once, and the number of each corner's. */
function differentNormals({ normals }: Corners, { corners }: Faces): { values: Float64Array; numbers: Uint32Array } {
  const values: number[] = [];
  const ofVertices = new Map<number, number[]>();
  const numbers = corners.map((v, c) => {
    const own = ofVertices.get(v) ?? [];
    ofVertices.set(v, own);
    let number = own.find((n) => [0, 1, 2].every((k) => values[3 * n + k] === normals[3 * c + k]));
    if (number === undefined) {
      own.push((number = values.length / 3));
      values.push(...normals.subarray(3 * c, 3 * c + 3));
    }
    return number;
  });
  return { values: Float64Array.from(values), numbers };
}

/** Triangles with normals of vertices, as they are drawn. */
export interface Drawn {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
}

/** Binary STL, which holds no more than the corners of each triangle and its normal. */
export function stlFile(points: Float64Array, triangles: Uint32Array): Uint8Array {
  const n = triangles.length / 3;
  const bytes = new Uint8Array(84 + 50 * n);
  bytes.set(new TextEncoder().encode("binary STL written by pn_subdivide"));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, n, true);
  for (let t = 0; t < n; ++t) {
    const corners = [0, 1, 2].map((k) => [...points.subarray(3 * triangles[3 * t + k], 3 * triangles[3 * t + k] + 3)]);
    [...unitNormal(corners), ...corners.flat()].forEach((x, k) => view.setFloat32(84 + 50 * t + 4 * k, x, true));
  }
  return bytes;
}

/** Of a triangle; zero if it has no area. */
function unitNormal([a, b, c]: number[][]): number[] {
  const sides = [b, c].map((p) => p.map((x, k) => x - a[k]));
  const largest = Math.max(...sides.flat().map(Math.abs));
  if (!(largest > 0)) return [0, 0, 0];
  const [u, v] = sides.map((side) => side.map((x) => x / largest));
  return unit([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]);
}

/** As std::hypot has the length, to the bit. */
function unit(n: number[]): number[] {
  const most = Math.max(...n.map(Math.abs));
  const length = most * Math.sqrt(n.map((x) => (x / most) * (x / most)).reduce((sum, x) => sum + x));
  return length > 0 ? n.map((x) => x / length) : [0, 0, 0];
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
