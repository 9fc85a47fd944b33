// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_TANGENT_MAPS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_TANGENT_MAPS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/checked_coordinates.h>
#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Old_values.h>
#include <CGAL/PN_subdivision_3/schemes/with_crease_tangents.h>
#include <CGAL/Uncertain.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The tangents of creases in a map of half-edges: read before the first round, written for the refined
// half-edges if the map can be written, and put back unless they are kept.
template <class FT, class Access, class Map>
class Crease_tangents
{
public:
  using Index = Level_connectivity::Index;

  Crease_tangents(const Access& access, const Level_connectivity& level, Map map)
    : access_(access)
    , map_(map)
    , old_(access, level.number_of_halfedges(), map)
  {}
  ~Crease_tangents()
  {
    if (is_changed_) old_.put_back(access_);
  }
  Crease_tangents(const Crease_tangents&) = delete;
  Crease_tangents& operator=(const Crease_tangents&) = delete;

  void read(Creases<FT>& creases) const
  {
    for (Crease_edge<FT>& e : creases.edges)
      for (Index side = 0; side < 2; ++side)
        e.tangent_from[side] = checked_tangent(e.halfedge(side));
  }

  // of all half-edges, those without a crease get zero
  void put_refined([[maybe_unused]] const Creases<FT>& creases,
                   [[maybe_unused]] Index number_of_edges)
  {
    if constexpr (is_writable_map_v<Map>) {
      is_changed_ = true;
      auto crease = creases.edges.begin();
      for (Index e = 0; e < number_of_edges; ++e) {
        const bool is_crease = crease != creases.edges.end() && crease->edge == e;
        for (Index side = 0; side < 2; ++side) {
          const auto h = access_.halfedge_at(2 * e + side);
          if (is_crease) {
            const Coordinates<FT, 3>& t = crease->tangent_from[side];
            put(map_, h, Vector(t[0], t[1], t[2]));
          } else
            put(map_, h, Vector(0, 0, 0));
        }
        if (is_crease) ++crease;
      }
    }
  }

  void keep() { is_changed_ = false; }

private:
  using Vector = typename Old_values<Map, Halfedge_of_mesh>::Value;

  Coordinates<FT, 3> checked_tangent(Index h) const
  {
    const Coordinates<FT, 3> t = coordinates_3<FT>(old_[h]);
    const auto name = [&] { return access_.halfedge_name(h); };
    check_finite<FT, 3>(t, "tangent", name);
    const FT longest = FT(1) + Unit_normal_traits<FT>::unit_tolerance();
    if (CGAL::certainly(is_greater(dot<FT, 3>(t, t), longest)))
      throw std::invalid_argument("PN_subdivision_3: the tangent of " + name() +
                                  " is longer than 1: give unit vectors, or zero where the tangent "
                                  "is to be made");
    if (is_shorter_than_tangents<FT, 3>(t) && !is_zero(t))
      throw std::invalid_argument(
        "PN_subdivision_3: the tangent of " + name() +
        " is shorter than 1e-6, as of a map that has not been set: give unit vectors, and "
        "CGAL::NULL_VECTOR where the tangent is to be made");
    return t;
  }

  static bool is_zero(const Coordinates<FT, 3>& t)
  {
    return std::all_of(t.begin(), t.end(), [](const FT& x) { return CGAL::certainly(x == FT(0)); });
  }

  const Access& access_;
  Map map_;
  Old_values<Map, Halfedge_of_mesh> old_;
  bool is_changed_ = false;
};

template <class FT, class Access>
class Crease_tangents<FT, Access, No_tangent_map>
{
public:
  Crease_tangents(const Access&, const Level_connectivity&, No_tangent_map) {}
  void read(Creases<FT>&) const {}
  void put_refined(const Creases<FT>&, Level_connectivity::Index) {}
  void keep() {}
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_TANGENT_MAPS_H
