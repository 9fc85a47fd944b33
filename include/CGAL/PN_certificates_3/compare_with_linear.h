// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_COMPARE_WITH_LINEAR_H
#define CGAL_PN_CERTIFICATES_3_COMPARE_WITH_LINEAR_H

#include <CGAL/PN_certificates_3/internal/Compared_level.h>
#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

how a refined mesh compares with the one that the linear twin of its scheme gives, as `compare_with_linear()` measures
it.
*/
struct Comparison_with_linear
{
  /// that of a volume that there is not.
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  /// whether the control mesh and the result have faces and no border; volumes are measured of no others.
  bool is_closed = false;
  /// the volume that the control mesh encloses, negative if its faces are inside out; infinite or 0 if `double` cannot
  /// hold it.
  double control_volume = none;
  /// the volume of the result, divided by that of the control mesh; `none` if that encloses no volume but rounding.
  double volume_ratio = none;
  /// the same of the linear result.
  double linear_volume_ratio = none;

  /// edges of the result that are not sharp and at which the surface folds by more than 90 degrees.
  std::size_t folded_edges = 0;
  /// the same of the linear result.
  std::size_t linear_folded_edges = 0;
  /// edges of the result that are not sharp and at which the surface folds by more than 150 degrees.
  std::size_t sharply_folded_edges = 0;
  /// the same of the linear result.
  std::size_t linear_sharply_folded_edges = 0;

  /// the largest distance of a vertex from the one of the linear result, divided by the mean length of the edges of that.
  double largest_distance = 0;
  /// the number of this vertex.
  std::size_t farthest_vertex = 0;

  /// vertices of the control mesh.
  std::size_t control_vertices = 0;
  /// control vertices of roundness 0, if the roundness varies; else 0.
  std::size_t vertices_of_roundness_0 = 0;
  /// the same of a roundness below 1.
  std::size_t vertices_of_roundness_below_1 = 0;
  /// control edges that are not sharp and turn by more than 40 degrees: what `detect_creases()` finds beyond those that
  /// are sharp.
  std::size_t turning_edges = 0;

  /// \f$ |\ln V| > |\ln V_{\mathrm{linear}}| + 0.05 \f$ with the two ratios of the volumes \f$ V \f$; `false` if there
  /// are none.
  bool is_swollen() const { return change(volume_ratio) > change(linear_volume_ratio) + 0.05; }
  /// more than 1.1 times the folded edges of the linear result, and 4.
  bool is_folded() const { return double(folded_edges) > 1.1 * double(linear_folded_edges) + 4; }

private:
  // what changes its sign is as bad as can be
  static double change(double ratio)
  {
    if (ratio > 0) return std::abs(std::log(ratio));
    return ratio <= 0 ? std::numeric_limits<double>::infinity() : ratio;
  }
};

namespace internal {

constexpr double degrees_of_turning_edges = 40;

template <class FT, class Access, class Edge_map>
std::size_t count_turning_edges(const Access& access, const Level_with_points<FT>& control,
                                [[maybe_unused]] Edge_map edge_map)
{
  using Index = Level_connectivity::Index;
  const std::vector<bool> turns =
    edges_of_greater_angle<FT>(control.level, control.points, degrees_of_turning_edges);
  const Edge_constraints<Access, Edge_map> sharp(access, edge_map, control.level.number_of_edges());
  std::size_t number = 0;
  for (Index e = 0; e < turns.size(); ++e) number += turns[e] && !(sharp.sharpness(e) > 0);
  return number;
}

template <class FT>
void compare_volumes(const Unit_frame<FT>& frame, const Level_shape& control,
                     const Level_shape& result, const Level_shape& linear,
                     Comparison_with_linear& comparison)
{
  comparison.is_closed = control.is_closed() && result.is_closed() && linear.is_closed();
  if (!comparison.is_closed) return;
  const double volume = control.volume();
  comparison.control_volume = std::ldexp(volume, 3 * frame.exponent());
  if (volume == 0) return;
  comparison.volume_ratio = result.volume() / volume;
  comparison.linear_volume_ratio = linear.volume() / volume;
}

inline void compare_folds(const Level_shape& result, const Level_shape& linear,
                          Comparison_with_linear& comparison)
{
  const double cosine_of_150_degrees = -std::sqrt(3.) / 2;
  comparison.folded_edges = result.edges_beyond(0);
  comparison.linear_folded_edges = linear.edges_beyond(0);
  comparison.sharply_folded_edges = result.edges_beyond(cosine_of_150_degrees);
  comparison.linear_sharply_folded_edges = linear.edges_beyond(cosine_of_150_degrees);
}

inline void compare_points(const Level_shape& result, const Level_shape& linear,
                           Comparison_with_linear& comparison)
{
  const std::vector<double> lengths = linear.edge_lengths();
  for (std::size_t v = 0; v < lengths.size(); ++v) {
    if (!(lengths[v] > 0)) continue; // the vertex is isolated, or its neighbors coincide with it
    const double distance =
      quick_length(difference(result.points()[v], linear.points()[v])) / lengths[v];
    if (!(distance > comparison.largest_distance)) continue;
    comparison.largest_distance = distance;
    comparison.farthest_vertex = v;
  }
}

template <class FT, class Access, class Edge_map>
Comparison_with_linear compare_levels(const Access& access, Level_with_points<FT>&& control,
                                      Edge_map edge_map, Level_with_points<FT>&& result,
                                      Level_with_points<FT>&& linear)
{
  if (result.points.size() != linear.points.size())
    throw std::invalid_argument("PN_subdivision_3: the result has " +
                                std::to_string(result.points.size()) +
                                " vertices, but the linear one that it is compared with " +
                                std::to_string(linear.points.size()));
  Comparison_with_linear comparison;
  comparison.control_vertices = control.points.size();
  comparison.vertices_of_roundness_0 = result.of_roundness_0;
  comparison.vertices_of_roundness_below_1 = result.of_roundness_below_1;
  comparison.turning_edges = count_turning_edges(access, control, edge_map);
  const Unit_frame<FT> frame(control.points);
  const auto shape = [&](Level_with_points<FT>& level) {
    return Level_shape(std::move(level.level), frame(level.points), std::move(level.is_sharp),
                       frame.rounding());
  };
  const Level_shape r = shape(result), l = shape(linear);
  compare_volumes(frame, shape(control), r, l, comparison);
  compare_folds(r, l, comparison);
  compare_points(r, l, comparison);
  return comparison;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

checks whether point-normal subdivision of a mesh is worse than linear subdivision: refines it by the scheme and by its
`linear()` twin, without touching it, and measures both results. Normals make spheres and other round shapes larger
than the linear result, and closer to the control mesh in volume. If they bend shapes that are not round, parts swell
or their surfaces fold: `Comparison_with_linear::is_swollen()`, `Comparison_with_linear::is_folded()`.

The volume of a closed mesh is \f$ V = \frac{1}{6} \sum \det(m, p_i, p_{i+1}) \f$ over the edges of its faces, each taken
as triangles round the mean \f$ m \f$ of its corners. The angle of a fold is that of the area vectors of its
faces; creases, and faces without area but that of the rounding of their coordinates, are left out. All is measured relative to a
point of the mesh and to its size, in `double`.

\tparam Concurrency_tag as of `subdivide()`
\tparam PolygonMesh a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `number_of_iterations`,
  `vertex_point_map`, `vertex_normal_map` with the control normals (without it they are estimated),
  `edge_is_constrained_map`, `vertex_is_constrained_map`, `parameters::vertex_roundness_map()` or `parameters::roundness()`,
  and `geom_traits`, as in `subdivide()`; the maps are read only

\throws std::invalid_argument, std::length_error, std::overflow_error, std::domain_error as `subdivide()` does
<br><b>Cost:</b> that of both subdivisions; both results are held in flat arrays
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!std::is_same_v<Scheme, NamedParameters>, int> = 0>
Comparison_with_linear compare_with_linear(const PolygonMesh& mesh, const Scheme& scheme,
                                           const NamedParameters& np = parameters::default_values())
{
  Comparison_with_linear comparison;
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh>();
  if constexpr (internal::is_open_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call<Comparison_with_linear,
                                         internal::Surface_call<PolygonMesh, NamedParameters>>(
      scheme, np, [&](const auto& s, const auto& others) {
        return compare_with_linear<Concurrency_tag>(mesh, s, others);
      });
  else if constexpr (internal::check_pieces_arguments<PolygonMesh, Scheme, NamedParameters>()) {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    using FT = typename Parameters::FT;
    internal::with_mesh_access(mesh, [&](const auto& access) {
      const auto edge_map = Parameters::edge_constraint_map(np);
      const auto refined = [&](const auto& s, unsigned rounds) {
        return internal::refined_aside<Concurrency_tag, FT>(
          s, access, rounds, Parameters::const_point_map(mesh, np), Parameters::normal_map(np),
          edge_map, Parameters::vertex_constraint_map(np));
      };
      const unsigned rounds = Parameters::number_of_iterations(np);
      internal::with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
        comparison = internal::compare_levels(access, refined(linear(scheme), 0), edge_map,
                                              refined(s, rounds), refined(linear(scheme), rounds));
      });
    });
  }
  return comparison;
}

/*!
\ingroup PkgPNSubdivision3Functions

measures the same of results that are there already.

\param control the control mesh
\param result what point-normal subdivision has made of it
\param linear_result what the linear twin of the scheme has made of it; its vertices are those of `result`, in this order
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" of the control mesh: `vertex_point_map`,
  `edge_is_constrained_map` and `geom_traits`, as in `subdivide()`
\param np_result the same of the result: `vertex_point_map`, `edge_is_constrained_map`
\param np_linear the same of the linear result: `vertex_point_map`, `edge_is_constrained_map`

\throws std::invalid_argument if a mesh is not an oriented 2-manifold with border, a point is not finite, or the results
  differ in their numbers of vertices.
<br><b>Cost:</b> Linear in the size of the results
*/
template <class ControlMesh, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters,
          class ResultParameters = parameters::Default_named_parameters,
          class LinearParameters = parameters::Default_named_parameters>
Comparison_with_linear
compare_with_linear(const ControlMesh& control, const PolygonMesh& result,
                    const PolygonMesh& linear_result,
                    const NamedParameters& np = parameters::default_values(),
                    const ResultParameters& np_result = parameters::default_values(),
                    const LinearParameters& np_linear = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  internal::check_are_read<ResultParameters>();
  internal::check_are_read<LinearParameters>();
  using Parameters = internal::Surface_parameters<ControlMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  const auto read = [](const auto& mesh, const auto& parameters_of_mesh) {
    using Read_mesh = std::decay_t<decltype(mesh)>;
    using Own = internal::Surface_parameters<Read_mesh, std::decay_t<decltype(parameters_of_mesh)>>;
    internal::Level_with_points<FT> level;
    internal::with_mesh_access(mesh, [&](const auto& access) {
      level.level = internal::checked_level(access);
      level.points = internal::read_given_values<Linear_average<FT, 3>>(
        access, Own::const_point_map(mesh, parameters_of_mesh), internal::Not_given(),
        level.level.number_of_vertices());
      const auto edge_map = Own::edge_constraint_map(parameters_of_mesh);
      const internal::Edge_constraints<std::decay_t<decltype(access)>,
                                       std::decay_t<decltype(edge_map)>>
        sharp(access, edge_map, level.level.number_of_edges());
      for (Level_connectivity::Index e = 0; e < level.level.number_of_edges(); ++e)
        level.is_sharp.push_back(sharp.sharpness(e) > 0);
    });
    return level;
  };
  return internal::with_mesh_access(control, [&](const auto& access) {
    return internal::compare_levels(access, read(control, np), Parameters::edge_constraint_map(np),
                                    read(result, np_result), read(linear_result, np_linear));
  });
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CERTIFICATES_3_COMPARE_WITH_LINEAR_H
