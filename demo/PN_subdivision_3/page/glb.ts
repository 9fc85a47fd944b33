// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The triangles of a binary glTF file, with all its nodes, as one mesh. glTF has y upwards.

import type { Faces } from "./modeler_types";

interface Accessor {
  bufferView?: number;
  byteOffset?: number;
  componentType: number;
  count: number;
}
interface Node {
  children?: number[];
  mesh?: number;
  matrix?: number[];
  translation?: number[];
  rotation?: number[];
  scale?: number[];
}
interface Model {
  scene?: number;
  scenes?: { nodes?: number[] }[];
  nodes?: Node[];
  meshes?: { primitives: { attributes: { POSITION?: number }; indices?: number; mode?: number; extensions?: object }[] }[];
  accessors?: Accessor[];
  bufferViews?: { buffer: number; byteOffset?: number; byteStride?: number }[];
}

const float = 5126;
const sizes: Record<number, number> = { 5121: 1, 5123: 2, 5125: 4, 5126: 4 };
/** Columns of a matrix with four rows. */
const upwards = [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1];

/** Vertices at one place are one, of which renderers need several where normals differ. */
export function triangleMeshOf(file: Uint8Array): { points: Float64Array; faces: Faces } {
  const [model, view] = partsOf(file);
  const points: number[] = [];
  const corners: number[] = [];
  const places = new Map<string, number>();
  const visit = (index: number, parent: number[], depth: number): void => {
    const node = model.nodes![index];
    if (depth > 100) throw new Error("the nodes of the file are nested without end");
    const place = product(parent, matrixOf(node));
    for (const primitive of node.mesh === undefined ? [] : model.meshes![node.mesh].primitives) {
      if (primitive.extensions && "KHR_draco_mesh_compression" in primitive.extensions) throw new Error("compressed meshes (Draco) are not read here");
      const { POSITION } = primitive.attributes;
      if ((primitive.mode ?? 4) !== 4 || POSITION === undefined) continue; // lines, points, strips
      const positions = numbersOf(model, view, POSITION, 3);
      const welded = Array.from({ length: positions.length / 3 }, (_, i) => {
        const point = product(place, [...positions.slice(3 * i, 3 * i + 3), 1]).slice(0, 3).map((x) => Math.fround(x) + 0); // no -0
        const key = point.join();
        if (!places.has(key)) {
          places.set(key, places.size);
          points.push(...point);
        }
        return places.get(key)!;
      });
      const indices = primitive.indices === undefined ? welded.keys() : numbersOf(model, view, primitive.indices, 1);
      const drawn = Array.from(indices, (i) => welded[i]);
      const turns = determinant(place) < 0;
      for (let c = 0; c + 2 < drawn.length; c += 3) {
        const triangle = turns ? [drawn[c], drawn[c + 2], drawn[c + 1]] : drawn.slice(c, c + 3);
        if (new Set(triangle).size === 3) corners.push(...triangle);
      }
    }
    for (const child of node.children ?? []) visit(child, place, depth + 1);
  };
  for (const root of model.scenes?.[model.scene ?? 0]?.nodes ?? []) visit(root, upwards, 0);
  if (corners.length === 0) throw new Error("the file has no triangles");
  const degrees = new Uint32Array(corners.length / 3).fill(3);
  return { points: Float64Array.from(points), faces: { degrees, corners: Uint32Array.from(corners) } };
}

/** Of two matrices, or of a matrix and a vector. */
function product(a: number[], b: number[]): number[] {
  return b.map((_, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i % 4)] * b[4 * Math.floor(i / 4) + k], 0));
}

function determinant(a: number[]): number {
  return a[0] * (a[5] * a[10] - a[9] * a[6]) - a[4] * (a[1] * a[10] - a[9] * a[2]) + a[8] * (a[1] * a[6] - a[5] * a[2]);
}

function matrixOf({ matrix, translation = [0, 0, 0], rotation: [x, y, z, w] = [0, 0, 0, 1], scale: [r, s, t] = [1, 1, 1] }: Node): number[] {
  return matrix ?? [
    r * (1 - 2 * (y * y + z * z)), 2 * r * (x * y + z * w), 2 * r * (x * z - y * w), 0,
    2 * s * (x * y - z * w), s * (1 - 2 * (x * x + z * z)), 2 * s * (y * z + x * w), 0,
    2 * t * (x * z + y * w), 2 * t * (y * z - x * w), t * (1 - 2 * (x * x + y * y)), 0,
    ...translation, 1];
}

function partsOf(file: Uint8Array): [Model, DataView] {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  if (file.length < 20 || view.getUint32(0, true) !== 0x46546c67 || view.getUint32(4, true) !== 2) throw new Error("this is no binary glTF file, version 2");
  const length = view.getUint32(12, true);
  const model = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length))) as Model;
  return [model, new DataView(file.buffer, file.byteOffset + Math.min(file.length, 28 + length))];
}

function numbersOf({ accessors, bufferViews }: Model, view: DataView, index: number, n: number): number[] {
  const { bufferView, byteOffset = 0, componentType, count } = accessors![index];
  const of = bufferViews?.[bufferView ?? -1];
  const size = sizes[componentType];
  if (!of || of.buffer !== 0 || !size || (n === 3 && componentType !== float)) throw new Error("the file has numbers of a kind that is not read here");
  const start = (of.byteOffset ?? 0) + byteOffset;
  const stride = of.byteStride ?? n * size;
  if (start + stride * (count - 1) + n * size > view.byteLength) throw new Error("the file ends too early");
  const read = componentType === float ? view.getFloat32 : size === 4 ? view.getUint32 : size === 2 ? view.getUint16 : view.getUint8;
  return Array.from({ length: n * count }, (_, i) => read.call(view, start + stride * Math.floor(i / n) + size * (i % n), true));
}
