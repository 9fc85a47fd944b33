// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is taken away: meshes as PLY, pictures, text.

import type { Faces } from "./modeler";

export interface PlyVertices {
  points: Float64Array;
  /** Left out where there are none. */
  normals: Float64Array;
  /** Left out where it is 1. */
  roundness?: Float64Array;
}

/** A binary PLY file with all digits. The kind of the normals is said as the command says it. */
export function plyFile(of: PlyVertices, faces: Faces, kind: "control normals" | "normals of the surface"): Uint8Array {
  const { points, normals, roundness } = of;
  const vertices = points.length / 3;
  const hasNormals = normals.length === points.length;
  const hasShortFaces = faces.degrees.every((degree) => degree < 256);
  const hasRoundness = hasNormals && roundness?.length === vertices;
  const names = ["x", "y", "z", ...(hasNormals ? ["nx", "ny", "nz"] : []), ...(hasRoundness ? ["roundness"] : [])];
  const header = [
    "ply",
    "format binary_little_endian 1.0",
    ...(hasNormals ? [`comment ${kind}`] : []),
    `element vertex ${vertices}`,
    ...names.map((name) => `property double ${name}`),
    `element face ${faces.degrees.length}`,
    `property list ${hasShortFaces ? "uchar" : "uint"} uint vertex_indices`,
    "end_header\n",
  ].join("\n");
  const head = new TextEncoder().encode(header);
  const sizeOfDegree = hasShortFaces ? 1 : 4;
  const size =
    head.length + vertices * 8 * names.length + faces.degrees.length * sizeOfDegree + 4 * faces.corners.length;
  const bytes = new Uint8Array(size);
  bytes.set(head);
  const view = new DataView(bytes.buffer);
  let at = head.length;
  const put = (x: number): void => {
    view.setFloat64(at, x, true);
    at += 8;
  };
  for (let v = 0; v < vertices; ++v) {
    for (let k = 0; k < 3; ++k) put(points[3 * v + k]);
    if (hasNormals) for (let k = 0; k < 3; ++k) put(normals[3 * v + k]);
    if (hasRoundness) put(roundness[v]);
  }
  let corner = 0;
  for (const degree of faces.degrees) {
    if (hasShortFaces) view.setUint8(at, degree);
    else view.setUint32(at, degree, true);
    at += sizeOfDegree;
    for (let i = 0; i < degree; ++i, at += 4) view.setUint32(at, faces.corners[corner++], true);
  }
  return bytes;
}

/** Normals of corners, so that creases are there again when the file is read. */
export function objFile(points: Float64Array, cornerNormals: Float64Array, faces: Faces): string {
  const lines: string[] = [];
  const addTriples = (word: string, values: Float64Array): void => {
    for (let i = 0; i < values.length; i += 3) lines.push(`${word} ${values[i]} ${values[i + 1]} ${values[i + 2]}`);
  };
  addTriples("v", points);
  addTriples("vn", cornerNormals);
  let corner = 0;
  for (const degree of faces.degrees) {
    const places = Array.from({ length: degree }, () => `${faces.corners[corner] + 1}//${++corner}`);
    lines.push(`f ${places.join(" ")}`);
  }
  return `${lines.join("\n")}\n`;
}

export function save(content: BlobPart, type: string, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
