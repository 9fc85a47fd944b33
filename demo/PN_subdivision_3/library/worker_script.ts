// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What worker.ts starts.

import { load, type Mesh, type Options } from "./index.js";

export interface Request {
  number: number;
  mesh: Mesh;
  options?: Options;
}

const scope = globalThis as unknown as {
  onmessage: ((event: { data: Request }) => void) | null;
  postMessage(message: unknown, transfer: Transferable[]): void;
};
const loaded = load();

scope.onmessage = async ({ data: { number, mesh, options } }) => {
  try {
    const refined = (await loaded).subdivide(mesh, options);
    const { positions, normals, roundness, creases, faces, uv, geometry } = refined;
    const arrays = [positions, normals, roundness, creases, uv, faces.degrees, faces.corners, ...Object.values(geometry)];
    scope.postMessage({ number, refined }, arrays.map(({ buffer }) => buffer as ArrayBuffer));
  } catch (error) {
    scope.postMessage({ number, message: error instanceof Error ? error.message : String(error) }, []);
  }
};
