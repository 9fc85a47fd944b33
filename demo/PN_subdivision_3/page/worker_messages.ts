// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the page and its worker say to each other.

import type { MeshState } from "./modeler_types";
import type { AboutFile, ReadJob } from "./read_file";
import type { Content, Drawings, Shown, Wanted } from "./surfaces";

export interface Make extends Wanted {
  state: MeshState;
}

/** Of vertices or of normals of vertices: a number, x, y, z. */
export type Edit = [number, number, number, number];

export interface DrawJob {
  /** New surfaces; then the edits. */
  make?: Make;
  points: Edit[];
  normals: Edit[];
  shown: Shown;
}

export interface ReadMesh {
  state: MeshState;
  hasOnlyTriangles: boolean;
  about: AboutFile;
}

export type Request = { number: number } & (
  | { draw: DrawJob }
  | { read: ReadJob }
  | { content: { isLinear: boolean } });

/** With how long it took to make, if anything was made. */
export type Drawn = Drawings & { milliseconds?: number };

export type Answer = { number: number } & (
  | { drawn: Drawn }
  | { read: ReadMesh }
  | { content: Content }
  | { message: string }
  /** From 0 to 1; more is to come. */
  | { progress: number });
