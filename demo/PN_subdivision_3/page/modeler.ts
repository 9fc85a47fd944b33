// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The package as WebAssembly: how the module is loaded from the page itself.

import text, { alphabet } from "modeler-wasm";
import { instantiate } from "./instantiate";
import type { Modeler } from "./modeler_types";

export type * from "./modeler_types";

export async function inflate(bytes: Uint8Array, format: CompressionFormat): Promise<Uint8Array> {
  // not by Response, of which Firefox reports what is damaged as an error that nobody has caught
  const reader = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream(format)).getReader();
  const parts: BlobPart[] = [];
  for (let part = await reader.read(); !part.done; part = await reader.read()) parts.push(part.value as BlobPart);
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

export async function loadModeler(): Promise<{ modeler: Modeler; module: WebAssembly.Module }> {
  const byteOf = new Uint8Array(0x180);
  for (let byte = 0; byte < 256; ++byte) byteOf[alphabet.charCodeAt(byte)] = byte;
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = byteOf[text.charCodeAt(i)];
  const module = await WebAssembly.compile(bytes);
  return { modeler: await instantiate(module), module };
}
