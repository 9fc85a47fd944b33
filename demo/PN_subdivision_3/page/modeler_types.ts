// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The types of ../modeler/bindings.cpp.

/** All that is to be known of a control mesh, as flat arrays: for undo, files and addresses. */
export interface MeshState {
  points: Float64Array;
  degrees: Uint32Array;
  corners: Uint32Array;
  /** Of each corner; without them they are estimated. */
  cornerNormals?: Float64Array;
  /** Pairs of vertices. */
  sharpEdges: Uint32Array;
  /** Of each vertex, or of each corner where creases have another one on each side; without it 1, or as the normals are
   * estimated. */
  roundness?: Float64Array;
  /** Texture coordinates of each corner. */
  uv?: Float64Array;
}

/** What a user takes hold of. A wedge is a run of faces at a vertex between sharp edges, with a normal of its own. */
export interface Handles {
  points: Float64Array;
  /** The vertex of each wedge. */
  vertices: Uint32Array;
  /** Of each wedge. */
  normals: Float64Array;
  edges: Uint32Array;
  sharp: Uint8Array;
  border: Uint8Array;
}

export interface Faces {
  degrees: Uint32Array;
  corners: Uint32Array;
}

export interface ControlMesh {
  state(): MeshState;
  handles(): Handles;
  triangulated(): ControlMesh;
  hasOnlyTriangles(): boolean;
  numberOfFaces(): number;
  numberOfSharpEdges(): number;
  /** Of a mesh that was read, for people: where its normals come from, and what was repaired. */
  normalsFrom(): string;
  repair(): string;
  setPoint(vertex: number, x: number, y: number, z: number): void;
  setNormal(wedge: number, x: number, y: number, z: number): void;
  setSharp(edge: number, isSharp: boolean): void;
  detectCreases(degrees: number): number;
  dropNormals(): void;
  /** And the roundness. */
  estimateNormals(): void;
  takeNormalsOfSphere(): void;
  setRoundness(roundness: number): void;
  estimateRoundness(): void;
  delete(): void;
}

/** What there is where there are creases; all of no length: there are none. */
export interface Sides {
  /** Pairs of vertices. */
  sharpEdges: Uint32Array;
  /** At these vertices, into the edges; of no length if the surface is linear. */
  tangents: Float64Array;
  /** Of the corners of the faces. */
  normals: Float64Array;
  roundness: Float64Array;
}

export interface RefinedSurface {
  /** To be told of each control vertex that has changed, before update(). */
  follow(mesh: ControlMesh, vertex: number): void;
  update(mesh: ControlMesh): void;
  /** Until hideLimit() or the next update(). */
  showLimit(mesh: ControlMesh): void;
  hideLimit(): void;
  curvature(isGaussian: boolean): Float32Array;
  /** Relative to the origin that refine() was given. Views are valid until the next call of anything. */
  positionsView(): Float32Array;
  normalsView(): Float32Array;
  triangles(): Uint32Array;
  points(): Float64Array;
  controlNormals(): Float64Array;
  /** Beside the control normals; of no length where it is 1. */
  roundness(mesh: ControlMesh): Float64Array;
  faces(): Faces;
  /** Of the corners of the faces; of no length where the control mesh has none. */
  uv(): Float64Array;
  sides(): Sides;
  delete(): void;
}

export type SchemeName = "catmull-clark" | "kobbelt" | "loop" | "butterfly" | "doo-sabin" | "sqrt3" | "modified-catmull-clark" |
  "modified-loop" | "ct-catmull-clark" | "ct-loop" | "midpoint" | "bilinear";

export interface SchemeTraits {
  name: SchemeName;
  takesTriangles: boolean;
  takesQuads: boolean;
  hasCreaseRules: boolean;
  hasLimitPoints: boolean;
}

export interface PlaneCurve {
  points: Float64Array;
  normals: Float64Array;
  curvature: Float64Array;
  /** Tips of the teeth, for the scale 1. */
  comb: Float64Array;
}

export interface Modeler {
  /** `repairs`: whether what is no oriented manifold is made one. */
  readMesh(content: Uint8Array, format: string, repairs: boolean): ControlMesh;
  restoreMesh(state: MeshState): ControlMesh;
  /** What is shown is relative to x, y, z. */
  refine(mesh: ControlMesh, scheme: string, rounds: number, isLinear: boolean, x: number, y: number, z: number): RefinedSurface;
  schemes(): SchemeTraits[];
  /** Three corners of each triangle, as the command splits faces for files of triangles. */
  splitFaces(points: Float64Array, faces: Faces): Uint32Array;
  refineCurve(points: Float64Array, normals: Float64Array, mask: string, isLinear: boolean, isClosed: boolean,
    rounds: number, roundness: number): PlaneCurve;
  estimateCurveNormals(points: Float64Array, isClosed: boolean): Float64Array;
}
