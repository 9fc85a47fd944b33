// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How the surface on the screen is made without this page: the command, and C++.

import type { Editor } from "./editor";

const classes: Record<string, string> = {
  "catmull-clark": "CatmullClark_scheme",
  kobbelt: "Kobbelt_scheme",
  loop: "Loop_scheme",
  butterfly: "Butterfly_scheme",
  "doo-sabin": "DooSabin_scheme",
  sqrt3: "Sqrt3_scheme",
  "modified-catmull-clark": "CatmullClark_scheme::Tuned",
  "modified-loop": "Loop_scheme::Tuned",
  "ct-catmull-clark": "CatmullClark_scheme::Transfer",
  "ct-loop": "Loop_scheme::Transfer",
  midpoint: "Midpoint_scheme",
  bilinear: "Bilinear_scheme",
};

/** Without the dashes of options. */
const stemOf = ({ name }: Editor): string => name.replace(/\.[^.]*$/, "").replace(/^-+/, "") || "mesh";

/** The files that "Control mesh" and "Surface" take with you. */
export const controlFile = (editor: Editor): string => `${stemOf(editor)}_control.ply`;
export const surfaceFile = (editor: Editor, format: string): string => `${stemOf(editor)}_${editor.settings.scheme}.${format}`;

const quoted = (word: string): string => (/^[\w./:-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

/** Words that make the file that "Surface" takes with you, to the byte, of the one that "Control mesh" does; GLB is not written there. */
export function commandFor(editor: Editor, format: string): string[] {
  const { settings, roundness } = editor;
  const isLinear = settings.layout === "linear";
  const words = ["pn_subdivide", "surface", controlFile(editor), surfaceFile(editor, format === "glb" ? "ply" : format),
    "--scheme", settings.scheme, "--levels", String(settings.rounds), "--no-mend"];
  if (editor.mesh.numberOfSharpEdges() > 0) words.push("--sharp", "file");
  words.push(...(isLinear ? ["--linear"] : ["--normals", "file"]));
  if (!isLinear && roundness !== 1) words.push("--roundness", "file");
  if (editor.showsLimit) words.push("--limit", "--limit-tolerance", "1e-7", "--output-normals", "surface");
  else if (!isLinear) words.push("--output-normals", format === "stl" ? "none" : "control");
  return words.map(quoted);
}

/** For a mesh with normals, and their roundness where it was estimated, that has been read. */
export function programFor(editor: Editor): string {
  const { settings, roundness } = editor;
  const isLinear = settings.layout === "linear";
  const scheme = `PN::${classes[settings.scheme] ?? settings.scheme}()`;
  const parameters = [`number_of_iterations(${settings.rounds})`];
  if (!isLinear && roundness === undefined) parameters.unshift("vertex_roundness_map(roundness)");
  else if (!isLinear && roundness !== 1) parameters.unshift(`roundness(${roundness})`);
  const first = parameters.length > 1 ? "PN::parameters::" : "CGAL::parameters::";
  if (!isLinear) parameters.push("vertex_normal_map(normals)");
  if (editor.mesh.numberOfSharpEdges() > 0) parameters.push("edge_is_constrained_map(creases)");
  return [
    "#include <CGAL/PN_subdivision_3.h>",
    "namespace PN = CGAL::PN_subdivision_3;",
    "// ...",
    `PN::subdivide(mesh, ${isLinear ? `PN::linear(${scheme})` : scheme},`,
    `              ${first}${parameters.join("\n                .")});`,
  ].join("\n");
}
