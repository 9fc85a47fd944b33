// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_REFINE_H
#define PN_SUBDIVIDE_REFINE_H

#include "surface/Scheme.h"
#include "surface/refine_surface.h"

#include <CGAL/PN_subdivision_3/internal/meshes/Wedge_normals.h>

#include <boost/property_map/property_map.hpp>

#include <vector>

// Each has a source file of its own, because a call for every scheme takes long to compile.

namespace pn_subdivide {

void refine_linearly(Surface& surface, const Scheme& scheme, const Refinement& refinement);

void refine_with_normals(Surface& surface, Normal_map normals, const Scheme& scheme,
                         const Refinement& refinement);

// The schemes must be different and have the same host.
void refine_with_normal_scheme(Surface& surface, Normal_map normals, const Scheme& scheme,
                               const Scheme& normal_scheme, const Refinement& refinement);

// those of the control mesh, by half-edges
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
using Wedge_normals =
  CGAL::PN_subdivision_3::internal::Wedge_normals<Control_corner_normals, Normal_map>;

// The same with creases; the schemes must have rules for them. Normals are those of corners.
void refine_linearly(Surface& surface, const Scheme& scheme, const Crease_maps& creases,
                     const Refinement& refinement);
void refine_with_normals(Surface& surface, const Wedge_normals& normals, const Scheme& scheme,
                         const Crease_maps& creases, const Refinement& refinement);
void refine_with_normal_scheme(Surface& surface, const Wedge_normals& normals, const Scheme& scheme,
                               const Scheme& normal_scheme, const Crease_maps& creases,
                               const Refinement& refinement);

struct Round_visitor
{
  template <class Round, class Number>
  void round_done(Round k, Number faces) const
  {
    if (report) report(static_cast<unsigned>(k), static_cast<std::size_t>(faces));
  }

  std::function<void(unsigned, std::size_t)> report;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_REFINE_H
