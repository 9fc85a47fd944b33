// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLY_TAGS_H
#define PN_SUBDIVIDE_PLY_TAGS_H

#include "io/Crease_tags.h"
#include "io/Ply_header.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pn_subdivide {

// The element 'edge' of a PLY file, if it has the sharpness of edges; then the property 'sharpness' of vertices
// is theirs, too.
class Ply_tags
{
public:
  explicit Ply_tags(const Ply_header& header);

  bool any() const { return edges_ != nullptr; }
  bool is_edge(const Ply_element& element) const { return &element == edges_; }

  // Adds an edge, whose scalars are those of the element. Throws Error.
  void add_edge(const std::vector<double>& scalars, std::size_t number_of_vertices,
                Crease_tags& tags) const;

private:
  const Ply_element* edges_ = nullptr;
  std::array<std::size_t, 9> places_{}; // of the properties
  bool has_tangents_ = false;
};

// Throws Error unless it is a number that is not negative.
void require_sharpness(double sharpness);

constexpr const char* edge_properties[] = {"vertex1", "vertex2", "sharpness", "t1x", "t1y",
                                           "t1z",     "t2x",     "t2y",       "t2z"};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLY_TAGS_H
