// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CONTROL_CORNER_NORMALS_H
#define PN_SUBDIVIDE_CONTROL_CORNER_NORMALS_H

#include "surface/Surface.h"

#include <boost/property_map/property_map.hpp>

#include <vector>

namespace pn_subdivide {

// The normals of take_corner_normals(), by half-edge.
struct Control_corner_normals
{
  using key_type = Surface::Halfedge_index;
  using value_type = Vector_3;
  using reference = const Vector_3&;
  using category = boost::readable_property_map_tag;

  friend const Vector_3& get(const Control_corner_normals& n, key_type h)
  {
    return (*n.normals)[h];
  }
  const std::vector<Vector_3>* normals;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CONTROL_CORNER_NORMALS_H
