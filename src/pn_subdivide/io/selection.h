// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SELECTION_H
#define PN_SUBDIVIDE_SELECTION_H

#include "io/Mesh_data.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pn_subdivide {

// What a file of CGAL's format of selections (.selection.txt) holds: numbers of vertices in the first
// line, of faces in the second, edges as pairs of vertex numbers in the third. Lines may be blank.
struct Selection
{
  std::vector<std::int64_t> vertices, faces;
  std::vector<std::array<std::int64_t, 2>> edges;
};

// Throws Error, which names the file and the line. Numbers are not negative.
Selection read_selection(const std::string& file);

class Output_file;
// Whatever is sharp for some rounds or for ever.
void write_selection(Output_file& out, const Crease_tags& tags);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SELECTION_H
