// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is on the screen as the part of the address behind '#', so that a view can be shared.

import { inflate } from "./modeler";
import type { MeshState } from "./modeler";

/** What has changed in an example, or a whole mesh. Numbers keep all their digits. */
export interface Edits {
  points?: number[][]; // vertex, x, y, z
  normals?: number[][]; // corner, x, y, z
  sharp?: number[]; // pairs of vertices, all of them
  roundness?: number[]; // of all vertices, of each or of each corner
  mesh?: { points: number[]; degrees: number[]; corners: number[]; normals: number[]; sharp: number[]; roundness?: number[] };
}

const damaged = "it is damaged, or its end is missing";

const sameArray = (a: ArrayLike<number>, b: ArrayLike<number>): boolean =>
  a.length === b.length && Array.prototype.every.call(a, (x: number, i: number) => x === b[i]);

function changedTriples(before: Float64Array, after: Float64Array): number[][] {
  const result: number[][] = [];
  for (let i = 0; i < after.length / 3; ++i) {
    const now = after.subarray(3 * i, 3 * i + 3);
    if (!sameArray(before.subarray(3 * i, 3 * i + 3), now)) result.push([i, ...now]);
  }
  return result;
}

/** One number where it is the same everywhere. */
export function shortRoundness({ roundness }: MeshState): number[] {
  if (!roundness) return [1];
  return roundness.every((w) => w === roundness[0]) ? [roundness[0]] : [...roundness];
}

function longRoundness(short: number[] | undefined, vertices: number, corners: number): Float64Array | undefined {
  if (short === undefined) return undefined;
  if (![1, vertices, corners].includes(short.length)) throw new Error(damaged);
  return short.length === 1 ? new Float64Array(vertices).fill(short[0]) : Float64Array.from(short);
}

/** Nothing if the mesh is its example. */
export function editsOf(mesh: MeshState, example: MeshState | undefined): Edits | undefined {
  if (!example || !sameArray(mesh.corners, example.corners) || !sameArray(mesh.degrees, example.degrees))
    return {
      mesh: {
        points: [...mesh.points],
        degrees: [...mesh.degrees],
        corners: [...mesh.corners],
        normals: [...mesh.cornerNormals!],
        sharp: [...mesh.sharpEdges],
        roundness: shortRoundness(mesh),
      },
    };
  const edits: Edits = {};
  const points = changedTriples(example.points, mesh.points);
  const normals = changedTriples(example.cornerNormals!, mesh.cornerNormals!);
  if (points.length > 0) edits.points = points;
  if (normals.length > 0) edits.normals = normals;
  if (!sameArray(mesh.sharpEdges, example.sharpEdges)) edits.sharp = [...mesh.sharpEdges];
  const roundness = shortRoundness(mesh);
  if (!sameArray(roundness, shortRoundness(example))) edits.roundness = roundness;
  return Object.keys(edits).length > 0 ? edits : undefined;
}

/** Anybody may have written the edits. */
export function applyEdits(edits: Edits, example: MeshState | undefined): MeshState {
  try {
    return edited(edits, example);
  } catch {
    throw new Error(damaged);
  }
}

function edited(edits: Edits, example: MeshState | undefined): MeshState {
  if (edits.mesh)
    return {
      points: Float64Array.from(edits.mesh.points),
      degrees: Uint32Array.from(edits.mesh.degrees),
      corners: Uint32Array.from(edits.mesh.corners),
      cornerNormals: Float64Array.from(edits.mesh.normals),
      sharpEdges: Uint32Array.from(edits.mesh.sharp),
      roundness: longRoundness(edits.mesh.roundness, edits.mesh.points.length / 3, edits.mesh.corners.length),
    };
  if (!example) throw new Error(damaged);
  const state = { ...example, points: example.points.slice(), cornerNormals: example.cornerNormals!.slice() };
  const put = (array: Float64Array, changes: number[][] | undefined): void => {
    for (const [i, ...values] of changes ?? []) {
      if (!(3 * i + 3 <= array.length) || values.length !== 3) throw new Error(damaged);
      array.set(values, 3 * i);
    }
  };
  put(state.points, edits.points);
  put(state.cornerNormals, edits.normals);
  if (edits.sharp) state.sharpEdges = Uint32Array.from(edits.sharp);
  if (edits.roundness) state.roundness = longRoundness(edits.roundness, state.points.length / 3, state.corners.length);
  return state;
}

/** Compressed, in letters that an address takes. */
export async function pack(value: unknown): Promise<string> {
  const stream = new Blob([JSON.stringify(value)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** An object. */
export async function unpack(text: string): Promise<object> {
  try {
    const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = await inflate(Uint8Array.from(binary, (c) => c.charCodeAt(0)), "deflate-raw");
    return Object(JSON.parse(new TextDecoder().decode(bytes)));
  } catch {
    throw new Error(damaged);
  }
}

/** The name before "=" and what is packed behind it. */
export function partsOf(hash: string): [name: string, packed: string | undefined] {
  const [name, packed] = hash.slice(1).split("=");
  try {
    return [decodeURIComponent(name), packed];
  } catch {
    throw new Error(damaged);
  }
}
