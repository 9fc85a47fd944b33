// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The surface that is shown: its control mesh, what is made of it, and every change of it.

import { shortRoundness } from "./address";
import { FrozenMesh, isTooLargeToEdit } from "./frozen_mesh";
import { History } from "./history";
import { messageOf } from "./instantiate";
import type { ControlMesh, Faces, Handles, MeshState, Modeler, RefinedSurface, SchemeTraits } from "./modeler";
import { readFile, type AboutFile, type ReadJob } from "./read_file";
import { RemoteSurfaces } from "./remote_surfaces";
import { roundShapeThrough } from "./round_shapes";
import { withCreases } from "./selection";
import type { Shading } from "./shading";
import { Surfaces, type Content, type Drawings, type Shown } from "./surfaces";
import { stemsOf, type Layout, type Selection, type Viewer } from "./viewer";

export { messageOf };

export interface Settings {
  scheme: string;
  rounds: number;
  layout: Layout;
  /** Where the linear surface ends in the view, from 0 to 1. */
  split: number;
  shading: Shading;
  /** Whether faces have their own normals, not those between them. */
  flat: boolean;
  limit: boolean;
  showControl: boolean;
  showNormals: boolean;
}

export type Triple = [number, number, number];
export type Say = (text: string, kind: "error" | "note") => void;

/** More faces than this would be slow to draw. */
const greatestNumberOfFaces = 600_000;
/** Surfaces with more faces together are made by the worker, so that the page does not stand still. */
const mostFacesHere = 14_000;
/** A mesh of the user's begins with the most rounds, up to 3, that make no more vertices. */
const mostVerticesAtFirst = 100_000;
/** Files of more bytes are read by the worker. */
export const large = 200_000;

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
  for (const name of ["flat", "limit", "showControl", "showNormals"] as const)
    if (typeof given[name] === "boolean") result[name] = given[name];
  return result;
}

interface Version {
  mesh: MeshState;
  scheme: string;
  rounds: number;
  name: string;
  about: AboutFile | undefined;
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
  meanRoundness = 1;
  verticesBelowRoundness1 = 0;
  colorEnd = 1;
  /** The most rounds for this mesh and scheme. */
  greatestRounds = 7;
  status = "";
  /** The mesh as there is a file of it; none: not at all. */
  ofFile: MeshState | undefined;
  /** Of the file that the mesh is of. */
  about: AboutFile | undefined;
  /** Another one after each change of the mesh. */
  meshNumber = 0;
  readonly history = new History<Version>(({ mesh }) => mesh.points.length + 4 * mesh.corners.length);
  settings: Settings = {
    scheme: "catmull-clark",
    rounds: 4,
    layout: "both",
    split: 0.5,
    shading: "smooth",
    flat: false,
    limit: false,
    showControl: true,
    showNormals: true,
  };
  /** Called when anything has changed that the panel or the address tells of. */
  onChange: ((isFinal: boolean) => void) | undefined;

  /** Those that are made on the page: all of them or, while the worker makes the real ones, with fewer rounds. */
  private readonly surfaces: Surfaces;
  private readonly remote: RemoteSurfaces;
  private isRemote = false;
  private roundsHere = 0; // with which nothing is left to the worker, if the mesh itself is not too large
  private positions: Float32Array = new Float32Array(); // of the surface on the screen, or the one before
  private lastShown: { version: Version; settings: Settings } | undefined; // if it is of the worker
  private faces: Faces | undefined; // of the mesh
  private size = 1;
  private dragged = { points: new Set<number>(), wedges: new Set<number>() };
  private frame = 0;
  private beforeDrag: Version | undefined; // until something is dragged
  private hasDragged = false;
  private beforeSlide: Version | undefined;
  private choices = 0;

  constructor(
    private readonly modeler: Modeler,
    private readonly viewer: Viewer,
    private readonly say: Say,
    module: WebAssembly.Module,
    onProgress: (share: number | undefined) => void,
  ) {
    this.schemes = new Map(modeler.schemes().map((s) => [s.name, s]));
    this.surfaces = new Surfaces(modeler);
    this.remote = new RemoteSurfaces(module, {
      onDrawn: (drawn, isLast) => {
        if (drawn.drawings[0]?.triangles) this.lastShown = { version: this.version(), settings: this.settings };
        this.draw(drawn, isLast, drawn.milliseconds);
      },
      onFailure: (message) => this.goBack(message),
      onProgress,
    });
  }

  get scheme(): SchemeTraits {
    return this.schemes.get(this.settings.scheme)!;
  }

  /** The surface on the screen; where there are two, the point-normal one. That of the worker is elsewhere. */
  get shownSurface(): RefinedSurface {
    return this.surfaces.get(this.settings.layout === "linear")!;
  }
  /** All of a surface, once it is made. */
  async content(isLinear = this.settings.layout === "linear"): Promise<Content> {
    await this.settled();
    return this.isRemote ? this.remote.content(isLinear) : this.surfaces.content(this.mesh, isLinear);
  }
  settled(): Promise<void> {
    return this.remote.settled();
  }
  surface(isLinear: boolean): RefinedSurface | undefined {
    return this.surfaces.get(isLinear);
  }

  // --- other meshes, schemes and views ---

  /** Of meshes, the one that was chosen last is shown: returns whether that is still the one of this call. */
  choose(): () => boolean {
    const choice = ++this.choices;
    return () => choice === this.choices;
  }

  /** Shows another mesh. If that fails, everything stays as it is, and the message says why. */
  load(make: () => ControlMesh, name: string, settings: Partial<Settings>, isFirst = false, about?: AboutFile): boolean {
    this.choose();
    let mesh: ControlMesh | undefined;
    try {
      mesh = make();
      const { shading } = this.settings;
      // whose average is of one surface
      const next = { ...this.settings, shading: shading === "relative" ? "smooth" as const : shading, rounds: firstRounds(mesh), ...settings };
      const before = isFirst ? undefined : this.version();
      this.replace(mesh, next);
      if (before) this.history.remember(before);
    } catch (error) {
      mesh?.delete();
      this.say(`${name}: ${messageOf(error)}`, "error");
      return false;
    }
    this.name = name;
    this.ofFile = this.mesh.state();
    this.about = about;
    this.selection = {};
    this.changed();
    this.frameAll(); // in the room that the caption leaves
    return true;
  }

  /** Reads a file as the command does: Loop subdivision for triangles, Catmull-Clark for other faces; what takes long
   * beside the page. Throws what is wrong with it; where another mesh has been chosen meanwhile, nothing happens. */
  async open(job: ReadJob, isLast = this.choose()): Promise<void> {
    const { content, fileName } = job;
    const read = content.length > large ? await this.remote.read(job).catch((error) => error as Error) : readFile(this.modeler, job);
    if (!isLast()) return;
    if (read instanceof Error) throw read;
    const mesh = "mesh" in read ? read.mesh : this.restored(read.state, read.hasOnlyTriangles);
    this.load(() => mesh, fileName, { scheme: mesh.hasOnlyTriangles() ? "loop" : "catmull-clark" }, false, read.about);
  }

  private restored(state: MeshState, hasOnlyTriangles = state.degrees.every((degree) => degree === 3)): ControlMesh {
    return isTooLargeToEdit(state) ? new FrozenMesh(state, hasOnlyTriangles) : this.modeler.restoreMesh(state);
  }

  /** The edges of a selection file become the creases of the mesh that is shown. */
  openSelection(selection: string, fileName: string): void {
    try {
      this.requireEditable();
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
    const { settings } = this;
    const before = this.version();
    const hadOnlyTriangles = this.mesh.hasOnlyTriangles();
    try {
      const next = { ...this.settings, ...change };
      const needsSurfaces = ["scheme", "rounds", "layout"].some((key) => key in change);
      if (needsSurfaces) this.replace(this.mesh, next);
      else {
        this.settings = next;
        this.show(true);
      }
      if (change.scheme !== undefined && change.scheme !== before.scheme) this.history.remember(before);
      if (!hadOnlyTriangles && this.mesh.hasOnlyTriangles())
        this.say("The faces were split into triangles, which is what this scheme takes. Undo brings them back.", "note");
    } catch (error) {
      this.say(messageOf(error), "error");
      if (this.settings !== settings) this.restore(before, settings);
    }
    this.changed();
  }

  /** Where the two surfaces of one view meet. */
  setSplit(split: number, isFinal: boolean): void {
    this.settings.split = split;
    this.viewer.setLayout(this.settings.layout, split);
    this.onChange?.(isFinal);
  }

  takeAsSaved(mesh: MeshState): void {
    this.ofFile = mesh;
    this.changed();
  }

  /** From the usual direction, or from another one. */
  frameAll(direction?: Triple): void {
    const tips = this.settings.showNormals ? stemsOf(this.shownHandles, this.normalLength).tips : [];
    this.viewer.frameAll([this.shownHandles.points, this.positions], tips, direction);
  }

  // --- changes of the mesh ---

  private requireEditable(): void {
    if (this.mesh instanceof FrozenMesh) this.mesh.refuse();
  }

  /** While a slider moves it is one change. */
  slideRoundness(w: number, isLast: boolean): void {
    if (this.mesh instanceof FrozenMesh) return void this.change((mesh) => mesh.setRoundness(w));
    const before = this.version();
    if (!this.beforeSlide) this.history.remember((this.beforeSlide = before));
    try {
      this.mesh.setRoundness(w);
      this.replace(this.mesh, this.settings);
    } catch (error) {
      this.restore(before);
      this.say(messageOf(error), "error");
    }
    if (!isLast) return;
    this.beforeSlide = undefined;
    this.changed();
  }

  /** A change that is done at once; returns whether it was. */
  change(change: (mesh: ControlMesh) => void): boolean {
    let before: Version | undefined;
    try {
      this.requireEditable();
      before = this.version();
      change(this.mesh);
      this.replace(this.mesh, this.settings);
      this.history.remember(before);
    } catch (error) {
      if (before) this.restore(before);
      this.say(messageOf(error), "error");
      return false;
    } finally {
      this.changed();
    }
    return true;
  }

  private restore({ mesh, scheme }: Version, settings = this.settings): void {
    this.replace(this.restored(mesh), { ...settings, scheme });
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
    this.dragged.points.add(vertex);
    this.drag();
  }

  dragNormal(wedge: number, x: number, y: number, z: number): void {
    this.mesh.setNormal(wedge, x, y, z);
    this.handles.normals.set([x, y, z], 3 * wedge);
    this.dragged.wedges.add(wedge);
    this.drag();
  }

  /** Shows what a normal would do, which is no change: the last call has the normal as it was. */
  showTurned(wedge: number, x: number, y: number, z: number, isLast: boolean): void {
    this.mesh.setNormal(wedge, x, y, z);
    this.handles.normals.set([x, y, z], 3 * wedge);
    this.dragged.wedges.add(wedge);
    this.follow(isLast);
  }

  private drag(): void {
    if (this.beforeDrag) this.history.remember(this.beforeDrag);
    this.beforeDrag = undefined;
    this.hasDragged = true;
    ++this.meshNumber;
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
    this.choose();
    const isOther = version.name !== this.name;
    this.restore(version, isOther ? { ...this.settings, rounds: version.rounds } : this.settings);
    this.name = version.name;
    this.about = version.about;
    if (isOther) this.selection = {};
    this.changed();
    if (isOther) this.frameAll();
  }

  select(selection: Selection): void {
    this.selection = selection;
    this.viewer.showSelection(this.shownHandles, this.normalLength, selection);
    this.onChange?.(false);
  }

  private version(): Version {
    const { name, about } = this;
    const { scheme, rounds } = this.settings;
    return { mesh: this.mesh.state(), scheme, rounds, name, about };
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
    const origin = this.originFor(state.points);
    const kinds = [false, true].filter((isLinear) => hasTwoSurfaces(wanted.layout) || (wanted.layout === "linear") === isLinear);
    const here = this.roundsWithin(state, wanted.scheme, mostFacesHere / kinds.length);
    const isRemote = here < rounds;
    try {
      // with fewer rounds it tells what the scheme has against the mesh
      if (here >= 0) this.surfaces.make(split, { scheme: wanted.scheme, rounds: Math.min(here, rounds), kinds, origin });
      else this.surfaces.clear();
    } catch (error) {
      if (split !== mesh) split.delete();
      throw error;
    }
    const keepsPicture = isRemote && this.isRemote && isSameMesh(state, this.faces);
    this.faces = { degrees: state.degrees, corners: state.corners };
    this.isRemote = isRemote;
    this.roundsHere = Math.max(0, Math.min(here, rounds));
    if (!isRemote) this.remote.cancel();
    if (rounds < wanted.rounds)
      this.say(`${rounds} ${rounds === 1 ? "round" : "rounds"}: ${wanted.rounds} would make more than ${greatestNumberOfFaces} faces.`, "note");
    if (this.mesh !== undefined && this.mesh !== split) this.mesh.delete();
    if (split !== mesh && mesh !== this.mesh) mesh.delete();
    this.mesh = split;
    this.origin = origin;
    this.settings = { ...wanted, rounds };
    this.greatestRounds = most;
    this.readHandles(state);
    const milliseconds = performance.now() - started;
    if (!isRemote) return this.show(true, milliseconds);
    this.status = "";
    if (here < 0) this.positions = thinnedOut(state.points, origin);
    if (!keepsPicture && here >= 0) this.draw(this.surfaces.draw(this.mesh, this.shown(true)), true);
    this.showOverlays();
    this.remote.make({ state, scheme: wanted.scheme, rounds, kinds, origin }, this.shown(true));
    this.onChange?.(false);
  }

  /** The worker has failed, or is to stop: what it showed before is shown again, or fewer rounds. */
  private goBack(message: string): void {
    this.say(message, "error");
    const last = this.lastShown;
    this.lastShown = undefined;
    if (!last && this.roundsHere === this.settings.rounds) return;
    const settings = last?.settings ?? { ...this.settings, rounds: this.roundsHere };
    if (last) ({ name: this.name, about: this.about } = last.version);
    try {
      this.replace(last ? this.restored(last.version.mesh) : this.mesh, settings);
    } catch (error) {
      this.say(messageOf(error), "error");
    }
    this.changed();
  }

  /** Nothing is waited for. */
  cancel(): void {
    this.remote.cancel();
    this.goBack("Stopped.");
  }

  /** 0 for what is near it; otherwise the center, which stays while the mesh does not go far away. */
  private originFor(points: Float64Array): Triple {
    const { center, size } = boxOf(points);
    const isNear = (origin: Triple): boolean => Math.hypot(...center.map((x, k) => x - origin[k])) <= 10 * size;
    return ([[0, 0, 0], this.origin] as Triple[]).find(isNear) ?? center;
  }

  private mostRounds(state: MeshState, scheme: string): number {
    return Math.max(0, Math.min(7, this.roundsWithin(state, scheme, greatestNumberOfFaces)));
  }

  /** The most rounds with so many faces; -1 where there are more already. */
  private roundsWithin({ corners, degrees }: MeshState, scheme: string, most: number): number {
    const traits = this.schemes.get(scheme)!;
    const inFirst = traits.takesTriangles ? (scheme === "sqrt3" ? 3 : 4) * degrees.length : corners.length;
    const perRound = scheme === "sqrt3" ? 3 : 4;
    let rounds = degrees.length <= most ? 0 : -1;
    for (let faces = inFirst; faces <= most; faces *= perRound) ++rounds;
    return rounds;
  }

  private readHandles(state: MeshState): void {
    ++this.meshNumber;
    this.handles = this.mesh.handles();
    const roundness = shortRoundness(state);
    this.roundness = roundness.length === 1 ? roundness[0] : undefined;
    this.meanRoundness = roundness.reduce((sum, w) => sum + w) / roundness.length;
    const vertices = this.handles.points.length / 3; // of those that can be edited
    const isBelow = (w: number | undefined, i: number): number[] => (w! < 1 ? [state.roundness!.length === vertices ? i : state.corners[i]] : []);
    this.verticesBelowRoundness1 = vertices === 0 ? 0 : new Set(Array.from(state.roundness ?? []).flatMap(isBelow)).size;
    const { points, edges, sharp } = this.handles;
    let length = 0;
    for (let e = 0; e < sharp.length; ++e) {
      const [a, b] = [3 * edges[2 * e], 3 * edges[2 * e + 1]];
      length += Math.hypot(points[a] - points[b], points[a + 1] - points[b + 1], points[a + 2] - points[b + 2]);
    }
    this.shownHandles = { ...this.handles, points: points.map((x, i) => x - this.origin[i % 3]) };
    this.size = boxOf(state.points).size || 1;
    this.viewer.setClosed(!this.handles.border.includes(1));
    this.normalLength = Math.min((0.5 * length) / Math.max(1, sharp.length), 0.14 * this.size);
    const { wedge, vertex } = this.selection;
    if (wedge !== undefined && (wedge >= this.handles.vertices.length || this.handles.vertices[wedge] !== vertex))
      this.selection = {};
  }

  private follow(isLast: boolean): void {
    const started = performance.now();
    const { points, wedges } = this.dragged;
    this.dragged = { points: new Set(), wedges: new Set() };
    const { handles } = this;
    if (this.isRemote) return this.followRemotely(points, wedges, isLast);
    try {
      this.surfaces.follow(this.mesh, new Set([...points, ...[...wedges].map((w) => handles.vertices[w])]));
      this.show(isLast, performance.now() - started);
    } catch (error) {
      this.say(messageOf(error), "error");
    }
  }

  private followRemotely(points: Set<number>, wedges: Set<number>, isLast: boolean): void {
    const { handles, settings } = this;
    const at = (values: Float64Array, i: number): Triple => [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
    this.showOverlays();
    // with creases vertices have several normals, which the worker's mesh may number in another order
    if (handles.sharp.includes(1)) {
      const kinds = [false, true].filter((isLinear) => hasTwoSurfaces(settings.layout) || (settings.layout === "linear") === isLinear);
      const { scheme, rounds } = settings;
      this.remote.make({ state: this.mesh.state(), scheme, rounds, kinds, origin: this.origin }, this.shown(isLast));
    } else
      this.remote.edit(
        Array.from(points, (v) => [v, ...at(handles.points, v)]),
        Array.from(wedges, (w) => [handles.vertices[w], ...at(handles.normals, w)]),
        this.shown(isLast),
      );
    this.onChange?.(false);
  }

  private shown(isLast: boolean): Shown {
    return {
      limit: this.showsLimit,
      shading: this.settings.shading,
      size: this.size,
      isLast,
      deviations: isLast && roundShapeThrough(this.handles.points, 3) !== undefined,
    };
  }

  private show(isLast: boolean, milliseconds?: number): void {
    this.showOverlays();
    if (this.isRemote) this.remote.show(this.shown(isLast));
    else this.draw(this.surfaces.draw(this.mesh, this.shown(isLast)), isLast, milliseconds);
  }

  private draw({ drawings, colorEnd }: Drawings, isLast: boolean, milliseconds?: number): void {
    const { shading, flat, layout, split } = this.settings;
    for (const { isLinear, positions, normals, triangles, values } of drawings) {
      const pane = this.viewer.pane(isLinear);
      if (triangles) pane.setTriangles(triangles);
      pane.setVertices(positions, normals);
      if (values) pane.setValues(values);
      if (isLinear === (layout === "linear")) this.positions = positions.slice();
    }
    if (colorEnd !== undefined) this.colorEnd = colorEnd;
    this.viewer.setLayout(layout, split);
    this.viewer.setShading(shading, flat, this.colorEnd);
    const time = milliseconds === undefined ? "" : ` · ${milliseconds.toFixed(1)} ms`;
    this.status = `${format(this.positions.length / 3)} vertices${time}${isLast ? deviations(drawings) : ""}`;
    this.onChange?.(false);
  }

  private showOverlays(): void {
    this.viewer.setVisible(this.settings.showControl, this.settings.showNormals);
    this.viewer.setSize(this.size / 2);
    this.viewer.showControlMesh(this.shownHandles, this.normalLength, this.selection);
  }

  get showsLimit(): boolean {
    return this.settings.limit && this.canShowLimit;
  }
  get canShowLimit(): boolean {
    return this.scheme.hasLimitPoints && this.mesh.numberOfSharpEdges() === 0;
  }
}

/** How much the radii of each surface differ, about the sphere that fits it best, if the control points are on one. */
function deviations(drawings: Drawings["drawings"]): string {
  const parts = [...drawings].reverse().filter(({ deviation }) => deviation !== undefined).map(({ isLinear, deviation }) =>
    `${isLinear ? "linear" : "point-normal"} ±${share(deviation!)}`);
  return parts.length === 0 ? "" : ` · radii about the best sphere: ${parts.join(", ")}`;
}

function firstRounds(mesh: ControlMesh): number {
  if (mesh instanceof FrozenMesh) return 0;
  const areTriangles = mesh.hasOnlyTriangles();
  const { points, degrees, corners } = mesh.state();
  let [v, e, f, c] = [points.length / 3, mesh.handles().sharp.length, degrees.length, corners.length];
  for (let rounds = 0; rounds < 3; ++rounds) {
    [v, e, f, c] = areTriangles ? [v + e, 2 * e + c, 4 * f, 4 * c] : [v + e + f, 2 * e + c, c, 4 * c];
    if (v > mostVerticesAtFirst) return rounds;
  }
  return 3;
}

function isSameMesh(a: Faces, b: Faces | undefined): boolean {
  const same = (x: Uint32Array, y: Uint32Array): boolean => x.length === y.length && x.every((v, i) => v === y[i]);
  return b !== undefined && same(a.degrees, b.degrees) && same(a.corners, b.corners);
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

/** Some of many points, relative to the origin: to look at all of them. */
function thinnedOut(points: Float64Array, origin: Triple): Float32Array {
  const step = Math.ceil(points.length / 3 / 20_000);
  const n = Math.floor(points.length / 3 / step);
  return Float32Array.from({ length: 3 * n }, (_, i) => points[3 * step * Math.floor(i / 3) + (i % 3)] - origin[i % 3]);
}

function isTriple(values: Float64Array, i: number, triple: number[]): boolean {
  return triple.every((x, k) => values[3 * i + k] === x);
}

function hasTwoSurfaces(layout: Layout): boolean {
  return layout === "both" || layout === "split";
}
/** A small number in hundredths, one that is rounding with its power of ten. */
function share(x: number): string {
  return x < 1e-6 ? x.toExponential(0) : `${(100 * x).toPrecision(2)} %`;
}

export function format(n: number): string {
  return n.toString().replace(/\B(?=(\d{3})+$)/g, "\u202f");
}
