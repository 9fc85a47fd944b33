// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_LIMIT_SURFACE_H
#define PN_SUBDIVIDE_LIMIT_SURFACE_H

#include "surface/Surface.h"
#include "surface/surface_schemes.h"

#include <cstddef>
#include <optional>
#include <string>

namespace pn_subdivide {

// The options --limit, --limit-tolerance and --surface-normals.
struct Limit_choice
{
  bool points = false, normals = false;
  std::optional<double> tolerance; // of the bounding box

  bool is_used() const { return points || normals; }
};

// Throws Usage_error if there is nothing that the tolerance is for, or if it is none.
void require_consistent(const Limit_choice& choice);

// Throws Usage_error if the scheme has no limit points at vertices.
void require_limit_of_vertices(const std::string& scheme, const Limit_choice& choice);

struct Limit_summary
{
  double error = 0, tolerance = 0, box = 0;
  double normal_error = 0; // in radians
  std::size_t misses = 0, stand_ins = 0;
  unsigned depth = 0;

  std::string description(const Limit_choice& choice) const;
  // empty if all is well
  std::string warning() const;
};

// Puts the vertices of a mesh of the given level on the limit surface, gives them the surface's normals,
// or both. Points without normals count as those of the linear scheme. Passes on the library's
// exceptions.
Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         unsigned levels, unsigned threads);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LIMIT_SURFACE_H
