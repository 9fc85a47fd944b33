// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The panel beside the curve.

import type { CurveEditor } from "./curves";
import { button, element, fill, input, select, silence } from "./elements";
import { curveExamples } from "./examples";
import { save } from "./files";

const masks: [string, string][] = [
  ["bspline:2", "Chaikin (quadratic B-spline)"],
  ["bspline:3", "Cubic B-spline"],
  ...[4, 5, 6, 7, 8, 9].map((d): [string, string] => [`bspline:${d}`, `B-spline of degree ${d}`]),
  ...[4, 6, 8, 10].map((n): [string, string] => [`${n}-point`, `${n} points, interpolating`]),
];

export class CurvePanel {
  constructor(
    private readonly editor: CurveEditor,
    onLink: () => void,
  ) {
    fill(select("curve-example"), Object.entries(curveExamples).map(([name, e]) => [name, e.title]));
    fill(select("mask"), masks);
    const onClick = (id: string, act: () => void): void => button(id).addEventListener("click", act);
    select("curve-example").addEventListener("change", () => {
      const name = select("curve-example").value;
      silence();
      this.stopDrawing();
      if (curveExamples[name]) editor.show(curveExamples[name], name);
    });
    onClick("draw", () => {
      if (editor.isDrawing) this.stopDrawing();
      else editor.startDrawing();
    });
    select("mask").addEventListener("change", () => editor.set({ mask: select("mask").value }));
    input("closed").addEventListener("change", () => editor.set({ closed: input("closed").checked }));
    input("curve-rounds").addEventListener("input", () => editor.set({ rounds: Number(input("curve-rounds").value) }));
    input("curve-roundness").addEventListener("input", () => editor.set({ roundness: Number(input("curve-roundness").value) }));
    input("show-linear").addEventListener("change", () => editor.set({ showLinear: input("show-linear").checked }));
    input("show-comb").addEventListener("change", () => editor.set({ showComb: input("show-comb").checked }));
    input("comb-scale").addEventListener("input", () => editor.set({ combScale: Number(input("comb-scale").value) }));
    onClick("curve-zero", () => editor.zeroNormals());
    onClick("curve-estimate", () => editor.estimateNormals());
    onClick("curve-left", () => editor.turnNormals(5));
    onClick("curve-right", () => editor.turnNormals(-5));
    onClick("save-svg", () => save(editor.svgFile(), "image/svg+xml", "curve.svg"));
    onClick("save-text", () => save(editor.textFile(), "text/plain", "polygon.txt"));
    onClick("curve-link", onLink);
  }

  private stopDrawing(): void {
    this.editor.isDrawing = false;
    this.editor.requestDraw();
    this.refresh();
  }

  refresh(): void {
    const { state, isDrawing } = this.editor;
    const list = select("curve-example");
    list.querySelector("option[data-own]")?.remove();
    if (!curveExamples[state.example]) {
      const own = new Option("Own drawing", state.example);
      own.dataset.own = "";
      list.prepend(own);
    }
    list.value = state.example;
    button("draw").setAttribute("aria-pressed", String(isDrawing));
    button("draw").textContent = isDrawing ? "Done" : "Draw anew";
    select("mask").value = state.mask;
    input("closed").checked = state.closed;
    input("curve-rounds").value = String(state.rounds);
    element("curve-rounds-value").textContent = String(state.rounds);
    input("curve-roundness").value = String(state.roundness);
    element("curve-roundness-value").textContent = state.roundness.toFixed(2);
    input("show-linear").checked = state.showLinear;
    input("show-comb").checked = state.showComb;
    input("comb-scale").value = String(state.combScale);
    input("comb-scale").disabled = !state.showComb;
  }
}
