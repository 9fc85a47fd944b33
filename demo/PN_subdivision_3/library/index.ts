// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The package as a library for JavaScript: in browsers, workers and Node.js.

import createModule from "./modeler.js";
import type { ControlMesh, Faces, MeshState, Modeler, RefinedSurface, SchemeName, SchemeTraits } from "../page/modeler_types.js";

export type { Faces, SchemeName, SchemeTraits };

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
  /** Of each vertex, or of each corner of each face, from 0 (linear) to 1 (point-normal). */
  roundness?: ArrayLike<number>;
  /** Texture coordinates: u, v of each vertex, or of each corner of each face; where those of a vertex differ there is a
   * seam. They follow the scheme as points of a linear surface do. */
  uv?: ArrayLike<number>;
}

export interface Options {
  /** One of schemes(); "catmull-clark" if there is none. */
  scheme?: SchemeName;
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
  /** Control normals, for further rounds: of each vertex, with creases of each corner; with `limit` the normals of the
   * surface; of no length if linear. */
  normals: Float64Array;
  /** The same of the roundness, for further rounds; of no length where it is 1. */
  roundness: Float64Array;
  /** Pairs of vertices, for further rounds. */
  creases: Uint32Array;
  faces: Faces;
  /** Of each corner of the faces; of no length where none were given. */
  uv: Float64Array;
  /** To be drawn: vertices along creases and seams are there once for each side. `uv` has no length where none were given. */
  geometry: { positions: Float32Array; normals: Float32Array; triangles: Uint32Array; uv: Float32Array };
}

export interface PointNormalSubdivision {
  /** Throws an Error that names the element if the mesh is none that the scheme takes. */
  subdivide(mesh: Mesh, options?: Options): Refined;
  /** The content of a PLY, OFF, OBJ or STL file, as the command `pn_subdivide` reads it; throws an Error that names what is
   * wrong with it. Normals and the roundness are estimated where there are none. */
  read(content: Uint8Array | string, format: "ply" | "off" | "obj" | "stl"): ReadMesh;
  schemes(): SchemeTraits[];
}

/** A mesh for subdivide(); normals are of corners. */
export type ReadMesh = Required<Pick<Mesh, "positions" | "normals" | "creases">> & Pick<Mesh, "roundness"> & { faces: Faces };

const optionNames = ["scheme", "levels", "linear", "limit", "roundness"];

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
    read: (content, format) => read(modeler, content, format),
    schemes: () => modeler.schemes(),
  };
}

function subdivide(modeler: Modeler, mesh: Mesh, options: Options): Refined {
  const unknown = Object.keys(options).find((name) => !optionNames.includes(name));
  if (unknown !== undefined) throw new Error(`there is no option '${unknown}': it must be one of ${optionNames.join(", ")}`);
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

function read(modeler: Modeler, content: Uint8Array | string, format: string): ReadMesh {
  const mesh = modeler.readMesh(typeof content === "string" ? new TextEncoder().encode(content) : content, format, false);
  try {
    const { points, degrees, corners, cornerNormals, sharpEdges, roundness } = mesh.state();
    return { positions: points, faces: { degrees, corners }, normals: cornerNormals!, creases: sharpEdges, roundness };
  } finally {
    mesh.delete();
  }
}

function resultOf(surface: RefinedSurface, control: ControlMesh, isLimit: boolean): Refined {
  const faces = surface.faces();
  const uv = surface.uv();
  const triangles = surface.triangles();
  const drawn = { positions: surface.positionsView().slice(), normals: surface.normalsView().slice(), triangles };
  const sides = surface.sides();
  const hasSides = sides.sharpEdges.length > 0;
  return {
    positions: surface.points(),
    normals: hasSides ? sides.normals : surface.controlNormals(),
    roundness: isLimit ? new Float64Array(0) : hasSides ? sides.roundness : surface.roundness(control),
    creases: sides.sharpEdges,
    faces,
    uv,
    geometry: uv.length > 0 ? cutAtSeams(drawn, faces.degrees, uv) : { ...drawn, uv: new Float32Array(0) },
  };
}

/** Triangles are fans about the first corners of the faces. */
function cutAtSeams(drawn: Omit<Refined["geometry"], "uv">, degrees: Uint32Array, uv: Float64Array): Refined["geometry"] {
  const places = new Map<string, number>(); // of vertices with texture coordinates
  const sources: number[] = [];
  const coordinates: number[] = [];
  const triangles = new Uint32Array(drawn.triangles.length);
  let [first, t] = [0, 0];
  for (const degree of degrees) {
    for (let c = 2; c < degree; ++c)
      for (const corner of [first, first + c - 1, first + c]) {
        const vertex = drawn.triangles[t];
        const [u, v] = [uv[2 * corner], uv[2 * corner + 1]];
        const key = `${vertex} ${u} ${v}`;
        let place = places.get(key);
        if (place === undefined) {
          places.set(key, (place = sources.length));
          sources.push(vertex);
          coordinates.push(u, v);
        }
        triangles[t++] = place;
      }
    first += degree;
  }
  const copied = (of: Float32Array): Float32Array =>
    Float32Array.from({ length: 3 * sources.length }, (_, i) => of[3 * sources[Math.floor(i / 3)] + (i % 3)]);
  return { positions: copied(drawn.positions), normals: copied(drawn.normals), triangles, uv: Float32Array.from(coordinates) };
}

function flatFaces(faces: Mesh["faces"]): Faces {
  if (typeof faces !== "object" || faces === null) throw new Error("the mesh has no faces: they must be lists of vertices, or { degrees, corners }");
  if ("degrees" in faces) return { degrees: indices("degrees", faces.degrees), corners: indices("corners", faces.corners) };
  const lists = Array.from(faces);
  const wrong = lists.findIndex((face) => typeof face?.length !== "number");
  if (wrong >= 0) throw new RangeError(`face ${wrong} is no list of vertices`);
  return { degrees: indices("degrees", lists.map((face) => face.length)), corners: indices("faces", lists.flatMap((face) => Array.from(face))) };
}

function indices(name: string, list: ArrayLike<number>): Uint32Array {
  if (typeof list?.length !== "number") throw new RangeError(`${name} must be a list of numbers`);
  const wrong = Array.prototype.findIndex.call(list, (i: number) => !Number.isInteger(i) || i < 0 || i >= 2 ** 32);
  if (wrong >= 0) throw new RangeError(`${name}: ${list[wrong]} is no number of a vertex`);
  return Uint32Array.from(list);
}

/** What has no length is not given, as in results. */
function given(values: ArrayLike<number> | undefined): ArrayLike<number> | undefined {
  return values?.length === 0 ? undefined : values;
}

function stateOf(mesh: Mesh): MeshState {
  const [normals, roundness, uv] = [given(mesh.normals), given(mesh.roundness), given(mesh.uv)];
  const { degrees, corners } = flatFaces(mesh.faces);
  if (!(mesh.positions?.length % 3 === 0) || typeof (mesh.positions[0] ?? 0) !== "number")
    throw new RangeError("positions must be three numbers for each vertex, one after the other");
  const vertices = mesh.positions.length / 3;
  if (roundness && roundness.length !== vertices && roundness.length !== corners.length)
    throw new RangeError(`there are ${vertices} vertices, and the roundness of ${roundness.length}`);
  if ((mesh.creases?.length ?? 0) % 2 !== 0) throw new RangeError("creases must be pairs of vertices");
  return {
    points: Float64Array.from(mesh.positions),
    degrees,
    corners,
    cornerNormals: normals && ofCorners("normals", normals, 3, vertices, corners),
    sharpEdges: indices("creases", mesh.creases ?? []),
    roundness: roundness && Float64Array.from(roundness),
    uv: uv && ofCorners("uv", uv, 2, vertices, corners),
  };
}

/** What is given for each vertex or for each corner. */
function ofCorners(name: string, values: ArrayLike<number>, n: 2 | 3, vertices: number, corners: Uint32Array): Float64Array {
  if (values.length === n * corners.length && values.length !== n * vertices) return Float64Array.from(values);
  if (values.length !== n * vertices)
    throw new RangeError(`${name} must be ${n === 3 ? "three" : "two"} numbers for each of ${vertices} vertices or ${corners.length} corners`);
  const result = new Float64Array(n * corners.length);
  corners.forEach((v, c) => {
    if (v < vertices) for (let k = 0; k < n; ++k) result[n * c + k] = values[n * v + k];
  });
  return result;
}
