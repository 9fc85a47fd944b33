// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The picture: one or two views of surfaces with one camera, and the control mesh over them.

import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { DistancePicture } from "./distance_picture";
import { makePale, Segments } from "./lines";
import type { Handles } from "./modeler";
import { makeMaterial, setShading, setTheme, type Shading, type Theme } from "./shading";

/** A surface, and where it is on the canvas. */
class Pane {
  readonly scene = new THREE.Scene();
  readonly material = makeMaterial();
  private readonly mesh = new THREE.Mesh<THREE.BufferGeometry, THREE.Material>(new THREE.BufferGeometry(), this.material);

  constructor(controlMesh: THREE.Object3D) {
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh, controlMesh);
  }

  /** The surface alone, drawn by another material. */
  drawSurface(renderer: THREE.WebGLRenderer, camera: THREE.Camera, material: THREE.Material): void {
    this.mesh.material = material;
    renderer.render(this.mesh, camera);
    this.mesh.material = this.material;
  }

  setTriangles(triangles: Uint32Array): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = new THREE.BufferGeometry();
    this.mesh.geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  }

  setVertices(positions: Float32Array, normals: Float32Array): void {
    this.setAttribute("position", positions, 3);
    this.setAttribute("normal", normals, 3);
  }

  setValues(values: Float32Array): void {
    this.setAttribute("value", values, 1);
  }

  private setAttribute(name: string, values: Float32Array, itemSize: number): void {
    const old = this.mesh.geometry.getAttribute(name) as THREE.BufferAttribute | undefined;
    if (old && old.array.length === values.length) {
      (old.array as Float32Array).set(values);
      old.needsUpdate = true;
    } else {
      const attribute = new THREE.BufferAttribute(values.slice(), itemSize);
      attribute.setUsage(THREE.DynamicDrawUsage);
      this.mesh.geometry.setAttribute(name, attribute);
    }
  }
}

/** Lines and dots of a control mesh. */
class ControlPicture {
  readonly group = new THREE.Group();
  readonly normals = new THREE.Group();
  private readonly edges = new Segments();
  private readonly sharp = new Segments();
  private readonly dots = new THREE.Points(new THREE.BufferGeometry(), dotMaterial());
  private readonly stems = new Segments();
  private readonly tips = new THREE.Points(new THREE.BufferGeometry(), dotMaterial());
  private readonly mark = new THREE.Points(new THREE.BufferGeometry(), dotMaterial());
  private readonly tipMark = new THREE.Points(new THREE.BufferGeometry(), dotMaterial());

  constructor() {
    this.group.add(this.edges, this.sharp, this.dots, this.mark);
    this.normals.add(this.stems, this.tips, this.tipMark);
    for (const object of this.allDots) {
      object.frustumCulled = false;
      object.add(makeGhost(object));
    }
    // what is selected is seen in front of the surface, too
    for (const mark of [this.mark, this.tipMark]) {
      mark.material.depthTest = false;
      mark.renderOrder = 1;
      mark.children[0].visible = false;
    }
  }

  private get allDots(): Dots[] {
    return [this.dots, this.tips, this.mark, this.tipMark];
  }

  setTheme(theme: Theme): void {
    this.edges.setColor(theme.edge);
    this.sharp.setColor(theme.crease);
    this.stems.setColor(theme.normal);
    this.dots.material.color.set(theme.vertex);
    this.tips.material.color.set(theme.normal);
    this.mark.material.color.set(theme.selection);
    this.tipMark.material.color.set(theme.selection);
    for (const object of this.allDots) (object.children[0] as Dots).material.color.copy(object.material.color);
  }

  /** In pixels. */
  setDotSize(size: number): void {
    for (const [points, factor] of [[this.dots, 1], [this.tips, 0.9], [this.mark, 1.6], [this.tipMark, 1.5]] as const) {
      points.material.size = factor * size;
      (points.children[0] as Dots).material.size = factor * size;
    }
  }

  show(handles: Handles, normalLength: number, selection: Selection): void {
    const { points, edges, sharp } = handles;
    const isSharp = (e: number): boolean => sharp[e] > 0;
    this.edges.setEnds(linesOf(points, edges, (e) => !isSharp(e)));
    this.sharp.setEnds(linesOf(points, edges, isSharp));
    const { stems, tips } = stemsOf(handles, normalLength);
    setPositions(this.dots, points);
    this.stems.setEnds(stems);
    setPositions(this.tips, tips);
    this.select(handles, normalLength, selection);
  }

  /** Marks what is selected; the rest stays as it is. */
  select(handles: Handles, normalLength: number, { vertex: v, wedge }: Selection): void {
    setPositions(this.mark, v === undefined ? [] : handles.points.slice(3 * v, 3 * v + 3));
    setPositions(this.tipMark, (wedge === undefined ? undefined : normalTip(handles, wedge, normalLength)) ?? []);
  }
}

export interface Selection {
  vertex?: number;
  wedge?: number;
}

export function normalTip(handles: Handles, wedge: number, length: number): [number, number, number] | undefined {
  const v = handles.vertices[wedge];
  const { normals } = handles;
  const [x, y, z] = [normals[3 * wedge], normals[3 * wedge + 1], normals[3 * wedge + 2]];
  const size = Math.hypot(x, y, z);
  if (size === 0) return undefined;
  const s = length / size;
  return [handles.points[3 * v] + s * x, handles.points[3 * v + 1] + s * y, handles.points[3 * v + 2] + s * z];
}

/** Round dots. */
function dotMaterial(): THREE.PointsMaterial {
  const material = new THREE.PointsMaterial({ sizeAttenuation: false, transparent: true });
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      "#include <color_fragment>",
      `#include <color_fragment>
      float fromCenter = length(gl_PointCoord - 0.5);
      if (fromCenter > 0.5) discard;
      diffuseColor.a *= 1.0 - smoothstep(0.42, 0.5, fromCenter);`,
    );
  };
  return material;
}

type Dots = THREE.Points<THREE.BufferGeometry, THREE.PointsMaterial>;

/** The same, pale, where it is behind the surface. */
function makeGhost(object: Dots): Dots {
  const ghost = object.clone(false) as Dots;
  ghost.material = object.material.clone();
  ghost.material.onBeforeCompile = object.material.onBeforeCompile;
  makePale(ghost.material);
  return ghost;
}

/** The ends of those edges that are wanted. */
function linesOf(points: Float64Array, edges: Uint32Array, isWanted: (edge: number) => boolean): Float32Array {
  const result = new Float32Array(3 * edges.length);
  let n = 0;
  for (let e = 0; e < edges.length; ++e) {
    if (!isWanted(e >> 1)) continue;
    result.set(points.subarray(3 * edges[e], 3 * edges[e] + 3), n);
    n += 3;
  }
  return result.subarray(0, n);
}

/** The lines from vertices to the tips of their normals, of those that have one. */
export function stemsOf(handles: Handles, length: number): { stems: Float32Array; tips: Float32Array } {
  const { points, vertices } = handles;
  const stems = new Float32Array(6 * vertices.length);
  const tips = new Float32Array(3 * vertices.length);
  let n = 0;
  for (let w = 0; w < vertices.length; ++w) {
    const tip = normalTip(handles, w, length);
    if (!tip) continue;
    for (let k = 0; k < 3; ++k) {
      stems[6 * n + k] = points[3 * vertices[w] + k];
      stems[6 * n + 3 + k] = tips[3 * n + k] = tip[k];
    }
    ++n;
  }
  return { stems: stems.subarray(0, 6 * n), tips: tips.subarray(0, 3 * n) };
}

function setPositions(object: Dots, positions: ArrayLike<number>): void {
  const array = Float32Array.from(positions);
  const old = object.geometry.getAttribute("position") as THREE.BufferAttribute | undefined;
  if (old && old.array.length === array.length) {
    (old.array as Float32Array).set(array);
    old.needsUpdate = true;
  } else {
    object.geometry.dispose();
    object.geometry = new THREE.BufferGeometry();
    object.geometry.setAttribute("position", new THREE.BufferAttribute(array, 3));
    for (const ghost of object.children as Dots[]) ghost.geometry = object.geometry;
  }
}

/** Without hardware smooth edges cost half of the frames. */
function graphicsOfBrowser(): "none" | "software" | "hardware" {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) return "none";
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const renderer = names ? String(context.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(renderer) ? "software" : "hardware";
}

export type Layout = "pn" | "linear" | "both" | "split";

/** Where the two surfaces of one view meet: the middle of a slider's thumb of 28 pixels. */
export function splitPlace(share: number, width: number): number {
  return 14 + share * (width - 28);
}

export class Viewer {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
  readonly controls: OrbitControls;
  /** None where the browser shows no such pictures. */
  private readonly renderer: THREE.WebGLRenderer | undefined;
  private readonly control = new ControlPicture();
  private readonly controlCopy = new ControlPicture();
  private readonly pn: Pane;
  private readonly linear: Pane;
  private layout: Layout = "both";
  private split = 0.5;
  private radius = 1;
  private normalLength = 1;
  private frame = 0;
  private theme: Theme | undefined;
  private readonly distances = new Map<boolean, DistancePicture>(); // by whether the pane is linear; since the last picture
  private readonly spareDistances = [new DistancePicture(), new DistancePicture()];
  /** Called after each picture. */
  onDraw: (() => void) | undefined;

  constructor(readonly canvas: HTMLCanvasElement) {
    const graphics = graphicsOfBrowser();
    if (graphics !== "none") {
      this.renderer = new THREE.WebGLRenderer({ canvas, antialias: graphics === "hardware", alpha: true });
      this.renderer.autoClear = false;
      canvas.addEventListener("webglcontextrestored", () => this.requestDraw());
    }
    const pnOverlay = new THREE.Group();
    pnOverlay.add(this.control.group, this.control.normals);
    this.pn = new Pane(pnOverlay);
    this.linear = new Pane(this.controlCopy.group);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.rotateSpeed = 0.9;
    this.controls.addEventListener("change", () => this.requestDraw());
    new ResizeObserver(() => this.requestDraw()).observe(canvas);
  }

  get canDraw(): boolean {
    return this.renderer !== undefined;
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.control.setTheme(theme);
    this.controlCopy.setTheme(theme);
    for (const pane of [this.pn, this.linear]) setTheme(pane.material, theme);
    this.requestDraw();
  }

  /** The inside of what has no border is never seen: where two triangles meet on the outline, rounding shows it. */
  setClosed(isClosed: boolean): void {
    for (const pane of [this.pn, this.linear]) pane.material.uniforms.isClosed.value = isClosed;
  }

  setLayout(layout: Layout, split: number): void {
    this.layout = layout;
    this.split = split;
    this.requestDraw();
  }

  setShading(shading: Shading, isFlat: boolean, scale: number): void {
    for (const pane of [this.pn, this.linear]) setShading(pane.material, shading, isFlat, scale);
    this.requestDraw();
  }

  setVisible(controlMesh: boolean, normals: boolean): void {
    this.control.group.visible = controlMesh;
    this.controlCopy.group.visible = controlMesh;
    this.control.normals.visible = normals;
    this.requestDraw();
  }

  pane(isLinear: boolean): Pane {
    return isLinear ? this.linear : this.pn;
  }

  showControlMesh(handles: Handles, normalLength: number, selection: Selection): void {
    this.normalLength = normalLength;
    this.control.show(handles, normalLength, selection);
    this.controlCopy.show(handles, normalLength, selection);
    this.requestDraw();
  }

  /** What is selected, where the rest is as it was. */
  showSelection(handles: Handles, normalLength: number, selection: Selection): void {
    this.control.select(handles, normalLength, selection);
    this.controlCopy.select(handles, normalLength, selection);
    this.requestDraw();
  }

  /** Where the eye is, from what it looks at. */
  get direction(): [number, number, number] {
    return this.camera.position.clone().sub(this.controls.target).toArray();
  }

  /** Looks at everything from the usual direction, or another one. */
  frameAll(pointLists: ArrayLike<number>[], tips: ArrayLike<number>, wanted?: [number, number, number]): void {
    const box = new THREE.Box3();
    const p = new THREE.Vector3();
    for (const points of pointLists)
      for (let i = 0; i < points.length; i += 3) box.expandByPoint(p.fromArray(points, i));
    const sphere = box.getBoundingSphere(new THREE.Sphere());
    this.radius = sphere.radius || 1;
    const direction = new THREE.Vector3(...(wanted ?? ([0.62, -1, 0.62] as const))).normalize();
    const center = box.getCenter(new THREE.Vector3());
    const aspect = this.paneSize().x / Math.max(1, this.paneSize().y);
    const high = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    const right = this.camera.up.clone().cross(direction).normalize();
    const up = direction.clone().cross(right);
    let distance = 0;
    // labels are above the surface; beside it tips of normals need less room than it
    for (const points of [...pointLists, tips])
      for (let i = 0; i < points.length; i += 3) {
        p.fromArray(points, i).sub(center);
        const sideways = ((points === tips ? 1.05 : 1.2) * Math.abs(p.dot(right))) / (high * aspect);
        distance = Math.max(distance, p.dot(direction) + Math.max(sideways, (1.2 * Math.abs(p.dot(up))) / high));
      }
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(direction, distance || 1);
    this.updateClipping();
    this.controls.update();
    this.requestDraw();
  }

  setSize(radius: number): void {
    this.radius = radius;
  }

  /** Turns the view, by angles in radians. */
  rotate(horizontal: number, vertical: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const spherical = new THREE.Spherical().setFromVector3(new THREE.Vector3(offset.x, offset.z, -offset.y));
    spherical.theta += horizontal;
    spherical.phi = THREE.MathUtils.clamp(spherical.phi + vertical, 0.05, Math.PI - 0.05);
    const turned = new THREE.Vector3().setFromSpherical(spherical);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3(turned.x, -turned.z, turned.y));
    this.controls.update();
    this.requestDraw();
  }

  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.requestDraw();
  }

  /** The pane at a place of the canvas, in CSS pixels: where it begins, and its size. */
  private paneSize(): THREE.Vector2 {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (this.layout !== "both") return new THREE.Vector2(width, height);
    return this.isStacked() ? new THREE.Vector2(width, height / 2) : new THREE.Vector2(width / 2, height);
  }

  /** Whether two views are above each other. */
  isStacked(): boolean {
    return this.canvas.clientHeight > 1.15 * this.canvas.clientWidth;
  }

  /** A place of the canvas in CSS pixels as one of its pane, in [-1, 1]. */
  toPane(x: number, y: number): { ndc: THREE.Vector2; isLinear: boolean } {
    const size = this.paneSize();
    const isSecond = this.layout === "both" && (this.isStacked() ? y >= size.y : x >= size.x);
    const inX = isSecond && !this.isStacked() ? x - size.x : x;
    const inY = isSecond && this.isStacked() ? y - size.y : y;
    const ndc = new THREE.Vector2((2 * inX) / size.x - 1, 1 - (2 * inY) / size.y);
    const isLeft = this.layout === "split" && x < splitPlace(this.split, size.x);
    return { ndc, isLinear: this.layout === "linear" || (this.layout === "both" && !isSecond) || isLeft };
  }

  /** Where a point is in a pane, in CSS pixels from its middle, and how far away. */
  toPixels(p: THREE.Vector3): { x: number; y: number; depth: number } {
    const size = this.paneSize();
    const projected = p.clone().project(this.camera);
    return { x: (projected.x * size.x) / 2, y: (-projected.y * size.y) / 2, depth: projected.z };
  }

  /** The middle of a pane on the canvas, in CSS pixels. */
  middleOf(isLinear: boolean): { x: number; y: number } {
    const size = this.paneSize();
    const isSecond = this.layout === "both" && !isLinear;
    return {
      x: size.x / 2 + (isSecond && !this.isStacked() ? size.x : 0),
      y: size.y / 2 + (isSecond && this.isStacked() ? size.y : 0),
    };
  }

  ndcToPixels(ndc: THREE.Vector2): { x: number; y: number } {
    const size = this.paneSize();
    return { x: (ndc.x * size.x) / 2, y: (-ndc.y * size.y) / 2 };
  }

  ray(ndc: THREE.Vector2): THREE.Ray {
    const caster = new THREE.Raycaster();
    caster.setFromCamera(ndc, this.camera);
    return caster.ray;
  }

  /** Whether the surface of a pane is in front of a point, nearer to the eye by more than `slack`. */
  isHidden(p: THREE.Vector3, isLinear: boolean, slack: number): boolean {
    const { renderer } = this;
    if (!renderer) return false;
    if (this.frame !== 0) {
      cancelAnimationFrame(this.frame);
      this.frame = 0;
      this.draw();
    }
    let picture = this.distances.get(isLinear);
    if (!picture) {
      picture = this.spareDistances[Number(isLinear)];
      picture.draw(renderer, this.camera, this.paneSize(), (material) =>
        this.pane(isLinear).drawSurface(renderer, this.camera, material));
      this.distances.set(isLinear, picture);
    }
    return picture.at(p.clone().project(this.camera)) < -p.clone().applyMatrix4(this.camera.matrixWorldInverse).z - slack;
  }

  requestDraw(): void {
    if (this.frame === 0)
      this.frame = requestAnimationFrame(() => {
        this.frame = 0;
        this.draw();
      });
  }

  /** `ratio`: pixels of the picture for one in CSS units; the screen's changes with the window's place and zoom. */
  draw(ratio = Math.min(window.devicePixelRatio, 2)): void {
    const { renderer } = this;
    this.distances.clear();
    if (!renderer) return;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
    if (this.canvas.width !== Math.floor(width * ratio) || this.canvas.height !== Math.floor(height * ratio))
      renderer.setSize(width, height, false);
    const size = this.paneSize();
    this.camera.aspect = size.x / size.y;
    this.updateClipping();
    renderer.setScissorTest(false);
    renderer.setClearColor(0, 0);
    renderer.clear();
    renderer.setScissorTest(true);
    // small where vertices are close to each other
    const distance = this.camera.position.distanceTo(this.controls.target);
    const pixels = (this.normalLength / distance) * (size.y / (2 * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2))));
    const dotSize = THREE.MathUtils.clamp(0.28 * pixels, 3.5, 9);
    this.control.setDotSize(dotSize);
    this.controlCopy.setDotSize(dotSize);
    if (this.layout === "split") this.drawSplit(renderer, size);
    else this.drawBesideEachOther(renderer, size);
    this.onDraw?.();
  }

  private drawBesideEachOther(renderer: THREE.WebGLRenderer, size: THREE.Vector2): void {
    const panes = this.layout === "both" ? [this.linear, this.pn] : [this.pane(this.layout === "linear")];
    panes.forEach((pane, i) => {
      // from the lower left
      const x = this.isStacked() ? 0 : i * size.x;
      const y = this.isStacked() && this.layout === "both" ? this.canvas.clientHeight - (i + 1) * size.y : 0;
      renderer.setViewport(x, y, size.x, size.y);
      renderer.setScissor(x, y, size.x, size.y);
      renderer.render(pane.scene, this.camera);
    });
  }

  /** One view, the linear surface on the left of it. */
  private drawSplit(renderer: THREE.WebGLRenderer, size: THREE.Vector2): void {
    const place = splitPlace(this.split, size.x);
    renderer.setViewport(0, 0, size.x, size.y);
    renderer.setScissor(0, 0, place, size.y);
    renderer.render(this.linear.scene, this.camera);
    renderer.setScissor(place, 0, size.x - place, size.y);
    renderer.render(this.pn.scene, this.camera);
  }

  private updateClipping(): void {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(distance - 4 * this.radius, distance / 200);
    this.camera.far = distance + 6 * this.radius;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  /** The picture on the screen, on the page's background. */
  async png(): Promise<Blob> {
    if (!this.canDraw) throw new Error("this browser shows no pictures in three dimensions (WebGL)");
    this.draw(2);
    const copy = document.createElement("canvas");
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    const context = copy.getContext("2d")!;
    context.fillStyle = this.theme?.background ?? "#fff";
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(this.canvas, 0, 0);
    this.requestDraw();
    return new Promise((resolve, reject) =>
      copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture cannot be made"))), "image/png"));
  }
}
