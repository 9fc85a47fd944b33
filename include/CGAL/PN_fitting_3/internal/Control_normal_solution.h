// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_CONTROL_NORMAL_SOLUTION_H
#define CGAL_PN_FITTING_3_INTERNAL_CONTROL_NORMAL_SOLUTION_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/solvers.h>

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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_CONTROL_NORMAL_SOLUTION_H
