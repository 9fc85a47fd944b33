// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_IN_DOUBLE_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_IN_DOUBLE_H

#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// The points or vectors of another map, rounded to double.
template <class Map, class Value>
struct Map_in_double
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  Map map;

  friend Value get(const Map_in_double& m, const key_type& key)
  {
    const auto& p = get(m.map, key);
    return Value(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
};

template <class Map, class Value>
inline constexpr bool is_of_estimate_v<Map_in_double<Map, Value>> = is_of_estimate_v<Map>;
template <class Map, class Value>
inline constexpr bool goes_with_roundness_v<Map_in_double<Map, Value>> = goes_with_roundness_v<Map>;
template <class Map, class Value, class Key, class = std::enable_if_t<is_of_estimate_v<Map>>>
auto get_whole(const Map_in_double<Map, Value>& m, const Key& key)
{
  return get_whole(m.map, key);
}

// the named parameters of a call that computes in double, whatever the mesh has
template <class PolygonMesh, class NamedParameters>
struct Parameters_in_double : Surface_parameters<PolygonMesh, NamedParameters>
{
  using Base = Surface_parameters<PolygonMesh, NamedParameters>;
  using Kernel = Simple_cartesian<double>;
  using FT = double;

  static auto points(const PolygonMesh& mesh, const NamedParameters& np)
  {
    const auto map = Base::const_point_map(mesh, np);
    return Map_in_double<std::decay_t<decltype(map)>, Kernel::Point_3>{map};
  }
  template <bool are_used>
  static auto normals([[maybe_unused]] const NamedParameters& np)
  {
    if constexpr (!are_used || std::is_same_v<typename Base::Normal_map, No_normal_map>)
      return No_normal_map();
    else
      return Map_in_double<typename Base::Normal_map, Kernel::Vector_3>{Base::normal_map(np)};
  }
};

// A scheme that is kept beyond the call. The values have the roundness of vertices; one of all goes to where it stays.
template <class Scheme, class FT>
Scheme kept_scheme(Scheme scheme, [[maybe_unused]] Given_roundness<FT>& kept)
{
  if constexpr (Is_with_roundness<Scheme>::value) {
    if (scheme.given != nullptr) kept.of_all = scheme.given->of_all;
    scheme.given = &kept;
  }
  return scheme;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_IN_DOUBLE_H
