// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Creases in a selection file of CGAL: three lines of numbers, of which the third has the edges as pairs of vertices.
// Normals of corners tell of most creases, but not of those along which two surfaces are tangent.

import type { ControlMesh, Modeler } from "./modeler";

/** The mesh with these edges as its only creases; the one that is given is deleted. Throws an Error that names
 * the first edge that is none. */
export function withCreases(modeler: Modeler, mesh: ControlMesh, selection: string): ControlMesh {
  try {
    const sharpEdges = edgesOf(selection);
    return modeler.restoreMesh({ ...mesh.state(), sharpEdges: Uint32Array.from(sharpEdges) });
  } finally {
    mesh.delete();
  }
}

function edgesOf(selection: string): number[] {
  const words = (selection.split(/\r?\n/)[2] ?? "").trim().split(/\s+/).filter((word) => word !== "");
  const wrong = words.find((word) => !/^\d+$/.test(word));
  if (wrong !== undefined) throw new Error(`line 3: ${wrong.slice(0, 20)} is no number of a vertex`);
  if (words.length % 2 !== 0) throw new Error("line 3: the last edge has one vertex only");
  return words.map(Number);
}
