// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// For three.js.

import type * as THREE from "three";
import type { Mesh, Refined } from "./index.js";

/** The mesh of a geometry of triangles. Vertices at the same place become one, which graphics hardware needs several times
 * where normals or texture coordinates differ. Its normals are those of shading, and left out: control normals are
 * estimated. */
export function meshOf(geometry: THREE.BufferGeometry): Mesh & { faces: { degrees: number[]; corners: number[] } } {
  const { position, uv } = geometry.attributes;
  const index = geometry.getIndex();
  const places = new Map<string, number>();
  const result = { positions: [] as number[], faces: { degrees: [] as number[], corners: [] as number[] }, uv: [] as number[] };
  const welded = Array.from({ length: position.count }, (_, i) => {
    const point = [position.getX(i), position.getY(i), position.getZ(i)];
    const key = point.join();
    let place = places.get(key);
    if (place === undefined) {
      places.set(key, (place = places.size));
      result.positions.push(...point);
    }
    return place;
  });
  const count = index?.count ?? position.count;
  for (let c = 0; c + 2 < count; c += 3) {
    const drawn = [c, c + 1, c + 2].map((i) => index?.getX(i) ?? i);
    const corners = drawn.map((i) => welded[i]);
    if (new Set(corners).size < 3) continue; // without area
    result.faces.degrees.push(3);
    result.faces.corners.push(...corners);
    if (uv) result.uv.push(...drawn.flatMap((i) => [uv.getX(i), uv.getY(i)]));
  }
  return result;
}

/** What three.js draws; `three` is the module itself, so that this package depends on none. */
export function bufferGeometry(three: typeof THREE, { geometry }: Refined): THREE.BufferGeometry {
  const result = new three.BufferGeometry();
  result.setAttribute("position", new three.BufferAttribute(geometry.positions, 3));
  result.setAttribute("normal", new three.BufferAttribute(geometry.normals, 3));
  if (geometry.uv.length > 0) result.setAttribute("uv", new three.BufferAttribute(geometry.uv, 2));
  result.setIndex(new three.BufferAttribute(geometry.triangles, 1));
  return result;
}
