// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Pictures to choose from: each is an example with its camera, shading and overlays. The small ones are made by
// test/draw_gallery.mjs.

import bolt from "./pictures/bolt.webp";
import bottle from "./pictures/bottle.webp";
import cube from "./pictures/cube.webp";
import head from "./pictures/head.webp";
import ring from "./pictures/ring.webp";
import waves from "./pictures/waves.webp";
import type { Settings, Triple } from "./editor";
import { element } from "./elements";

export interface Picture {
  title: string;
  sentence: string;
  /** Of the picture in the panel, as an address. */
  image: string;
  /** Of surfaces; without it the picture is a curve. */
  settings?: Partial<Settings>;
  /** Where the eye is. */
  direction?: Triple;
  /** Whether the normal that is nearest to the eye asks to be turned. */
  asksToTurn?: boolean;
}

const plain: Partial<Settings> = { flat: false, limit: false, showControl: false, showNormals: false };

/** By the names of their examples. */
export const pictures: Record<string, Picture> = {
  cube: {
    title: "Cube",
    sentence: "Eight points, twice. On the right their normals count, too, and make a sphere: its curvature is even.",
    image: cube,
    settings: { ...plain, layout: "both", shading: "relative", rounds: 5, showControl: true, showNormals: true },
    direction: [0.62, -1, 0.5],
    asksToTurn: true,
  },
  bolt: {
    title: "Bolt",
    sentence: "Move the slider: rims are circles and the shank is a cylinder where normals count.",
    image: bolt,
    settings: { ...plain, layout: "split", split: 0.5, shading: "zebra", rounds: 4 },
    direction: [0.7, -1, 0.55],
  },
  waves: {
    title: "Waves",
    sentence: "All points are in one plane. The normals alone make the waves.",
    image: waves,
    settings: { ...plain, layout: "pn", shading: "smooth", rounds: 4, showControl: true, showNormals: true },
    direction: [0.5, -1, 0.55],
  },
  ring: {
    title: "Ring",
    sentence: "The same points in both views: only normals were turned.",
    image: ring,
    settings: { ...plain, layout: "both", shading: "smooth", rounds: 4, showControl: true },
    direction: [0.4, -1, 0.75],
  },
  head: {
    title: "Head",
    sentence: "Normals and roundness are estimated from the points. Move the slider: the stripes run on smoothly.",
    image: head,
    settings: { ...plain, layout: "split", split: 0.5, shading: "zebra", rounds: 3 },
    direction: [0.45, -1, 0.12],
  },
  bottle: {
    title: "Bottle",
    sentence: "A curve with its curvature comb.",
    image: bottle,
  },
};

/** The examples that the pictures are of, where these are others. */
export const exampleOf = (name: string): string => (name === "ring" ? "ring_edited" : name);

/** The picture on the screen is marked, and its sentence is over it. */
export function markPicture(shown: string | undefined): void {
  for (const name of Object.keys(pictures)) element(`picture-${name}`).setAttribute("aria-pressed", String(name === shown));
  element("caption").hidden = shown === undefined;
  element("caption").textContent = shown === undefined ? "" : pictures[shown].sentence;
}

export function fillGallery(show: (name: string) => void): void {
  element("gallery").replaceChildren(
    ...Object.entries(pictures).map(([name, { title, image }]) => {
      const button = document.createElement("button");
      button.type = "button";
      button.id = `picture-${name}`;
      const small = document.createElement("img");
      small.src = image;
      small.alt = "";
      const text = document.createElement("span");
      text.textContent = title;
      button.append(small, text);
      button.addEventListener("click", () => show(name));
      return button;
    }),
  );
}
