// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Circles and spheres that control points lie on.

const onShape = 1e-9; // of the radius

/** Solves a 3 by 3 system, row by row; NaN or infinite where there is no solution. */
function solve(a: number[][], b: number[]): number[] {
  const det = (m: number[][]): number =>
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  const d = det(a);
  return [0, 1, 2].map((k) => det(a.map((row, i) => row.map((x, j) => (j === k ? b[i] : x)))) / d);
}

/** The largest distance of points from a sphere or circle, in radii. */
export function deviation(points: ArrayLike<number>, center: number[], radius: number): number {
  const n = center.length;
  let worst = 0;
  for (let i = 0; i < points.length; i += n) {
    let squared = 0;
    for (let k = 0; k < n; ++k) squared += (points[i + k] - center[k]) ** 2;
    worst = Math.max(worst, Math.abs(Math.sqrt(squared) - radius) / radius);
  }
  return worst;
}

/** The sphere of which the squared distances of the points are least wrong: linear in the center and r^2 - |center|^2. */
export function bestSphere(points: ArrayLike<number>): Round {
  const n = points.length / 3;
  const mean = [0, 0, 0];
  for (let i = 0; i < points.length; ++i) mean[i % 3] += points[i] / n;
  const second = [0, 1, 2].map(() => [0, 0, 0]);
  const third = [0, 0, 0];
  let squared = 0;
  for (let i = 0; i < points.length; i += 3) {
    const d = mean.map((m, k) => points[i + k] - m);
    const length = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    squared += length / n;
    for (let k = 0; k < 3; ++k) {
      third[k] += (d[k] * length) / n;
      for (let j = 0; j < 3; ++j) second[k][j] += (2 * d[k] * d[j]) / n;
    }
  }
  const found = solve(second, third);
  const offset = found.every(Number.isFinite) ? found : [0, 0, 0];
  const radius = Math.sqrt(squared + offset.reduce((sum, x) => sum + x * x, 0));
  return { center: mean.map((m, k) => m + offset[k]), radius };
}

export interface Round {
  center: number[];
  radius: number;
}

/** The circle (2 coordinates) or sphere (3) that all points are on, if there is one and they determine it. */
export function roundShapeThrough(points: ArrayLike<number>, dimension: 2 | 3): Round | undefined {
  const n = points.length / dimension;
  if (n < dimension + 1) return undefined;
  const at = (i: number): number[] => Array.from({ length: dimension }, (_, k) => points[dimension * i + k]);
  const origin = at(0);
  // three far apart, to solve with: for those next to each other it would be ill-conditioned
  for (const step of [3, 4, 5, 7]) {
    const others = [1, 2, 3].slice(0, dimension).map((i) => at(Math.floor((i * (n - 1)) / Math.min(step, n - 1)) % n));
    const rows = others.map((p) => p.map((x, k) => 2 * (x - origin[k])));
    const right = others.map((p) => p.reduce((sum, x, k) => sum + (x - origin[k]) ** 2, 0));
    if (dimension === 2) {
      rows.forEach((row) => row.push(0));
      rows.push([0, 0, 1]);
      right.push(0);
    }
    const offset = solve(rows, right).slice(0, dimension);
    if (!offset.every(Number.isFinite)) continue;
    const center = offset.map((x, k) => origin[k] + x);
    const radius = Math.hypot(...offset);
    const extent = Math.max(...others.map((p) => Math.hypot(...p.map((x, k) => x - origin[k]))));
    // points of a plane are on spheres that are large enough
    if (radius < 100 * extent && deviation(points, center, radius) < onShape) return { center, radius };
  }
  return undefined;
}
