// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How far from the eye the surface is, at each place of a view: what is behind it cannot be taken hold of.

import * as THREE from "three";

/** Pixels of the screen, in CSS units, for one of this picture. */
const coarseness = 2;

// 24 bits of the distance along the axis of the view, from the nearest to the farthest that is drawn
const vertexShader = `
uniform float near;
uniform float far;
varying float share;
void main() {
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  share = (-place.z - near) / (far - near);
  gl_Position = projectionMatrix * place;
}`;
const fragmentShader = `
varying float share;
void main() {
  float x = clamp(share, 0.0, 1.0) * 255.0;
  float high = floor(x);
  float y = (x - high) * 255.0;
  float middle = floor(y);
  gl_FragColor = vec4(high / 255.0, middle / 255.0, y - middle, 1.0);
}`;

export class DistancePicture {
  private readonly target = new THREE.WebGLRenderTarget(1, 1, {
    minFilter: THREE.NearestFilter,
    magFilter: THREE.NearestFilter,
  });
  private readonly material = new THREE.ShaderMaterial({
    vertexShader,
    fragmentShader,
    side: THREE.DoubleSide,
    uniforms: { near: { value: 0 }, far: { value: 1 } },
  });
  private bytes = new Uint8Array(4);
  private near = 0;
  private far = 1;

  /** `size` of the view in CSS pixels; `drawSurface` draws what hides. */
  draw(renderer: THREE.WebGLRenderer, camera: THREE.PerspectiveCamera, size: THREE.Vector2,
    drawSurface: (material: THREE.Material) => void): void {
    const width = Math.max(1, Math.ceil(size.x / coarseness));
    const height = Math.max(1, Math.ceil(size.y / coarseness));
    this.target.setSize(width, height);
    if (this.bytes.length !== 4 * width * height) this.bytes = new Uint8Array(4 * width * height);
    this.near = this.material.uniforms.near.value = camera.near;
    this.far = this.material.uniforms.far.value = camera.far;
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0, 0);
    renderer.clear();
    drawSurface(this.material);
    renderer.readRenderTargetPixels(this.target, 0, 0, width, height, this.bytes);
    renderer.setRenderTarget(null);
  }

  /** The distance along the axis of the view at a place in [-1, 1]^2; infinite where there is no surface. */
  at(place: THREE.Vector3): number {
    const { width, height } = this.target;
    const x = Math.floor(((place.x + 1) / 2) * width);
    const y = Math.floor(((place.y + 1) / 2) * height);
    if (x < 0 || y < 0 || x >= width || y >= height) return Infinity;
    const [high, middle, low, isSurface] = this.bytes.subarray(4 * (y * width + x), 4 * (y * width + x) + 4);
    if (isSurface === 0) return Infinity;
    const share = (high + (middle + low / 255) / 255) / 255;
    return this.near + share * (this.far - this.near);
  }
}
