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
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Control normals n of which the limit N is the given normals M: n <- unit(n + m^-1 (M - N)) with the
// matrix m of the linear limit points, sped up by Anderson's method over the last four differences. A
// vertex whose n turns away from M by more than 45 degrees, or if that fails half of all, those that
// are furthest off, return to n = M and leave the system.
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
  using Difference = std::pair<Eigen::VectorXd, Eigen::VectorXd>; // of x, of g

  static constexpr double tolerance = 1e-14;
  static constexpr double least_cosine = 0.7071;
  static constexpr std::size_t memory = 4;

  // Steps until the limits are met or a vertex leaves; whether all is done.
  bool iterate(Vectors<dimension>& normals, unsigned max_steps)
  {
    std::vector<double> error;
    Eigen::VectorXd f = defects(normals, error);
    const Limit_matrix<> matrix = make_limit_matrix();
    if (!matrix.is_regular()) return leave_worst(normals, error, active_.size());
    differences_.clear();
    keeps_history_ = false;
    double best = norm(error);
    unsigned without_gain = 0;
    Vectors<dimension> best_normals = normals;
    while (best > tolerance && without_gain < 6 && steps_ < max_steps) {
      Limit_preconditioner<double> solver;
      solver.set(&matrix, dimension);
      const Eigen::VectorXd g = solver.solve(f);
      ++steps_;
      const Eigen::VectorXd x = gathered<dimension>(normals, active_);
      set(normals, accelerated(x, g));
      if (drop_turned(normals)) return false;
      f = defects(normals, error);
      const double now = norm(error);
      without_gain = now < 0.9 * best ? 0 : without_gain + 1;
      if (!(now < best)) continue;
      best = now;
      best_normals = normals;
    }
    normals = best_normals;
    if (best <= 1e-9) return true;
    defects(normals, error);
    return leave_worst(normals, error, (active_.size() + 1) / 2);
  }

  // Of the last changes of x and g the part is taken off by which g would be the least.
  Eigen::VectorXd accelerated(const Eigen::VectorXd& x, const Eigen::VectorXd& g)
  {
    Eigen::VectorXd step = g;
    if (last_x_.size() == x.size() && keeps_history_) {
      differences_.emplace_back(x - last_x_, g - last_g_);
      if (differences_.size() > memory) differences_.pop_front();
      auto orthogonal = differences_;
      Eigen::VectorXd rest = g;
      for (auto d = orthogonal.begin(); d != orthogonal.end(); ++d) {
        const double length = d->second.norm();
        for (auto e = orthogonal.begin(); e != d; ++e) subtract(*e, e->second.dot(d->second), *d);
        const double height = d->second.norm();
        const double scale = height > 1e-12 * length ? 1 / height : 0.; // 0: depends on the others
        d->first *= scale;
        d->second *= scale;
        const double c = d->second.dot(rest);
        rest -= c * d->second;
        step -= c * (d->first + d->second);
      }
      if (!step.allFinite() || step.norm() > 4 * g.norm()) step = g;
    }
    last_x_ = x;
    last_g_ = g;
    keeps_history_ = true;
    return x + step;
  }
  static void subtract(const Difference& a, double factor, Difference& b)
  {
    b.first -= factor * a.first;
    b.second -= factor * a.second;
  }

  // M - N, and their lengths
  Eigen::VectorXd defects(const Vectors<dimension>& normals, std::vector<double>& error)
  {
    functionals_ =
      source_(to_values<dimension>(data_.points, normals, data_), active_, data_.precision());
    Eigen::VectorXd f(dimension * static_cast<Eigen::Index>(active_.size()));
    error.clear();
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const Vector d = data_.normals[active_[i]] - functionals_[i].control_normal;
      f.template segment<dimension>(dimension * static_cast<Eigen::Index>(i)) = d;
      error.push_back(d.norm());
    }
    return f;
  }
  static double norm(const std::vector<double>& error)
  {
    return error.empty() ? 0 : *std::max_element(error.begin(), error.end());
  }

  Limit_matrix<> make_limit_matrix() const
  {
    Data part;
    part.vertices = active_;
    part.is_at_border = data_.is_at_border;
    return internal::make_limit_matrix(part, functionals_,
                                       unknowns_of(active_, data_.points.size()));
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

  // always false
  bool leave_worst(Vectors<dimension>& normals, const std::vector<double>& error, std::size_t n)
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
    keeps_history_ = false;
    return false;
  }

  const Data& data_;
  Source& source_;
  std::vector<Index> active_;
  std::vector<typename Source::Functionals> functionals_;
  std::deque<Difference> differences_;
  Eigen::VectorXd last_x_, last_g_;
  bool keeps_history_ = false;
  std::size_t left_out_ = 0;
  unsigned steps_ = 0;
};

// The control net that `net` makes of control normals: of those that are given, or are solved for if the options say so.
template <int dimension, int tangents, class Options, class Net>
Interpolation_result<dimension>
with_control_normals(const Options& options, const Interpolation_data<dimension>& data,
                     Limit_source<dimension, tangents>& source, const Net& net)
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
    , unknowns_(unknowns_of(data.vertices, data.points.size()))
  {}

  // solves with these control normals, of all vertices
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
