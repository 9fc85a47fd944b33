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
#include <CGAL/PN_fitting_3/internal/find_root.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

using Row_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Control normals n of which the limit N is the given normals M: n goes by M - N. A vertex whose n turns away from M by more than 45
// degrees, or if the others are not met half of all, those that are furthest off, return to n = M and leave the system.
template <int dimension, int tangents>
class Control_normal_solution
{
public:
  using Source = Limit_source<dimension, tangents>;
  using Data = Interpolation_data<dimension>;

  Control_normal_solution(const Data& data, Source& source)
    : data_(data)
    , source_(source)
  {}

  // the control normals of all vertices
  Vectors<dimension> operator()(unsigned max_steps)
  {
    Vectors<dimension> normals = data_.normals;
    active_.clear();
    for (const auto v : data_.vertices)
      if (data_.normals[v].squaredNorm() > 0.5) active_.push_back(v);
    left_out_ = data_.vertices.size() - active_.size();
    while (!active_.empty() && steps_ < max_steps && !iterate(normals, max_steps)) {
    }
    return normals;
  }

  std::size_t left_out() const { return left_out_; }
  unsigned steps() const { return steps_; }

private:
  using Vector = Eigen_vector<dimension>;
  using Index = typename Data::Index;

  static constexpr double tolerance = 1e-14;
  static constexpr double least_cosine = 0.7071;

  // Steps until the limits are met or a vertex leaves; whether all is done.
  bool iterate(Vectors<dimension>& normals, unsigned max_steps)
  {
    bool has_turned = false;
    std::vector<double> error;
    const Root root = find_root(
      gathered<dimension>(normals, active_),
      [&](Eigen::VectorXd& x, Eigen::VectorXd& r) {
        set(normals, x);
        has_turned = drop_turned(normals);
        if (has_turned) return std::numeric_limits<double>::infinity();
        x = gathered<dimension>(normals, active_);
        r = defects(normals, error);
        return *std::max_element(error.begin(), error.end());
      },
      tolerance, max_steps - steps_, 6);
    steps_ += root.steps;
    if (has_turned) return false;
    set(normals, root.x);
    if (root.residual <= 1e-9) return true;
    defects(normals, error);
    leave_worst(normals, error, steps_ < max_steps ? (active_.size() + 1) / 2 : active_.size());
    return false;
  }

  // M - N, and their lengths
  Eigen::VectorXd defects(const Vectors<dimension>& normals, std::vector<double>& error)
  {
    Limit_precision precision = data_.precision();
    precision.with_blocks = false;
    const auto limits =
      source_(to_values<dimension>(data_.points, normals, data_), active_, precision);
    Eigen::VectorXd f(dimension * static_cast<Eigen::Index>(active_.size()));
    error.clear();
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const Vector d = data_.normals[active_[i]] - limits[i].control_normal;
      f.template segment<dimension>(dimension * static_cast<Eigen::Index>(i)) = d;
      error.push_back(finite_or_infinite(d.norm()));
    }
    return f;
  }

  void set(Vectors<dimension>& normals, const Eigen::VectorXd& x) const
  {
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const Vector n = x.template segment<dimension>(dimension * static_cast<Eigen::Index>(i));
      const double length = n.norm();
      if (length > 1e-3 && std::isfinite(length)) normals[active_[i]] = n / length;
    }
  }

  // whether some vertices have left since they were turned too far
  bool drop_turned(Vectors<dimension>& normals)
  {
    std::vector<double> turn;
    std::size_t n = 0;
    for (const Index v : active_) {
      const bool is_turned = normals[v].dot(data_.normals[v]) < least_cosine;
      turn.push_back(is_turned ? 1 : 0);
      n += is_turned ? 1 : 0;
    }
    if (n != 0) leave_worst(normals, turn, n);
    return n != 0;
  }

  void leave_worst(Vectors<dimension>& normals, const std::vector<double>& error, std::size_t n)
  {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < active_.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return error[a] > error[b]; });
    std::vector<char> leaves(active_.size(), 0);
    for (std::size_t k = 0; k < n; ++k) leaves[order[k]] = 1;
    std::vector<Index> rest;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (leaves[i] != 0)
        normals[active_[i]] = data_.normals[active_[i]];
      else
        rest.push_back(active_[i]);
    }
    left_out_ += active_.size() - rest.size();
    active_.swap(rest);
  }

  const Data& data_;
  Source& source_;
  std::vector<Index> active_;
  std::size_t left_out_ = 0;
  unsigned steps_ = 0;
};

// The control net that `net` makes of control normals: of those that are given, or are solved for if the options say so.
template <int dimension, int tangents, class Net>
Interpolation_result<dimension> with_control_normals(const Interpolation_options& options,
                                                     const Interpolation_data<dimension>& data,
                                                     Limit_source<dimension, tangents>& source,
                                                     const Net& net)
{
  if (options.normals != Limit_interpolation::Normals::solved || !data.takes_normals)
    return net(data.normals);
  Control_normal_solution<dimension, tangents> solution(data, source);
  auto result = net(solution(data.max_steps));
  result.report.left_out = solution.left_out();
  result.report.steps += solution.steps();
  return result;
}

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
  {}

  // solves with these control normals, of all vertices
  Result operator()(Vectors<dimension> control_normals)
  {
    Result best;
    best.normals = std::move(control_normals);
    best.points = data_.points;
    unsigned steps = 0;
    best.report.residual = evaluate(best.points, best.normals);
    // functionals are for the depth that is right for the data, then for the result
    for (int k = 0; k < 3 && best.report.residual > data_.tolerance && steps < data_.max_steps;
         ++k) {
      Vectors<dimension> points = best.points;
      steps += solve(points, data_.max_steps - steps);
      const double residual = evaluate(points, best.normals);
      if (!(residual < best.report.residual)) {
        evaluate(best.points, best.normals);
        break;
      }
      best.points = std::move(points);
      best.report.residual = residual;
    }
    note_evaluation(functionals_, best.report);
    best.report.steps = steps;
    best.report.tolerance = data_.tolerance;
    return best;
  }

private:
  double evaluate(const Vectors<dimension>& points, const Vectors<dimension>& normals)
  {
    functionals_ =
      source_(to_values<dimension>(points, normals, data_), data_.vertices, data_.precision());
    return largest_length<dimension>(missing(points));
  }

  Eigen::VectorXd missing(const Vectors<dimension>& p) const
  {
    Eigen::VectorXd r = gathered<dimension>(data_.points, data_.vertices);
    for (std::size_t i = 0; i < functionals_.size(); ++i)
      r.template segment<dimension>(dimension * static_cast<Eigen::Index>(i)) -=
        functionals_[i].limit(p);
    return r;
  }

  // C, of the points that are sought
  Row_matrix make_system() const
  {
    std::vector<int> unknown(data_.points.size(), -1);
    for (std::size_t i = 0; i < data_.vertices.size(); ++i)
      unknown[data_.vertices[i]] = dimension * static_cast<int>(i);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < functionals_.size(); ++i)
      for (const auto& e : functionals_[i].entries) {
        const int j = unknown[e.vertex];
        if (j < 0) continue;
        for (int r = 0; r < dimension; ++r)
          for (int c = 0; c < dimension; ++c)
            entries.emplace_back(dimension * static_cast<int>(i) + r, j + c, e.block(r, c));
      }
    const auto n = static_cast<Eigen::Index>(dimension * functionals_.size());
    Row_matrix a(n, n);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
  }

  // Moves the points; the number of steps. What is missing is linear in the change, which is small where the points are not.
  unsigned solve(Vectors<dimension>& points, unsigned max_steps) const
  {
    const Row_matrix a = make_system();
    const Eigen::VectorXd wanted = missing(points);
    const Root root = find_root(
      Eigen::VectorXd::Zero(wanted.size()),
      [&](Eigen::VectorXd& change, Eigen::VectorXd& r) {
        r = wanted - a * change;
        return largest_length<dimension>(r);
      },
      data_.tolerance / 2, max_steps);
    put_gathered<dimension>(gathered<dimension>(points, data_.vertices) + root.x, data_.vertices,
                            points);
    return root.steps;
  }

  const Data& data_;
  Source& source_;
  std::vector<typename Source::Functionals> functionals_;
};

// Control points whose limit points are the given points, where limits(points, tolerance) puts limit points in the place of the control
// points, and returns how well they are known. They lie near the control points. If they are not linear in these, old steps tell little,
// and the residual may fall after many steps.
template <int dimension>
Interpolation_result<dimension>
interpolate_evaluated(const Interpolation_data<dimension>& data, bool is_linear,
                      Function_ref<Limit_interpolation(Vectors<dimension>&, double)> limits)
{
  Interpolation_result<dimension> result;
  const Eigen::VectorXd wanted = gathered<dimension>(data.points, data.vertices);
  const auto missing = [&](const Eigen::VectorXd& x) {
    result.points = data.points;
    put_gathered<dimension>(x, data.vertices, result.points);
    Vectors<dimension> at = result.points;
    result.report = limits(at, data.precision().tolerance);
    return Eigen::VectorXd(wanted - gathered<dimension>(at, data.vertices));
  };
  const Root root = find_root(
    wanted,
    [&](Eigen::VectorXd& x, Eigen::VectorXd& r) {
      r = missing(x);
      return largest_length<dimension>(r);
    },
    data.tolerance, data.max_steps, is_linear ? 8 : data.max_steps, is_linear ? 20 : 5);
  if (root.steps > 0) missing(root.x);
  result.report.residual = root.residual;
  result.report.steps = root.steps;
  result.report.tolerance = data.tolerance;
  return result;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_STRICT_INTERPOLATION_H
