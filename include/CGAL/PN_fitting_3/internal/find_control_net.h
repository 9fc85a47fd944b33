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

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Control points whose limits on a surface with creases are given points. With the normals of the wedges and the
// tangents of the creases as they are, limits are linear in the control points: L p = P. L is not made, but
// evaluated, and GMRES solves for the corrections.
template <int dimension>
class Creased_solution
{
public:
  using Limits = Function_ref<void(Vectors<3>&, double, Limit_interpolation*)>;

  Creased_solution(const Interpolation_data<dimension>& data, Limits limits)
    : data_(data)
    , limits_(limits)
    , size_(box_size<3>(data.points))
  {}

  Interpolation_result<3> operator()()
  {
    Interpolation_result<3> result;
    result.report.tolerance = data_.tolerance;
    const Vector wanted = gathered<3>(data_.points, data_.vertices);
    Vector p = wanted;
    Vector rest = wanted - limits_at(p, &result.report);
    result.report.residual = largest(rest);
    while (!(result.report.residual <= data_.tolerance) && result.report.steps < most_steps()) {
      const Vector next = p + correction(rest);
      ++result.report.steps;
      Limit_interpolation report = result.report;
      const Vector next_rest = wanted - limits_at(next, &report);
      report.residual = largest(next_rest);
      if (!(report.residual < result.report.residual)) break;
      p = next;
      rest = next_rest;
      result.report = report;
    }
    result.points = data_.points;
    for (std::size_t i = 0; i < data_.vertices.size(); ++i)
      result.points[data_.vertices[i]] = p.segment<3>(3 * Eigen::Index(i));
    return result;
  }

private:
  using Vector = Eigen::VectorXd;

  static constexpr int most_directions = 60;
  static constexpr double reduction = 1e-4; // of the residual in a step

  unsigned most_steps() const { return (std::min)(12u, data_.max_steps); }

  static double largest(const Vector& x)
  {
    double length = 0;
    for (Eigen::Index i = 0; i < x.size(); i += 3)
      length = (std::max)(length, finite_or_infinite(x.segment<3>(i).norm()));
    return length;
  }

  // the limits of the control points, of which the sought ones are `unknowns`
  Vector limits_at(const Vector& unknowns, Limit_interpolation* report)
  {
    return limits(unknowns, data_.points, data_.precision().tolerance, report);
  }
  // the limits of changes of the sought control points, where the other points are zero
  Vector limits_of_direction(const Vector& direction)
  {
    const double scale = size_ / direction.lpNorm<Eigen::Infinity>();
    const Vectors<3> none(data_.points.size(), Eigen_vector<3>::Zero());
    return limits(scale * direction, none, reduction / 100 * size_, nullptr) / scale;
  }

  Vector limits(const Vector& unknowns, Vectors<3> points, double tolerance,
                Limit_interpolation* report)
  {
    for (std::size_t i = 0; i < data_.vertices.size(); ++i)
      points[data_.vertices[i]] = unknowns.segment<3>(3 * Eigen::Index(i));
    limits_(points, tolerance, report);
    return gathered<3>(points, data_.vertices);
  }

  // GMRES
  Vector correction(const Vector& rest)
  {
    const double length = rest.norm();
    std::vector<Vector> basis{rest / length};
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(most_directions + 1, most_directions);
    for (int k = 0;; ++k) {
      Vector next = limits_of_direction(basis.back());
      for (int i = 0; i <= k; ++i) {
        h(i, k) = next.dot(basis[std::size_t(i)]);
        next -= h(i, k) * basis[std::size_t(i)];
      }
      h(k + 1, k) = next.norm();
      Vector wanted = Vector::Zero(k + 2);
      wanted[0] = length;
      const auto part = h.topLeftCorner(k + 2, k + 1);
      const Vector y = part.colPivHouseholderQr().solve(wanted);
      const bool is_last = k + 1 == most_directions || !(h(k + 1, k) > 1e-12);
      if (is_last || !((part * y - wanted).norm() > reduction * length)) {
        Vector x = Vector::Zero(rest.size());
        for (int i = 0; i <= k; ++i) x += y[i] * basis[std::size_t(i)];
        return x;
      }
      basis.push_back(next / h(k + 1, k));
    }
  }

  const Interpolation_data<3>& data_;
  Limits limits_;
  double size_;
};

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
  return Estimated_interpolation(level, estimate, data, source)();
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

template <int dimension>
Interpolation_result<dimension>
interpolate_creased(const Interpolation_data<dimension>& data,
                    Function_ref<void(Vectors<dimension>&, double, Limit_interpolation*)> limits)
{
  return Creased_solution(data, limits)();
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
