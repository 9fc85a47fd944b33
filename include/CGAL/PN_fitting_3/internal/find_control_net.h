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
#include <CGAL/PN_fitting_3/internal/Prescription.h>
#include <CGAL/PN_fitting_3/internal/Slide_interpolation.h>
#include <CGAL/PN_fitting_3/internal/Strict_interpolation.h>
#include <CGAL/PN_fitting_3/internal/interpolate_mesh.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// all control points move, as smoothly as they can
template <int dimension>
Interpolation_result<3> interpolate_smoothly(const Level_connectivity& level,
                                             Interpolation_data<dimension> data,
                                             Surface_limits& source, Vectors<3> control_normals)
{
  std::vector<Prescribed_vertex> prescribed;
  for (const auto v : data.vertices) {
    prescribed.emplace_back().vertex = v;
    prescribed.back().point = data.points[v];
  }
  data.normals = std::move(control_normals);
  return Prescription(level, data, source, std::move(prescribed),
                      (std::numeric_limits<unsigned>::max)())();
}

template <int dimension>
Interpolation_result<dimension>
interpolate_estimated(const Level_connectivity& level, Control_normal_estimate estimate,
                      Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source)
{
  const bool estimates_roundness = data.roundness.empty();
  Limit_precision precision = data.precision();
  precision.with_blocks = false;
  auto result =
    interpolate_evaluated<dimension>(data, false, [&](Vectors<dimension>& points, double) {
      estimate_all_normals(level, estimate, points, estimates_roundness, data);
      const auto limits =
        source(to_values<dimension>(points, data.normals, data), data.vertices, precision);
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
slide_along_normals(const Level_connectivity& level, Control_normal_estimate estimate,
                    Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source,
                    typename Limit_source<dimension, 2>::Farthest farthest)
{
  estimate_missing_normals(level, estimate, data);
  return interpolate_by_sliding<dimension, 2>(data, source, farthest);
}

template <class Options>
Interpolation_result<3> interpolate_strictly(const Level_connectivity& level,
                                             const Options& options, Interpolation_data<3>& data,
                                             Surface_limits& source)
{
  return with_control_normals(options, data, source, [&](Vectors<3> normals) {
    return options.free == Limit_interpolation::Free::smooth
             ? interpolate_smoothly(level, data, source, std::move(normals))
             : Strict_interpolation<3, 2>(data, source)(std::move(normals));
  });
}

template <int dimension, class Options>
Interpolation_result<dimension>
prescribe(const Level_connectivity& level, const Options& options,
          const Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source,
          std::vector<Prescribed_vertex> prescribed, const std::vector<Prescribed_form>& forms,
          Function_ref<std::string(Level_connectivity::Index)> names)
{
  if (const auto v = vertex_without_tangents(prescribed, data, source))
    throw std::invalid_argument("PN_subdivision_3: a normal is prescribed at " + names(*v) +
                                ", where the scheme has no tangent plane: prescribe none there");
  if (forms.empty())
    return Prescription(level, data, source, std::move(prescribed), options.rings)();
  const double size = box_size(data.points);
  return Curvature_prescription(level, data, source, std::move(prescribed), forms, options.rings,
                                names)(size > 0 ? options.curvature_tolerance / size : 0,
                                       options.max_curvature_steps);
}

template <int dimension, class Options>
Interpolation_result<dimension> interpolate_polygon(bool is_closed, const Options& options,
                                                    Interpolation_data<dimension>& data)
{
  Curve_limit_functionals<dimension> source(is_closed);
  if (options.mode == Limit_interpolation::Mode::slide)
    return interpolate_by_sliding<dimension, 1>(data, source, Curve_distance<dimension>(is_closed));
  return with_control_normals<dimension, 1>(options, data, source, [&](Vectors<dimension> normals) {
    return Strict_interpolation<dimension, 1>(data, source)(std::move(normals));
  });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_FIND_CONTROL_NET_H
