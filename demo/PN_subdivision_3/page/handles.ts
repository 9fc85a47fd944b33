// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Taking hold of control points, normals and edges with a mouse, a finger or keys.

import * as THREE from "three";
import type { Editor, Triple } from "./editor";
import { normalTip, type Viewer } from "./viewer";

type Hold =
  | { kind: "point"; vertex: number; plane: THREE.Plane; offset: THREE.Vector3 }
  | { kind: "normal"; wedge: number; towardsEye: boolean; offset: THREE.Vector2 };

type Found = { vertex?: number; wedge?: number };

/** A hand that does not want to move anything moves by so many pixels. */
const stillness = (event: PointerEvent): number => (event.pointerType === "touch" ? 5 : 2);

export class Handles {
  /** Whether a click on an edge makes it a crease. */
  marksEdges = false;
  private hold: Hold | undefined;
  private pointer = -1;
  private pressed: { x: number; y: number } | undefined;
  private hasMoved = false;

  constructor(
    private readonly viewer: Viewer,
    private readonly editor: Editor,
    private readonly announce: (text: string) => void,
  ) {
    const canvas = viewer.canvas;
    // before those of the view, which turns where there is nothing to hold
    canvas.addEventListener("pointerdown", (e) => this.down(e), { capture: true });
    canvas.addEventListener("pointermove", (e) => this.move(e), { capture: true });
    for (const name of ["pointerup", "pointercancel"] as const)
      canvas.addEventListener(name, (e) => this.up(e), { capture: true });
    canvas.addEventListener("keydown", (e) => this.key(e));
  }

  // --- the nearest of what can be held ---

  private nearest(x: number, y: number, reach: number): Found | undefined {
    const { shownHandles: handles, normalLength, settings } = this.editor;
    const { ndc, isLinear } = this.viewer.toPane(x, y);
    const place = this.viewer.ndcToPixels(ndc);
    const candidates: { distance: number; p: THREE.Vector3; found: Found }[] = [];
    const consider = (p: THREE.Vector3, found: Found): void => {
      const q = this.viewer.toPixels(p);
      if (q.depth < -1 || q.depth > 1) return;
      // what is in front is preferred
      const distance = Math.hypot(q.x - place.x, q.y - place.y) * (1 + 0.25 * q.depth);
      if (distance < reach) candidates.push({ distance, p, found });
    };
    if (settings.showNormals && !isLinear)
      for (let w = 0; w < handles.vertices.length; ++w) {
        const tip = normalTip(handles, w, normalLength);
        if (tip) consider(new THREE.Vector3(...tip), { wedge: w });
      }
    if (settings.showControl)
      for (let v = 0; v < handles.points.length / 3; ++v) consider(this.pointOf(v), { vertex: v });
    candidates.sort((a, b) => a.distance - b.distance);
    return candidates.find(({ p, found }) => {
      const vertices = [found.vertex ?? handles.vertices[found.wedge!]];
      return !this.viewer.isHidden(p, isLinear, this.slack(vertices));
    })?.found;
  }

  /** Control points may be below a surface that looks towards the eye, but not far. */
  private slack(vertices: number[]): number {
    const { handles, normalLength } = this.editor;
    const looksAway = vertices.every((v) => {
      const toEye = this.viewer.camera.position.clone().sub(this.pointOf(v));
      const normal = new THREE.Vector3();
      const wedges = this.wedgesOf(v);
      return wedges.every((w) => normal.fromArray(handles.normals, 3 * w).dot(toEye) < 0);
    });
    return (looksAway ? 0.25 : 2) * normalLength;
  }

  private wedgesOf(vertex: number): number[] {
    const { vertices } = this.editor.handles;
    const result: number[] = [];
    for (let w = vertices.indexOf(vertex); w >= 0; w = vertices.indexOf(vertex, w + 1)) result.push(w);
    return result;
  }

  private nearestEdge(x: number, y: number, reach: number): number | undefined {
    const { handles } = this.editor;
    const { ndc, isLinear } = this.viewer.toPane(x, y);
    const place = this.viewer.ndcToPixels(ndc);
    const candidates: { distance: number; edge: number; s: number }[] = [];
    for (let e = 0; e < handles.sharp.length; ++e) {
      if (handles.border[e]) continue;
      const a = this.viewer.toPixels(this.pointOf(handles.edges[2 * e]));
      const b = this.viewer.toPixels(this.pointOf(handles.edges[2 * e + 1]));
      const [dx, dy] = [b.x - a.x, b.y - a.y];
      const t = ((place.x - a.x) * dx + (place.y - a.y) * dy) / Math.max(1e-9, dx * dx + dy * dy);
      const s = Math.min(1, Math.max(0, t));
      const depth = a.depth + s * (b.depth - a.depth);
      // edges behind others are farther; near an end two edges are equally near
      const distance =
        Math.hypot(a.x + s * dx - place.x, a.y + s * dy - place.y) + 4 * depth + 3 * Math.abs(s - 0.5);
      if (distance < reach) candidates.push({ distance, edge: e, s });
    }
    candidates.sort((a, b) => a.distance - b.distance);
    return candidates.find(({ edge, s }) => {
      const ends = [handles.edges[2 * edge], handles.edges[2 * edge + 1]];
      const p = this.pointOf(ends[0]).lerp(this.pointOf(ends[1]), s);
      return !this.viewer.isHidden(p, isLinear, this.slack(ends));
    })?.edge;
  }

  private pointOf(v: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.editor.shownHandles.points, 3 * v);
  }
  private toWorld(p: THREE.Vector3): Triple {
    return p.toArray().map((x, k) => x + this.editor.origin[k]) as Triple;
  }

  // --- mouse and finger ---

  private down(event: PointerEvent): void {
    if (this.hold) return event.stopImmediatePropagation(); // a second finger does not turn the view
    if (event.button !== 0 || !event.isPrimary) return;
    const { offsetX: x, offsetY: y } = event;
    const reach = event.pointerType === "touch" ? 22 : 12;
    this.pressed = { x, y };
    if (this.marksEdges) return;
    const found = this.nearest(x, y, reach);
    if (!found) return;
    event.stopImmediatePropagation();
    this.viewer.canvas.focus({ preventScroll: true });
    const { ndc } = this.viewer.toPane(x, y);
    const wedge = found.wedge ?? this.editor.handles.vertices.indexOf(found.vertex!);
    const vertex = found.vertex ?? this.editor.handles.vertices[wedge];
    this.editor.select({ vertex, wedge: wedge < 0 ? undefined : wedge });
    const p = this.pointOf(vertex);
    if (found.wedge !== undefined) {
      const tip = new THREE.Vector3(...normalTip(this.editor.shownHandles, wedge, this.editor.normalLength)!);
      const eye = this.viewer.camera.position.clone().sub(p);
      const onScreen = tip.clone().project(this.viewer.camera);
      this.hold = {
        kind: "normal",
        wedge,
        towardsEye: tip.sub(p).dot(eye) >= 0,
        offset: new THREE.Vector2(onScreen.x - ndc.x, onScreen.y - ndc.y),
      };
    } else {
      const direction = this.viewer.camera.getWorldDirection(new THREE.Vector3());
      const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(direction, p);
      const at = this.viewer.ray(ndc).intersectPlane(plane, new THREE.Vector3()) ?? p;
      this.hold = { kind: "point", vertex, plane, offset: p.clone().sub(at) };
    }
    this.pointer = event.pointerId;
    this.hasMoved = false;
    this.viewer.canvas.setPointerCapture(event.pointerId);
    this.editor.beginDrag();
  }

  private move(event: PointerEvent): void {
    if (!this.hold) {
      // only a hint, too dear with very many vertices
      if (event.buttons === 0 && event.pointerType === "mouse" && this.editor.handles.vertices.length < 10_000) {
        const found = this.marksEdges
          ? this.nearestEdge(event.offsetX, event.offsetY, 14) !== undefined
          : this.nearest(event.offsetX, event.offsetY, 12) !== undefined;
        this.viewer.canvas.style.cursor = found ? "pointer" : "";
      }
      return;
    }
    event.stopImmediatePropagation();
    if (event.pointerId !== this.pointer) return;
    const { x, y } = this.pressed!;
    this.hasMoved ||= Math.hypot(event.offsetX - x, event.offsetY - y) > stillness(event);
    if (!this.hasMoved) return;
    const { ndc } = this.viewer.toPane(event.offsetX, event.offsetY);
    if (this.hold.kind === "normal") this.turn(this.hold, ndc);
    else this.shift(this.hold, ndc, event.shiftKey);
  }

  /** The tip moves on a sphere about its vertex. */
  private turn(hold: Hold & { kind: "normal" }, ndc: THREE.Vector2): void {
    const center = this.pointOf(this.editor.handles.vertices[hold.wedge]);
    const ray = this.viewer.ray(ndc.clone().add(hold.offset));
    const alongRay = center.clone().sub(ray.origin).dot(ray.direction);
    const closest = ray.at(alongRay, new THREE.Vector3());
    const away = closest.clone().sub(center);
    const half = this.editor.normalLength ** 2 - away.lengthSq();
    if (half > 0) away.addScaledVector(ray.direction, (hold.towardsEye ? -1 : 1) * Math.sqrt(half));
    away.normalize();
    this.editor.dragNormal(hold.wedge, away.x, away.y, away.z);
  }

  /** In the plane that faces the eye or, with Shift, along the normal. */
  private shift(hold: Hold & { kind: "point" }, ndc: THREE.Vector2, alongNormal: boolean): void {
    const at = this.viewer.ray(ndc).intersectPlane(hold.plane, new THREE.Vector3());
    if (!at) return;
    const p = at.add(hold.offset);
    const { wedge } = this.editor.selection;
    if (alongNormal && wedge !== undefined) {
      const n = new THREE.Vector3().fromArray(this.editor.handles.normals, 3 * wedge).normalize();
      const old = this.pointOf(hold.vertex);
      p.copy(old).addScaledVector(n, n.dot(at.clone().sub(old)));
    }
    this.editor.dragPoint(hold.vertex, ...this.toWorld(p));
  }

  private up(event: PointerEvent): void {
    if (this.hold) event.stopImmediatePropagation();
    if (this.hold && event.pointerId !== this.pointer) return;
    const pressed = this.pressed;
    this.pressed = undefined;
    if (this.hold) {
      this.hold = undefined;
      this.editor.endDrag();
      return;
    }
    if (!this.marksEdges || !pressed || event.type !== "pointerup") return;
    if (Math.hypot(event.offsetX - pressed.x, event.offsetY - pressed.y) > 4) return;
    const edge = this.nearestEdge(event.offsetX, event.offsetY, event.pointerType === "touch" ? 24 : 14);
    if (edge !== undefined) this.toggleEdge(edge);
  }

  /** Returns whether that could be. */
  toggleEdge(edge: number): boolean {
    const isSharp = !this.editor.handles.sharp[edge];
    return this.editor.change((mesh) => mesh.setSharp(edge, isSharp));
  }

  // --- keys ---

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = THREE.MathUtils.degToRad(event.shiftKey ? 1 : 5);
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.viewer.rotate(-0.1, 0),
      ArrowRight: () => this.viewer.rotate(0.1, 0),
      ArrowUp: () => this.viewer.rotate(0, -0.1),
      ArrowDown: () => this.viewer.rotate(0, 0.1),
      "+": () => this.viewer.zoom(1 / 1.1),
      "=": () => this.viewer.zoom(1 / 1.1),
      "-": () => this.viewer.zoom(1.1),
      f: () => this.editor.frameAll(this.viewer.direction),
      n: () => this.selectNext(1),
      p: () => this.selectNext(-1),
      Escape: () => this.editor.select({}),
      w: () => this.turnSelected("right", -turn),
      s: () => this.turnSelected("right", turn),
      a: () => this.turnSelected("up", -turn),
      d: () => this.turnSelected("up", turn),
      i: () => this.moveSelected("up", event.shiftKey ? 0.01 : 0.05),
      k: () => this.moveSelected("up", event.shiftKey ? -0.01 : -0.05),
      j: () => this.moveSelected("right", event.shiftKey ? -0.01 : -0.05),
      l: () => this.moveSelected("right", event.shiftKey ? 0.01 : 0.05),
      c: () => this.toggleNextEdge(),
      Backspace: () => this.dropSelected(),
      Delete: () => this.dropSelected(),
    };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  private selectNext(step: number): void {
    const { vertices } = this.editor.handles;
    const now = this.editor.selection.wedge;
    const wedge = now === undefined ? (step > 0 ? 0 : vertices.length - 1) : (now + step + vertices.length) % vertices.length;
    this.editor.select({ wedge, vertex: vertices[wedge] });
    this.announceSelected();
  }

  private announceSelected(): void {
    const { wedge, vertex } = this.editor.selection;
    if (wedge === undefined || vertex === undefined) return;
    const text = (values: Float64Array): string => Array.from(values, (x) => x.toFixed(2)).join(", ");
    const { points, normals } = this.editor.handles;
    const normal = normals.subarray(3 * wedge, 3 * wedge + 3);
    this.announce(
      `Vertex ${vertex} at ${text(points.subarray(3 * vertex, 3 * vertex + 3))}, ` +
        (Math.hypot(...normal) > 0 ? `normal ${text(normal)}` : "no normal"),
    );
  }

  /** About an axis of the view. */
  private turnSelected(axis: "right" | "up", angle: number): void {
    const { wedge } = this.editor.selection;
    if (wedge === undefined) return this.selectNext(1);
    const n = new THREE.Vector3().fromArray(this.editor.handles.normals, 3 * wedge);
    if (n.lengthSq() === 0) this.viewer.camera.getWorldDirection(n).negate();
    n.applyAxisAngle(this.axis(axis), angle).normalize();
    this.editor.setNormal(wedge, n.x, n.y, n.z);
    this.announceSelected();
  }

  private moveSelected(axis: "right" | "up", share: number): void {
    const { vertex } = this.editor.selection;
    if (vertex === undefined) return this.selectNext(1);
    const p = this.pointOf(vertex).addScaledVector(this.axis(axis), share * 2 * this.editor.normalLength);
    this.editor.setPoint(vertex, ...this.toWorld(p));
    this.announceSelected();
  }

  private axis(name: "right" | "up"): THREE.Vector3 {
    return new THREE.Vector3().setFromMatrixColumn(this.viewer.camera.matrixWorld, name === "right" ? 0 : 1);
  }

  private dropSelected(): void {
    const { wedge } = this.editor.selection;
    if (wedge === undefined) return;
    this.editor.setNormal(wedge, 0, 0, 0);
    this.announceSelected();
  }

  private lastEdge = -1;
  private toggleNextEdge(): void {
    const { vertex } = this.editor.selection;
    const { edges, border } = this.editor.handles;
    if (vertex === undefined) return;
    const around: number[] = [];
    for (let e = 0; e < border.length; ++e)
      if (!border[e] && (edges[2 * e] === vertex || edges[2 * e + 1] === vertex)) around.push(e);
    if (around.length === 0) return;
    const edge = around.find((e) => e > this.lastEdge) ?? around[0];
    this.lastEdge = edge;
    if (!this.toggleEdge(edge)) return;
    this.announce(`The edge from ${edges[2 * edge]} to ${edges[2 * edge + 1]} is ${this.editor.handles.sharp[edge] ? "sharp" : "smooth"}`);
  }
}
