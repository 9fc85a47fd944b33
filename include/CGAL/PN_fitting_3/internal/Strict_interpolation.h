// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_STRICT_INTERPOLATION_H
#define CGAL_PN_FITTING_3_INTERNAL_STRICT_INTERPOLATION_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/solvers.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Control points whose limit points are the given points, for given control normals: the limit points
// L = C p are linear in them.
template <int dimension, int tangents>
class Strict_interpolation
{
public:
  using Source = Limit_source<dimension, tangents>;
  using Data = Interpolation_data<dimension>;
  using Result = Interpolation_result<dimension>;

  Strict_interpolation(const Data& data, Source& source)
    : data_(data)
    , source_(source)
    , unknowns_(unknowns_of(data.vertices, data.points.size()))
  {}

  // with these control normals, of all vertices
  Result operator()(Vectors<dimension> control_normals)
  {
    Result result;
    result.normals = std::move(control_normals);
    normals_ = &result.normals;
    report_.tolerance = data_.tolerance;
    best_.points = data_.points;
    evaluate_at(best_);
    // functionals are for the depth that is right for the data, then for the result
    for (int k = 0; k < 3 && !(best_.residual <= data_.tolerance); ++k) {
      const double before = best_.residual;
      iterate(make_limit_matrix(data_, functionals_, unknowns_));
      Iterate same = best_;
      evaluate_at(same);
      best_.residual = same.residual;
      if (!(best_.residual < before)) break;
    }
    if (!(best_.residual <= first_residual_)) {
      best_.points = data_.points;
      evaluate_at(best_);
    }
    note_evaluation(functionals_, report_);
    report_.residual = best_.residual;
    result.points = std::move(best_.points);
    result.report = report_;
    return result;
  }

private:
  using Vector = Eigen_vector<dimension>;
  using Functionals = typename Source::Functionals;

  static constexpr unsigned most_steps = 12;

  struct Iterate
  {
    Vectors<dimension> points;
    double residual = 0;
  };

  void evaluate_at(Iterate& iterate)
  {
    const bool is_first = functionals_.empty();
    functionals_ = source_(to_values<dimension>(iterate.points, *normals_, data_), data_.vertices,
                           data_.precision());
    iterate.residual = residual(iterate.points);
    if (is_first) first_residual_ = iterate.residual;
  }

  double residual(const Vectors<dimension>& p) const
  {
    double largest = 0;
    for (std::size_t i = 0; i < functionals_.size(); ++i)
      largest = (std::max)(
        largest,
        finite_or_infinite((data_.points[data_.vertices[i]] - functionals_[i].limit(p)).norm()));
    return largest;
  }

  Row_matrix make_system() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < functionals_.size(); ++i)
      for (const auto& e : functionals_[i].entries) {
        const int j = unknowns_[e.vertex];
        if (j < 0) continue;
        for (int r = 0; r < dimension; ++r)
          for (int c = 0; c < dimension; ++c)
            entries.emplace_back(dimension * static_cast<int>(i) + r, dimension * j + c,
                                 e.block(r, c));
      }
    const auto n = static_cast<Eigen::Index>(dimension * functionals_.size());
    Row_matrix a(n, n);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
  }

  void iterate(const Limit_matrix<>& matrix)
  {
    const Row_matrix a = make_system();
    for (unsigned k = 0; k < most_steps && report_.steps < data_.max_steps; ++k) {
      Eigen::VectorXd b(a.rows());
      for (std::size_t i = 0; i < functionals_.size(); ++i)
        b.template segment<dimension>(dimension * static_cast<Eigen::Index>(i)) =
          data_.points[data_.vertices[i]] - functionals_[i].limit(best_.points);
      const Eigen::VectorXd delta = solve_limit_system(a, b, matrix, dimension, 1e-6);
      ++report_.steps;
      if (delta.size() == 0 || !take(delta)) return;
      if (best_.residual <= data_.tolerance) return;
    }
  }

  // whether the step, or a part of it, is one for the better
  bool take(const Eigen::VectorXd& delta)
  {
    for (double part = 1; part >= 1. / 64; part /= 2) {
      Iterate next = best_;
      for (std::size_t i = 0; i < data_.vertices.size(); ++i)
        next.points[data_.vertices[i]] +=
          part * delta.template segment<dimension>(dimension * static_cast<Eigen::Index>(i));
      next.residual = residual(next.points);
      if (!(next.residual < best_.residual)) continue;
      best_ = std::move(next);
      return true;
    }
    return false;
  }

  const Data& data_;
  Source& source_;
  std::vector<int> unknowns_;
  const Vectors<dimension>* normals_ = nullptr;
  std::vector<Functionals> functionals_;
  Iterate best_;
  double first_residual_ = 0;
  Limit_interpolation report_;
};

// Control points whose limit points are the given points, where control normals and roundness are those that are estimated
// from the control points. These limits lie near the control points.
template <int dimension>
class Estimated_interpolation
{
public:
  Estimated_interpolation(const Level_connectivity& level, Control_normal_estimate estimate,
                          Interpolation_data<dimension>& data, Surface_limits& source)
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
  // the largest of the residuals
  double evaluate(const Vectors<3>& points)
  {
    estimate_all_normals(level_, estimate_, points, estimates_roundness_, data_);
    functionals_ =
      source_(to_values<3>(points, data_.normals, data_), data_.vertices, data_.precision());
    x_ = gathered<3>(points, data_.vertices);
    rest_.resize(x_.size());
    double largest = 0;
    for (std::size_t i = 0; i < data_.vertices.size(); ++i) {
      const Eigen_vector<3> r = data_.points[data_.vertices[i]] - functionals_[i].limit_point;
      rest_.segment<3>(3 * Eigen::Index(i)) = r;
      largest = (std::max)(largest, finite_or_infinite(r.norm()));
    }
    return largest;
  }

  void advance(Vectors<3>& points)
  {
    const Eigen::VectorXd next = iteration_.next(x_, rest_);
    for (std::size_t i = 0; i < data_.vertices.size(); ++i)
      points[data_.vertices[i]] = next.segment<3>(3 * Eigen::Index(i));
  }

  const Level_connectivity& level_;
  const Control_normal_estimate estimate_;
  Interpolation_data<3>& data_;
  Surface_limits& source_;
  const bool estimates_roundness_;
  std::vector<Surface_limits::Functionals> functionals_;
  Anderson_iteration<> iteration_{8, false};
  Eigen::VectorXd x_,
    rest_; // the control points, and what is missing, of all vertices to be interpolated
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_STRICT_INTERPOLATION_H
