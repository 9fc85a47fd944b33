// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_BLEND_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_BLEND_H

#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// a dart has the smooth rule
inline bool is_same_rule(Vertex_rule a, Vertex_rule b)
{
  const auto smooth = [](Vertex_rule r) {
    return r == Vertex_rule::dart ? Vertex_rule::smooth : r;
  };
  return smooth(a) == smooth(b);
}

// the weight of a vertex's rule before the round beside that after it: the mean sharpness of what is sharp no
// more after the round, at most 1
template <class FT>
double weight_of_parent_rule(const Creases<FT>& creases, const Crease_star& star)
{
  double sum = 0;
  int number = 0;
  const auto add = [&](double s) {
    if (!(s > 0) || refined_sharpness(s) > 0) return;
    sum += s;
    ++number;
  };
  add(star.sharpness);
  for (Level_connectivity::Index i = 0; i < star.number_of_ends; ++i)
    add(creases.edge(creases.end(star, i)).sharpness);
  return number == 0 ? 1 : sum / number;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_BLEND_H
