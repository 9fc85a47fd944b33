// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes that are too large to be edited here: they are shown and refined by the worker, and stay as they are.

import type { ControlMesh, Handles, MeshState } from "./modeler_types";

const mostFacesToEdit = 60_000;

export class FrozenMesh implements ControlMesh {
  constructor(
    private readonly given: MeshState,
    private readonly onlyTriangles: boolean,
  ) {}

  state(): MeshState {
    return this.given;
  }
  /** Nothing of it can be held. */
  handles(): Handles {
    const none = new Float64Array();
    return { points: none, normals: none, vertices: new Uint32Array(), edges: new Uint32Array(), sharp: new Uint8Array(),
      border: Uint8Array.of(1) };
  }
  hasOnlyTriangles(): boolean {
    return this.onlyTriangles;
  }
  numberOfFaces(): number {
    return this.given.degrees.length;
  }
  numberOfSharpEdges(): number {
    return this.given.sharpEdges.length / 2;
  }
  normalsFrom(): string {
    return "";
  }
  repair(): string {
    return "";
  }
  delete(): void {}

  refuse = refuse;
  triangulated = refuse;
  setPoint = refuse;
  setNormal = refuse;
  setSharp = refuse;
  detectCreases = refuse;
  dropNormals = refuse;
  estimateNormals = refuse;
  takeNormalsOfSphere = refuse;
  setRoundness = refuse;
  estimateRoundness = refuse;
}

function refuse(): never {
  throw new Error(`meshes with more than ${mostFacesToEdit} faces are shown here, but not edited`);
}

export function isTooLargeToEdit(state: MeshState): boolean {
  return state.degrees.length > mostFacesToEdit;
}
