// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The rule of X. Yang, Point-Normal Subdivision Curves and Surfaces, Section 3.1, for two points with normals in the
// plane: every number of it is shown. Roundness and the fade of opposite normals are as in the package's PN_average.

export type Pair = [number, number];
export interface PointNormal {
  p: Pair;
  /** Of length 1, or 0: none. */
  n: Pair;
}

export interface Average {
  q: Pair;
  n: Pair;
  /** The height of the end of the arc from each point, over q along n. */
  h: Pair;
  /** Their mean, times the roundness. */
  height: number;
  p: Pair;
}

const dot = (a: Pair, b: Pair): number => a[0] * b[0] + a[1] * b[1];
export const along = (a: Pair, s: number, v: Pair): Pair => [a[0] + s * v[0], a[1] + s * v[1]];

/** How much an entry counts whose normal is nearly opposite to the new one: not at all from 155 degrees on. */
function fade(d: number): number {
  const [begin, end] = [75 / 256, 3 / 32];
  const t = Math.min(1, Math.max(0, (d - end) / (begin - end)));
  return t * t * (3 - 2 * t);
}

/** Between two points, nearer to the second one the larger `share` is. */
export function average(a: PointNormal, b: PointNormal, share: number, roundness: number): Average {
  const weights = [1 - share, share];
  const both = [a, b];
  const sum = (of: (entry: PointNormal) => Pair): Pair =>
    [0, 1].map((k) => weights[0] * of(both[0])[k] + weights[1] * of(both[1])[k]) as Pair;
  const q = sum(({ p }) => p);
  const total = sum(({ n }) => n);
  const length = Math.hypot(...total);
  if (length < 1e-12) return { q, n: [0, 0], h: [0, 0], height: 0, p: q };
  const n: Pair = [total[0] / length, total[1] / length];
  const halves = both.map((entry) => along(entry.n, 1, n));
  const d = halves.map((s) => dot(s, n));
  const h = both.map(({ p }, j) => dot(halves[j], along(p, -1, q)) / d[j]) as Pair;
  const counted = weights.map((w, j) => w * fade(d[j]));
  const all = counted[0] + counted[1];
  const mean = all < 1 / 64 ? 0 : counted.reduce((s, w, j) => (w === 0 ? s : s + w * h[j]), 0) / all;
  return { q, n, h, height: roundness * mean, p: along(q, roundness * mean, n) };
}

/** A new point in each edge. */
export function nextRound(polygon: PointNormal[], share: number, roundness: number): PointNormal[] {
  return polygon.flatMap((entry, i) => {
    if (i + 1 === polygon.length) return [entry];
    const { p, n } = average(entry, polygon[i + 1], share, roundness);
    return [entry, { p, n }];
  });
}

/** The arc from a point to the end at its height, as points: of a circle with both normals, or straight. */
export function arcTo(from: PointNormal, end: Pair, n: Pair): Pair[] {
  const turn = along(n, -1, from.n);
  const squared = dot(turn, turn);
  if (squared < 1e-12 || dot(from.n, from.n) === 0) return [from.p, end];
  const radius = dot(along(end, -1, from.p), turn) / squared;
  const center = along(from.p, -radius, from.n);
  const first = Math.atan2(from.n[1], from.n[0]);
  const angle = Math.atan2(from.n[0] * n[1] - from.n[1] * n[0], dot(from.n, n));
  return Array.from({ length: 33 }, (_, i) => {
    const a = first + (i / 32) * angle;
    return along(center, radius, [Math.cos(a), Math.sin(a)]);
  });
}
