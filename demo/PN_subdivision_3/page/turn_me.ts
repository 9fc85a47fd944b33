// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The normal that asks to be turned, until something is changed.

import { Vector3 } from "three";
import type { Editor } from "./editor";
import { element } from "./elements";
import { normalTip, type Viewer } from "./viewer";

export class TurnMe {
  private readonly sign = element("turn-me");
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
