// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MOVE_TO_LIMITS_H
#define PN_SUBDIVIDE_MOVE_TO_LIMITS_H

#include "surface/limit.h"

#include <CGAL/PN_subdivision_3.h>

#include <type_traits>

namespace pn_subdivide {

// The call that the functions of limit.h for surfaces with creases have in common; the scheme has the border of
// the creases.
template <class S>
Limit_report move_to_limits(Surface& surface, Corner_normal_map normals, const S& scheme,
                            const Crease_maps& creases, const Limit_options& options)
{
  return CGAL::PN_subdivision_3::move_to_limit<CGAL::Parallel_if_available_tag>(
    surface, scheme, options,
    CGAL::parameters::vertex_normal_map(normals)
      .edge_is_constrained_map(creases.edges)
      .vertex_is_constrained_map(creases.vertices));
}

// the border and the tangents of the creases
template <class S>
auto with_creases(const S& scheme, const Crease_maps& creases)
{
  namespace PN = CGAL::PN_subdivision_3;
  return PN::with_crease_tangents(PN::with_border(scheme, creases.border), creases.tangents);
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MOVE_TO_LIMITS_H
