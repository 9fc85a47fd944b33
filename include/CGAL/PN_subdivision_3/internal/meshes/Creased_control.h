// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASED_CONTROL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASED_CONTROL_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/control_creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Wedge_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/tangent_maps.h>
#include <CGAL/PN_subdivision_3/schemes/normal_estimate.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>
#include <CGAL/PN_subdivision_3/schemes/with_crease_tangents.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// whether a call tells of anything that may be sharp, or of normals of wedges
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
constexpr bool may_be_creased_v =
  is_constraint_map_v<Edge_map> || is_constraint_map_v<Vertex_map> || Border_of<Scheme>::is_given ||
  has_crease_tangents_v<Scheme> || is_of_halfedges_v<Access, Normal_map>;

// the map of vertices that takes normals of a map, and what takes those of its corners
struct Nothing_of_corners
{
  template <class Access, class Map>
  Nothing_of_corners(const Access&, const Level_connectivity&, Map)
  {}
  void keep() {}
};
template <class Access, class Map, bool is_of_halfedges = is_of_halfedges_v<Access, Map>>
struct Normal_writers
{
  using Vertex_map = Map;
  using Corner_writer = Nothing_of_corners;
  static Vertex_map vertex_map(const Map& map) { return map; }
};
template <class Access, class Map>
struct Normal_writers<Access, Map, true>
{
  using Vertex_map = No_normal_map;
  using Corner_writer = Corner_normal_writer<Access, Map>;
  static Vertex_map vertex_map(const Map&) { return {}; }
};
template <class Access, class Corners, class Vertices>
struct Normal_writers<Access, Wedge_normals<Corners, Vertices>, true>
{
  using Map = Wedge_normals<Corners, Vertices>;
  using Vertex_map = Vertices;
  using Corner_writer = Wedge_normal_writer<Access, Map>;
  static Vertex_map vertex_map(const Map& map) { return map.vertices; }
};

// What the maps of a mesh with creases tell of it, and what is written to those of its sharpness.
template <class Scheme, class FT>
class Creased_control
{
  static constexpr bool is_pn = !Is_linear<Scheme>::value;

public:
  using Index = Level_connectivity::Index;

  template <class Edges, class Vertices>
  static Creases<FT> make_creases(const Scheme& scheme, const Level_connectivity& level,
                                  const Edges& edges, const Vertices& vertices)
  {
    return Make_creases<FT>(level, Border_of<Scheme>::get(scheme))(
      [&](Index e) { return edges.sharpness(e); }, [&](Index v) { return vertices.sharpness(v); });
  }

  // a linear scheme has no use for tangents either
  static auto tangent_map([[maybe_unused]] const Scheme& scheme)
  {
    if constexpr (is_pn)
      return crease_tangents(scheme);
    else
      return No_tangent_map();
  }
  template <class Access>
  using Tangents =
    Crease_tangents<FT, Access,
                    std::conditional_t<is_pn, Crease_tangent_map<Scheme>, No_tangent_map>>;

  template <class Access, class Normal_map>
  using Vertex_normal_map = typename Normal_writers<Access, Normal_map>::Vertex_map;
  template <class Access, class Normal_map>
  using Corner_writer = typename Normal_writers<Access, Normal_map>::Corner_writer;
  template <class Access, class Normal_map>
  static Vertex_normal_map<Access, Normal_map> make_vertex_normal_map(const Normal_map& normals)
  {
    return Normal_writers<Access, Normal_map>::vertex_map(normals);
  }

  // the values of the slots, and the tangents that are missing
  template <class Control_value, class Access, class Point_map, class Normal_map>
  static std::vector<Control_value> read(const Scheme& scheme, const Access& access,
                                         const Level_connectivity& level, Point_map points,
                                         [[maybe_unused]] Normal_map normals, Creases<FT>& creases)
  {
    const Index n = level.number_of_vertices();
    std::vector<Control_value> values(creases.number_of_slots);
    for (Index v = 0; v < n; ++v) point_of(values[v]) = checked_point<FT>(access, points, v);
    const std::vector<Index> extra = vertices_of_extra_slots(creases, n);
    for (std::size_t i = 0; i < extra.size(); ++i)
      point_of(values[n + i]) = point_of(values[extra[i]]);
    if constexpr (is_pn) {
      std::vector<bool> is_given(values.size(), false);
      for (Control_value& value : values) value.normal = zero_vector<FT, 3>();
      if constexpr (is_of_halfedges_v<Access, Normal_map>) {
        is_given.assign(values.size(), true);
        read_corner_normals<FT>(access, level, creases, normals, values);
      } else if constexpr (!std::is_same_v<Normal_map, No_normal_map>) {
        std::fill_n(is_given.begin(), n, true);
        for (const Crease_star& star : creases.stars)
          if (star.number_of_wedges > 1) is_given[star.vertex] = false;
        read_vertex_normals(access, normals, is_given, n, values);
      }
      Control_creases<FT>(level, creases, values, is_given, normal_estimate(scheme))();
    }
    return values;
  }

  // what the user has tagged; the border that is a crease by the scheme's rule is not
  template <class Edges, class Vertices>
  static void put_constraints(const Creases<FT>& creases, const Level_size& size, Edges& edges,
                              Vertices& vertices, unsigned rounds)
  {
    std::vector<std::pair<Index, std::pair<Index, double>>> tagged;
    for (const Crease_edge<FT>& e : creases.edges)
      if (edges.sharpness(e.control_edge) > 0)
        tagged.push_back({e.edge, {e.control_edge, e.sharpness}});
    edges.put_refined(static_cast<Index>(size.edges), tagged);
    tagged.clear();
    for (Index v = 0; v < vertices.number_of_old(); ++v) {
      double s = vertices.sharpness(v);
      for (unsigned k = 0; k < rounds && s > 0; ++k) s = refined_sharpness(s);
      if (s > 0) tagged.push_back({v, {v, s}});
    }
    vertices.put_refined(static_cast<Index>(size.vertices), tagged);
  }

private:
  template <class Access, class Normal_map>
  static void read_vertex_normals(const Access& access, Normal_map normals,
                                  const std::vector<bool>& is_given, Index n,
                                  std::vector<Point_normal<FT, 3>>& values)
  {
    std::vector<Point_normal<FT, 3>> given(n);
    read_normals<FT>(access, normals, given);
    for (Index v = 0; v < n; ++v)
      if (is_given[v]) values[v].normal = given[v].normal;
  }
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASED_CONTROL_H
