// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// "What the formula does": two points and two normals in the plane that can be moved, and all that the rule makes of them.

import { button, element, input } from "./elements";
import { along, arcTo, average, nextRound, type Average, type Pair, type PointNormal } from "./formula";
import { make } from "./svg";

type Handle = { entry: 0 | 1; kind: "point" | "normal" };

const handles: Handle[] = ([0, 1] as const).flatMap((entry) => [{ entry, kind: "point" }, { entry, kind: "normal" }] as Handle[]);
const lengthOfNormals = 0.8;
const mostRounds = 7;

const unit = (x: number, y: number): Pair => [x / Math.hypot(x, y), y / Math.hypot(x, y)];
const atStart = (): [PointNormal, PointNormal] => [
  { p: [-2, -0.6], n: unit(-0.75, 1) },
  { p: [2, -0.6], n: unit(0.35, 1) },
];

export class FormulaView {
  ends = atStart();
  rounds = 0;
  private held: Handle | undefined;
  private chosen: Handle | undefined;

  constructor(
    private readonly svg: SVGSVGElement,
    private readonly announce: (text: string) => void,
  ) {
    svg.addEventListener("pointerdown", (e) => this.down(e));
    svg.addEventListener("pointermove", (e) => this.held && this.moveTo(this.held, this.toUnits(e)));
    for (const name of ["pointerup", "pointercancel"] as const) svg.addEventListener(name, () => (this.held = undefined));
    svg.addEventListener("keydown", (e) => this.key(e));
    new ResizeObserver(() => this.draw()).observe(svg);
    for (const id of ["formula-share", "formula-roundness"]) input(id).addEventListener("input", () => this.draw());
    button("formula-next").addEventListener("click", () => this.setRounds(this.rounds + 1));
    button("formula-first").addEventListener("click", () => this.setRounds(0));
    button("formula-circle").addEventListener("click", () => this.takeCircle());
    button("formula-reset").addEventListener("click", () => this.reset());
  }

  get share(): number {
    return Number(input("formula-share").value);
  }
  get roundness(): number {
    return Number(input("formula-roundness").value);
  }

  /** The polygon after the rounds that were asked for. */
  get polygon(): PointNormal[] {
    let polygon: PointNormal[] = [...this.ends];
    for (let i = 0; i < this.rounds; ++i) polygon = nextRound(polygon, this.share, this.roundness);
    return polygon;
  }

  private setRounds(rounds: number): void {
    this.rounds = Math.min(mostRounds, rounds);
    this.draw();
  }

  private reset(): void {
    this.ends = atStart();
    this.rounds = 0;
    input("formula-share").value = "0.5";
    input("formula-roundness").value = "1";
    this.draw();
  }

  /** The second normal becomes that of the circle through both points on which the first one is. */
  private takeCircle(): void {
    const [a, b] = this.ends;
    const chord = along(b.p, -1, a.p);
    const [x, y] = unit(...chord);
    const across = a.n[0] * x + a.n[1] * y;
    b.n = along(a.n, -2 * across, [x, y]);
    this.draw();
  }

  // --- mouse, finger, keys ---

  private get scale(): number {
    return Math.min(this.svg.clientWidth / 6.4, this.svg.clientHeight / 4.6);
  }
  private pixels(p: Pair): Pair {
    return [this.svg.clientWidth / 2 + p[0] * this.scale, this.svg.clientHeight * 0.58 - p[1] * this.scale];
  }
  private toUnits(event: PointerEvent): Pair {
    const box = this.svg.getBoundingClientRect();
    return [
      (event.clientX - box.left - this.svg.clientWidth / 2) / this.scale,
      -(event.clientY - box.top - this.svg.clientHeight * 0.58) / this.scale,
    ];
  }

  private placeOf({ entry, kind }: Handle): Pair {
    const { p, n } = this.ends[entry];
    return kind === "point" ? p : along(p, lengthOfNormals, n);
  }

  private down(event: PointerEvent): void {
    const i = (event.target as SVGElement).dataset.handle;
    if (event.button !== 0 || i === undefined) return;
    this.held = this.chosen = handles[Number(i)];
    this.svg.setPointerCapture(event.pointerId);
    this.draw();
  }

  private moveTo({ entry, kind }: Handle, place: Pair): void {
    const end = this.ends[entry];
    if (kind === "point") end.p = place;
    else if (Math.hypot(place[0] - end.p[0], place[1] - end.p[1]) > 1e-6) end.n = unit(place[0] - end.p[0], place[1] - end.p[1]);
    this.draw();
  }

  private key(event: KeyboardEvent): void {
    const steps: Record<string, Pair> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const step = steps[event.key];
    if (event.key.toLowerCase() === "n" && !event.ctrlKey && !event.metaKey) this.chooseNext();
    else if (step && this.chosen) this.moveTo(this.chosen, along(this.placeOf(this.chosen), event.shiftKey ? 0.02 : 0.1, step));
    else return;
    event.preventDefault();
    this.draw();
  }

  private chooseNext(): void {
    const now = this.chosen ? handles.indexOf(this.chosen) : -1;
    this.chosen = handles[(now + 1) % handles.length];
    this.announce(`${this.chosen.kind} ${this.chosen.entry}`);
  }

  // --- the drawing ---

  draw(): void {
    if (this.svg.clientWidth === 0) return;
    const result = average(...this.ends, this.share, this.roundness);
    this.svg.replaceChildren(...this.construction(result), ...this.curve(), ...this.result(result), ...this.grips());
    this.write(result);
  }

  private line(points: Pair[], name: string): SVGElement {
    const places = points.map((p) => this.pixels(p).map((x) => x.toFixed(2)).join(" "));
    return make("path", { class: name, d: `M${places.join("L")}` });
  }
  private dot(p: Pair, name: string, r: number): SVGElement {
    const [cx, cy] = this.pixels(p);
    return make("circle", { class: name, cx, cy, r });
  }
  private text(p: Pair, text: string, dx: number, dy: number): SVGElement {
    const [x, y] = this.pixels(p);
    const result = make("text", { x: x + dx, y: y + dy });
    result.textContent = text;
    return result;
  }

  /** Chord, q, the line along n through it, and the arcs that end on that line. */
  private construction({ q, n, h }: Average): SVGElement[] {
    const [low, high] = [Math.min(0, ...h) - 0.3, Math.max(0, ...h) + 0.9];
    const parts = [
      this.line(this.ends.map(({ p }) => p), "polygon"),
      this.line([along(q, low, n), along(q, high, n)], "axis"),
    ];
    this.ends.forEach((end, j) => {
      const tip = along(q, h[j], n);
      parts.push(this.line(arcTo(end, tip, n), `arc arc-${j}`), this.dot(tip, `height height-${j}`, 5));
      parts.push(this.text(tip, j === 0 ? "q + h₀ n" : "q + h₁ n", j === 0 ? -74 : 12, j === 0 ? -10 : 20));
    });
    return [...parts, this.dot(q, "point", 4), this.text(q, "q", 9, 18)];
  }

  private curve(): SVGElement[] {
    if (this.rounds === 0) return [];
    const points = this.polygon.map(({ p }) => p);
    return [this.line(points, "curve"), ...points.map((p) => this.dot(p, "refined", points.length > 40 ? 1.8 : 3.5))];
  }

  private result({ p, n }: Average): SVGElement[] {
    return [
      this.line([p, along(p, lengthOfNormals, n)], "stem new"),
      this.dot(p, "new", 7),
      this.text(p, "p", -22, -10),
      this.text(along(p, lengthOfNormals, n), "n", 8, 0),
    ];
  }

  /** What can be taken hold of. */
  private grips(): SVGElement[] {
    const names = ["p₀", "n₀", "p₁", "n₁"];
    return handles.flatMap((handle, i) => {
      const place = this.placeOf(handle);
      const [cx, cy] = this.pixels(place);
      const isChosen = this.chosen === handle ? " selected" : "";
      const isPoint = handle.kind === "point";
      return [
        ...(isPoint ? [] : [this.line([this.ends[handle.entry].p, place], "stem")]),
        this.dot(place, (isPoint ? "point" : "tip") + isChosen, 5.5),
        this.text(place, names[i], handle.entry === 0 ? -26 : 12, isPoint ? 20 : 0),
        make("circle", { class: "hold", cx, cy, r: 16 }, { handle: i }),
      ];
    });
  }

  private write({ q, n, h, height, p }: Average): void {
    const pair = (v: Pair): string => `(${v.map((x) => x.toFixed(3)).join(", ")})`;
    const values = { q: pair(q), n: pair(n), h0: h[0].toFixed(3), h1: h[1].toFixed(3), H: height.toFixed(3), p: pair(p) };
    for (const [name, text] of Object.entries(values)) element(`formula-${name}`).textContent = text;
    element("formula-share-value").textContent = this.share.toFixed(2);
    element("formula-roundness-value").textContent = this.roundness.toFixed(2);
    element("formula-rounds").textContent = `${this.polygon.length} points after ${this.rounds} ${this.rounds === 1 ? "round" : "rounds"}`;
    button("formula-next").disabled = this.rounds === mostRounds;
    button("formula-first").disabled = this.rounds === 0;
  }
}
