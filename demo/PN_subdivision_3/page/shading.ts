// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How a surface looks: smooth, in reflected stripes, or in the colors of its curvature.

import * as THREE from "three";

export type Shading = "smooth" | "zebra" | "gaussian" | "mean" | "relative";

export interface Theme {
  background: string;
  surface: string;
  inside: string;
  edge: string;
  crease: string;
  vertex: string;
  normal: string;
  selection: string;
}

const vertexShader = `
attribute float value;
varying vec3 vNormal;
varying vec3 vPosition;
varying float vValue;
void main() {
  vNormal = normalMatrix * normal;
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vPosition = place.xyz;
  vValue = value;
  gl_Position = projectionMatrix * place;
}`;

const fragmentShader = `
uniform int mode; // 0 smooth, 1 zebra, 2 curvature
uniform float scale;
uniform vec3 surface;
uniform vec3 inside;
uniform bool isClosed;
uniform bool isDark;
uniform bool isFlat;
varying vec3 vNormal;
varying vec3 vPosition;
varying float vValue;

// blue, white and red with even steps of lightness; in the dark from gray to light blue and light red, so that light lines
// over the surface are seen
vec3 diverging(float t) {
  vec3 low = vec3(0.085, 0.125, 0.565), middle = vec3(0.88), high = vec3(0.50, 0.012, 0.035);
  vec3 half_low = vec3(0.33, 0.48, 0.90), half_high = vec3(0.90, 0.33, 0.24);
  if (isDark) {
    low = vec3(0.60, 0.75, 1.0), middle = vec3(0.13), high = vec3(1.0, 0.66, 0.55);
    half_low = vec3(0.16, 0.27, 0.68), half_high = vec3(0.65, 0.17, 0.11);
  }
  float s = clamp(abs(t), 0.0, 1.0);
  vec3 end = t < 0.0 ? low : high;
  vec3 half_way = t < 0.0 ? half_low : half_high;
  return s < 0.5 ? mix(middle, half_way, 2.0 * s) : mix(half_way, end, 2.0 * s - 1.0);
}

void main() {
  vec3 n = normalize(vNormal);
  if (!gl_FrontFacing) n = -n;
  if (isFlat) n = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
  vec3 toEye = normalize(-vPosition);
  bool isOutside = gl_FrontFacing || isClosed;
  vec3 color = isOutside ? surface : inside;
  if (mode == 2) color = diverging(vValue / scale);
  if (mode == 1) {
    // stripes of lamps that are far away, parallel to the horizon
    vec3 r = reflect(-toEye, n);
    float stripe = 14.0 * atan(r.y, length(r.xz) + 0.25);
    float width = fwidth(stripe);
    float black = smoothstep(-width, width, sin(stripe));
    color = mix(vec3(0.025), vec3(0.93), black);
    if (!isOutside) color *= inside + 0.25;
  }
  float key = max(dot(n, normalize(vec3(0.45, 0.75, 0.65))), 0.0);
  float fill = max(dot(n, normalize(vec3(-0.8, 0.1, 0.45))), 0.0);
  float light = mode == 0 ? 0.30 + 0.62 * key + 0.18 * fill : 0.62 + 0.36 * key + 0.08 * fill;
  color *= light;
  if (mode == 0) {
    vec3 h = normalize(normalize(vec3(0.45, 0.75, 0.65)) + toEye);
    color += 0.16 * pow(max(dot(n, h), 0.0), 42.0);
    color += 0.05 * pow(1.0 - max(dot(n, toEye), 0.0), 3.0);
  }
  gl_FragColor = vec4(color, 1.0);
  #include <colorspace_fragment>
}`;

export function makeMaterial(): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    vertexShader,
    fragmentShader,
    side: THREE.DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: {
      mode: { value: 0 },
      scale: { value: 1 },
      surface: { value: new THREE.Color() },
      inside: { value: new THREE.Color() },
      isClosed: { value: false },
      isDark: { value: false },
      isFlat: { value: false },
    },
  });
}

/** `isFlat`: each triangle has its own normal. */
export function setShading(material: THREE.ShaderMaterial, shading: Shading, isFlat: boolean, scale: number): void {
  material.uniforms.mode.value = shading === "smooth" ? 0 : shading === "zebra" ? 1 : 2;
  material.uniforms.isFlat.value = isFlat;
  material.uniforms.scale.value = scale;
}

export function setTheme(material: THREE.ShaderMaterial, theme: Theme): void {
  material.uniforms.surface.value.set(theme.surface);
  material.uniforms.inside.value.set(theme.inside);
  const { r, g, b } = new THREE.Color(theme.background);
  material.uniforms.isDark.value = r + g + b < 1.5;
}
