// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CREASE_TAGS_H
#define PN_SUBDIVIDE_CREASE_TAGS_H

#include <array>
#include <cstdint>
#include <vector>

namespace pn_subdivide {

// What is sharp in a mesh, by the numbers of its vertices in the file.
struct Crease_tags
{
  struct Edge
  {
    std::array<std::uint32_t, 2> ends;
    double sharpness; // greater than 0; infinite for ever
    // unit tangents at the ends, along the edge and into it; zero where there is none
    std::array<std::array<double, 3>, 2> tangents;
  };

  std::vector<Edge> edges;
  std::vector<double> vertices; // sharpness, or empty

  bool any() const { return !edges.empty() || !vertices.empty(); }
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CREASE_TAGS_H
