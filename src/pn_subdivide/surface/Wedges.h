// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_WEDGES_H
#define PN_SUBDIVIDE_WEDGES_H

#include "surface/Surface.h"
#include "surface/creases.h"

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The wedges of all vertices: runs of faces round a vertex between sharp edges and border edges.
struct Wedges
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::vector<std::size_t> of_corner; // of the face of a half-edge at its target; by half-edge
  std::vector<Vertex> vertex;         // of each wedge
  std::vector<std::size_t> number;    // at each vertex

  // `is_sharp(edge)`
  template <class Is_sharp>
  Wedges(const Surface& surface, const Is_sharp& is_sharp)
    : of_corner(surface.number_of_halfedges(), none)
    , number(surface.number_of_vertices(), 0)
  {
    for (const Halfedge h : surface.halfedges()) {
      if (surface.is_border(h) || of_corner[h] != none) continue;
      fill(surface, is_sharp, h);
      ++number[surface.target(h)];
      vertex.push_back(surface.target(h));
    }
  }

private:
  // Both ways round the vertex.
  template <class Is_sharp>
  void fill(const Surface& surface, const Is_sharp& is_sharp, Halfedge first)
  {
    const auto is_new = [&](Halfedge h) { return !surface.is_border(h) && of_corner[h] == none; };
    Halfedge h = first;
    of_corner[h] = vertex.size();
    while (!is_sharp(surface.edge(surface.next(h)))) {
      h = surface.opposite(surface.next(h));
      if (!is_new(h)) break;
      of_corner[h] = vertex.size();
    }
    for (h = first; !is_sharp(surface.edge(h)) && !surface.is_border(surface.opposite(h));) {
      h = surface.prev(surface.opposite(h));
      if (!is_new(h)) break;
      of_corner[h] = vertex.size();
    }
  }
};

// What take_corner_normals() takes, by half-edge, and that without edges that hardly are sharp.
struct Control_corner_normals
{
  Control_corner_normals(const std::vector<Corner_value>& of_corners,
                         std::shared_ptr<const Normals_without_fractions> of_others)
    : values(&of_corners)
    , roundness(&of_corners)
    , without_fractions(std::move(of_others))
  {
    if (without_fractions && without_fractions->values.size() != of_corners.size())
      without_fractions = nullptr; // those of the control mesh
  }

  using key_type = Halfedge;
  using value_type = Vector_3;
  using reference = const Vector_3&;
  using category = boost::readable_property_map_tag;

  static constexpr bool goes_with_roundness = true;

  Corner_value whole(key_type h) const { return {(*values)[h].normal, (*roundness)[h].roundness}; }
  friend const Vector_3& get(const Control_corner_normals& n, key_type h)
  {
    return (*n.values)[h].normal;
  }
  friend Control_corner_normals normals_without_fractions(Control_corner_normals n)
  {
    if (!n.without_fractions) return n;
    n.values = &n.without_fractions->values;
    if (n.without_fractions->has_roundness) n.roundness = n.values;
    return n;
  }
  const std::vector<Corner_value>*values, *roundness; // these of those
  std::shared_ptr<const Normals_without_fractions> without_fractions;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_WEDGES_H
