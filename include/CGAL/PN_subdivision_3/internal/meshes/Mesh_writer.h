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
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Lets a mesh grow and puts points, normals and roundness of its new vertices. Unless commit() is called, the mesh
// and its maps get back their old values.
template <class Value, class Access, class Point_map, class Normal_map,
          class Roundness_map = Not_given>
class Mesh_writer
{
  static constexpr bool has_roundness_map = is_writable_map_v<Roundness_map>;
  static constexpr bool has_normal_map = is_there_v<Normal_map>;

public:
  using Index = Level_connectivity::Index;

  // whether the maps belong to a Surface_mesh
  static constexpr bool has_own_maps =
    has_concurrent_put_v<Point_map> && (!has_normal_map || has_concurrent_put_v<Normal_map>)&&(
                                         !has_roundness_map || has_concurrent_put_v<Roundness_map>);

  Mesh_writer(Access& access, Point_map points, Normal_map normals, bool is_near_overflow,
              Roundness_map roundness = Roundness_map())
    : is_near_overflow_(is_near_overflow)
    , number_of_old_vertices_(static_cast<Index>(access.size().vertices))
    , growth_(access)
    , points_(access, points, number_of_old_vertices_)
    , normals_(access, normals, number_of_old_vertices_)
    , roundness_(access, roundness, number_of_old_vertices_)
  {}

  Index number_of_old_vertices() const { return number_of_old_vertices_; }
  // to be called before the first old vertex is put
  void begin_old_vertices()
  {
    points_.begin();
    normals_.begin();
    roundness_.begin();
  }
  void commit()
  {
    growth_.commit();
    points_.commit();
    normals_.commit();
    roundness_.commit();
  }

  // values of the vertices from `first` on
  void put_values(Index first, const Value* values, Index number) const
  {
    for (Index i = 0; i < number; ++i) {
      const Index v = first + i;
      const auto& p = point_of(values[i]);
      if (is_near_overflow_)
        check_in_range(p, [&] { return "the point of the new vertex " + std::to_string(v); });
      points_.set_vector(v, p);
      if constexpr (has_normal_map) normals_.set_vector(v, values[i].normal);
      if constexpr (has_roundness_map) {
        using Number = std::decay_t<typename boost::property_traits<Roundness_map>::value_type>;
        roundness_.set(v, roundness_as<Number>(values[i].roundness));
      }
    }
  }

private:
  bool is_near_overflow_;
  Index number_of_old_vertices_;
  Growth<Access> growth_;
  Undoable_map<Access, Point_map, Vertex_of_mesh> points_;
  Undoable_map<Access, Normal_map, Vertex_of_mesh> normals_;
  Undoable_map<Access, Roundness_map, Vertex_of_mesh> roundness_;
};

// Writes what the last round makes of the connectivity. commit() is called where nothing may fail any more. Threads
// may; then one alone repeats what they have begun.
template <class Round, class Access>
void put_connectivity(const Round& last, Access& access, const For_chunks& for_chunks,
                      Function_ref<void()> commit)
{
  std::optional<Level_connectivity> child;
  if (!access.is_child_of_hosts()) child = child_level(last, for_chunks);
  commit();
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

// Makes an empty mesh one with the connectivity of a level, with points and normals, and with what put_others() puts.
template <class Access, class Point_map, class Point, class Normal_map, class Vector,
          class Function>
void build_mesh(Access& access, const Level_connectivity& level, Point_map point_map,
                const std::vector<Point>& points, [[maybe_unused]] Normal_map normal_map,
                [[maybe_unused]] const std::vector<Vector>& normals, const Function& put_others)
{
  using Index = Level_connectivity::Index;
  const Level_size size = level.size(), old_size = access.size();
  if (old_size.vertices != 0 || old_size.edges != 0 || old_size.faces != 0)
    throw std::invalid_argument("PN_subdivision_3: the mesh to be built has vertices already: it "
                                "must be empty");
  if (size.halfedges() >= Access::index_limit() || size.vertices >= Access::index_limit())
    throw std::length_error("PN_subdivision_3: the refined mesh has " +
                            std::to_string(size.halfedges()) +
                            " half-edges, more than the index type of the mesh can number");
  Growth<Access> growth(access);
  access.grow(size);
  for (Index v = 0; v < points.size(); ++v) {
    put(point_map, access.vertex(v), points[v]);
    if constexpr (is_there_v<Normal_map>)
      if (v < normals.size()) put(normal_map, access.vertex(v), normals[v]);
  }
  put_others();
  access.write(level, For_chunks());
  growth.commit();
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_WRITER_H
