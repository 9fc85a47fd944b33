// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Lines of two pixels; very many are as thin as the graphics hardware draws them.

import * as THREE from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

/** A line that is wide is four triangles. */
const mostWideLines = 20_000;

/** Segments with the same, pale, where they are behind the surface. */
export class Segments extends THREE.Group {
  private readonly thin = [new THREE.LineBasicMaterial(), new THREE.LineBasicMaterial()].map(
    (material) => new THREE.LineSegments(new THREE.BufferGeometry(), material));
  private readonly wide = [new LineMaterial({ linewidth: 1.7 }), new LineMaterial({ linewidth: 1.7 })].map(
    (material) => new LineSegments2(new LineSegmentsGeometry(), material));

  constructor() {
    super();
    for (const [front, behind] of [this.thin, this.wide]) {
      makePale(behind.material as THREE.Material);
      this.add(front, behind);
    }
    for (const object of this.children) object.frustumCulled = false;
  }

  setColor(color: string): void {
    for (const { material } of [...this.thin, ...this.wide]) material.color.set(color);
  }

  /** x, y, z of both ends of each. */
  setEnds(ends: Float32Array): void {
    const isWide = ends.length <= 6 * mostWideLines;
    for (const object of this.thin) object.visible = !isWide && ends.length > 0;
    for (const object of this.wide) object.visible = isWide && ends.length > 0;
    if (ends.length === 0) return;
    const geometry = isWide ? new LineSegmentsGeometry().setPositions(ends) : new THREE.BufferGeometry();
    if (!isWide) geometry.setAttribute("position", new THREE.BufferAttribute(ends, 3));
    this.children.filter(({ visible }) => visible).forEach((object) => {
      (object as THREE.LineSegments).geometry.dispose();
      (object as THREE.LineSegments).geometry = geometry;
    });
  }
}

/** For what is drawn where it is behind the surface. */
export function makePale(material: THREE.Material): void {
  material.depthFunc = THREE.GreaterDepth;
  material.depthWrite = false;
  material.transparent = true;
  material.opacity = 0.22;
}
