// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A compiled module becomes the package: on the page, and again in its worker.

import createModule from "modeler-code";
import type { Modeler } from "./modeler_types";

export function instantiate(module: WebAssembly.Module): Promise<Modeler> {
  return createModule({
    locateFile: (name) => name, // there is no file
    instantiateWasm: (imports, done) => {
      void WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
      return {};
    },
  });
}
