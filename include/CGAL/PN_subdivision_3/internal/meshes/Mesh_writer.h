// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_WRITER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_WRITER_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Map>
constexpr bool is_writable_map_v =
  std::is_convertible_v<typename boost::property_traits<Map>::category,
                        boost::writable_property_map_tag>;

// whether refined roundness is put into a map
template <class Map>
constexpr bool is_writable_roundness_v = is_writable_map_v<Map>;
template <>
inline constexpr bool is_writable_roundness_v<No_roundness> = false;

// The values that a map has for the old elements, to be put back.
template <class Map, class Element>
class Old_values
{
public:
  using Index = Level_connectivity::Index;
  using Value = std::decay_t<typename boost::property_traits<Map>::value_type>;

  template <class Access>
  Old_values(const Access& access, std::size_t number, Map map)
    : map_(map)
  {
    values_.reserve(number);
    for (Index i = 0; i < number; ++i) values_.push_back(get(map_, Element::at(access, i)));
  }

  Index size() const { return static_cast<Index>(values_.size()); }
  Value operator[](Index i) const { return values_[i]; }

  // a map that throws here too keeps what it has, as does one that is only read
  template <class Access>
  void put_back([[maybe_unused]] const Access& access) noexcept
  {
    if constexpr (is_writable_map_v<Map>)
      for (Index i = 0; i < values_.size(); ++i) try {
          put(map_, Element::at(access, i), Value(values_[i]));
        } catch (...) {
        }
  }

private:
  Map map_;
  std::vector<Value> values_;
};

struct No_old_values
{
  template <class Access, class Map>
  No_old_values(const Access&, std::size_t, Map)
  {}
  template <class Access>
  void put_back(const Access&) noexcept
  {}
};
template <class Map, class Not_given>
using Old_values_if_given = std::conditional_t<std::is_same_v<Map, Not_given>, No_old_values,
                                               Old_values<Map, Vertex_of_mesh>>;

// Lets a mesh grow and puts points, normals and roundness of its new vertices. Unless keep() is called, the mesh
// and its maps get back what they had.
template <class Value, class Access, class Point_map, class Normal_map,
          class Roundness_map = No_roundness>
class Mesh_writer
{
  static constexpr bool has_roundness_map = is_writable_roundness_v<Roundness_map>;
  static constexpr bool has_normal_map = !std::is_same_v<Normal_map, No_normal_map>;

public:
  using Index = Level_connectivity::Index;

  // the maps are those of a Surface_mesh
  static constexpr bool has_own_maps =
    has_concurrent_put_v<Point_map> && (!has_normal_map || has_concurrent_put_v<Normal_map>)&&(
                                         !has_roundness_map || has_concurrent_put_v<Roundness_map>);

  Mesh_writer(Access& access, Point_map points, Normal_map normals, bool is_near_overflow,
              Roundness_map roundness = Roundness_map())
    : access_(access)
    , points_(points)
    , normals_(normals)
    , roundness_(roundness)
    , is_near_overflow_(is_near_overflow)
    , number_of_old_vertices_(static_cast<Index>(access.size().vertices))
    , old_points_(access, number_of_old_vertices_, points)
    , old_normals_(access, number_of_old_vertices_, normals)
    , old_roundness_(access, number_of_old_vertices_, roundness)
  {}
  ~Mesh_writer()
  {
    if (is_kept_) return;
    if (old_values_put_) {
      old_points_.put_back(access_);
      old_normals_.put_back(access_);
      old_roundness_.put_back(access_);
    }
    access_.shrink();
  }
  Mesh_writer(const Mesh_writer&) = delete;
  Mesh_writer& operator=(const Mesh_writer&) = delete;

  Index number_of_old_vertices() const { return number_of_old_vertices_; }
  // to be called before the first old vertex is put
  void begin_old_vertices() { old_values_put_ = true; }
  void keep() { is_kept_ = true; }

  // values of the vertices from `first` on
  void put_values(Index first, const Value* values, Index number) const
  {
    using Point = typename boost::property_traits<Point_map>::value_type;
    for (Index i = 0; i < number; ++i) {
      const auto v = access_.vertex(first + i);
      const auto& p = point_of(values[i]);
      if (is_near_overflow_)
        check_in_range(p,
                       [&] { return "the point of the new vertex " + std::to_string(first + i); });
      put(points_, v, Point(p[0], p[1], p[2]));
      if constexpr (has_normal_map) {
        using Normal = typename boost::property_traits<Normal_map>::value_type;
        const auto& n = values[i].normal;
        put(normals_, v, Normal(n[0], n[1], n[2]));
      }
      if constexpr (has_roundness_map) {
        using Number = std::decay_t<typename boost::property_traits<Roundness_map>::value_type>;
        put(roundness_, v, roundness_as<Number>(values[i].roundness));
      }
    }
  }

private:
  Access& access_;
  Point_map points_;
  Normal_map normals_;
  Roundness_map roundness_;
  bool is_near_overflow_;
  bool old_values_put_ = false;
  bool is_kept_ = false;
  Index number_of_old_vertices_;
  Old_values<Point_map, Vertex_of_mesh> old_points_;
  Old_values_if_given<Normal_map, No_normal_map> old_normals_;
  Old_values_if_given<Roundness_map, No_roundness> old_roundness_;
};

// whether the child of a host may be the mesh itself
template <class Access>
bool is_child_of_hosts([[maybe_unused]] const Access& access)
{
  if constexpr (Access::may_be_child_of_hosts)
    return access.is_child_of_hosts();
  else
    return false;
}

// Writes what the last round makes of the connectivity. keep() is called where nothing may fail any more. Threads
// may; then one alone repeats what they have begun.
template <class Round, class Access>
void put_connectivity(const Round& last, Access& access, const For_chunks& for_chunks,
                      Function_ref<void()> keep)
{
  std::optional<Level_connectivity> child;
  if (!is_child_of_hosts(access)) child = child_level(last, for_chunks);
  keep();
  const auto write = [&](const For_chunks& in_chunks) {
    if (child) return access.write(*child, in_chunks);
    if constexpr (Access::may_be_child_of_hosts) last.host().connect(access, in_chunks);
  };
  try {
    write(Access::has_concurrent_connectivity ? for_chunks : For_chunks());
  } catch (...) {
    write(For_chunks());
  }
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_WRITER_H
