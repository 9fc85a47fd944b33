// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The package as a library for JavaScript: in browsers, workers and Node.js.

import createModule from "./modeler.js";
import type { ControlMesh, Faces, MeshState, Modeler, RefinedSurface, SchemeTraits } from "../page/modeler_types";

export type { Faces, SchemeTraits };

/** A polygon mesh, an oriented 2-manifold with or without borders. Nothing of it is changed. */
export interface Mesh {
  /** x, y, z of each vertex. */
  positions: ArrayLike<number>;
  /** The vertices of each face, counter-clockwise as seen from outside; or flat, with the degrees of all faces. */
  faces: ArrayLike<ArrayLike<number>> | { degrees: ArrayLike<number>; corners: ArrayLike<number> };
  /** The control normals: x, y, z of each vertex, or of each corner of each face; 0, 0, 0 where there is none. Without
   * them normals and the roundness are estimated. */
  normals?: ArrayLike<number>;
  /** Sharp edges: pairs of vertices. */
  creases?: ArrayLike<number>;
  /** Of each vertex, from 0 (linear) to 1 (point-normal). */
  roundness?: ArrayLike<number>;
}

export interface Options {
  /** One of schemes(); "catmull-clark" if there is none. */
  scheme?: string;
  /** Rounds of refinement; 1 if there is no number. */
  levels?: number;
  /** The scheme without normals. */
  linear?: boolean;
  /** Points and normals of the limit surface. Not with creases. */
  limit?: boolean;
  /** Of all vertices, instead of the mesh's; or read off the points. */
  roundness?: number | "estimate";
}

export interface Refined {
  positions: Float64Array;
  /** Control normals, for further rounds; with `limit` the normals of the surface; of no length if linear. */
  normals: Float64Array;
  /** Of each vertex, for further rounds; of no length where it is 1. */
  roundness: Float64Array;
  faces: Faces;
  /** To be drawn: vertices along creases are there once for each side. Relative to the origin that was given. */
  geometry: { positions: Float32Array; normals: Float32Array; triangles: Uint32Array };
}

export interface PointNormalSubdivision {
  /** Throws an Error that names the element if the mesh is none that the scheme takes. */
  subdivide(mesh: Mesh, options?: Options): Refined;
  schemes(): SchemeTraits[];
}

async function binaryBeside(name: string): Promise<Uint8Array> {
  const address = new URL(name, import.meta.url);
  if (address.protocol !== "file:") return new Uint8Array(await (await fetch(address)).arrayBuffer());
  // what bundlers for browsers do not look for
  const files = (await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs/promises" as string)) as {
    readFile(file: URL): Promise<Uint8Array>;
  };
  return files.readFile(address);
}

/** Loads the WebAssembly module that is beside this file, or takes one that has been loaded. */
export async function load(wasmBinary?: Uint8Array): Promise<PointNormalSubdivision> {
  const modeler = await createModule({ wasmBinary: wasmBinary ?? (await binaryBeside("modeler.wasm")) });
  return {
    subdivide: (mesh, options = {}) => subdivide(modeler, mesh, options),
    schemes: () => modeler.schemes(),
  };
}

function subdivide(modeler: Modeler, mesh: Mesh, options: Options): Refined {
  const { scheme = "catmull-clark", levels = 1, linear = false, limit = false, roundness } = options;
  const traits = modeler.schemes().find(({ name }) => name === scheme);
  if (!traits) throw new Error(`there is no scheme '${scheme}': it must be one of ${modeler.schemes().map(({ name }) => name).join(", ")}`);
  if (!Number.isInteger(levels) || levels < 0) throw new RangeError("levels must be a number of rounds: 0, 1, 2, ...");
  const control = modeler.restoreMesh(stateOf(mesh));
  let surface: RefinedSurface | undefined;
  try {
    if (traits.takesTriangles && !control.hasOnlyTriangles()) throw new Error(`${scheme} takes triangles only`);
    if (roundness === "estimate") control.estimateRoundness();
    else if (roundness !== undefined) control.setRoundness(roundness);
    surface = modeler.refine(control, scheme, levels, linear, 0, 0, 0);
    if (limit) surface.showLimit(control);
    return resultOf(surface, control, limit);
  } finally {
    surface?.delete();
    control.delete();
  }
}

function resultOf(surface: RefinedSurface, control: ControlMesh, isLimit: boolean): Refined {
  return {
    positions: surface.points(),
    normals: surface.controlNormals(),
    roundness: isLimit ? new Float64Array(0) : surface.roundness(control),
    faces: surface.faces(),
    geometry: {
      positions: surface.positionsView().slice(),
      normals: surface.normalsView().slice(),
      triangles: surface.triangles(),
    },
  };
}

function flatFaces(faces: Mesh["faces"]): Faces {
  if ("degrees" in faces) return { degrees: indices(faces.degrees), corners: indices(faces.corners) };
  const lists = Array.from(faces);
  return { degrees: indices(lists.map((face) => face.length)), corners: indices(lists.flatMap((face) => Array.from(face))) };
}

function indices(list: ArrayLike<number>): Uint32Array {
  const wrong = Array.prototype.findIndex.call(list, (i: number) => !Number.isInteger(i) || i < 0 || i >= 2 ** 32);
  if (wrong >= 0) throw new RangeError(`${list[wrong]} is no number of a vertex`);
  return Uint32Array.from(list);
}

function stateOf(mesh: Mesh): MeshState {
  const { degrees, corners } = flatFaces(mesh.faces);
  if (mesh.positions.length % 3 !== 0) throw new RangeError("positions must be three numbers for each vertex");
  const vertices = mesh.positions.length / 3;
  if (mesh.roundness && mesh.roundness.length !== vertices)
    throw new RangeError(`there are ${vertices} vertices, and the roundness of ${mesh.roundness.length}`);
  return {
    points: Float64Array.from(mesh.positions),
    degrees,
    corners,
    cornerNormals: mesh.normals && normalsOfCorners(mesh.normals, vertices, corners),
    sharpEdges: indices(mesh.creases ?? []),
    roundness: mesh.roundness && Float64Array.from(mesh.roundness),
  };
}

function normalsOfCorners(normals: ArrayLike<number>, vertices: number, corners: Uint32Array): Float64Array {
  if (normals.length === 3 * corners.length && normals.length !== 3 * vertices) return Float64Array.from(normals);
  if (normals.length !== 3 * vertices)
    throw new RangeError(`normals must be three numbers for each of ${vertices} vertices or ${corners.length} corners`);
  const result = new Float64Array(3 * corners.length);
  corners.forEach((v, c) => {
    if (v < vertices) for (let k = 0; k < 3; ++k) result[3 * c + k] = normals[3 * v + k];
  });
  return result;
}
