// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The surfaces of a control mesh, and what is drawn of them: the same on the page and in its worker.

import { endOfColors, endOfRelative, isCurvature, relativeToMean } from "./color_scale";
import type { ControlMesh, Faces, Modeler, RefinedSurface, Sides } from "./modeler_types";
import { bestSphere, deviation } from "./round_shapes";
import type { Shading } from "./shading";

/** What takes no longer than this many milliseconds is done while the mouse moves. */
const whileDragging = 25;

export interface Wanted {
  scheme: string;
  rounds: number;
  /** Whether the surfaces are linear. */
  kinds: boolean[];
  /** What is drawn is relative to it. */
  origin: [number, number, number];
}

export interface Shown {
  limit: boolean;
  shading: Shading;
  /** Of the mesh. */
  size: number;
  /** Whether the mouse is at rest. */
  isLast: boolean;
  /** Whether the radii about the best sphere are wanted. */
  deviations: boolean;
}

/** Arrays are views until the next call of anything. */
export interface Drawing {
  isLinear: boolean;
  positions: Float32Array;
  normals: Float32Array;
  /** Left out where they are those of the drawing before. */
  triangles?: Uint32Array;
  /** Of the colors. */
  values?: Float32Array;
  /** How much the radii about the best sphere differ. */
  deviation?: number;
}

export interface Drawings {
  drawings: Drawing[];
  colorEnd?: number;
}

/** What is taken away. */
export interface Content {
  points: Float64Array;
  normals: Float64Array;
  /** Of no length where it is 1. */
  roundness: Float64Array;
  sides: Sides;
  faces: Faces;
  /** As it is drawn, without the origin. */
  positions: Float32Array;
  drawnNormals: Float32Array;
  triangles: Uint32Array;
}

export class Surfaces {
  private made = new Map<boolean, RefinedSurface>();
  private areNew = false;
  private cost = { limit: 0, curvature: 0 };

  constructor(private readonly modeler: Modeler) {}

  get(isLinear: boolean): RefinedSurface | undefined {
    return this.made.get(isLinear);
  }

  /** If anything fails, nothing has changed. */
  make(mesh: ControlMesh, { scheme, rounds, kinds, origin }: Wanted, onStep?: () => void): void {
    const made = new Map<boolean, RefinedSurface>();
    try {
      for (const isLinear of kinds) {
        made.set(isLinear, this.modeler.refine(mesh, scheme, rounds, isLinear, ...origin));
        onStep?.();
      }
    } catch (error) {
      for (const surface of made.values()) surface.delete();
      throw error;
    }
    this.clear();
    this.made = made;
    this.areNew = true;
  }

  clear(): void {
    for (const surface of this.made.values()) surface.delete();
    this.made.clear();
  }

  /** These vertices of the mesh have moved, or their normals have turned. */
  follow(mesh: ControlMesh, vertices: Iterable<number>): void {
    for (const surface of this.made.values()) {
      for (const v of vertices) surface.follow(mesh, v);
      surface.update(mesh);
    }
  }

  /** Limit points and curvatures are left for the end of a drag where they take long. */
  draw(mesh: ControlMesh, shown: Shown, onStep?: () => void): Drawings {
    const { limit, shading, isLast } = shown;
    const drawings: Drawing[] = [];
    for (const surface of this.made.values()) {
      if (limit && (isLast || this.cost.limit < whileDragging)) this.cost.limit = timeOf(() => surface.showLimit(mesh));
      else if (!limit) surface.hideLimit();
      onStep?.();
    }
    const values = new Map<boolean, Float32Array>();
    if (isCurvature(shading) && (isLast || this.cost.curvature < whileDragging))
      this.cost.curvature = timeOf(() => {
        for (const [isLinear, surface] of this.made) values.set(isLinear, surface.curvature(shading !== "mean"));
      });
    const isRelative = shading === "relative";
    for (const [isLinear, surface] of this.made) {
      const curvatures = values.get(isLinear);
      drawings.push({
        isLinear,
        triangles: this.areNew ? surface.triangles() : undefined,
        values: curvatures && isRelative ? relativeToMean(curvatures) : curvatures,
        deviation: shown.deviations ? deviationOf(surface.points()) : undefined,
        positions: surface.positionsView(),
        normals: surface.normalsView(),
      });
    }
    // memory may have grown, which ends views
    for (const drawing of drawings) {
      drawing.positions = this.made.get(drawing.isLinear)!.positionsView();
      drawing.normals = this.made.get(drawing.isLinear)!.normalsView();
    }
    this.areNew = false;
    // the colors are those of the surface that is looked at, so that both views can be compared
    const pn = values.get(false) ?? values.get(true);
    return { drawings, colorEnd: pn && (isRelative ? endOfRelative : endOfColors(pn, shown.size, shading)) };
  }

  content(mesh: ControlMesh, isLinear: boolean): Content {
    const surface = this.made.get(isLinear)!;
    return {
      points: surface.points(),
      normals: surface.controlNormals(),
      roundness: surface.roundness(mesh),
      sides: surface.sides(),
      faces: surface.faces(),
      triangles: surface.triangles(),
      positions: surface.positionsView().slice(),
      drawnNormals: surface.normalsView().slice(),
    };
  }
}

function deviationOf(points: Float64Array): number {
  const { center, radius } = bestSphere(points);
  return deviation(points, center, radius);
}

function timeOf(work: () => void): number {
  const started = performance.now();
  work();
  return performance.now() - started;
}
