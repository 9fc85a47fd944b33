// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_VALUES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Wedge_estimation.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
#  include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>
#endif

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Scheme, class Access, class Edge_map, class Vertex_map, class Refuse>
void refuse_sharp_elements(const Scheme& scheme, const Access& access,
                           const Level_connectivity& level, Edge_map edge_map,
                           Vertex_map vertex_map, const Refuse& refuse)
{
  using Index = Level_connectivity::Index;
  const Edge_constraints<Access, Edge_map> edges(access, edge_map, level.number_of_edges());
  const Vertex_constraints<Access, Vertex_map> vertices(access, vertex_map,
                                                        level.number_of_vertices());
  const bool has_sharp_border = Border_of<Scheme>::get(scheme) != Border::surface;
  for (Index e = 0; e < level.number_of_edges(); ++e)
    if (edges.sharpness(e) > 0 || (has_sharp_border && level.is_border_edge(e)))
      refuse(Edge_of_mesh::name(access, e));
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    if (vertices.sharpness(v) > 0) refuse(access.vertex_name(v));
}

// refuses creases at the border for functions that know surfaces without creases only
template <class Scheme, class Access>
void refuse_crease_borders(const Scheme& scheme, const Access& access,
                           const Level_connectivity& level, const std::string& what)
{
  refuse_sharp_elements(
    scheme, access, level, Not_given(), Not_given(), [&](const std::string& element) {
      throw std::invalid_argument("PN_subdivision_3: border makes " + element +
                                  " a crease, for which " + what + ": take the scheme without it");
    });
}

// whether a call tells of anything that may be sharp, or of normals of wedges
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
constexpr bool may_be_sharp_v =
  is_there_v<Edge_map> || is_there_v<Vertex_map> || Border_of<Scheme>::is_given ||
  has_crease_tangents_v<Scheme> || has_corner_normals_v<Access, Normal_map>;

// whether creases are looked for; a scheme without rules for creases refuses sharp edges and vertices
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
constexpr bool may_have_creases_v = Has_crease_rules<Scheme>::value&&
  may_be_sharp_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>;

template <class Scheme, class Access, class Normal_map>
constexpr bool check_corner_normals()
{
  constexpr bool are_taken =
    Has_crease_rules<Scheme>::value || !has_corner_normals_v<Access, Normal_map>;
  static_assert(are_taken, "PN_subdivision_3: the scheme has no rules for creases and takes a "
                           "normal per vertex, not per half-edge");
  return are_taken;
}

// Refuses sharp edges and vertices if the scheme has no rules for creases.
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
void require_crease_rules([[maybe_unused]] const Scheme& scheme,
                          [[maybe_unused]] const Access& access, const Normal_map&,
                          [[maybe_unused]] Edge_map edge_map,
                          [[maybe_unused]] Vertex_map vertex_map)
{
  if constexpr (may_be_sharp_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>) {
    if (facts_of(scheme).has_crease_rules) return;
    if constexpr (has_corner_normals_v<Access, Normal_map>)
      throw std::invalid_argument("PN_subdivision_3: " + name_in_message(scheme) +
                                  " has no rules for creases and takes a normal per vertex, not "
                                  "per half-edge");
    else
      refuse_sharp_elements(
        scheme, access, checked_level(access), edge_map, vertex_map,
        [&](const std::string& element) {
          throw std::invalid_argument(
            "PN_subdivision_3: " + element + " is sharp, but " + name_in_message(scheme) +
            " has no rules for creases: take Catmull-Clark or Loop, or their modified forms");
        });
  }
}

// Points, normals and creases of a mesh. Maps of creases are written for the refined elements, and put back unless commit()
// is called. If nothing can be sharp, there are No_creases.
template <class Scheme, class FT, class Access, class Edge_map, class Vertex_map, bool may_have_any>
class Mesh_values
{
public:
  using Index = Level_connectivity::Index;
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Level_creases = std::conditional_t<may_have_any, Creases<FT>, No_creases>;

  Mesh_values(const Scheme& scheme, const Access& access, const Level_connectivity& level,
              Edge_map edge_map, Vertex_map vertex_map)
    : scheme_(scheme)
    , access_(access)
    , edges_(access, used<may_have_any>(edge_map), level.number_of_edges())
    , vertices_(access, used<may_have_any>(vertex_map), level.number_of_vertices())
    , tangents_(access, level, used<has_tangents>(crease_tangents(scheme)))
  {}

  // the creases of a level, without their tangents
  Level_creases creases(const Level_connectivity& level) const
  {
    if constexpr (may_have_any)
      return Make_creases<FT>(level, Border_of<Scheme>::get(scheme_))(
        [&](Index e) { return edges_.sharpness(e); },
        [&](Index v) { return vertices_.sharpness(v); });
    else
      return No_creases(level.number_of_vertices());
  }
  // the given tangents
  void read_tangents(Creases<FT>& creases) const { tangents_.read(creases); }
  void read_tangents(No_creases) const {}

  // the values of the slots, and the tangents that are missing
  template <class Point_map, class Normal_map>
  std::vector<Value> values(const Level_connectivity& level, Point_map points, Normal_map normals,
                            Creases<FT>& creases) const
  {
    if constexpr (is_pn_v<Scheme> && creases_may_end_v<Scheme>)
      if (!has_corner_normals_v<Access, Normal_map> || !goes_on(creases))
        keep_without_fractions<FT>(level, creases, [&](Creases<FT>& others) {
          return values_of_slots(level, points, normals_without_fractions(normals), others);
        });
    return values_of_slots(level, points, normals, creases);
  }
  template <class Point_map, class Normal_map>
  std::vector<Value> values(const Level_connectivity& level, Point_map points, Normal_map normals,
                            No_creases) const
  {
    auto values = read_values<Average>(access_, level, points, normals, normal_estimate(scheme_));
    put_given_roundness(scheme_, level.number_of_vertices(), values);
    return values;
  }

  // the sharpness besides the seams of attributes
  Control_sharpness sharpness(const Level_connectivity& level) const
  {
    Control_sharpness result;
    if constexpr (!may_have_any) return result;
    result.border = Border_of<Scheme>::get(scheme_);
    for (Index e = 0; e < level.number_of_edges(); ++e) result.edges.push_back(edges_.sharpness(e));
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      result.vertices.push_back(vertices_.sharpness(v));
    return result;
  }

  // \name The refined mesh

  // Puts the rest of the user's sharpness after some rounds; a border that is a crease by the scheme's rule
  // is not the user's.
  void put_sharpness(const Creases<FT>& creases, const Level_size& size, unsigned rounds)
  {
    std::vector<std::pair<Index, std::pair<Index, double>>> tagged;
    for (const Crease_edge<FT>& e : creases.edges)
      if (edges_.sharpness(e.control_edge) > 0)
        tagged.push_back({e.edge, {e.control_edge, e.sharpness}});
    edges_.put_refined(static_cast<Index>(size.edges), tagged);
    tagged.clear();
    for (Index v = 0; v < vertices_.number_of_old(); ++v) {
      double s = vertices_.sharpness(v);
      for (unsigned k = 0; k < rounds && s > 0; ++k) s = refined_sharpness(s);
      if (s > 0) tagged.push_back({v, {v, s}});
    }
    vertices_.put_refined(static_cast<Index>(size.vertices), tagged);
  }
  void put_sharpness(No_creases, const Level_size&, unsigned) const {}
  void put_tangents(const Creases<FT>& creases, const Level_size& size)
  {
    tangents_.put_refined(creases, static_cast<Index>(size.edges));
  }
  void put_tangents(No_creases, const Level_size&) const {}
  void commit()
  {
    edges_.commit();
    vertices_.commit();
    tangents_.commit();
  }

private:
  // without creases no map is read, and a linear scheme has no use for tangents
  static constexpr bool has_tangents = may_have_any && is_pn_v<Scheme>;
  template <bool is_used, class Map>
  using Used_map = std::conditional_t<is_used, Map, Not_given>;
  template <bool is_used, class Map>
  static Used_map<is_used, Map> used([[maybe_unused]] const Map& map)
  {
    if constexpr (is_used)
      return map;
    else
      return {};
  }

  // Whether what ends has a past: who carries normals of wedges from call to call carries tangents, too.
  static bool goes_on(const Creases<FT>& creases)
  {
    const auto is_old = [](const Crease_edge<FT>& e) {
      const auto is_given = [](const Coordinates<FT, 3>& t) {
        return !is_zero(to_double_3<FT>(t));
      };
      return is_fraction(e.sharpness) &&
             (is_given(e.tangent_from[0]) || is_given(e.tangent_from[1]));
    };
    return std::any_of(creases.edges.begin(), creases.edges.end(), is_old);
  }

  template <class Point_map, class Normal_map>
  std::vector<Value> values_of_slots(const Level_connectivity& level, Point_map points,
                                     [[maybe_unused]] Normal_map normals,
                                     Creases<FT>& creases) const
  {
    const Index n = level.number_of_vertices();
    std::vector<Value> values(creases.number_of_slots);
    for (Index v = 0; v < n; ++v) point_of(values[v]) = checked_point<FT>(access_, points, v);
    const std::vector<Index> extra = vertices_of_extra_slots(creases, n);
    for (std::size_t i = 0; i < extra.size(); ++i)
      point_of(values[n + i]) = point_of(values[extra[i]]);
    if constexpr (is_pn_v<Scheme>) {
      std::vector<bool> is_given(values.size(), false);
      for (Value& value : values) value.normal = zero_vector<FT, 3>();
      if constexpr (has_corner_normals_v<Access, Normal_map>) {
        read_corner_normals<FT>(access_, level, creases, normals, values, &is_given);
        if constexpr (is_of_estimate_v<Normal_map>)
          make_control_tangents(level, creases, values, is_given,
                                normal_estimate(scheme_) == Control_normal_estimate::coherent);
        is_given.assign(values.size(), true);
      } else if constexpr (is_there_v<Normal_map>) {
        std::fill_n(is_given.begin(), n, true);
        for (const Crease_star& star : creases.stars)
          if (star.number_of_wedges > 1) is_given[star.vertex] = false;
        std::vector<Value> given(n);
        read_normals<FT>(access_, normals, given);
        for (Index v = 0; v < n; ++v)
          if (is_given[v]) values[v].normal = given[v].normal;
      }
      estimate_wedges<FT>(level, creases, values, is_given, normal_estimate(scheme_));
      if constexpr (!goes_with_roundness_v<Normal_map>)
        put_given_roundness(scheme_, n, values, &is_given, extra);
    }
    return values;
  }

  const Scheme& scheme_;
  const Access& access_;
  Edge_constraints<Access, Used_map<may_have_any, Edge_map>> edges_;
  Vertex_constraints<Access, Used_map<may_have_any, Vertex_map>> vertices_;
  Crease_tangents<FT, Access, Used_map<has_tangents, Crease_tangent_map<Scheme>>> tangents_;
};

// What functions read of a mesh: its level, checked, what its maps tell, and its creases, which lack their tangents.
template <class Scheme, class FT, class Access, class Normal_map, class Edge_map, class Vertex_map>
struct Control_mesh
{
  Control_mesh(const Scheme& scheme, const Access& access, const Normal_map&, Edge_map edge_map,
               Vertex_map vertex_map, FT)
    : level(checked_level(access))
    , maps((check_scheme<Scheme, Element_names>(scheme, level, access), scheme), access, level,
           edge_map, vertex_map)
    , creases(maps.creases(level))
  {}

  using Maps = Mesh_values<Scheme, FT, Access, Edge_map, Vertex_map,
                           may_have_creases_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>>;
  using Level_creases = typename Maps::Level_creases;

  Level_connectivity level;
  Maps maps;
  Level_creases creases;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_VALUES_H
