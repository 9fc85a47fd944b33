// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the colors of curvatures stand for.

import type { Shading } from "./shading";

/** The end of the colors of curvatures relative to their mean: this much less and more. */
export const endOfRelative = 0.4;

/** How much each value differs from the mean of all, as a share of it. */
export function relativeToMean(values: Float32Array): Float32Array {
  const mean = values.reduce((sum, x) => sum + x, 0) / Math.max(1, values.length);
  return values.map((x) => x / mean - 1);
}

/** The value at the end of the colors: nine tenths of the vertices are within. What is flat but for rounding stays so. */
export function endOfColors(values: Float32Array, size: number, shading: Shading): number {
  const sizes = values.map(Math.abs).sort();
  const least = shading === "mean" ? 1e-4 / size : 1e-4 / size ** 2;
  const end = sizes.length === 0 ? 1 : sizes[Math.floor(0.9 * (sizes.length - 1))];
  return Math.max(end, least);
}

export function isCurvature(shading: Shading): boolean {
  return shading === "gaussian" || shading === "mean" || shading === "relative";
}
