// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The surface that is shown: its control mesh, what is made of it, and every change of it.

import { shortRoundness } from "./address";
import { History } from "./history";
import type { ControlMesh, Handles, MeshState, Modeler, RefinedSurface, SchemeTraits } from "./modeler";
import { bestSphere, deviation, roundShapeThrough } from "./round_shapes";
import { withCreases } from "./selection";
import { endOfColors, endOfRelative, relativeToMean, type Shading } from "./shading";
import type { Layout, Selection, Viewer } from "./viewer";

export interface Settings {
  scheme: string;
  rounds: number;
  layout: Layout;
  /** Where the linear surface ends in the view, from 0 to 1. */
  split: number;
  shading: Shading;
  limit: boolean;
  showControl: boolean;
  showNormals: boolean;
}

export type Triple = [number, number, number];
export type Say = (text: string, kind: "error" | "note") => void;

/** More faces than this would be slow to draw. */
const greatestNumberOfFaces = 600_000;
/** What takes no longer than this many milliseconds is done while the mouse moves. */
const whileDragging = 25;

/** Settings from an address, of which anyone may be the author: what is no setting is left out. */
export function checkedSettings(given: Partial<Record<keyof Settings, unknown>>): Partial<Settings> {
  const result: Partial<Settings> = {};
  if (typeof given.scheme === "string") result.scheme = given.scheme;
  if (typeof given.rounds === "number" && given.rounds >= 0) result.rounds = Math.min(7, Math.floor(given.rounds));
  const layout = (["pn", "linear", "both", "split"] as const).find((name) => name === given.layout);
  if (layout) result.layout = layout;
  const shading = (["smooth", "zebra", "gaussian", "mean", "relative"] as const).find((name) => name === given.shading);
  if (shading) result.shading = shading;
  if (typeof given.split === "number" && given.split >= 0) result.split = Math.min(1, given.split);
  for (const name of ["limit", "showControl", "showNormals"] as const)
    if (typeof given[name] === "boolean") result[name] = given[name];
  return result;
}

interface Version {
  mesh: MeshState;
  scheme: string;
  name: string;
}

export class Editor {
  readonly schemes: Map<string, SchemeTraits>;
  mesh!: ControlMesh;
  handles!: Handles;
  /** The same with points relative to the origin of the picture. */
  shownHandles!: Handles;
  /** Of the picture: a small mesh that is far away is shown near 0, where numbers of 24 bits suffice. */
  origin: Triple = [0, 0, 0];
  selection: Selection = {};
  /** What the mesh is called; it is changed if it differs from its example. */
  name = "";
  normalLength = 1;
  /** That of all vertices, if it is the same. */
  roundness: number | undefined = 1;
  colorEnd = 1;
  /** The most rounds for this mesh and scheme. */
  greatestRounds = 7;
  status = "";
  /** Another one after each change of the mesh. */
  meshNumber = 0;
  readonly history = new History<Version>(({ mesh }) => mesh.points.length + 4 * mesh.corners.length);
  settings: Settings = {
    scheme: "catmull-clark",
    rounds: 4,
    layout: "both",
    split: 0.5,
    shading: "smooth",
    limit: false,
    showControl: true,
    showNormals: true,
  };
  /** Called when anything has changed that the panel or the address tells of. */
  onChange: ((isFinal: boolean) => void) | undefined;

  private surfaces = new Map<boolean, RefinedSurface>(); // by whether they are linear
  private size = 1;
  private cost = { limit: 0, curvature: 0 };
  private dragged = new Set<number>();
  private frame = 0;
  private beforeDrag: Version | undefined; // until something is dragged
  private hasDragged = false;
  private beforeSlide: Version | undefined;

  constructor(
    private readonly modeler: Modeler,
    private readonly viewer: Viewer,
    private readonly say: Say,
  ) {
    this.schemes = new Map(modeler.schemes().map((s) => [s.name, s]));
  }

  get scheme(): SchemeTraits {
    return this.schemes.get(this.settings.scheme)!;
  }

  /** The surface on the screen; where there are two, the point-normal one. */
  get shownSurface(): RefinedSurface {
    return this.surfaces.get(this.settings.layout === "linear")!;
  }
  surface(isLinear: boolean): RefinedSurface | undefined {
    return this.surfaces.get(isLinear);
  }

  // --- other meshes, schemes and views ---

  /** Shows another mesh. If that fails, everything stays as it is, and the message says why. */
  load(make: () => ControlMesh, name: string, settings: Partial<Settings>, isFirst = false): boolean {
    let mesh: ControlMesh | undefined;
    try {
      mesh = make();
      const next = { ...this.settings, ...settings };
      const before = isFirst ? undefined : this.version();
      this.replace(mesh, next);
      if (before) this.history.remember(before);
    } catch (error) {
      mesh?.delete();
      this.say(`${name}: ${messageOf(error)}`, "error");
      return false;
    }
    this.name = name;
    this.selection = {};
    this.frameAll();
    this.changed();
    return true;
  }

  /** Reads a file as the command does: Loop subdivision for triangles, Catmull-Clark for other faces.
   * `selection`: the content of a selection file of CGAL, whose edges are the creases. */
  open(content: Uint8Array, fileName: string, selection?: string): boolean {
    const format = fileName.split(".").pop()!.toLowerCase();
    let scheme = this.settings.scheme;
    return this.load(
      () => {
        let mesh = this.modeler.readMesh(content, format);
        if (selection !== undefined) mesh = withCreases(this.modeler, mesh, selection);
        scheme = mesh.hasOnlyTriangles() ? "loop" : "catmull-clark";
        return mesh;
      },
      fileName,
      {
        get scheme() {
          return scheme;
        },
      } as Partial<Settings>,
    );
  }

  /** The edges of a selection file become the creases of the mesh that is shown. */
  openSelection(selection: string, fileName: string): void {
    try {
      const copy = this.modeler.restoreMesh(this.mesh.state());
      const mesh = withCreases(this.modeler, copy, selection);
      const before = this.version();
      this.replace(mesh, this.settings);
      this.history.remember(before);
      this.say(`${mesh.numberOfSharpEdges()} edges are sharp.`, "note");
    } catch (error) {
      this.say(`${fileName}: ${messageOf(error)}`, "error");
    }
    this.changed();
  }

  set(change: Partial<Settings>): void {
    const before = this.version();
    const hadOnlyTriangles = this.mesh.hasOnlyTriangles();
    try {
      const next = { ...this.settings, ...change };
      const needsSurfaces = ["scheme", "rounds", "layout"].some((key) => key in change);
      if (needsSurfaces) this.replace(this.mesh, next);
      this.settings = next;
      if (change.scheme !== undefined && change.scheme !== before.scheme) this.history.remember(before);
      if (!hadOnlyTriangles && this.mesh.hasOnlyTriangles())
        this.say("The faces were split into triangles, which is what this scheme takes. Undo brings them back.", "note");
    } catch (error) {
      this.say(messageOf(error), "error");
    }
    this.show(true);
    this.changed();
  }

  /** Where the two surfaces of one view meet. */
  setSplit(split: number, isFinal: boolean): void {
    this.settings.split = split;
    this.viewer.setLayout(this.settings.layout, split);
    this.onChange?.(isFinal);
  }

  /** From the usual direction, or from another one. */
  frameAll(direction?: Triple): void {
    this.viewer.frameAll([this.shownHandles.points, this.shownSurface.positionsView()], direction);
  }

  // --- changes of the mesh ---

  /** While a slider moves it is one change. */
  slideRoundness(w: number, isLast: boolean): void {
    if (!this.beforeSlide) this.history.remember((this.beforeSlide = this.version()));
    this.mesh.setRoundness(w);
    this.replace(this.mesh, this.settings);
    if (!isLast) return;
    this.beforeSlide = undefined;
    this.changed();
  }

  /** A change that is done at once. */
  change(change: (mesh: ControlMesh) => void): void {
    this.history.remember(this.version());
    try {
      change(this.mesh);
      this.replace(this.mesh, this.settings);
    } catch (error) {
      const before = this.history.undo(this.version())!;
      this.replace(this.modeler.restoreMesh(before.mesh), { ...this.settings, scheme: before.scheme });
      this.say(messageOf(error), "error");
    }
    this.changed();
  }

  /** What moves nothing until endDrag() is no change. */
  beginDrag(): void {
    this.beforeDrag = this.version();
    this.hasDragged = false;
  }

  dragPoint(vertex: number, x: number, y: number, z: number): void {
    this.mesh.setPoint(vertex, x, y, z);
    this.handles.points.set([x, y, z], 3 * vertex);
    this.shownHandles.points.set([x, y, z].map((c, k) => c - this.origin[k]), 3 * vertex);
    this.drag(vertex);
  }

  dragNormal(wedge: number, x: number, y: number, z: number): void {
    this.mesh.setNormal(wedge, x, y, z);
    this.handles.normals.set([x, y, z], 3 * wedge);
    this.drag(this.handles.vertices[wedge]);
  }

  private drag(vertex: number): void {
    if (this.beforeDrag) this.history.remember(this.beforeDrag);
    this.beforeDrag = undefined;
    this.hasDragged = true;
    ++this.meshNumber;
    this.dragged.add(vertex);
    if (this.frame === 0)
      this.frame = requestAnimationFrame(() => {
        this.frame = 0;
        this.follow(false);
      });
  }

  endDrag(): void {
    if (this.frame !== 0) cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.beforeDrag = undefined;
    if (!this.hasDragged) return;
    this.hasDragged = false;
    this.follow(true);
    this.changed();
  }

  /** A point that is entered or moved by a key. */
  setPoint(vertex: number, x: number, y: number, z: number): void {
    if (isTriple(this.handles.points, vertex, [x, y, z])) return;
    this.beginDrag();
    this.dragPoint(vertex, x, y, z);
    this.endDrag();
  }
  setNormal(wedge: number, x: number, y: number, z: number): void {
    if (isTriple(this.handles.normals, wedge, [x, y, z])) return;
    this.beginDrag();
    this.dragNormal(wedge, x, y, z);
    this.endDrag();
  }

  undo(): void {
    this.go(this.history.undo(this.version()));
  }
  redo(): void {
    this.go(this.history.redo(this.version()));
  }

  private go(version: Version | undefined): void {
    if (!version) return;
    const isOther = version.name !== this.name;
    this.replace(this.modeler.restoreMesh(version.mesh), { ...this.settings, scheme: version.scheme });
    this.name = version.name;
    if (isOther) {
      this.selection = {};
      this.frameAll();
    }
    this.changed();
  }

  select(selection: Selection): void {
    this.selection = selection;
    this.viewer.showSelection(this.shownHandles, this.normalLength, selection);
    this.onChange?.(false);
  }

  private version(): Version {
    return { mesh: this.mesh.state(), scheme: this.settings.scheme, name: this.name };
  }

  private changed(): void {
    this.onChange?.(true);
  }

  // --- the surfaces ---

  /** New surfaces, of this mesh or another one. If anything fails, nothing has changed. */
  private replace(mesh: ControlMesh, wanted: Settings): void {
    const started = performance.now();
    const traits = this.schemes.get(wanted.scheme);
    if (!traits) throw new Error(`there is no scheme ${wanted.scheme}`);
    const split = traits.takesTriangles && !mesh.hasOnlyTriangles() ? mesh.triangulated() : mesh;
    const state = split.state();
    const most = this.mostRounds(state, wanted.scheme);
    const rounds = Math.min(wanted.rounds, most);
    const made = new Map<boolean, RefinedSurface>();
    const origin = this.originFor(state.points);
    try {
      for (const isLinear of [false, true])
        if (hasTwoSurfaces(wanted.layout) || (wanted.layout === "linear") === isLinear)
          made.set(isLinear, this.modeler.refine(split, wanted.scheme, rounds, isLinear, ...origin));
    } catch (error) {
      for (const surface of made.values()) surface.delete();
      if (split !== mesh) split.delete();
      throw error;
    }
    if (rounds < wanted.rounds)
      this.say(`${rounds} ${rounds === 1 ? "round" : "rounds"}: ${wanted.rounds} would make more than ${greatestNumberOfFaces} faces.`, "note");
    for (const surface of this.surfaces.values()) surface.delete();
    if (this.mesh !== undefined && this.mesh !== split) this.mesh.delete();
    if (split !== mesh && mesh !== this.mesh) mesh.delete();
    this.surfaces = made;
    this.mesh = split;
    this.origin = origin;
    this.settings = { ...wanted, rounds };
    this.greatestRounds = most;
    this.readHandles(state);
    for (const [isLinear, surface] of made) this.viewer.pane(isLinear).setTriangles(surface.triangles());
    this.show(true, performance.now() - started);
  }

  /** 0 for what is near it; otherwise the center, which stays while the mesh does not go far away. */
  private originFor(points: Float64Array): Triple {
    const { center, size } = boxOf(points);
    const isNear = (origin: Triple): boolean => Math.hypot(...center.map((x, k) => x - origin[k])) <= 10 * size;
    return ([[0, 0, 0], this.origin] as Triple[]).find(isNear) ?? center;
  }

  private mostRounds({ corners, degrees }: MeshState, scheme: string): number {
    const traits = this.schemes.get(scheme)!;
    const inFirst = traits.takesTriangles ? (scheme === "sqrt3" ? 3 : 4) * degrees.length : corners.length;
    const perRound = scheme === "sqrt3" ? 3 : 4;
    let rounds = 0;
    for (let faces = inFirst; faces <= greatestNumberOfFaces; faces *= perRound) ++rounds;
    return Math.min(rounds, 7);
  }

  private readHandles(state: MeshState): void {
    ++this.meshNumber;
    this.handles = this.mesh.handles();
    const roundness = shortRoundness(state);
    this.roundness = roundness.length === 1 ? roundness[0] : undefined;
    const { points, edges, sharp } = this.handles;
    let length = 0;
    for (let e = 0; e < sharp.length; ++e) {
      const [a, b] = [3 * edges[2 * e], 3 * edges[2 * e + 1]];
      length += Math.hypot(points[a] - points[b], points[a + 1] - points[b + 1], points[a + 2] - points[b + 2]);
    }
    this.shownHandles = { ...this.handles, points: points.map((x, i) => x - this.origin[i % 3]) };
    this.size = boxOf(points).size || 1;
    this.viewer.setClosed(!this.handles.border.includes(1));
    this.normalLength = Math.min((0.5 * length) / Math.max(1, sharp.length), 0.14 * this.size);
    const { wedge, vertex } = this.selection;
    if (wedge !== undefined && (wedge >= this.handles.vertices.length || this.handles.vertices[wedge] !== vertex))
      this.selection = {};
  }

  private follow(isLast: boolean): void {
    const started = performance.now();
    try {
      for (const surface of this.surfaces.values()) {
        for (const v of this.dragged) surface.follow(this.mesh, v);
        surface.update(this.mesh);
      }
    } catch (error) {
      this.say(messageOf(error), "error");
    }
    this.dragged.clear();
    this.show(isLast, performance.now() - started);
  }

  /** Limit points and curvatures are left for the end of a drag where they take long. */
  private show(isLast: boolean, milliseconds?: number): void {
    const { limit, shading } = this.settings;
    const curved = isCurvature(shading);
    for (const [isLinear, surface] of this.surfaces) {
      const pane = this.viewer.pane(isLinear);
      if (limit && this.canShowLimit && (isLast || this.cost.limit < whileDragging))
        this.cost.limit = timeOf(() => surface.showLimit(this.mesh));
      else if (!limit || !this.canShowLimit) surface.hideLimit();
      pane.setVertices(surface.positionsView(), surface.normalsView());
    }
    if (curved && (isLast || this.cost.curvature < whileDragging)) {
      const values = new Map<boolean, Float32Array>();
      this.cost.curvature = timeOf(() => {
        for (const [isLinear, surface] of this.surfaces)
          values.set(isLinear, surface.curvature(shading !== "mean"));
      });
      // the colors are those of the surface that is looked at, so that both views can be compared
      const pn = values.get(false) ?? values.get(true)!;
      this.colorEnd = shading === "relative" ? endOfRelative : endOfColors([pn], this.size, shading);
      for (const [isLinear, array] of values)
        this.viewer.pane(isLinear).setValues(shading === "relative" ? relativeToMean(array) : array);
    }
    this.viewer.setLayout(this.settings.layout, this.settings.split);
    this.viewer.setShading(shading, this.colorEnd);
    this.viewer.setVisible(this.settings.showControl, this.settings.showNormals);
    this.viewer.setSize(this.size / 2);
    this.showControlMesh();
    if (milliseconds !== undefined) {
      const vertices = this.shownSurface.positionsView().length / 3;
      this.status = `${format(vertices)} vertices · ${milliseconds.toFixed(1)} ms${this.deviations(isLast)}`;
    }
    this.onChange?.(false);
  }

  /** How much the radii of each surface differ, about the sphere that fits it best, if the control points are on one. */
  private deviations(isLast: boolean): string {
    if (!isLast || !roundShapeThrough(this.handles.points, 3)) return "";
    const parts = [...this.surfaces].reverse().map(([isLinear, surface]) => {
      const points = surface.points();
      const { center, radius } = bestSphere(points);
      return `${isLinear ? "linear" : "point-normal"} ±${share(deviation(points, center, radius))}`;
    });
    return ` · radii about the best sphere: ${parts.join(", ")}`;
  }

  get showsLimit(): boolean {
    return this.settings.limit && this.canShowLimit;
  }
  get canShowLimit(): boolean {
    return this.scheme.hasLimitPoints && this.mesh.numberOfSharpEdges() === 0;
  }

  private showControlMesh(): void {
    this.viewer.showControlMesh(this.shownHandles, this.normalLength, this.selection);
  }
}

function boxOf(points: Float64Array): { center: Triple; size: number } {
  const low: Triple = [Infinity, Infinity, Infinity];
  const high: Triple = [-Infinity, -Infinity, -Infinity];
  points.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  if (points.length === 0) return { center: [0, 0, 0], size: 0 };
  return { center: low.map((x, k) => x + (high[k] - x) / 2) as Triple, size: Math.hypot(...low.map((x, k) => high[k] - x)) };
}

function isTriple(values: Float64Array, i: number, triple: number[]): boolean {
  return triple.every((x, k) => values[3 * i + k] === x);
}

function hasTwoSurfaces(layout: Layout): boolean {
  return layout === "both" || layout === "split";
}
function isCurvature(shading: Shading): boolean {
  return shading === "gaussian" || shading === "mean" || shading === "relative";
}

/** A small number in hundredths, one that is rounding with its power of ten. */
function share(x: number): string {
  return x < 1e-6 ? x.toExponential(0) : `${(100 * x).toPrecision(2)} %`;
}

function timeOf(work: () => void): number {
  const started = performance.now();
  work();
  return performance.now() - started;
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

export function format(n: number): string {
  return n.toString().replace(/\B(?=(\d{3})+$)/g, "\u202f");
}
