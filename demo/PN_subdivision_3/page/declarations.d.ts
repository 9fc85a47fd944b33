// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What build.mjs makes of files that are no TypeScript.

declare module "modeler-code" {
  import type { Modeler } from "./modeler";
  const create: (options: {
    locateFile(name: string): string;
    instantiateWasm(
      imports: WebAssembly.Imports,
      done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
    ): object;
  }) => Promise<Modeler>;
  export default create;
}
declare module "modeler-wasm" {
  /** A letter for each byte; the alphabet has them in the order of the bytes. */
  export const alphabet: string;
  const text: string;
  export default text;
}
declare module "surface-worker-code" {
  const address: () => string;
  export default address;
}
declare module "*.ply" {
  const text: string;
  export default text;
}
declare module "*.off" {
  const text: string;
  export default text;
}
declare module "*.txt" {
  const text: string;
  export default text;
}
declare module "*.obj" {
  const text: string;
  export default text;
}
declare module "*.webp" {
  const address: string;
  export default address;
}
