// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WRITER_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WRITER_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_limits.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

template <class Limit, class Average>
Limit to_limit_point(const Limit_result<Average>& result)
{
  using FT = typename Average::FT;
  using Point = std::decay_t<decltype(std::declval<Limit>().point)>;
  using Vector = std::decay_t<decltype(std::declval<Limit>().control_normal)>;
  Limit l;
  const Coordinates<FT, 3>& p = point_of(result.value);
  l.point = Point(p[0], p[1], p[2]);
  if constexpr (has_normal_v<typename Average::Value>) {
    const Coordinates<FT, 3>& m = result.value.normal;
    l.control_normal = Vector(m[0], m[1], m[2]);
  }
  const Coordinates<double, 3>& n = result.surface_normal;
  l.surface_normal =
    result.has_surface_normal ? Vector(FT(n[0]), FT(n[1]), FT(n[2])) : l.control_normal;
  l.error = result.error;
  l.normal_error = result.normal_error;
  l.has_surface_normal = result.has_surface_normal;
  l.gaussian = result.gaussian;
  l.mean = result.mean;
  l.has_curvature = result.has_curvature;
  return l;
}

template <class FT, class Results, class Name>
void check_limits(const Results& results, const Name& name)
{
  for (std::size_t i = 0; i < results.size(); ++i)
    check_in_range<FT, 3>(point_of(results[i].value),
                          [&] { return "the limit point of " + name(i); });
}

// what becomes the normal of a vertex: that of the surface, if it is asked for and exists, otherwise the
// control normal; zero with a linear scheme
template <class Average>
Coordinates<typename Average::FT, 3> limit_normal(const Limit_result<Average>& result,
                                                  bool surface_normals)
{
  using FT = typename Average::FT;
  if (surface_normals && result.has_surface_normal) {
    const Coordinates<double, 3>& n = result.surface_normal;
    return {FT(n[0]), FT(n[1]), FT(n[2])};
  }
  if constexpr (has_normal_v<typename Average::Value>)
    return result.value.normal;
  else
    return zero_vector<FT, 3>();
}

// Writes limits into the maps of a mesh, and puts the old values back if that fails.
template <class Scheme, class Access, class Point_map, class Normal_map, class Results>
void write_limits(const Access& access, Point_map points, Normal_map normals,
                  const Results& results, const Limit_options& options)
{
  using Index = Level_connectivity::Index;
  const bool moves = asks_for_points(options), surface_normals = options.surface_normals;
  const bool puts_normals = is_pn_v<Scheme> || surface_normals;
  const std::size_t n = results.size();
  Undoable_map<Access, Point_map, Vertex_of_mesh> new_points(access, points, moves ? n : 0);
  Undoable_map<Access, Normal_map, Vertex_of_mesh> new_normals(access, normals,
                                                               puts_normals ? n : 0);
  new_points.begin();
  new_normals.begin();
  for (Index v = 0; v < n; ++v) {
    if (moves) new_points.set_vector(v, point_of(results[v].value));
    if constexpr (is_there_v<Normal_map>)
      if (puts_normals) new_normals.set_vector(v, limit_normal(results[v], surface_normals));
  }
  new_points.commit();
  new_normals.commit();
}

// A map of limits that writes what the call has maps for: points, normals and errors.
template <class Key, class Kernel, class NamedParameters>
struct Limit_maps
{
  using key_type = Key;
  using value_type = Limit_point<Kernel>;
  using reference = void;
  using category = boost::writable_property_map_tag;

  friend void put(const Limit_maps& maps, const Key& key, const value_type& limit)
  {
    maps.template write<limit_point_map_t>(key, limit.point);
    maps.template write<limit_normal_map_t>(key, limit.surface_normal);
    maps.template write<limit_error_map_t>(key, limit.error);
  }
  template <class Tag, class Value>
  void write([[maybe_unused]] const Key& key, [[maybe_unused]] const Value& value) const
  {
    if constexpr (is_given_v<Tag, NamedParameters>) {
      const auto map = parameters::get_parameter(np, Tag());
      if constexpr (Check_map<Tag>::template check<std::decay_t<decltype(map)>, Key,
                                                   NamedParameters, Writable>())
        put(map, key, value);
    }
  }

  const NamedParameters& np;
};

// the map of a parameter; of one that is refused elsewhere, since its keys are no vertices, there is none
template <class Tag, class Access, class NamedParameters>
auto undoable_map_of_vertices(const Access& access, [[maybe_unused]] const NamedParameters& np)
{
  using Map = Parameter_type<Tag, NamedParameters>;
  if constexpr (is_property_map_of_v<Map, typename Access::vertex_descriptor>)
    return Undoable_map<Access, Map, Vertex_of_mesh>(
      access, parameter_or<Tag>(np), static_cast<std::size_t>(access.size().vertices));
  else
    return Undoable_map<Access, Not_given, Vertex_of_mesh>(access, {});
}

// The writer for a mesh that is moved to its limit: values in maps that can be read are taken back, unless commit() is called.
template <class Access, class Kernel, class NamedParameters>
class Limit_maps_writer
{
  using Vertex = typename Access::vertex_descriptor;

  template <class Tag>
  using Undoable = decltype(undoable_map_of_vertices<Tag>(std::declval<const Access&>(),
                                                          std::declval<const NamedParameters&>()));

public:
  static constexpr bool is_any_given = is_given_v<limit_point_map_t, NamedParameters> ||
                                       is_given_v<limit_normal_map_t, NamedParameters> ||
                                       is_given_v<limit_error_map_t, NamedParameters>;

  Limit_maps_writer(const Access& access, const NamedParameters& np)
    : access_(access)
    , np_(np)
    , points_(undoable_map_of_vertices<limit_point_map_t>(access, np))
    , normals_(undoable_map_of_vertices<limit_normal_map_t>(access, np))
    , errors_(undoable_map_of_vertices<limit_error_map_t>(access, np))
  {}

  template <class Results>
  void write([[maybe_unused]] const Results& results,
             [[maybe_unused]] Level_connectivity::Index number_of_vertices)
  {
    if constexpr (is_any_given) {
      points_.begin();
      normals_.begin();
      errors_.begin();
      const Limit_maps<Vertex, Kernel, NamedParameters> maps{np_};
      for (Level_connectivity::Index v = 0; v < number_of_vertices; ++v)
        put(maps, access_.vertex(v), to_limit_point<Limit_point<Kernel>>(results[v]));
    }
  }
  void commit()
  {
    points_.commit();
    normals_.commit();
    errors_.commit();
  }

private:
  const Access& access_;
  const NamedParameters& np_;
  Undoable<limit_point_map_t> points_;
  Undoable<limit_normal_map_t> normals_;
  Undoable<limit_error_map_t> errors_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WRITER_H
