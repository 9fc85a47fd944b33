// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_FITTING_3_INTERNAL_CREASED_INTERPOLATION_H
#define CGAL_PN_FITTING_3_INTERNAL_CREASED_INTERPOLATION_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/interpolate_mesh.h>
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The limits of the points of vertices on a surface with creases, with the normals of the wedges and the tangents of the
// creases as they are.
template <class Scheme>
class Creased_limit_points
{
public:
  using Index = Level_connectivity::Index;
  using Level = Valued_level<typename Average_of_scheme<Scheme, double>::Value>;

  // `level` has the values of the slots, `vertex_of_slot` the vertices of the slots; the vertices of the data are sorted
  Creased_limit_points(const Scheme& scheme, Level& level, const Creases<double>& creases,
                       const std::vector<Index>& vertex_of_slot, const Interpolation_data<3>& data,
                       const For_chunks& for_chunks)
    : scheme_(scheme)
    , level_(level)
    , creases_(creases)
    , vertex_of_slot_(vertex_of_slot)
    , data_(data)
    , for_chunks_(for_chunks)
  {}

  // Puts the limit points of the data's vertices in place of their control points.
  void operator()(Vectors<3>& points, double tolerance, Limit_interpolation* report) const
  {
    for (std::size_t slot = 0; slot < level_.values.size(); ++slot)
      point_of(level_.values[slot]) = to_coordinates<3>(points[vertex_of_slot_[slot]]);
    Limit_demand demand;
    demand.tolerance = tolerance;
    demand.max_depth = data_.max_depth;
    Creases<double> creases = creases_; // whose tangents become those of the limit
    constexpr bool points_alone = asks_for_points_alone<parameters::Default_named_parameters>();
    const auto results = limits_at_slots<double, points_alone>(scheme_, demand, for_chunks_, level_,
                                                               creases, 1, &data_.vertices);
    if (report != nullptr) report->error = report->depth = 0;
    for (const Index v : data_.vertices) {
      points[v] = to_eigen<3>(point_of(results[v].value));
      if (report == nullptr) continue;
      report->error = (std::max)(report->error, results[v].error);
      report->depth = (std::max)(report->depth, results[v].depth);
    }
  }

private:
  const Scheme& scheme_;
  Level& level_;
  const Creases<double>& creases_;
  const std::vector<Index>& vertex_of_slot_;
  const Interpolation_data<3>& data_;
  For_chunks for_chunks_;
};

template <class FT>
Creases<double> in_double(const Creases<FT>& creases)
{
  if constexpr (std::is_same_v<FT, double>)
    return creases;
  else {
    Creases<double> result;
    for (const Crease_edge<FT>& e : creases.edges) {
      const auto& [t, u] = e.tangent_from;
      result.edges.push_back({e.edge, e.control_edge, e.sharpness, e.border_side, e.after, e.before,
                              std::array{to_double_3(t), to_double_3(u)}});
    }
    result.ends = creases.ends;
    result.stars = creases.stars;
    result.number_of_slots = creases.number_of_slots;
    result.has_fixed_border = creases.has_fixed_border;
    return result;
  }
}

template <class Scheme, class FT, class Value>
auto slots_in_double(const std::vector<Value>& values)
{
  std::vector<typename Average_of_scheme<Scheme, double>::Value> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    point_of(result[i]) = to_double_3(point_of(values[i]));
    if constexpr (is_pn_v<Scheme>) {
      result[i].normal = to_double_3(values[i].normal);
      result[i].roundness = CGAL::to_double(values[i].roundness);
    }
  }
  return result;
}

// What stays that of the data has to reach the calls that refine the result.
template <class Scheme, class FT, class Access, class Normal_map>
void require_fixed_creases([[maybe_unused]] const Access& access,
                           [[maybe_unused]] const Creases<FT>& creases, const Normal_map&)
{
  if constexpr (is_pn_v<Scheme>) {
    if (!has_crease_tangents_v<Scheme> && !creases.edges.empty())
      throw std::invalid_argument(
        "PN_subdivision_3: " + Edge_of_mesh::name(access, creases.edges.front().edge) +
        " is sharp, and the result is interpolated with the tangents of the data: take "
        "a crease_tangent_map, with which the result is refined, too");
    if constexpr (!has_corner_normals_v<Access, Normal_map>)
      for (const Crease_star& star : creases.stars)
        if (star.number_of_wedges > 1)
          throw std::invalid_argument(
            "PN_subdivision_3: " + access.vertex_name(star.vertex) +
            " has a normal on each side of its creases, which has to stay that of the data: give "
            "a vertex_normal_map of half-edges, see estimate_control_normals()");
  }
}

// what a call tells of that is sharp, or that it has normals of wedges; empty if there is neither
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
std::string what_is_sharp(const Scheme& scheme, const Access& access,
                          const Level_connectivity& level, const Normal_map&, Edge_map edge_map,
                          Vertex_map vertex_map)
{
  std::string what;
  refuse_sharp_elements(scheme, access, level, edge_map, vertex_map,
                        [&](const std::string& element) {
                          if (what.empty()) what = element + " is sharp";
                        });
  if (what.empty() && has_corner_normals_v<Access, Normal_map>) what = "corners have normals";
  return what;
}

template <class Options>
void require_creased_options(const Options& options, const std::string& what_is_sharp)
{
  const auto require = [&](bool is_so, const std::string& what) {
    if (!is_so)
      throw std::invalid_argument("PN_subdivision_3: " + what_is_sharp + ", but " + what +
                                  ": take Limit_interpolation::Mode::strict with given "
                                  "normals and Limit_interpolation::Free::fixed, or make all edges "
                                  "and vertices smooth");
  };
  require(options.mode == Limit_interpolation::Mode::strict,
          "control points slide on surfaces without creases only");
  require(options.normals == Limit_interpolation::Normals::given,
          "control normals are found on surfaces without creases only");
  require(options.free == Limit_interpolation::Free::fixed,
          "control points move along on surfaces without creases only");
}

// Reads a mesh with edges that are sharp forever, interpolates, and writes the control points, the normals of the wedges
// and the tangents of the creases. is_interpolated(v) tells the vertices.
template <class FT, class Access, class Scheme, class Mesh, class NamedParameters, class Options,
          class Is_interpolated>
Limit_interpolation
interpolate_with_creases(const Access& access, const Scheme& given_scheme,
                         const Level_connectivity& level, Mesh& mesh, const NamedParameters& np,
                         const Options& options, const std::string& what_is_sharp,
                         const For_chunks& for_chunks, const Is_interpolated& is_interpolated)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  const auto normals = Parameters::normal_map(np);
  const auto points = Parameters::point_map(mesh, np);
  using Normal_map = std::decay_t<decltype(normals)>;
  check_scheme(given_scheme, level, access);
  const Given_roundness<FT> roundness = read_roundness<FT, Parameters>(access, np);
  using Scheme_of_call = With_roundness<Scheme, FT>;
  const Scheme_of_call scheme{{given_scheme}, &roundness};
  const auto edge_map = Parameters::edge_constraint_map(np);
  const auto vertex_map = Parameters::vertex_constraint_map(np);
  require_crease_rules(scheme, access, normals, edge_map, vertex_map);
  Mesh_values<Scheme_of_call, FT, Access, std::decay_t<decltype(edge_map)>,
              std::decay_t<decltype(vertex_map)>, true>
    of_mesh(scheme, access, level, edge_map, vertex_map);
  Creases<FT> creases = of_mesh.creases(level);
  require_sharp_for_ever<FT>(access, creases, 0);
  require_creased_options(options, what_is_sharp);
  require_fixed_creases<Scheme>(access, creases, normals);
  of_mesh.read_tangents(creases);
  const auto values = of_mesh.values(level, points, normals, creases);

  Interpolation_data<3> data;
  const Level_connectivity::Index n = level.number_of_vertices();
  for (Level_connectivity::Index v = 0; v < n; ++v) {
    data.points.push_back(to_eigen<3>(to_double_3(point_of(values[v]))));
    if (is_interpolated(v)) data.vertices.push_back(v);
  }
  divide_by_size(data);
  set_demand(options, data);
  std::vector<Level_connectivity::Index> vertex_of_slot(n);
  std::iota(vertex_of_slot.begin(), vertex_of_slot.end(), Level_connectivity::Index(0));
  const auto extra = vertices_of_extra_slots(creases, n);
  vertex_of_slot.insert(vertex_of_slot.end(), extra.begin(), extra.end());
  Valued_level<typename Average_of_scheme<Scheme_of_call, double>::Value> valued{
    level, slots_in_double<Scheme_of_call, FT>(values)};
  const Creases<double> fixed = in_double(creases);
  const auto rules = rules_of(scheme);
  auto result =
    interpolate_creased<3>(data, Creased_limit_points<Rules_of<Scheme_of_call>>(
                                   rules, valued, fixed, vertex_of_slot, data, for_chunks));
  multiply_by_size<FT>(data, result);

  Undoable_vertices<Access, std::decay_t<decltype(points)>> new_points(access, points);
  put_changed<FT>(new_points, data.points, result.points);
  using Writers = Normal_writers<Access, Normal_map>;
  typename Writers::Corner_writer corners(access, level, normals);
  if constexpr (Writers::Corner_writer::takes_corners && is_pn_v<Scheme>)
    corners.put_all(level, creases, values);
  of_mesh.put_tangents(creases, level.size());
  new_points.keep();
  corners.keep();
  of_mesh.keep();
  return result.report;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_CREASED_INTERPOLATION_H
