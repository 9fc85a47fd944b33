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

/** The files that "Control mesh" takes with you. */
export function controlFiles({ name, mesh }: Editor): { mesh: string; creases?: string } {
  const stem = `${name.replace(/\.[^.]*$/, "") || "mesh"}_control`;
  if (mesh.numberOfSharpEdges() === 0) return { mesh: `${stem}.ply` };
  return { mesh: `${stem}.obj`, creases: `${stem}.selection.txt` };
}

const quoted = (word: string): string => (/^[\w./:-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

/** For the files of controlFiles(). */
export function commandFor(editor: Editor): string {
  const { settings, roundness } = editor;
  const files = controlFiles(editor);
  const isLinear = settings.layout === "linear";
  const words = ["pn_subdivide", "surface", files.mesh, "surface.ply", "--scheme", settings.scheme, "--levels", String(settings.rounds)];
  if (files.creases) words.push("--sharp", files.creases);
  words.push(...(isLinear ? ["--linear"] : ["--normals", "file"]));
  // which PLY files hold themselves
  if (files.creases && !isLinear && roundness !== 1) words.push("--roundness", roundness === undefined ? "estimate" : String(roundness));
  if (editor.showsLimit) words.push("--limit", "--surface-normals", "--limit-tolerance", "1e-7");
  return words.map(quoted).join(" ");
}

/** For a mesh with normals, and their roundness where it was estimated, that has been read. */
export function programFor(editor: Editor): string {
  const { settings, roundness } = editor;
  const isLinear = settings.layout === "linear";
  const scheme = `PN::${classes[settings.scheme] ?? settings.scheme}()`;
  let parameters = "CGAL::parameters::";
  if (!isLinear && roundness === undefined) parameters = "PN::parameters::vertex_roundness_map(roundness).";
  else if (!isLinear && roundness !== 1) parameters = `PN::parameters::roundness(${roundness}).`;
  parameters += `number_of_iterations(${settings.rounds})`;
  if (!isLinear) parameters += ".vertex_normal_map(normals)";
  if (editor.mesh.numberOfSharpEdges() > 0) parameters += ".edge_is_constrained_map(creases)";
  return [
    "#include <CGAL/PN_subdivision_3.h>",
    "namespace PN = CGAL::PN_subdivision_3;",
    "// ...",
    `PN::subdivide(mesh, ${isLinear ? `PN::linear(${scheme})` : scheme},`,
    `              ${parameters});`,
  ].join("\n");
}
