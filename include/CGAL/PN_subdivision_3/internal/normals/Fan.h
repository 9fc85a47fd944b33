// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The half-edges with the same target v, one after the other clockwise. A closed fan has all of
// them, an open one those from `first` to `last`; the faces of a closed fan are those of its
// half-edges, those of an open one all but that of `last`. An open fan may have the same first and
// last half-edge: then it goes once round v.
struct Fan
{
  using Index = Level_connectivity::Index;

  Index first, last;
  bool closed;
};

// all half-edges at v. \pre v is not isolated
inline Fan fan_of_vertex(const Level_connectivity& level, Level_connectivity::Index v)
{
  const Level_connectivity::Index h = level.halfedge_of_vertex(v);
  if (!level.is_border(h)) return {h, h, true};
  return {level.next_around_target(h), h, false};
}

// calls f(h) for the half-edges of a fan
template <class Function>
void for_each_halfedge(const Level_connectivity& level, const Fan& fan, const Function& f)
{
  Level_connectivity::Index h = fan.first;
  do {
    f(h);
    h = level.next_around_target(h);
  } while (h != (fan.closed ? fan.first : fan.last));
  if (!fan.closed) f(h);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H
