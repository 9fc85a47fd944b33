// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_SUB_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_SUB_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Corner_slots.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/creases_of_part.h>
#include <CGAL/PN_subdivision_3/internal/limit/Sub_level.h>

#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The part of a level about some vertices, with its creases, their tangents and the values of its slots. At its rim,
// but not at the border of the level, the rules are those of a smooth border.
template <class FT, class Value>
class Creased_sub_level
{
public:
  using Index = Level_connectivity::Index;

  // `level` is not cut open, `values` are those of its slots
  Creased_sub_level(const Level_connectivity& level, const Creases<FT>& creases,
                    const std::vector<Value>& values, const std::vector<Index>& centers,
                    unsigned rings)
    : sub_(level, centers, rings, true)
    , creases_(creases_of_part(
        creases, sub_.level(), [&](Index e) { return sub_.edge_origin()[e]; },
        [&](Index v) { return sub_.origin()[v]; }))
    , values_(creases_.number_of_slots)
  {
    take_slot_values(
      sub_.level(), creases_, [&](Index h) { return sub_.halfedge_origin(h); },
      Corner_slots<FT>(level, creases), values, values_);
  }

  const Level_connectivity& level() const { return sub_.level(); }
  const Creases<FT>& creases() const { return creases_; }
  const std::vector<Value>& values() const { return values_; }
  // the centers' numbers in this level, in their order
  const std::vector<Index>& centers() const { return sub_.centers(); }

private:
  Sub_level sub_;
  Creases<FT> creases_;
  std::vector<Value> values_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_SUB_LEVEL_H
