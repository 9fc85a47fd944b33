// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The package as WebAssembly: how the module is loaded from the page itself.

import compressedModule from "modeler-wasm";
import { instantiate } from "./instantiate";
import type { Modeler } from "./modeler_types";

export type * from "./modeler_types";

export async function inflate(bytes: Uint8Array, format: CompressionFormat): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream(format));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** It is compiled while it is inflated. */
export async function loadModeler(): Promise<{ modeler: Modeler; module: WebAssembly.Module }> {
  const stream = new Blob([compressedModule as BlobPart]).stream().pipeThrough(new DecompressionStream("gzip"));
  const module = await WebAssembly.compileStreaming(new Response(stream, { headers: { "Content-Type": "application/wasm" } }));
  return { modeler: await instantiate(module), module };
}
