// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

declare module "*/modeler.js" {
  import type { Modeler } from "../page/modeler_types.js";
  const create: (options: { wasmBinary: Uint8Array }) => Promise<Modeler>;
  export default create;
}
