// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_FIND_CONTROL_NET_H
#define CGAL_PN_FITTING_3_INTERNAL_FIND_CONTROL_NET_H

#include <CGAL/PN_fitting_3/internal/Curvature_prescription.h>
#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/Limit_distance.h>
#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/Mesh_limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/Prescription.h>
#include <CGAL/PN_fitting_3/internal/Slide_interpolation.h>
#include <CGAL/PN_fitting_3/internal/Strict_interpolation.h>
#include <CGAL/PN_fitting_3/internal/interpolate_mesh.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// control values of points, with their estimated normals and roundness
inline std::vector<Point_normal<double, 3>> estimated_values(const Level_connectivity& level,
                                                             Control_normal_estimate estimate,
                                                             const Vectors<3>& points)
{
  std::vector<Point_normal<double, 3>> values;
  for (const Eigen_vector<3>& p : points) values.push_back({to_coordinates<3>(p), {}});
  estimate_normals_of<double>(level, estimate, values);
  return values;
}

// estimates the normals that are zero
inline void estimate_missing_normals(const Level_connectivity& level,
                                     Control_normal_estimate estimate, Interpolation_data<3>& data)
{
  const auto is_missing = [](const Eigen_vector<3>& n) { return n.isZero(0); };
  if (std::none_of(data.normals.begin(), data.normals.end(), is_missing)) return;
  const auto values = estimated_values(level, estimate, data.points);
  for (std::size_t v = 0; v < values.size(); ++v)
    if (is_missing(data.normals[v])) data.normals[v] = to_eigen<3>(values[v].normal);
}

// the largest angle between the normals of neighbors, in degrees
inline double largest_normal_angle(const Level_connectivity& level, const Vectors<3>& normals)
{
  using Index = Level_connectivity::Index;
  double least = 1;
  for (Index e = 0; e < level.number_of_edges(); ++e) {
    const Eigen_vector<3>& a = normals[level.target(2 * e)];
    const Eigen_vector<3>& b = normals[level.target(2 * e + 1)];
    if (!a.isZero(0) && !b.isZero(0)) least = (std::min)(least, a.dot(b));
  }
  return in_degrees(std::acos((std::max)(-1., least)));
}

// with normals, and roundness unless it is given, that are estimated of the control points, again in each step
template <int dimension>
Interpolation_result<dimension>
interpolate_estimated(const Level_connectivity& level, Control_normal_estimate estimate,
                      Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source)
{
  Limit_precision precision = data.precision();
  precision.with_blocks = false;
  auto result =
    interpolate_evaluated<dimension>(data, false, [&](Vectors<dimension>& points, double) {
      auto values = estimated_values(level, estimate, points);
      for (std::size_t v = 0; v < values.size(); ++v) {
        data.normals[v] = to_eigen<dimension>(values[v].normal);
        if (!data.roundness.empty()) values[v].roundness = data.roundness[v];
      }
      const auto limits = source(values, data.vertices, precision);
      for (std::size_t i = 0; i < limits.size(); ++i)
        points[data.vertices[i]] = limits[i].limit_point;
      Limit_interpolation report;
      note_evaluation(limits, report);
      return report;
    });
  result.normals = data.normals;
  return result;
}

template <int dimension>
Interpolation_result<dimension>
interpolate_strictly(const Level_connectivity& level, const Interpolation_options& options,
                     const Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source)
{
  return with_control_normals(options, data, source, [&](Vectors<dimension> normals) {
    if (options.free == Limit_interpolation::Free::fixed)
      return Strict_interpolation<dimension, 2>(data, source)(std::move(normals));
    std::vector<Prescribed_vertex> prescribed;
    for (const auto v : data.vertices) prescribed.push_back({v, data.points[v], std::nullopt});
    Interpolation_data<dimension> with_normals = data;
    with_normals.normals = std::move(normals);
    return Prescription(level, with_normals, source, std::move(prescribed),
                        (std::numeric_limits<unsigned>::max)())();
  });
}

template <bool estimates_normals, bool may_be_strict, class Scheme>
Interpolation_result<3>
find_control_net(const Fitted_surface<Scheme>& surface, const Interpolation_options& options,
                 Control_normal_estimate estimate, Interpolation_data<3>& data)
{
  const Level_connectivity& level = surface.level;
  Mesh_limit_functionals<Scheme> source(surface.scheme, level, surface.for_chunks);
  const auto find = [&] {
    if constexpr (estimates_normals) {
      if (options.free == Limit_interpolation::Free::smooth)
        throw std::invalid_argument(
          "PN_subdivision_3: without normals control points move where they "
          "are interpolated only: give a vertex_normal_map, or take "
          "Limit_interpolation::Free::fixed");
      return interpolate_estimated(level, estimate, data, source);
    } else {
      if constexpr (may_be_strict)
        if (options.mode == Limit_interpolation::Mode::strict)
          return interpolate_strictly(level, options, data, source);
      set_surroundings(level, data);
      estimate_missing_normals(level, estimate, data);
      return interpolate_by_sliding<3, 2>(
        data, source, [&](const auto&... arguments) { return source.farthest(arguments...); });
    }
  };
  auto result = find();
  result.report.normal_angle = largest_normal_angle(level, data.normals);
  return result;
}

template <class Scheme>
void find_natural_normals(const Fitted_surface<Scheme>& surface, Interpolation_data<3>& data)
{
  for (Level_connectivity::Index v = 0; v < surface.level.number_of_vertices(); ++v)
    if (!data.normals[v].isZero(0)) data.vertices.push_back(v);
  data.tolerance = 1e-9 * box_size(data.points);
  set_surroundings(surface.level, data);
  Mesh_limit_functionals<Scheme> source(surface.scheme, surface.level, surface.for_chunks);
  find_natural_normals(data, source);
}

template <class Scheme>
Interpolation_result<3>
prescribe(const Fitted_surface<Scheme>& surface, const Interpolation_options& options,
          const Interpolation_data<3>& data, std::vector<Prescribed_vertex> prescribed,
          const std::vector<Prescribed_form>& forms,
          Function_ref<std::string(Level_connectivity::Index)> names)
{
  Mesh_limit_functionals<Scheme> source(surface.scheme, surface.level, surface.for_chunks);
  if (const auto v = vertex_without_tangents(prescribed, data, source))
    throw std::invalid_argument("PN_subdivision_3: a normal is prescribed at " + names(*v) +
                                ", where the scheme has no tangent plane: prescribe none there");
  if (forms.empty())
    return Prescription(surface.level, data, source, std::move(prescribed), options.rings)();
  const double size = box_size(data.points);
  return Curvature_prescription(surface.level, data, source, std::move(prescribed), forms,
                                options.rings, names)(
    size > 0 ? options.curvature_tolerance / size : 0, options.max_curvature_steps);
}

template <class Scheme>
Interpolation_result<3>
interpolate_creased(const Fitted_surface<Scheme>& surface, std::vector<Slot_value<Scheme>> values,
                    const Creases<double>& creases, const Interpolation_data<3>& data)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> vertex_of_slot = first_indices(surface.level.number_of_vertices());
  const auto extra = vertices_of_extra_slots(creases, surface.level.number_of_vertices());
  vertex_of_slot.insert(vertex_of_slot.end(), extra.begin(), extra.end());
  Valued_level<Slot_value<Scheme>> level{surface.level, std::move(values)};
  return interpolate_evaluated<3>(data, true, [&](Vectors<3>& points, double tolerance) {
    for (std::size_t slot = 0; slot < level.values.size(); ++slot)
      point_of(level.values[slot]) = to_coordinates<3>(points[vertex_of_slot[slot]]);
    Limit_demand demand;
    demand.tolerance = tolerance;
    demand.max_depth = data.max_depth;
    Creases<double> of_limit = creases; // whose tangents become those of the limit
    constexpr Limit_kinds kinds = limit_kinds<parameters::Default_named_parameters>();
    const auto results = limits_at_slots<double, kinds>(surface.scheme, demand, surface.for_chunks,
                                                        level, of_limit, 1, &data.vertices);
    Limit_interpolation report;
    for (const Index v : data.vertices) {
      points[v] = to_eigen<3>(point_of(results[v].value));
      report.error = (std::max)(report.error, results[v].error);
      report.depth = (std::max)(report.depth, results[v].depth);
    }
    return report;
  });
}

template <int dimension>
Interpolation_result<dimension> interpolate_polygon(bool is_closed,
                                                    const Interpolation_options& options,
                                                    Interpolation_data<dimension>& data)
{
  Curve_limit_functionals<dimension> source(is_closed);
  if (options.mode == Limit_interpolation::Mode::slide) {
    set_curve_surroundings(is_closed, data);
    return interpolate_by_sliding<dimension, 1>(data, source, Curve_distance<dimension>(is_closed));
  }
  return with_control_normals<dimension, 1>(options, data, source, [&](Vectors<dimension> normals) {
    return Strict_interpolation<dimension, 1>(data, source)(std::move(normals));
  });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_FIND_CONTROL_NET_H
