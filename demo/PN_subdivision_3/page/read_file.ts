// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A file becomes a control mesh: on the page or, if it is large, in a worker.

import { plyFile } from "./files";
import { triangleMeshOf } from "./glb";
import type { ControlMesh, Modeler } from "./modeler_types";
import { withCreases } from "./selection";

export interface ReadJob {
  content: Uint8Array;
  fileName: string;
  /** A selection file with the creases. */
  selection?: string;
  /** Whether what is no oriented manifold is made one. */
  repairs: boolean;
}

/** What is to be told of a file that has been read. */
export interface AboutFile {
  /** Where they come from. */
  normals: string;
  /** What the file has and the page does not keep. */
  lost: string[];
  /** What was repaired, if anything. */
  repair: string;
}

export function readFile(modeler: Modeler, { content, fileName, selection, repairs }: ReadJob): { mesh: ControlMesh; about: AboutFile } {
  const format = fileName.split(".").pop()!.toLowerCase();
  if (!["ply", "off", "obj", "stl", "glb"].includes(format)) throw new Error("the file name must end in one of .ply .off .obj .stl .glb");
  const lost = lostOf(content, format);
  let mesh: ControlMesh;
  if (format === "glb") {
    const { points, faces } = triangleMeshOf(content);
    mesh = modeler.readMesh(plyFile({ points, normals: new Float64Array(), faces }, "control normals"), "ply", repairs);
  } else mesh = modeler.readMesh(content, format, repairs);
  const about = { normals: mesh.normalsFrom(), lost, repair: mesh.repair() };
  if (selection !== undefined) mesh = withCreases(modeler, mesh, selection);
  return { mesh, about };
}

const signs: Record<string, [sign: RegExp, what: string][]> = {
  obj: [
    [/^[ \t]*usemtl\b/m, "materials"],
    [/^[ \t]*vt\b/m, "texture coordinates"],
    [/^[ \t]*[go][ \t]+\S/m, "groups"],
    [/^[ \t]*v([ \t]+[-+.\deE]+){6}/m, "colors"],
  ],
  ply: [
    [/^property \S+ (red|diffuse_red)\r?$/m, "colors"],
    [/^property (list \S+ )?\S+ (s|u|texture_u|texcoord)\r?$/m, "texture coordinates"],
    [/^element (?!vertex |face |edge )/m, "other elements"],
  ],
  // of a face they are behind its vertices
  off: [[/^(ST)?C|^(ST)?OFF\b[^]*^[ \t]*(3([ \t]+\d+){3}|4([ \t]+\d+){4})[ \t]+[\d.]/m, "colors"], [/^ST/, "texture coordinates"]],
  stl: [[/^[^]{0,70}COLOR=/, "colors"]],
  glb: [
    [/"materials":/, "materials"],
    [/"TEXCOORD_0":/, "texture coordinates"],
    [/"COLOR_0":/, "colors"],
    [/"(skins|animations)":/, "motion"],
  ],
};

/** By the words of text files and of headers. */
function lostOf(content: Uint8Array, format: string): string[] {
  const isAllText = format === "obj" || format === "off";
  const text = new TextDecoder("latin1").decode(isAllText ? content : content.subarray(0, 100_000));
  const end = format === "ply" ? text.indexOf("end_header") : -1;
  const header = end < 0 ? text : text.slice(0, end);
  return (signs[format] ?? []).filter(([sign]) => sign.test(header)).map(([, what]) => what);
}
