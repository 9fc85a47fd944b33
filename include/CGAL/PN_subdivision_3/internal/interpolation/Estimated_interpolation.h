// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_ESTIMATED_INTERPOLATION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_ESTIMATED_INTERPOLATION_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Interpolation_data.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Limit_functionals.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Control points whose limit points are the given points, where control normals and roundness are those that are estimated
// from the control points. These limits lie near the control points, which go by what is missing, mixed with the last
// steps (D. G. Anderson, Iterative procedures for nonlinear integral equations, 1965).
class Estimated_interpolation
{
public:
  Estimated_interpolation(const Level_connectivity& level, Control_normal_estimate estimate,
                          Interpolation_data<3>& data, Surface_limits& source)
    : level_(level)
    , estimate_(estimate)
    , data_(data)
    , source_(source)
    , estimates_roundness_(data.roundness.empty())
  {}

  Interpolation_result<3> operator()()
  {
    Interpolation_result<3> best;
    Vectors<3> points = data_.points;
    unsigned steps = 0;
    for (;; ++steps) {
      const double residual = evaluate(points);
      if (steps == 0 || residual < best.report.residual) {
        best.points = points;
        best.normals = data_.normals;
        best.report.residual = residual;
      }
      if (steps == 0) note_evaluation(functionals_, best.report);
      if (!(residual > data_.tolerance) || !std::isfinite(residual) || steps == data_.max_steps)
        break;
      advance(points);
    }
    best.report.steps = steps;
    best.report.tolerance = data_.tolerance;
    return best;
  }

private:
  static constexpr std::size_t most_kept = 8;

  // the largest of the residuals
  double evaluate(const Vectors<3>& points)
  {
    estimate_all_normals(level_, estimate_, points, estimates_roundness_, data_);
    functionals_ =
      source_(to_values<3>(points, data_.normals, data_), data_.vertices, data_.precision());
    const auto n = static_cast<Eigen::Index>(data_.vertices.size());
    now_ = {Eigen::VectorXd(3 * n), Eigen::VectorXd(3 * n)};
    double largest = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto v = data_.vertices[std::size_t(i)];
      const Eigen_vector<3> r = data_.points[v] - functionals_[std::size_t(i)].limit_point;
      now_.point.segment<3>(3 * i) = points[v];
      now_.residual.segment<3>(3 * i) = r;
      largest = (std::max)(largest, finite_or_infinite(r.norm()));
    }
    return largest;
  }

  void advance(Vectors<3>& points)
  {
    Eigen::VectorXd next = now_.point + now_.residual;
    if (!last_.empty()) {
      const auto columns = static_cast<Eigen::Index>(last_.size());
      Eigen::MatrixXd dp(next.size(), columns), dr(next.size(), columns);
      for (Eigen::Index k = 0; k < columns; ++k) {
        dp.col(k) = now_.point - last_[std::size_t(k)].point;
        dr.col(k) = now_.residual - last_[std::size_t(k)].residual;
      }
      next -= (dp + dr) * dr.colPivHouseholderQr().solve(now_.residual);
    }
    last_.push_back(now_);
    if (last_.size() > most_kept) last_.erase(last_.begin());
    for (std::size_t i = 0; i < data_.vertices.size(); ++i)
      points[data_.vertices[i]] = next.segment<3>(3 * Eigen::Index(i));
  }

  struct Step
  {
    Eigen::VectorXd point, residual; // of all vertices to be interpolated
  };

  const Level_connectivity& level_;
  const Control_normal_estimate estimate_;
  Interpolation_data<3>& data_;
  Surface_limits& source_;
  const bool estimates_roundness_;
  std::vector<Surface_limits::Functionals> functionals_;
  Step now_;
  std::vector<Step> last_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_ESTIMATED_INTERPOLATION_H
