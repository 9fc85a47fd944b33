// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Subdivides all meshes of a glTF model, for Node.js: node example.mjs MODEL.glb OUTPUT.obj
import { readFile, writeFile } from "node:fs/promises";
import * as THREE from "three";
import { OBJExporter } from "three/addons/exporters/OBJExporter.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { load } from "pn-subdivision";
import { bufferGeometry, meshOf } from "pn-subdivision/three";

globalThis.ProgressEvent ??= Event; // for three.js, which reads buffers as browsers do
const [, , input, output] = process.argv;
const bytes = await readFile(input);
const model = await new GLTFLoader().parseAsync(Uint8Array.from(bytes).buffer, "");
const { subdivide } = await load();
model.scene.traverse((object) => {
  if (!object.isMesh) return;
  const refined = subdivide(meshOf(object.geometry), { scheme: "loop", levels: 2 });
  object.geometry = bufferGeometry(THREE, refined);
  console.log(`${object.name}: ${refined.faces.degrees.length} triangles`);
});
await writeFile(output, new OBJExporter().parse(model.scene));
