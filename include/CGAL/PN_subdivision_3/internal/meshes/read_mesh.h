// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_READ_MESH_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_READ_MESH_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The control level of a mesh, read through an access and checked.
template <class Access>
Level_connectivity checked_level(const Access& access)
{
  const Level_size size = access.size();
  if (size.halfedges() >= Level_connectivity::null || size.vertices >= Level_connectivity::null)
    throw std::length_error("PN_subdivision_3: the mesh has " + std::to_string(size.halfedges()) +
                            " half-edges, more than can be numbered");
  Level_connectivity level(size);
  access.read(level);
  check_connectivity<Element_names>(level, access);
  return level;
}

// without faces all rounds are alike
inline unsigned number_of_rounds(const Level_connectivity& level, unsigned rounds)
{
  return level.size().faces == 0 ? (std::min)(rounds, 1u) : rounds;
}

// reports the last round, and the rounds of a call that change nothing
template <class Round_done>
void report_last_round(const Round_done& done, unsigned last, unsigned all, const Level_size& size)
{
  done(last, static_cast<std::size_t>(size.faces));
  while (last < all) done(++last, 0);
}

[[noreturn]] inline void refuse_size(const Level_size& size, unsigned round, std::uint64_t limit)
{
  throw std::length_error(
    "PN_subdivision_3: round " + std::to_string(round) + " would need " +
    std::to_string(size.vertices) + " vertices, " + std::to_string(size.halfedges()) +
    " half-edges and " + std::to_string(size.faces) + " faces, more than the " +
    std::to_string(limit - 1) + " that the index type of the mesh can number: ask for at most " +
    std::to_string(round - 1) + " rounds");
}

// the size after some rounds
template <class Host>
Level_size checked_refined_size(Level_size size, unsigned rounds, std::uint64_t limit)
{
  for (unsigned k = 1; k <= rounds; ++k) {
    size = Host::refined_size(size, k);
    if (size.halfedges() < limit && size.vertices < limit && size.faces < limit) continue;
    refuse_size(size, k, limit);
  }
  return size;
}

// a point of a mesh, checked
template <class FT, class Access, class Point_map>
Coordinates<FT, 3> checked_point(const Access& access, Point_map points,
                                 Level_connectivity::Index v)
{
  const Coordinates<FT, 3> p = coordinates_3<FT>(get(points, access.vertex(v)));
  check_finite<FT, 3>(p, "point", [&] { return access.vertex_name(v); });
  return p;
}

template <class FT, class Value, class Access, class Normal_map>
void read_normals(const Access& access, Normal_map normals, std::vector<Value>& values)
{
  for (Level_connectivity::Index v = 0; v < values.size(); ++v) {
    Coordinates<FT, 3>& normal = values[v].normal;
    normal = coordinates_3<FT>(get(normals, access.vertex(v)));
    const auto name = [&] { return access.vertex_name(v); };
    check_finite<FT, 3>(normal, "normal", name);
    normalize_control_normal<FT, 3>(normal, name);
  }
}

// The points of a mesh and, of values that have them, the control normals, zero if there is no map of
// them.
template <class Average, class Access, class Point_map, class Normal_map>
std::vector<typename Average::Value> read_given_values(const Access& access, Point_map points,
                                                       [[maybe_unused]] Normal_map normals,
                                                       Level_connectivity::Index number_of_vertices)
{
  using FT = typename Average::FT;
  using Value = typename Average::Value;
  std::vector<Value> values(number_of_vertices);
  for (Level_connectivity::Index v = 0; v < number_of_vertices; ++v)
    point_of(values[v]) = checked_point<FT>(access, points, v);
  if constexpr (has_normal_v<Value>) {
    if constexpr (!is_there_v<Normal_map>)
      for (Value& value : values) value.normal.fill(FT(0));
    else
      read_normals<FT>(access, normals, values);
  }
  return values;
}

// as read_values(), but normals are estimated if there is no map of normals
template <class Average, class Access, class Point_map, class Normal_map>
std::vector<typename Average::Value>
read_values(const Access& access, const Level_connectivity& level, Point_map points,
            Normal_map normals, [[maybe_unused]] Control_normal_estimate estimate)
{
  using FT = typename Average::FT;
  auto values = read_given_values<Average>(access, points, normals, level.number_of_vertices());
  using Value = typename Average::Value;
  if constexpr (has_normal_v<Value> && !is_there_v<Normal_map>)
    estimate_normals_of<FT>(level, estimate, values);
  return values;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_READ_MESH_H
