// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Curves: a control polygon with normals, drawn in SVG.

import { messageOf } from "./editor";
import type { CurveExample } from "./examples";
import { History } from "./history";
import type { Modeler, PlaneCurve } from "./modeler";
import { deviation, roundShapeThrough } from "./round_shapes";
import { make, space } from "./svg";

export interface CurveState {
  example: string;
  points: number[]; // x y
  normals: number[]; // x y
  closed: boolean;
  mask: string;
  rounds: number;
  roundness: number;
  showLinear: boolean;
  showComb: boolean;
  combScale: number; // 0 to 100
}

/** A curve from an address, of which anyone may be the author. Throws an Error if it is none. */
export function checkedCurve(given: Partial<CurveState>, usual: CurveState): CurveState {
  const isNumbers = (list: unknown): list is number[] => Array.isArray(list) && list.every(Number.isFinite);
  const { points, normals } = given;
  if (!isNumbers(points) || !isNumbers(normals) || points.length !== normals.length || points.length % 2 !== 0)
    throw new Error("it has no points with normals");
  const inRange = (x: unknown, most: number, otherwise: number): number =>
    typeof x === "number" && x >= 0 && x <= most ? Math.floor(x) : otherwise;
  const isShare = (x: unknown): x is number => typeof x === "number" && x >= 0 && x <= 1;
  return {
    example: String(given.example ?? ""),
    points,
    normals,
    closed: Boolean(given.closed),
    mask: String(given.mask ?? usual.mask),
    rounds: inRange(given.rounds, 8, usual.rounds),
    roundness: isShare(given.roundness) ? given.roundness : 1,
    showLinear: Boolean(given.showLinear),
    showComb: Boolean(given.showComb),
    combScale: inRange(given.combScale, 100, usual.combScale),
  };
}

const tipDistance = 34; // pixels

type Hold = { kind: "point" | "normal"; vertex: number; pointer: number; x: number; y: number; before?: CurveState };

/** A hand that does not want to move anything moves by so many pixels. */
const stillness = 2;

export class CurveEditor {
  state: CurveState = {
    example: "bottle",
    points: [],
    normals: [],
    closed: true,
    mask: "bspline:3",
    rounds: 6,
    roundness: 1,
    showLinear: true,
    showComb: true,
    combScale: 12,
  };
  readonly history = new History<CurveState>((state) => state.points.length + state.normals.length);
  onChange: (() => void) | undefined;
  status = "";
  /** Whether clicks add points to a new polygon. */
  isDrawing = false;
  private selected: number | undefined;
  private hold: Hold | undefined;
  private view = { x: 0, y: 0, scale: 40 }; // of the middle, pixels per unit
  private mustFit = true;
  private frame = 0;
  private curve: PlaneCurve | undefined;

  constructor(
    private readonly svg: SVGSVGElement,
    private readonly modeler: Modeler,
    private readonly say: (text: string, kind: "error" | "note") => void,
    private readonly announce: (text: string) => void,
  ) {
    svg.addEventListener("pointerdown", (e) => this.down(e));
    svg.addEventListener("pointermove", (e) => this.move(e));
    for (const name of ["pointerup", "pointercancel"] as const) svg.addEventListener(name, (e) => this.up(e));
    svg.addEventListener("dblclick", (e) => this.doubleClick(e));
    svg.addEventListener("keydown", (e) => this.key(e));
    svg.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
    new ResizeObserver(() => this.requestDraw()).observe(svg);
  }

  // --- changes ---

  show(example: CurveExample, name: string, isFirst = false): void {
    if (!isFirst) this.remember();
    this.state = {
      ...this.state,
      example: name,
      points: [...example.points],
      closed: example.closed,
      mask: example.mask,
      normals: [...(example.normals ?? this.estimate(example.points, example.closed))],
    };
    this.selected = undefined;
    this.mustFit = true;
    this.changed();
  }

  restore(state: CurveState): void {
    this.state = state;
    this.selected = undefined;
    this.mustFit = true;
    this.changed();
  }

  set(change: Partial<CurveState>): void {
    this.state = { ...this.state, ...change };
    this.changed();
  }

  undo(): void {
    const state = this.history.undo(this.copy());
    if (state) this.restore(state);
  }
  redo(): void {
    const state = this.history.redo(this.copy());
    if (state) this.restore(state);
  }

  zeroNormals(): void {
    this.remember();
    this.set({ normals: this.state.points.map(() => 0) });
  }
  estimateNormals(): void {
    this.remember();
    this.set({ normals: [...this.estimate(this.state.points, this.state.closed)] });
  }
  turnNormals(degrees: number): void {
    this.remember();
    const normals = [...this.state.normals];
    for (let v = 0; v < normals.length / 2; ++v) turn(normals, v, degrees);
    this.set({ normals });
  }

  startDrawing(): void {
    this.remember();
    this.isDrawing = true;
    this.selected = undefined;
    this.state = { ...this.state, points: [], normals: [], example: "" };
    this.changed();
  }

  private estimate(points: number[], closed: boolean): Float64Array {
    return this.modeler.estimateCurveNormals(Float64Array.from(points), closed);
  }

  private copy(): CurveState {
    return { ...this.state, points: [...this.state.points], normals: [...this.state.normals] };
  }
  private remember(): void {
    this.history.remember(this.copy());
  }

  private changed(): void {
    this.requestDraw();
    this.onChange?.();
  }

  private insert(position: number, x: number, y: number): void {
    const points = [...this.state.points];
    points.splice(2 * position, 0, x, y);
    const estimated = this.estimate(points, this.state.closed);
    const normals = [...this.state.normals];
    normals.splice(2 * position, 0, estimated[2 * position], estimated[2 * position + 1]);
    if (this.isDrawing) normals.splice(0, normals.length, ...estimated);
    this.selected = position;
    this.set({ points, normals });
  }

  private remove(position: number): void {
    if (this.state.points.length <= 4) return;
    this.remember();
    const points = [...this.state.points];
    const normals = [...this.state.normals];
    points.splice(2 * position, 2);
    normals.splice(2 * position, 2);
    this.selected = undefined;
    this.set({ points, normals });
  }

  // --- mouse, finger, keys ---

  private toUnits(event: MouseEvent): [number, number] {
    const box = this.svg.getBoundingClientRect();
    return [
      this.view.x + (event.clientX - box.left - box.width / 2) / this.view.scale,
      this.view.y - (event.clientY - box.top - box.height / 2) / this.view.scale,
    ];
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0 || this.hold) return;
    const target = event.target as SVGElement;
    const vertex = Number(target.dataset.vertex);
    if (target.dataset.kind === "point" || target.dataset.kind === "normal") {
      const { pointerId: pointer, clientX: x, clientY: y } = event;
      this.hold = { kind: target.dataset.kind, vertex, pointer, x, y, before: this.copy() };
      this.selected = vertex;
      this.svg.setPointerCapture(event.pointerId);
      this.requestDraw();
    } else if (this.isDrawing) {
      this.insert(this.state.points.length / 2, ...this.toUnits(event));
    }
  }

  private move(event: PointerEvent): void {
    if (this.hold?.pointer !== event.pointerId) return;
    const { kind, vertex, before } = this.hold;
    if (before) {
      if (Math.hypot(event.clientX - this.hold.x, event.clientY - this.hold.y) <= stillness) return;
      this.history.remember(before);
      this.hold.before = undefined;
    }
    const [x, y] = this.toUnits(event);
    if (kind === "point") this.state.points.splice(2 * vertex, 2, x, y);
    else {
      const [dx, dy] = [x - this.state.points[2 * vertex], y - this.state.points[2 * vertex + 1]];
      const length = Math.hypot(dx, dy);
      if (length > 0) this.state.normals.splice(2 * vertex, 2, dx / length, dy / length);
    }
    this.requestDraw();
  }

  private up(event: PointerEvent): void {
    if (this.hold?.pointer !== event.pointerId) return;
    const hasMoved = this.hold.before === undefined;
    this.hold = undefined;
    if (hasMoved) this.changed();
  }

  private doubleClick(event: MouseEvent): void {
    // whoever holds a pointer gets its clicks: what was clicked is asked for
    const target = document.elementFromPoint(event.clientX, event.clientY) as SVGElement | null;
    if (this.isDrawing || !target) return;
    if (target.dataset.kind === "point") this.remove(Number(target.dataset.vertex));
    if (target.dataset.kind === "edge") {
      this.remember();
      this.insert(Number(target.dataset.vertex) + 1, ...this.toUnits(event));
    }
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    this.view.scale *= Math.exp(-0.001 * event.deltaY);
    this.requestDraw();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const n = this.state.points.length / 2;
    const step = (event.shiftKey ? 2 : 12) / this.view.scale;
    const angle = event.shiftKey ? 1 : 5;
    const v = this.selected;
    const actions: Record<string, () => void> = {
      n: () => this.select(v === undefined ? 0 : (v + 1) % n),
      p: () => this.select(v === undefined ? n - 1 : (v + n - 1) % n),
      f: () => this.fit(),
      "+": () => (this.view.scale *= 1.1),
      "-": () => (this.view.scale /= 1.1),
      Escape: () => (this.selected = undefined),
      ArrowLeft: () => this.moveSelected(-step, 0),
      ArrowRight: () => this.moveSelected(step, 0),
      ArrowUp: () => this.moveSelected(0, step),
      ArrowDown: () => this.moveSelected(0, -step),
      a: () => this.turnSelected(angle),
      d: () => this.turnSelected(-angle),
      Backspace: () => v !== undefined && this.remove(v),
      Delete: () => v !== undefined && this.remove(v),
      Insert: () => v !== undefined && this.insertBehind(v),
    };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action || n === 0) return;
    event.preventDefault();
    action();
    this.requestDraw();
  }

  private select(v: number): void {
    this.selected = v;
    const at = (array: number[]): string => `${array[2 * v].toFixed(2)}, ${array[2 * v + 1].toFixed(2)}`;
    this.announce(`Vertex ${v} at ${at(this.state.points)}, normal ${at(this.state.normals)}`);
  }

  private insertBehind(v: number): void {
    const { points } = this.state;
    const w = (v + 1) % (points.length / 2);
    this.remember();
    this.insert(v + 1, (points[2 * v] + points[2 * w]) / 2, (points[2 * v + 1] + points[2 * w + 1]) / 2);
  }

  private moveSelected(dx: number, dy: number): void {
    if (this.selected === undefined) return this.select(0);
    this.remember();
    const points = [...this.state.points];
    points[2 * this.selected] += dx;
    points[2 * this.selected + 1] += dy;
    this.set({ points });
    this.select(this.selected);
  }

  private turnSelected(degrees: number): void {
    if (this.selected === undefined) return this.select(0);
    this.remember();
    const normals = [...this.state.normals];
    turn(normals, this.selected, degrees);
    this.set({ normals });
    this.select(this.selected);
  }

  // --- the drawing ---

  /** Shows all of the curve, with room for normals and comb. */
  fit(): void {
    this.mustFit = false;
    const { points } = this.state;
    if (points.length < 4) return;
    const xs = points.filter((_, i) => i % 2 === 0);
    const ys = points.filter((_, i) => i % 2 === 1);
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const { clientWidth: width, clientHeight: height } = this.svg;
    const room = Math.min(110, 0.16 * Math.min(width, height));
    this.view = {
      x: (left + right) / 2,
      y: (low + high) / 2,
      scale: Math.max(1e-9, Math.min((width - 2 * room) / (right - left || 1), (height - 2 * room) / (high - low || 1))),
    };
  }

  requestDraw(): void {
    if (this.frame === 0)
      this.frame = requestAnimationFrame(() => {
        this.frame = 0;
        this.draw();
      });
  }

  private refine(isLinear: boolean): PlaneCurve {
    const { points, normals, mask, closed, rounds, roundness } = this.state;
    return this.modeler.refineCurve(
      Float64Array.from(points), Float64Array.from(normals), mask, isLinear, closed, rounds, roundness);
  }

  /** The refined curve that is shown. */
  get shownCurve(): PlaneCurve | undefined {
    return this.curve;
  }

  private draw(): void {
    if (this.svg.clientWidth === 0) return;
    if (this.mustFit) this.fit();
    let pn: PlaneCurve | undefined;
    let linear: PlaneCurve | undefined;
    const started = performance.now();
    if (this.state.points.length >= 4)
      try {
        pn = this.refine(false);
        linear = this.refine(true);
      } catch (error) {
        this.say(messageOf(error), "error");
      }
    this.curve = pn;
    const milliseconds = performance.now() - started;
    this.svg.replaceChildren(...this.pictures(pn, this.state.showLinear ? linear : undefined));
    this.status = pn ? `${pn.points.length / 2} points in ${milliseconds.toFixed(1)} ms${this.deviations(pn, linear!)}` : "Click where the points shall be.";
    const line = this.svg.parentElement?.querySelector("#curve-status");
    if (line) line.textContent = this.status;
  }

  /** How far the curves are from the circle that the control points are on, if they are on one. */
  private deviations(pn: PlaneCurve, linear: PlaneCurve): string {
    const circle = roundShapeThrough(this.state.points, 2);
    if (!circle) return "";
    const of = (curve: PlaneCurve): string => deviation(curve.points, circle.center, circle.radius).toExponential(0);
    return ` · distance from the circle in radii: point-normal ${of(pn)}, linear ${of(linear)}`;
  }

  private pictures(pn: PlaneCurve | undefined, linear: PlaneCurve | undefined): SVGElement[] {
    const { points, normals, closed, showComb } = this.state;
    const result: SVGElement[] = [];
    const edges = points.length / 2 - (closed ? 0 : 1);
    result.push(make("path", { class: "polygon", d: this.path(points, closed) }));
    if (pn && showComb) result.push(...this.comb(pn));
    if (linear) result.push(make("path", { class: "linear", d: this.path(linear.points, closed) }));
    if (pn) result.push(make("path", { class: "curve", d: this.path(pn.points, closed) }));
    if (!this.isDrawing)
      for (let e = 0; e < edges; ++e) {
        const [a, b] = [this.pixels(points, e), this.pixels(points, (e + 1) % (points.length / 2))];
        result.push(
          make("line", { class: "edge-hold", x1: a[0], y1: a[1], x2: b[0], y2: b[1] }, { kind: "edge", vertex: e }));
      }
    for (let v = 0; v < points.length / 2; ++v) {
      const p = this.pixels(points, v);
      const chosen = v === this.selected ? " selected" : "";
      const length = Math.hypot(normals[2 * v], normals[2 * v + 1]);
      if (length > 0) {
        const tip = [
          p[0] + (tipDistance * normals[2 * v]) / length,
          p[1] - (tipDistance * normals[2 * v + 1]) / length,
        ];
        result.push(make("line", { class: "stem", x1: p[0], y1: p[1], x2: tip[0], y2: tip[1] }));
        result.push(make("circle", { class: `tip${chosen}`, cx: tip[0], cy: tip[1], r: 4.5 }));
        result.push(make("circle", { class: "hold", cx: tip[0], cy: tip[1], r: 14 }, { kind: "normal", vertex: v }));
      }
      result.push(make("circle", { class: `point${chosen}`, cx: p[0], cy: p[1], r: 4.5 }));
      result.push(make("circle", { class: "hold", cx: p[0], cy: p[1], r: 14 }, { kind: "point", vertex: v }));
    }
    return result;
  }

  private comb(curve: PlaneCurve): SVGElement[] {
    // the scale is such that a length of 50 makes the comb of a circle half as long as its radius
    const { points } = this.state;
    const xs = points.filter((_, i) => i % 2 === 0);
    const ys = points.filter((_, i) => i % 2 === 1);
    const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)) / 2;
    const scale = (this.state.combScale / 100) * size * size;
    const teeth: string[] = [];
    const tips: number[] = [];
    for (let i = 0; i < curve.points.length; i += 2) {
      const [x, y] = [curve.points[i], curve.points[i + 1]];
      tips.push(x + scale * (curve.comb[i] - x), y + scale * (curve.comb[i + 1] - y));
    }
    const step = Math.max(1, Math.floor(curve.points.length / 2 / 320));
    for (let v = 0; v < tips.length / 2; v += step) {
      const [a, b] = [this.pixels(curve.points, v), this.pixels(tips, v)];
      teeth.push(`M${a[0].toFixed(1)} ${a[1].toFixed(1)}L${b[0].toFixed(1)} ${b[1].toFixed(1)}`);
    }
    return [
      make("path", { class: "comb", d: teeth.join("") }),
      make("path", { class: "envelope", d: this.path(tips, this.state.closed) }),
    ];
  }

  private pixels(points: ArrayLike<number>, v: number): [number, number] {
    return [
      this.svg.clientWidth / 2 + (points[2 * v] - this.view.x) * this.view.scale,
      this.svg.clientHeight / 2 - (points[2 * v + 1] - this.view.y) * this.view.scale,
    ];
  }

  private path(points: ArrayLike<number>, closed: boolean): string {
    const parts: string[] = [];
    for (let v = 0; v < points.length / 2; ++v) {
      const [x, y] = this.pixels(points, v);
      parts.push(`${v === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`);
    }
    return parts.join("") + (closed && parts.length > 2 ? "Z" : "");
  }

  /** The drawing as a file of its own. */
  svgFile(): string {
    const copy = this.svg.cloneNode(true) as SVGSVGElement;
    const originals = this.svg.querySelectorAll<SVGElement>("*");
    copy.querySelectorAll<SVGElement>("*").forEach((child, i) => {
      const style = getComputedStyle(originals[i]);
      for (const name of ["fill", "stroke", "stroke-width", "stroke-dasharray", "opacity"])
        child.setAttribute(name, style.getPropertyValue(name));
    });
    copy.querySelectorAll(".hold, .edge-hold").forEach((child) => child.remove());
    const { clientWidth: width, clientHeight: height } = this.svg;
    for (const name of ["id", "tabindex", "role", "aria-label", "aria-roledescription"]) copy.removeAttribute(name);
    copy.setAttribute("xmlns", space);
    copy.setAttribute("viewBox", `0 0 ${width} ${height}`);
    return new XMLSerializer().serializeToString(copy);
  }

  /** As the command pn_subdivide reads it. */
  textFile(): string {
    const { points, normals } = this.state;
    let text = "";
    for (let v = 0; v < points.length; v += 2)
      text += `${points[v]} ${points[v + 1]} ${normals[v]} ${normals[v + 1]}\n`;
    return text;
  }
}

function turn(normals: number[], v: number, degrees: number): void {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const [x, y] = [normals[2 * v], normals[2 * v + 1]];
  const isZero = x === 0 && y === 0;
  normals.splice(2 * v, 2, isZero ? 0 : c * x - s * y, isZero ? 1 : s * x + c * y);
}
