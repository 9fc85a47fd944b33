// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A compiled module becomes the package: on the page, and again in its workers.

import createModule from "modeler-code";
import type { Modeler } from "./modeler_types";

export function instantiate(module: WebAssembly.Module): Promise<Modeler> {
  return new Promise((resolve, reject) =>
    createModule({
      locateFile: (name) => name, // there is no file
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiate(module, imports).then((instance) => done(instance, module)).catch(reject);
        return {};
      },
    }).then(resolve, reject),
  );
}

/** What anything that was thrown says to the user. */
export function messageOf(error: unknown): string {
  if (error instanceof Error) return error.message;
  // of C++, where nobody has made an Error of it
  if (typeof WebAssembly.Exception === "function" && error instanceof WebAssembly.Exception) return "there is not enough memory for this";
  return String(error);
}
