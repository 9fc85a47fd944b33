// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_INTERPOLATION_WRITER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_INTERPOLATION_WRITER_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/PN_row_blocks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/No_normal_map.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Writes what has changed into a map of a mesh, and puts the old values back unless it is kept.
template <class Access, class Map>
class Changed_values
{
  using Index = Level_connectivity::Index;
  using Value = typename boost::property_traits<Map>::value_type;

public:
  Changed_values(const Access& access, Map map)
    : access_(access)
    , map_(map)
  {}
  Changed_values(const Changed_values&) = delete;
  Changed_values& operator=(const Changed_values&) = delete;
  // a map that throws here too keeps what it has
  ~Changed_values()
  {
    if (is_kept_) return;
    for (const auto& [v, value] : old_) try {
        put(map_, access_.vertex(v), value);
      } catch (...) {
      }
  }

  template <class FT>
  void change(Index v, const Eigen_vector<3>& x)
  {
    old_.emplace_back(v, get(map_, access_.vertex(v)));
    put(map_, access_.vertex(v), Value(FT(x[0]), FT(x[1]), FT(x[2])));
  }
  void keep() { is_kept_ = true; }

private:
  const Access& access_;
  Map map_;
  std::vector<std::pair<Index, Value>> old_;
  bool is_kept_ = false;
};

// Writes the control net in place of the data; points and normals that are the same stay untouched.
template <class FT, class Access, class Point_map, class Normal_map>
void write_control_net(const Access& access, Point_map points, [[maybe_unused]] Normal_map normals,
                       const Vectors<3>& old_points, const Vectors<3>& new_points,
                       [[maybe_unused]] const Vectors<3>& old_normals,
                       [[maybe_unused]] const Vectors<3>& new_normals)
{
  using Index = Level_connectivity::Index;
  Changed_values<Access, Point_map> new_point(access, points);
  for (std::size_t v = 0; v < new_points.size(); ++v)
    if (new_points[v] != old_points[v])
      new_point.template change<FT>(static_cast<Index>(v), new_points[v]);
  if constexpr (!std::is_same_v<Normal_map, No_normal_map>) {
    Changed_values<Access, Normal_map> new_normal(access, normals);
    for (std::size_t v = 0; v < new_normals.size(); ++v)
      if (new_normals[v] != old_normals[v])
        new_normal.template change<FT>(static_cast<Index>(v), new_normals[v]);
    new_normal.keep();
  }
  new_point.keep();
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_INTERPOLATION_WRITER_H
