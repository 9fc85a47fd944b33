// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The normal that asks to be turned, until something is changed. On the first view it turns by itself, once.

import { Vector3 } from "three";
import type { Editor, Triple } from "./editor";
import { element } from "./elements";
import { normalTip, type Viewer } from "./viewer";

/** What may end the turn: whatever is done finds the normal as it was. */
const doings = ["pointerdown", "keydown", "wheel", "click", "input", "change", "drop", "hashchange"] as const;
const milliseconds = 2600;
const farthest = 0.7; // in radians

export class TurnMe {
  private readonly sign = element("turn-me");
  private end: (() => void) | undefined; // of the turn
  private meshNumber = -1; // of the mesh that is as it was
  private wedge: number | undefined;

  constructor(
    private readonly viewer: Viewer,
    private readonly editor: Editor,
  ) {
    viewer.onDraw = () => this.place();
  }

  show(isShown: boolean): void {
    this.meshNumber = isShown ? this.editor.meshNumber : -1;
    this.wedge = isShown ? this.nearest() : undefined;
    this.viewer.requestDraw();
  }

  /** To one side, to the other and back, after a while; nothing has changed then. */
  turnOnce(wait = 1200): void {
    const { editor, wedge, meshNumber } = this;
    if (wedge === undefined || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    const normal = editor.handles.normals.slice(3 * wedge, 3 * wedge + 3);
    const toEye = this.viewer.camera.position.clone().sub(this.viewer.controls.target).normalize();
    let frame = 0;
    const turn = (n: Triple, isLast: boolean): void => {
      if (editor.meshNumber === meshNumber) editor.showTurned(wedge, ...n, isLast);
    };
    const step = (now: number, start: number): void => {
      const share = (now - start) / milliseconds;
      if (share >= 1) return this.end?.();
      const angle = farthest * Math.sin(2 * Math.PI * share) * Math.sin(Math.PI * share);
      turn(new Vector3(...normal).applyAxisAngle(toEye, angle).toArray(), false);
      frame = requestAnimationFrame((time) => step(time, start));
    };
    const timer = setTimeout(() => (frame = requestAnimationFrame((start) => step(start, start))), wait);
    this.end = () => {
      clearTimeout(timer);
      if (frame !== 0) {
        cancelAnimationFrame(frame);
        turn([...normal] as unknown as Triple, true);
      }
      for (const name of doings) window.removeEventListener(name, this.end!, { capture: true });
      this.end = undefined;
    };
    for (const name of doings) window.addEventListener(name, this.end, { capture: true });
  }

  /** Of the normals that look up, the tip nearest to the eye. */
  private nearest(): number | undefined {
    const { shownHandles: handles } = this.editor;
    let [best, least]: [number | undefined, number] = [undefined, Infinity];
    for (let w = 0; w < handles.vertices.length; ++w) {
      const tip = this.tip(w);
      if (!tip || handles.normals[3 * w + 2] < 0) continue;
      const distance = tip.distanceTo(this.viewer.camera.position);
      if (distance < least) [best, least] = [w, distance];
    }
    return best;
  }

  private tip(wedge: number): Vector3 | undefined {
    const tip = normalTip(this.editor.shownHandles, wedge, this.editor.normalLength);
    return tip && new Vector3(...tip);
  }

  private place(): void {
    const isAsIt = this.wedge !== undefined && this.editor.meshNumber === this.meshNumber;
    const tip = isAsIt && this.editor.settings.showNormals && this.editor.settings.layout !== "linear" ? this.tip(this.wedge!) : undefined;
    this.sign.hidden = tip === undefined;
    if (!tip) return;
    const middle = this.viewer.middleOf(false);
    const { x, y } = this.viewer.toPixels(tip);
    this.sign.style.translate = `${middle.x + x}px ${middle.y + y}px`;
  }
}
