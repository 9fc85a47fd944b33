// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_FITTING_3_INTERNAL_CREASED_SOLUTION_H
#define CGAL_PN_FITTING_3_INTERNAL_CREASED_SOLUTION_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cstddef>
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
    const Vector wanted = of_unknowns(data_.points);
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

  Vector of_unknowns(const Vectors<3>& of_vertices) const
  {
    Vector x(3 * Eigen::Index(data_.vertices.size()));
    for (std::size_t i = 0; i < data_.vertices.size(); ++i)
      x.segment<3>(3 * Eigen::Index(i)) = of_vertices[data_.vertices[i]];
    return x;
  }

  static double largest(const Vector& x)
  {
    double length = 0;
    for (Eigen::Index i = 0; i < x.size(); i += 3)
      length = (std::max)(length, finite_or_infinite(x.segment<3>(i).norm()));
    return length;
  }

  // of the control points with the unknowns in place of those that are sought
  Vector limits_at(const Vector& unknowns, Limit_interpolation* report)
  {
    return limits(unknowns, data_.points, data_.precision().tolerance, report);
  }
  // of changes of the control points that are sought, where the other points are zero
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
    return of_unknowns(points);
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_CREASED_SOLUTION_H
