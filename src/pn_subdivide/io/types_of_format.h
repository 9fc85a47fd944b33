// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_TYPES_OF_FORMAT_H
#define PN_SUBDIVIDE_TYPES_OF_FORMAT_H

#include "io/Attributes.h"
#include "io/mesh_io.h"

namespace pn_subdivide {

// Where the format has types, other programs read colors as bytes and texture coordinates as floats. Those that
// a file has given no type become such.
void take_types_of_format(const Mesh_file& output, Attributes& attributes);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_TYPES_OF_FORMAT_H
