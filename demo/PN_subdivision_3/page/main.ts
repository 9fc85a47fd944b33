// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The page: two tabs, what they share, and the address.

import { applyEdits, editsOf, pack, partsOf, unpack, type Edits } from "./address";
import { CurvePanel } from "./curve_panel";
import { checkedCurve, CurveEditor, type CurveState } from "./curves";
import { checkedSettings, Editor, messageOf, type Settings } from "./editor";
import { announce, button, element, say, showProgress, silence } from "./elements";
import { curveExamples, examples } from "./examples";
import { FrozenMesh } from "./frozen_mesh";
import { FormulaView } from "./formula_view";
import { exampleOf, fillGallery, markPicture, pictures } from "./gallery";
import { Handles } from "./handles";
import { loadModeler, type MeshState, type Modeler } from "./modeler";
import type { Theme } from "./shading";
import { SurfacePanel } from "./surface_panel";
import { Tour } from "./tour";
import { TurnMe } from "./turn_me";
import { forget, isSameMesh, keep, kept, type Unsaved } from "./unsaved";
import { Viewer } from "./viewer";

const tabs = ["surface", "curve", "formula"] as const;
type Tab = (typeof tabs)[number];

/** Of links; what another page cannot read has another number. Links of before had none. */
const linkVersion = 1;
/** Meshes with more numbers are not put into an address. */
const mostNumbers = 60_000;

interface Shared {
  version?: number;
  settings: Settings;
  camera: number[];
  edits?: Edits;
  /** The picture that this is. */
  picture?: string;
}

class Page {
  private tab: Tab = "surface";
  private readonly viewer = new Viewer(element<HTMLCanvasElement>("canvas"));
  readonly editor: Editor;
  readonly curve: CurveEditor;
  private readonly panel: SurfacePanel;
  private readonly curvePanel: CurvePanel;
  readonly formula: FormulaView;
  private readonly turnMe: TurnMe;
  private picture: string | undefined;
  private timer = 0;
  private ownAddress = "";
  private isAddressFull = false;
  private keptName = ""; // of the edits that the browser keeps
  private place = ""; // what is looked at: the browser goes back to the one before
  private edits: { meshNumber: number; value: Edits | undefined } | undefined;
  private readonly exampleStates = new Map<string, MeshState | undefined>();
  private isReady = false; // before, the address is what is to be shown

  constructor(
    readonly modeler: Modeler,
    module: WebAssembly.Module,
  ) {
    this.editor = new Editor(modeler, this.viewer, say, module, showProgress);
    this.curve = new CurveEditor(element<SVGSVGElement>("drawing"), modeler, say, announce);
    const link = (): void => void this.copyLink();
    const handles = new Handles(this.viewer, this.editor, announce);
    this.panel = new SurfacePanel(this.editor, this.viewer, handles, modeler, link);
    this.curvePanel = new CurvePanel(this.curve, link);
    this.formula = new FormulaView(element<SVGSVGElement>("formula-drawing"), announce);
    this.turnMe = new TurnMe(this.viewer, this.editor);
    fillGallery((name) => this.showPicture(name));
    new Tour((name, settings) => this.showStep(name, settings));
    this.editor.onChange = (isFinal) => {
      this.panel.refresh();
      if (isFinal && this.picture && !this.isPicture(this.picture)) this.takePicture(undefined);
      if (isFinal) this.changed();
    };
    this.curve.onChange = () => {
      this.curvePanel.refresh();
      this.changed();
    };
    this.viewer.controls.addEventListener("end", () => this.changed());
    this.editor.history.onChange = this.curve.history.onChange = () => this.showHistory();
    this.wire();
    this.takeTheme();
    document.body.classList.toggle("embedded", new URLSearchParams(location.search).get("embed") === "1");
  }

  async start(): Promise<void> {
    this.curve.show(curveExamples.bottle, "bottle", true);
    if (!(await this.readAddress())) this.showPicture("cube", true);
    this.isReady = true;
    this.place = this.placeOfNow();
    this.changed();
    if (!this.viewer.canDraw) {
      element("no-webgl").hidden = false;
      say(element("no-webgl").textContent!, "error");
      this.show("curve");
    }
    await this.editor.settled();
    element("loading").remove();
    this.viewer.draw();
    this.turnMe.turnOnce();
    const edits = await kept();
    if (edits) this.offer(edits);
    document.documentElement.dataset.ready = String(Math.round(performance.now()));
  }

  // --- the frame of the page ---

  private wire(): void {
    button("undo").addEventListener("click", () => this.undo());
    button("redo").addEventListener("click", () => this.redo());
    button("stop").addEventListener("click", () => this.editor.cancel());
    button("help").addEventListener("click", () => element<HTMLDialogElement>("help-dialog").showModal());
    element("message").querySelector("button")!.addEventListener("click", () => silence());
    for (const tab of tabs)
      button(`tab-${tab}`).addEventListener("click", () => this.show(tab));
    element("tab-surface").parentElement!.addEventListener("keydown", (event) => {
      if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
      const step = event.key === "ArrowRight" ? 1 : tabs.length - 1;
      this.show(tabs[(tabs.indexOf(this.tab) + step) % tabs.length]);
      button(`tab-${this.tab}`).focus();
    });
    window.addEventListener("keydown", (event) => this.key(event));
    for (const form of document.querySelectorAll("form.panel")) form.addEventListener("submit", (event) => event.preventDefault());
    window.addEventListener("hashchange", () => {
      if (location.hash !== this.ownAddress) void this.goTo();
    });
    window.addEventListener("resize", () => this.panel.refresh());
    window.addEventListener("beforeunload", (event) => this.isUnsaved() && event.preventDefault());
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.takeTheme());
  }

  private key(event: KeyboardEvent): void {
    const inText = event.target instanceof HTMLInputElement && !["range", "checkbox", "radio"].includes(event.target.type);
    if ((event.ctrlKey || event.metaKey) && !inText && ["z", "y"].includes(event.key.toLowerCase())) {
      event.preventDefault();
      if (event.key.toLowerCase() === "y" || event.shiftKey) this.redo();
      else this.undo();
    }
    if (event.key === "?" && !inText) element<HTMLDialogElement>("help-dialog").showModal();
  }

  /** What undo and redo are of. */
  private get edited(): Editor | CurveEditor | undefined {
    return { surface: this.editor, curve: this.curve, formula: undefined }[this.tab];
  }

  private undo(): void {
    silence();
    if (this.edited?.history.canUndo) announce("Undone");
    this.edited?.undo();
  }
  private redo(): void {
    silence();
    if (this.edited?.history.canRedo) announce("Redone");
    this.edited?.redo();
  }

  private showHistory(): void {
    button("undo").disabled = !this.edited?.history.canUndo;
    button("redo").disabled = !this.edited?.history.canRedo;
  }

  // --- pictures ---

  private showPicture(name: string, isFirst = false): boolean {
    const picture = pictures[name];
    if (!isFirst) silence();
    if (!picture?.settings) {
      this.curve.show(curveExamples.bottle, "bottle");
      this.show("curve");
      return false;
    }
    if (!this.panel.showExample(exampleOf(name), picture.settings, isFirst)) return false;
    markPicture(name);
    this.editor.frameAll(picture.direction); // in the room that its sentence leaves
    this.takePicture(name);
    return true;
  }

  /** Whether its sentence is true of what is shown. */
  private isPicture(name: string): boolean {
    const { editor } = this;
    const { layout, shading } = pictures[name].settings!;
    const { settings } = editor;
    return editor.name === exampleOf(name) && settings.layout === layout && settings.shading === shading &&
      settings.scheme === examples[editor.name].scheme && this.editsOfNow() === undefined;
  }

  private showStep(name: string, settings?: Partial<Settings>): void {
    if (name === "formula") return this.show("formula");
    if (this.tab !== "surface") this.show("surface");
    this.showPicture(name);
    if (settings) this.editor.set(settings);
  }

  private takePicture(name: string | undefined): void {
    this.picture = name;
    markPicture(name);
    this.turnMe.show(name !== undefined && pictures[name].asksToTurn === true);
  }

  private show(tab: Tab): void {
    this.tab = tab;
    for (const name of tabs) {
      element(name).hidden = name !== tab;
      button(`tab-${name}`).setAttribute("aria-selected", String(name === tab));
      button(`tab-${name}`).tabIndex = name === tab ? 0 : -1;
    }
    this.showHistory();
    if (tab === "surface") this.viewer.requestDraw();
    else if (tab === "curve") this.curve.requestDraw();
    else this.formula.draw();
    this.changed();
  }

  private takeTheme(): void {
    const style = getComputedStyle(document.documentElement);
    const color = (name: string): string => style.getPropertyValue(`--${name}`).trim();
    this.viewer.setTheme({
      background: color("background"),
      surface: color("surface"),
      inside: color("inside"),
      edge: color("edge"),
      crease: color("crease"),
      vertex: color("vertex"),
      normal: color("normal"),
      selection: color("selection"),
    } satisfies Theme);
  }

  // --- the address ---

  private changed(): void {
    if (!this.isReady) return;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.writeAddress(), 400);
  }

  private placeOfNow(): string {
    return this.tab === "surface" ? `surface ${this.editor.name}` : this.tab;
  }

  /** Nothing for a large mesh of the user's, of which no address is made. */
  private async address(): Promise<string | undefined> {
    if (this.tab === "formula") return "#formula";
    if (this.tab === "curve") return `#curve=${await pack({ version: linkVersion, ...this.curve.state })}`;
    const { editor } = this;
    if (!this.fitsInAddress()) return undefined;
    const { origin } = editor;
    const isNear = origin.every((x) => x === 0);
    const inWorld = (p: number[]): number[] => p.map((x, k) => (isNear ? Number(x.toPrecision(6)) : x + origin[k]));
    const shared: Shared = {
      version: linkVersion,
      settings: editor.settings,
      camera: [...inWorld(this.viewer.camera.position.toArray()), ...inWorld(this.viewer.controls.target.toArray())],
    };
    const edits = this.editsOfNow();
    if (edits) shared.edits = edits;
    else if (this.picture) shared.picture = this.picture;
    return `#${encodeURIComponent(editor.name)}=${await pack(shared)}`;
  }

  private fitsInAddress(): boolean {
    const { handles, mesh, name } = this.editor;
    if (mesh instanceof FrozenMesh) return false;
    return examples[name] !== undefined || handles.points.length + 3 * handles.vertices.length + handles.edges.length <= mostNumbers;
  }

  /** Whether the mesh is neither in a file nor in the address. */
  private isUnsaved(): boolean {
    const { mesh, ofFile } = this.editor;
    return this.isReady && (!this.fitsInAddress() || this.isAddressFull) && !isSameMesh(mesh.state(), ofFile);
  }

  /** What was not saved the last time. */
  private offer({ name, mesh, settings }: Unsaved): void {
    const line = element("unsaved");
    line.querySelector("span")!.textContent = `Edits of ${name} were not saved.`;
    line.hidden = false;
    button("unsaved-open").onclick = () => {
      line.hidden = true;
      if (!this.editor.load(() => this.modeler.restoreMesh(mesh), name, checkedSettings(Object(settings)))) return;
      this.editor.ofFile = undefined;
      this.keptName = name;
      this.show("surface");
    };
    button("unsaved-drop").onclick = () => {
      line.hidden = true;
      void forget();
    };
  }

  private editsOfNow(): Edits | undefined {
    const { meshNumber, mesh, name } = this.editor;
    if (this.edits?.meshNumber !== meshNumber)
      this.edits = { meshNumber, value: editsOf(mesh.state(), this.exampleState(name)) };
    return this.edits.value;
  }

  private exampleState(name: string): MeshState | undefined {
    if (!examples[name]) return undefined;
    if (!this.exampleStates.has(name)) {
      const mesh = this.panel.exampleMesh(name);
      this.exampleStates.set(name, mesh.state());
      mesh.delete();
    }
    return this.exampleStates.get(name);
  }

  private async writeAddress(): Promise<void> {
    const address = await this.address();
    const hash = address !== undefined && address.length <= 200_000 ? address : "";
    this.isAddressFull = hash === "";
    const { name, settings, mesh } = this.editor;
    if (this.isUnsaved()) void keep({ name: (this.keptName = name), settings, mesh: mesh.state() });
    else if (this.keptName === name) void forget();
    const place = this.placeOfNow();
    const write = place === this.place ? history.replaceState : history.pushState;
    this.place = place;
    this.ownAddress = hash;
    element<HTMLAnchorElement>("whole").href = location.pathname + hash;
    write.call(history, null, "", hash || location.pathname + location.search);
  }

  /** Back, forward, or an address that was entered. */
  private async goTo(): Promise<void> {
    clearTimeout(this.timer);
    silence();
    await this.readAddress();
    this.place = this.placeOfNow();
    this.ownAddress = location.hash;
  }

  private async copyLink(): Promise<void> {
    const hash = await this.address();
    if (hash === undefined) return say("This mesh is too large for a link: take the control mesh with you instead.", "error");
    const text = location.href.replace(/#.*$/, "") + hash;
    try {
      await navigator.clipboard.writeText(text);
      say(`The link is copied; it has ${text.length} characters.`, "note");
    } catch {
      say("The link cannot be copied; the address of the page is the same.", "error");
    }
  }

  /** Shows what the address says; false if it says nothing, or what cannot be read. */
  private async readAddress(): Promise<boolean> {
    if (location.hash.length < 2) return false;
    const isLast = this.editor.choose();
    try {
      const [name, packed] = partsOf(location.hash);
      if (!packed) return this.showNamed(name);
      const value = await unpack(packed).catch((error) => error as Error);
      if (!isLast()) return true;
      if (value instanceof Error) throw value;
      return this.showUnpacked(name, value);
    } catch (error) {
      say(`The link cannot be read: ${messageOf(error)}.`, "error");
      return false;
    }
  }

  private showNamed(name: string): boolean {
    const isFirst = this.editor.mesh === undefined;
    if (name === "formula") {
      this.show("formula");
      return !isFirst || this.showPicture("cube", true);
    }
    if (name.startsWith("picture-")) return this.showPictureOf(name.slice("picture-".length));
    if (!examples[name]) throw new Error(`there is no example “${name}”`);
    return this.panel.showExample(name, {}, isFirst);
  }

  private showUnpacked(name: string, value: object): boolean {
    requireVersion(value as Shared);
    if (name === "curve") {
      this.curve.restore(checkedCurve(value as Partial<CurveState>, this.curve.state));
      this.show("curve");
      return this.editor.mesh !== undefined || this.panel.showExample("cube", {}, true);
    }
    if (this.tab !== "surface") this.show("surface");
    return this.takeShared(name, value as Shared);
  }

  private showPictureOf(name: string): boolean {
    const isFirst = this.editor.mesh === undefined;
    if (!Object.hasOwn(pictures, name)) throw new Error(`there is no picture “${name}”`);
    if (name !== "bottle") return this.showPicture(name, isFirst);
    if (isFirst) this.showPicture("cube", true);
    this.showPicture(name);
    return true;
  }

  private takeShared(name: string, shared: Shared): boolean {
    const { settings, edits } = shared;
    const make = () =>
      edits ? this.modeler.restoreMesh(applyEdits(edits, this.exampleState(name))) : this.panel.exampleMesh(name);
    if (!this.editor.load(make, name, checkedSettings(settings ?? {}), this.editor.mesh === undefined)) return false;
    if (Array.isArray(shared.camera) && shared.camera.length === 6 && shared.camera.every(Number.isFinite)) {
      const camera = shared.camera.map((x, k) => x - this.editor.origin[k % 3]);
      this.viewer.controls.target.fromArray(camera, 3);
      this.viewer.camera.position.fromArray(camera);
      this.viewer.controls.update();
    }
    const { picture } = shared;
    this.takePicture(picture !== undefined && Object.hasOwn(pictures, picture) && exampleOf(picture) === name ? picture : undefined);
    return true;
  }
}

function requireVersion(shared: Shared): void {
  if ((shared.version ?? 0) > linkVersion) throw new Error("it is of a newer version of this page");
}

// What nobody has caught. Browsers report as errors without one what is none.
const sayFailure = (error: unknown): void => say(`This did not work: ${messageOf(error)}.`, "error");
window.addEventListener("error", ({ error }) => error && sayFailure(error));
window.addEventListener("unhandledrejection", ({ reason }) => sayFailure(reason));

try {
  const { modeler, module } = await loadModeler();
  const page = new Page(modeler, module);
  await page.start();
  Object.assign(window, { page }); // for the tests
} catch (error) {
  element("loading").textContent = `The page cannot be shown: ${messageOf(error)}`;
}
