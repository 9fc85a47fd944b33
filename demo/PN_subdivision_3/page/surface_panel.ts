// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The panel beside the surface.

import { button, buttonOf, choose, element, fill, input, onChoice, say, select, silence, wordOf } from "./elements";
import { format, large, messageOf, type Editor, type Settings, type Triple } from "./editor";
import { examples } from "./examples";
import { glbFile, objFile, plyFile, save, stlFile, valuesOfVertices, type MeshOfFile } from "./files";
import type { Handles } from "./handles";
import type { Modeler } from "./modeler";
import { commandFor, controlFile, programFor, surfaceFile } from "./recipe";
import { withCreases } from "./selection";
import type { Shading } from "./shading";
import type { Content } from "./surfaces";
import type { Layout, Viewer } from "./viewer";

const titles: Record<string, string> = {
  "catmull-clark": "Catmull-Clark",
  kobbelt: "Kobbelt (quads)",
  loop: "Loop (triangles)",
  butterfly: "Butterfly (triangles)",
  "doo-sabin": "Doo-Sabin",
  sqrt3: "√3 (triangles)",
  "modified-catmull-clark": "Modified Catmull-Clark",
  "modified-loop": "Modified Loop (triangles)",
  "ct-catmull-clark": "Catmull-Clark, curvature transfer",
  "ct-loop": "Loop, curvature transfer",
  midpoint: "Midpoints (triangles)",
  bilinear: "Bilinear",
};

export class SurfacePanel {
  constructor(
    private readonly editor: Editor,
    private readonly viewer: Viewer,
    private readonly handles: Handles,
    private readonly modeler: Modeler,
    private readonly onLink: () => void,
  ) {
    fill(select("example"), Object.entries(examples).map(([name, e]) => [name, e.title]));
    fill(select("scheme"), [...editor.schemes.keys()].map((name) => [name, titles[name] ?? name]));
    select("example").addEventListener("change", () => {
      silence();
      this.showExample(select("example").value);
    });
    this.wireFiles();
    this.wireSettings();
    this.wireMesh();
    this.wireSelection();
    this.wireExport();
  }

  /** Returns whether it worked. */
  showExample(name: string, settings: Partial<Settings> = {}, isFirst = false): boolean {
    const example = examples[name];
    if (!example) return false;
    return this.editor.load(
      () => this.exampleMesh(name),
      name,
      { scheme: example.scheme, rounds: example.rounds, showNormals: !example.hidesNormals, ...settings },
      isFirst,
    );
  }

  exampleMesh(name: string): ReturnType<Modeler["readMesh"]> {
    const example = examples[name];
    const mesh = this.modeler.readMesh(new TextEncoder().encode(example.text), example.format, false);
    if (example.normals === "sphere") mesh.takeNormalsOfSphere();
    if (example.selection === undefined) return mesh;
    return withCreases(this.modeler, mesh, example.selection);
  }

  /** A mesh, a selection file with its creases beside it, or such a file for the mesh that is shown. */
  async open(files: Iterable<File>, repairs = false): Promise<void> {
    silence();
    const isSelection = (file: File): boolean => file.name.toLowerCase().endsWith(".txt");
    const all = [...files];
    const mesh = all.find(({ name }) => /\.(ply|off|obj|stl|glb)$/i.test(name)) ?? all.find((file) => !isSelection(file));
    const creases = all.find(isSelection);
    const file = mesh ?? creases;
    if (!file) return;
    const isLast = this.editor.choose();
    const reading = `Reading ${file.name} …`;
    try {
      if (file.size > large) say(reading, "note");
      const selection = await creases?.text();
      const content = new Uint8Array((await mesh?.arrayBuffer()) ?? []);
      if (!isLast()) return;
      if (mesh) await this.editor.open({ content, fileName: mesh.name, selection, repairs }, isLast);
      else this.editor.openSelection(selection!, file.name);
      sayLeftOut(all.filter((other) => other !== mesh && other !== creases));
    } catch (error) {
      if (!isLast()) return;
      const text = `${file.name}: ${error instanceof DOMException ? "the file cannot be read" : messageOf(error)}`;
      const canRepair = !repairs && text.includes("no oriented manifold");
      say(text, "error", canRepair ? { title: "Repair", act: () => void this.open(all, true) } : undefined);
    } finally {
      silence(reading);
    }
  }

  private wireFiles(): void {
    button("open").addEventListener("click", () => input("file").click());
    input("file").addEventListener("change", () => {
      void this.open(input("file").files ?? []);
      input("file").value = "";
    });
    const drop = element("drop");
    let depth = 0; // of elements that the mouse is over
    const show = (change: number): void => {
      depth = Math.max(0, depth + change);
      drop.hidden = depth === 0;
    };
    const hasFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
    window.addEventListener("dragenter", (e) => hasFile(e) && show(1));
    window.addEventListener("dragleave", (e) => hasFile(e) && show(-1));
    window.addEventListener("dragover", (e) => e.preventDefault());
    window.addEventListener("drop", (event) => {
      event.preventDefault();
      show(-depth);
      void this.open(event.dataTransfer?.files ?? []);
    });
  }

  private wireSettings(): void {
    const { editor } = this;
    select("scheme").addEventListener("change", () => editor.set({ scheme: select("scheme").value }));
    input("rounds").addEventListener("input", () => editor.set({ rounds: Number(input("rounds").value) }));
    onChoice("layout", (value) => editor.set({ layout: value as Layout }));
    onChoice("shading", (value) => editor.set({ shading: value as Shading }));
    input("flat").addEventListener("change", () => editor.set({ flat: input("flat").checked }));
    input("limit").addEventListener("change", () => editor.set({ limit: input("limit").checked }));
    for (const event of ["input", "change"] as const)
      input("split").addEventListener(event, () => editor.setSplit(Number(input("split").value), event === "change"));
    input("show-control").addEventListener("change", () => editor.set({ showControl: input("show-control").checked }));
    input("show-normals").addEventListener("change", () => editor.set({ showNormals: input("show-normals").checked }));
  }

  private wireMesh(): void {
    const { editor } = this;
    const onClick = (id: string, act: () => void): void => button(id).addEventListener("click", act);
    onClick("normals-zero", () => editor.change((mesh) => mesh.dropNormals()));
    onClick("normals-estimate", () => editor.change((mesh) => mesh.estimateNormals()));
    onClick("normals-sphere", () => editor.change((mesh) => mesh.takeNormalsOfSphere()));
    for (const event of ["input", "change"] as const)
      input("roundness").addEventListener(event, () => editor.slideRoundness(Number(input("roundness").value), event === "change"));
    onClick("roundness-estimate", () => editor.change((mesh) => mesh.estimateRoundness()));
    onClick("roundness-one", () => editor.change((mesh) => mesh.setRoundness(1)));
    onClick("mark", () => this.markEdges(!this.handles.marksEdges));
    onClick("creases-clear", () => editor.change((mesh) => void mesh.detectCreases(180)));
    onClick("detect", () => {
      const angle = Number(input("angle").value);
      editor.change((mesh) => {
        const n = mesh.detectCreases(angle);
        say(`${n} ${n === 1 ? "edge is" : "edges are"} sharp.`, "note");
      });
    });
  }

  private markEdges(marks: boolean): void {
    this.handles.marksEdges = marks;
    button("mark").setAttribute("aria-pressed", String(marks));
  }

  private wireSelection(): void {
    const { editor } = this;
    // the fields show fewer digits than the numbers have: only what is entered is taken
    const onNumber = (name: string, k: number, act: (change: (values: Float64Array, i: number) => Triple) => void): void => {
      const field = input(name);
      field.addEventListener("change", () => {
        const text = field.value.trim().replace(",", ".");
        const x = Number(text);
        if (text !== "" && Number.isFinite(x))
          act((values, i) => {
            const triple: Triple = [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
            triple[k] = x;
            return triple;
          });
        this.refresh();
        this.showSelected(true);
      });
    };
    ["px", "py", "pz"].forEach((name, k) => onNumber(name, k, (change) => {
      const { vertex } = editor.selection;
      if (vertex !== undefined) editor.setPoint(vertex, ...change(editor.handles.points, vertex));
    }));
    ["nx", "ny", "nz"].forEach((name, k) => onNumber(name, k, (change) => {
      const { wedge } = editor.selection;
      if (wedge !== undefined) editor.setNormal(wedge, ...change(editor.handles.normals, wedge));
    }));
    button("normal-zero").addEventListener("click", () => {
      const { wedge } = editor.selection;
      if (wedge !== undefined) editor.setNormal(wedge, 0, 0, 0);
    });
    button("deselect").addEventListener("click", () => editor.select({}));
  }

  private wireExport(): void {
    button("save-surface").addEventListener("click", () => void this.saveSurface(select("surface-format").value));
    button("save-control").addEventListener("click", () => this.saveControlMesh());
    button("save-png").addEventListener("click", () => void this.savePicture(surfaceFile(this.editor, "png")));
    button("copy-link").addEventListener("click", this.onLink);
    button("recipe").addEventListener("click", () => this.showRecipe());
  }

  private async savePicture(fileName: string): Promise<void> {
    try {
      save(await this.viewer.png(), "image/png", fileName);
    } catch (error) {
      say(`There is no picture: ${messageOf(error)}.`, "error");
    }
  }

  private async saveSurface(format: string): Promise<void> {
    const { editor } = this;
    const name = surfaceFile(editor, format);
    const content = await editor.content();
    const { points, faces } = content;
    if (format === "stl") return save(stlFile(points, this.modeler.splitFaces(points, faces)) as BlobPart, "model/stl", name);
    if (format === "obj") return save(objFile(meshOf(content, editor.showsLimit)), "model/obj", name);
    if (format === "ply") {
      // which has no place for several normals of a vertex beside the others
      const mesh = { ...meshOf(content, editor.showsLimit), corners: undefined };
      return save(plyFile(mesh, editor.showsLimit ? "normals of the surface" : "control normals") as BlobPart, "model/ply", name);
    }
    const { origin } = editor;
    const positions = content.positions.map((x, i) => x + origin[i % 3]);
    save(glbFile({ positions, normals: content.drawnNormals, triangles: content.triangles }) as BlobPart, "model/gltf-binary", name);
  }

  private showRecipe(): void {
    element("recipe-command").replaceChildren(...commandFor(this.editor, select("surface-format").value).flatMap((word) => [wordOf(word), " "]).slice(0, -1));
    element("recipe-program").textContent = programFor(this.editor);
    element<HTMLDialogElement>("recipe-dialog").showModal();
  }

  /** With the creases, and all that the command needs of them. */
  private saveControlMesh(): void {
    const state = this.editor.mesh.state();
    const { points, corners, cornerNormals, sharpEdges, roundness } = state;
    this.editor.takeAsSaved(state);
    const ofCorners = { normals: cornerNormals!,
      roundness: roundness && (roundness.length === corners.length ? roundness : Float64Array.from(corners, (v) => roundness[v])) };
    const { differ, ...ofVertices } = valuesOfVertices(points.length / 3, ofCorners, state);
    const content = plyFile({ points, ...ofVertices, faces: state, corners: differ ? ofCorners : undefined,
      sharpEdges: sharpEdges.length > 0 ? sharpEdges : undefined }, "control normals");
    save(content as BlobPart, "model/ply", controlFile(this.editor));
  }

  /** Shows what holds now. */
  refresh(): void {
    const { editor } = this;
    const { settings } = editor;
    const example = examples[editor.name];
    this.showName();
    if (example) element("about").textContent = example.about;
    else this.showAboutFile();
    select("scheme").value = settings.scheme;
    input("rounds").max = String(editor.greatestRounds);
    input("rounds").value = String(settings.rounds);
    element("rounds-value").textContent = String(settings.rounds);
    choose("layout", settings.layout);
    choose("shading", settings.shading);
    input("flat").checked = settings.flat;
    input("limit").checked = settings.limit && editor.canShowLimit;
    input("limit").disabled = !editor.canShowLimit;
    input("show-control").checked = settings.showControl;
    input("show-normals").checked = settings.showNormals;
    for (const id of ["mark", "detect", "creases-clear"]) button(id).disabled = !editor.scheme.hasCreaseRules;
    if (!editor.scheme.hasCreaseRules) this.markEdges(false);
    element("status").textContent = editor.status;
    this.showScale();
    this.showRoundness();
    this.showSelected(false);
    this.showLayout();
  }

  /** What the user's file is, and what the page has made of it. */
  private showAboutFile(): void {
    const { editor } = this;
    const { about } = editor;
    const faces = editor.mesh.numberOfFaces();
    const parts = [`${format(faces)} ${faces === 1 ? "face" : "faces"}.`];
    if (about?.normals) parts.push(`Normals ${about.normals}.`);
    if (about && about.lost.length > 0) parts.push(`Not kept: ${about.lost.join(", ")}.`);
    if (about?.repair) parts.push(`${about.repair[0].toUpperCase()}${about.repair.slice(1)}.`);
    const n = editor.verticesBelowRoundness1;
    if (n > 0) parts.push(`Roundness below 1 at ${format(n)} of ${format(editor.handles.points.length / 3)} vertices:`);
    const text = parts.join(" ");
    if (element("about").firstChild?.textContent === text) return; // the button keeps the focus
    element("about").textContent = text;
    if (n > 0) element("about").append(" ", buttonOf("Make it 1", () => editor.change((mesh) => mesh.setRoundness(1))));
  }

  private showRoundness(): void {
    const { roundness, meanRoundness } = this.editor;
    input("roundness").value = String(roundness ?? meanRoundness);
    element("roundness-value").textContent = roundness === undefined ? "varies" : roundness.toFixed(2);
  }

  private showLayout(): void {
    const { settings } = this.editor;

    const picture = this.viewer.canvas.parentElement!;
    picture.classList.toggle("both", settings.layout === "both");
    picture.classList.toggle("split", settings.layout === "split");
    picture.style.setProperty("--split", String(settings.split));
    input("split").hidden = settings.layout !== "split";
    input("split").value = String(settings.split);
    picture.classList.toggle("stacked", this.viewer.isStacked());
    element("label-linear").hidden = settings.layout === "pn";
    element("label-pn").hidden = settings.layout === "linear";
  }

  /** A field in which somebody types is left alone, unless its number has just been taken. */
  private showSelected(evenIfTyping: boolean): void {
    const { selection, handles } = this.editor;
    const { vertex, wedge } = selection;
    element("selection-title").textContent = vertex === undefined ? "Vertex" : `Vertex ${vertex}`;
    element("selection-hint").hidden = vertex !== undefined;
    element("selection-values").hidden = vertex === undefined;
    const show = (names: string[], values: Float64Array, i: number): void =>
      names.forEach((name, k) => {
        const field = input(name);
        if (evenIfTyping || document.activeElement !== field)
          field.value = String(Number(values[3 * i + k].toPrecision(6)));
      });
    if (vertex !== undefined) show(["px", "py", "pz"], handles.points, vertex);
    if (wedge !== undefined) show(["nx", "ny", "nz"], handles.normals, wedge);
  }

  private showName(): void {
    const list = select("example");
    list.querySelector("option[data-file]")?.remove();
    if (!examples[this.editor.name]) {
      const own = new Option(this.editor.name, this.editor.name);
      own.dataset.file = "";
      list.prepend(own);
    }
    list.value = this.editor.name;
  }

  private showScale(): void {
    const { settings, colorEnd } = this.editor;
    const isRelative = settings.shading === "relative";
    const title = { gaussian: "Gaussian curvature", mean: "Mean curvature", relative: "Gaussian curvature of each surface" };
    element("scale").hidden = !(settings.shading in title);
    element("scale-name").textContent = title[settings.shading as keyof typeof title] ?? "";
    element("scale-low").textContent = isRelative ? `−${100 * colorEnd} %` : `−${colorEnd.toPrecision(2)}`;
    element("scale-middle").textContent = isRelative ? "average" : "0";
    element("scale-high").textContent = isRelative ? `+${100 * colorEnd} %` : colorEnd.toPrecision(2);
  }
}

/** As the command writes it, whose linear surfaces have neither normals nor creases. */
function meshOf({ points, normals, roundness, sides, faces }: Content, isLimit: boolean): MeshOfFile {
  const isCreased = sides.normals.length > 0;
  const corners = { normals: sides.normals, roundness: sides.roundness.length > 0 ? sides.roundness : undefined };
  const ofVertices = isCreased ? valuesOfVertices(points.length / 3, corners, faces) : { normals, roundness, differ: false };
  const hasRoundness = normals.length > 0 && !isLimit && ofVertices.roundness?.some((w) => w !== 1);
  return {
    points,
    faces,
    normals: ofVertices.normals,
    roundness: hasRoundness ? ofVertices.roundness : undefined,
    corners: ofVertices.differ ? corners : undefined,
    ...(isCreased ? { sharpEdges: sides.sharpEdges, tangents: sides.tangents } : {}),
  };
}

function sayLeftOut(others: File[]): void {
  if (others.length === 0) return;
  const names = others.map(({ name }) => name).join(", ");
  say(`Not opened: ${names}. The page shows one mesh at a time, and one file with its creases.`, "note");
}
