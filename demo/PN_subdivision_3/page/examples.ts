// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes that are one click away. Those of files are the project's, see data/README.md.

import bearingHousing from "../../../data/meshes/parts/bearing_housing.obj";
import bearingHousingSelection from "../../../data/meshes/parts/bearing_housing.selection.txt";
import bolt from "../../../data/meshes/parts/bolt.obj";
import boltSelection from "../../../data/meshes/parts/bolt.selection.txt";
import bracket from "../../../data/meshes/parts/bracket.obj";
import bracketSelection from "../../../data/meshes/parts/bracket.selection.txt";
import creature from "../../../data/meshes/creature.obj";
import cube from "../../../data/meshes/cube.off";
import head from "../../../data/meshes/head.obj";
import spoon from "../../../data/meshes/spoon.obj";
import bell from "../../../data/meshes/paper/bell.ply";
import bumps from "../../../data/meshes/paper/bumps.ply";
import cuboidWithHole from "../../../data/meshes/paper/cuboid_with_hole.ply";
import ring from "../../../data/meshes/paper/ring.ply";
import ringEdited from "../../../data/meshes/paper/ring_edited.ply";
import tetrahedron from "../../../data/meshes/paper/tetrahedron.ply";
import torus4 from "../../../data/meshes/paper/torus_4.ply";
import torus8 from "../../../data/meshes/paper/torus_8.ply";
import waves from "../../../data/meshes/paper/waves.ply";
import wheel from "../../../data/meshes/paper/wheel.ply";
import wheelTori from "../../../data/meshes/paper/wheel_tori.ply";

export interface Example {
  title: string;
  about: string;
  text: string;
  format: string;
  scheme: string;
  rounds: number;
  /** Instead of the normals of the file. */
  normals?: "sphere";
  /** The creases, in CGAL's format: also those where surfaces are tangent, which normals do not tell of. */
  selection?: string;
  /** Where normals would hide the surface. */
  hidesNormals?: boolean;
}

const quads = { scheme: "catmull-clark", rounds: 4 };

export const examples: Record<string, Example> = {
  cube: {
    title: "Cube to sphere",
    about: "With normals that point away from the center, the eight corners of a cube make a sphere. Turn one.",
    text: cube,
    format: "off",
    scheme: "catmull-clark",
    rounds: 5,
    normals: "sphere",
  },
  tetrahedron: {
    title: "Tetrahedron to sphere",
    about: "The same from four points and the normals of a sphere, by Loop subdivision.",
    text: tetrahedron,
    format: "ply",
    scheme: "loop",
    rounds: 6,
  },
  ring: { title: "Ring", about: "All normals are horizontal.", text: ring, format: "ply", ...quads },
  ring_edited: {
    title: "Ring, edited",
    about: "The same points: only normals were turned.",
    text: ringEdited,
    format: "ply",
    ...quads,
  },
  wheel: { title: "Wheel", about: "All normals are horizontal.", text: wheel, format: "ply", ...quads },
  wheel_tori: {
    title: "Wheel of tori",
    about: "The same points with the normals of tori.",
    text: wheelTori,
    format: "ply",
    ...quads,
  },
  waves: {
    title: "Grid with waves",
    about: "All points are in a plane. The normals make the waves.",
    text: waves,
    format: "ply",
    ...quads,
  },
  bumps: {
    title: "Grid with bumps",
    about: "All points are in a plane. The normals make the bumps.",
    text: bumps,
    format: "ply",
    ...quads,
  },
  torus: {
    title: "Torus, 4 by 4",
    about: "Sixteen points and normals of a torus.",
    text: torus4,
    format: "ply",
    scheme: "catmull-clark",
    rounds: 5,
  },
  torus_8: { title: "Torus, 8 by 8", about: "Points and normals of a torus.", text: torus8, format: "ply", ...quads },
  bell: { title: "Bell", about: "The vertex on top has no normal.", text: bell, format: "ply", ...quads },
  cuboid: {
    title: "Cuboid with a hole",
    about: "The corners have no normals.",
    text: cuboidWithHole,
    format: "ply",
    ...quads,
  },
  housing: {
    title: "Part: bearing housing",
    about: "Planes, cylinders and a spherical seat, which stay what they are up to their sharp edges.",
    text: bearingHousing,
    selection: bearingHousingSelection,
    format: "obj",
    hidesNormals: true,
    scheme: "catmull-clark",
    rounds: 3,
  },
  bolt: {
    title: "Part: bolt",
    about: "Rims stay circles, the shank a cylinder, its end a piece of a sphere.",
    text: bolt,
    selection: boltSelection,
    format: "obj",
    hidesNormals: true,
    ...quads,
  },
  bracket: {
    title: "Part: bracket",
    about: "The fillet is a cylinder, tangent to floor and wall.",
    text: bracket,
    selection: bracketSelection,
    format: "obj",
    hidesNormals: true,
    ...quads,
  },
  head: { title: "Head", about: "The normals are estimated.", text: head, format: "obj", ...quads },
  creature: { title: "Creature", about: "The normals are estimated.", text: creature, format: "obj", ...quads },
  spoon: { title: "Spoon", about: "The normals are estimated.", text: spoon, format: "obj", ...quads },
};

Object.setPrototypeOf(examples, null); // names come from addresses

const degrees = Math.PI / 180;

export interface CurveExample {
  title: string;
  closed: boolean;
  mask: string;
  points: number[];
  /** Estimated where there are none. */
  normals?: number[];
}

const unevenAngles = [0, 25, 70, 95, 150, 205, 240, 310].map((a) => a * degrees);

export const curveExamples: Record<string, CurveExample> = {
  bottle: {
    title: "Bottle",
    closed: true,
    mask: "bspline:3",
    points: [1, 0, 2.5, 1, 2.5, 5, 1, 8, 1, 12, -1, 12, -1, 8, -2.5, 5, -2.5, 1, -1, 0],
  },
  circle: {
    title: "Uneven points of a circle",
    closed: true,
    mask: "bspline:3",
    points: unevenAngles.flatMap((a) => [3 * Math.cos(a), 3 * Math.sin(a)]),
    normals: unevenAngles.flatMap((a) => [Math.cos(a), Math.sin(a)]),
  },
  square: {
    title: "Square",
    closed: true,
    mask: "bspline:3",
    points: [1, -1, 1, 1, -1, 1, -1, -1],
    normals: [1, -1, 1, 1, -1, 1, -1, -1].map((x) => x * Math.SQRT1_2),
  },
  spiral: {
    title: "Spiral, open",
    closed: false,
    mask: "4-point",
    points: Array.from({ length: 14 }, (_, i) => (60 * i * degrees) as number).flatMap((a, i) => [
      (1 + 0.35 * i) * Math.cos(a),
      (1 + 0.35 * i) * Math.sin(a),
    ]),
  },
  letter: {
    title: "Letter S, open",
    closed: false,
    mask: "bspline:5",
    points: [3, 4, 0, 6, -3, 4, -2, 1, 2, -1, 3, -4, 0, -6, -3, -4],
  },
};
