// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// For three.js.

import type * as THREE from "three";
import type { Refined } from "./index.js";

/** What three.js draws; `three` is the module itself, so that this package depends on none. */
export function bufferGeometry(three: typeof THREE, { geometry }: Refined): THREE.BufferGeometry {
  const result = new three.BufferGeometry();
  result.setAttribute("position", new three.BufferAttribute(geometry.positions, 3));
  result.setAttribute("normal", new three.BufferAttribute(geometry.normals, 3));
  result.setIndex(new three.BufferAttribute(geometry.triangles, 1));
  return result;
}
