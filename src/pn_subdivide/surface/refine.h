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

// Each has a source file of its own, because a call for every scheme takes long to compile.

namespace pn_subdivide {

void refine_linearly(Surface& surface, const Scheme& scheme, const Refinement& refinement);

void refine_with_normals(Surface& surface, Normal_map normals, const Scheme& scheme,
                         const Refinement& refinement);

// The schemes must be different and have the same host.
void refine_with_normal_scheme(Surface& surface, Normal_map normals, const Scheme& scheme,
                               const Scheme& normal_scheme, const Refinement& refinement);

// The same with creases; the schemes must have rules for them. Normals are those of corners.
void refine_linearly(Surface& surface, const Scheme& scheme, const Crease_maps& creases,
                     const Refinement& refinement);
void refine_with_normals(Surface& surface, Corner_normal_map normals, const Scheme& scheme,
                         const Crease_maps& creases, const Refinement& refinement);
void refine_with_normal_scheme(Surface& surface, Corner_normal_map normals, const Scheme& scheme,
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
