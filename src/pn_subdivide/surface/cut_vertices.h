// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CUT_VERTICES_H
#define PN_SUBDIVIDE_CUT_VERTICES_H

#include "surface/Surface.h"

#include <CGAL/PN_recognition_3/surfaces/Recognized_surface.h>

#include <cstddef>
#include <vector>

namespace pn_subdivide {

struct Moved_vertex
{
  std::size_t vertex;
  Point_3 point;
};

// Programs that cut facets, not what these stand for, leave vertices on their chords, which refinement would keep: where they
// belong, on all surfaces of the faces around them. `segments` are the numbers of the surfaces of the faces.
std::vector<Moved_vertex>
cut_vertices(const Surface& surface, const std::vector<std::size_t>& segments,
             const std::vector<CGAL::PN_subdivision_3::Recognized_surface>& surfaces);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CUT_VERTICES_H
