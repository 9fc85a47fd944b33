// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A tour of five steps: each is a picture or a tab, and a few sentences.

import type { Settings } from "./editor";
import { announce, button, element } from "./elements";

interface Step {
  title: string;
  text: string;
  /** A picture's name, or a tab. */
  shows: string;
  /** Other than those of the picture. */
  settings?: Partial<Settings>;
}

const steps: Step[] = [
  { title: "Points are not all", shows: "cube",
    text: "Subdivision makes smooth surfaces of coarse meshes. If vertices have normals, too, eight of them make a sphere, not a rounded box." },
  { title: "Normals are handles", shows: "ring", settings: { showNormals: true },
    text: "These are the control normals. Turn one by its tip: the surface follows, while all points stay where they are." },
  { title: "Round stays round", shows: "bolt",
    text: "Move the slider over the bolt: with normals, circles and cylinders are circles and cylinders, up to sharp edges." },
  { title: "Any mesh", shows: "head",
    text: "Without normals they are estimated, and how round each vertex is. Drop a file of your own onto the page." },
  { title: "How it is done", shows: "formula",
    text: "Two arcs, one from each point, meet a line; the new point is at the mean of their heights. Drag the points and normals." },
];

export class Tour {
  private step = -1;

  constructor(private readonly show: (name: string, settings?: Partial<Settings>) => void) {
    button("tour").addEventListener("click", () => this.go(0));
    button("tour-next").addEventListener("click", () => this.go(this.step + 1));
    button("tour-end").addEventListener("click", () => this.go(-1));
    element("tour-box").addEventListener("keydown", (event) => event.key === "Escape" && this.go(-1));
  }

  private go(step: number): void {
    const now = steps[step] as Step | undefined;
    this.step = now ? step : -1;
    element("tour-box").hidden = !now;
    if (!now) return button("tour").focus();
    const { title, text, shows, settings } = now;
    this.show(shows, settings);
    element("tour-title").textContent = `${step + 1} of ${steps.length}: ${title}`;
    element("tour-text").textContent = text;
    button("tour-next").hidden = step + 1 === steps.length;
    button(step + 1 === steps.length ? "tour-end" : "tour-next").focus();
    announce(`${title}. ${text}`);
  }
}
