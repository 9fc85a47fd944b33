// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_IO_H
#define PN_SUBDIVIDE_CURVE_IO_H

#include "io/Output_file.h"
#include "io/curve_data.h"

#include <string>

namespace pn_subdivide {

// Reads lines `x y`, `x y nx ny`, `x y z` or `x y z nx ny nz`, all of the same form. Blank lines
// and what follows a # are skipped. Throws Error, which names the file and the line.
Curve_data read_curve(const std::string& file);

// Writes the same form with 17 significant digits, without normals if the curve has none.
void write_curve(Output_file& out, const Curve_data& curve);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_IO_H
