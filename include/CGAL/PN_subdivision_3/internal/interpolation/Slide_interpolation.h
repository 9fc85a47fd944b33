// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_SLIDE_INTERPOLATION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_SLIDE_INTERPOLATION_H

#include <CGAL/PN_subdivision_3/internal/interpolation/Interpolation_data.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Control points p_v = P_v + s_v M_v, control normals M_v: P_v and the limit point L_v with the normal
// nu_v of the limit surface shall lie on one PN arc,
//   w_v = (M_v + nu_v) . (P_v - L_v) / ((M_v + nu_v) . nu_v) = 0.
// In each step nu is taken as it is, and w is linear in s. Where that does not converge, and on borders,
// the limit control normal is taken for nu: then w is linear. A curve in space slides along its binormal
// too, along which L_v shall not be away from P_v.
template <int dimension, int tangents>
class Slide_interpolation
{
public:
  static constexpr int freedom = dimension - tangents; // of a control point

  using Source = Limit_source<dimension, tangents>;
  using Data = Interpolation_data<dimension>;
  using Result = Interpolation_result<dimension>;

  // \pre the vertices of the data have normals
  Slide_interpolation(const Data& data, Source& source)
    : data_(data)
    , source_(source)
    , unknowns_(data.vertices, data.points.size())
  {}

  Result operator()()
  {
    Result result;
    result.normals = data_.normals;
    report_.tolerance = data_.tolerance;
    best_.points = data_.points;
    set_directions();
    evaluate_at(best_);
    if (!(best_.residual <= data_.tolerance)) solve();
    check();
    result.points = std::move(best_.points);
    report_.residual = best_.residual;
    result.report = report_;
    return result;
  }

private:
  using Vector = Eigen_vector<dimension>;
  using Functionals = typename Source::Functionals;
  using Directions = Eigen::Matrix<double, dimension, freedom>;

  static constexpr unsigned most_steps = 12;

  struct Iterate
  {
    Vectors<dimension> points;
    double residual = 0;
  };

  void evaluate_at(Iterate& iterate)
  {
    functionals_ = source_(to_values<dimension>(iterate.points, data_.normals, data_),
                           data_.vertices, data_.precision());
    iterate.residual = residual(iterate.points);
  }

  // in which the control points slide
  void set_directions()
  {
    for (const auto v : data_.vertices) {
      Directions d;
      d.col(0) = data_.normals[v];
      if constexpr (freedom == 2) d.col(1) = data_.binormals[v];
      directions_.push_back(d);
    }
  }

  void solve()
  {
    const Limit_matrix matrix = make_limit_matrix(data_, functionals_, unknowns_);
    const double first = best_.residual;
    iterate(matrix);
    if (best_.residual <= data_.tolerance) return;
    // once more, in the linear way
    report_.fallback = true;
    const Iterate before = best_;
    best_.points = data_.points;
    best_.residual = residual(best_.points);
    const double linear_first = best_.residual;
    iterate(matrix);
    if (best_.residual < linear_first || best_.residual <= data_.tolerance) return;
    best_ = before;
    if (!(before.residual < first)) best_.points = data_.points;
    report_.fallback = false;
    best_.residual = residual(best_.points);
  }

  // steps while the residual falls
  void iterate(const Limit_matrix& matrix)
  {
    for (unsigned k = 0; k < most_steps && report_.steps < data_.max_steps; ++k) {
      const Eigen::VectorXd s = step(matrix, best_.points);
      ++report_.steps;
      if (s.size() == 0) return;
      Iterate next = best_;
      for (std::size_t i = 0; i < data_.vertices.size(); ++i) {
        const auto v = data_.vertices[i];
        next.points[v] += directions_[i] * s.template segment<freedom>(row(i));
      }
      next.residual = residual(next.points);
      if (!(next.residual < best_.residual)) return;
      best_ = std::move(next);
      if (best_.residual <= data_.tolerance) return;
    }
  }

  static Eigen::Index row(std::size_t i) { return freedom * static_cast<Eigen::Index>(i); }

  // What P - L shall be perpendicular to: (M + nu) / ((M + nu) . nu), and a binormal.
  Directions conditions(std::size_t i, const Vectors<dimension>& p) const
  {
    const auto v = data_.vertices[i];
    const Functionals& f = functionals_[i];
    Vector m = data_.normals[v];
    const bool has_control_normal = f.control_normal.squaredNorm() > 0.5;
    const Vector nu = report_.fallback || data_.is_at_border[v]
                        ? (has_control_normal ? f.control_normal : m)
                        : f.surface_normal(p, m);
    if (m.dot(nu) < 0) m = -m;
    const Vector sum = m + nu;
    Directions d;
    d.col(0) = sum / (std::max)(sum.dot(nu), 1e-3);
    if constexpr (freedom == 2) {
      const Vector b = f.has_tangents ? Vector(nu.cross(f.tangent(0, p))) : Vector(Vector::Zero());
      d.col(1) = b.norm() > 0 ? Vector(b.normalized()) : Vector(directions_[i].col(1));
    }
    return d;
  }

  Eigen::Matrix<double, freedom, 1> w(std::size_t i, const Vectors<dimension>& p) const
  {
    return conditions(i, p).transpose() *
           (data_.points[data_.vertices[i]] - functionals_[i].limit(p));
  }
  double residual(const Vectors<dimension>& p) const
  {
    double largest = 0;
    for (std::size_t i = 0; i < functionals_.size(); ++i)
      largest = (std::max)(largest, finite_or_infinite(w(i, p).norm()));
    return largest;
  }

  Eigen::VectorXd step(const Limit_matrix& matrix, const Vectors<dimension>& p) const
  {
    const Eigen::Index n = row(functionals_.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd b(n);
    for (std::size_t i = 0; i < functionals_.size(); ++i) {
      const Directions c = conditions(i, p);
      b.template segment<freedom>(row(i)) =
        c.transpose() * (data_.points[data_.vertices[i]] - functionals_[i].limit(p));
      for (const auto& e : functionals_[i].entries) {
        const int j = unknowns_[e.vertex];
        if (j < 0) continue;
        const Eigen::Matrix<double, freedom, freedom> part =
          c.transpose() * e.block.template topRows<dimension>() *
          directions_[static_cast<std::size_t>(j)];
        for (int r = 0; r < freedom; ++r)
          for (int k = 0; k < freedom; ++k)
            entries.emplace_back(static_cast<int>(row(i)) + r, freedom * j + k, part(r, k));
      }
    }
    Row_matrix a(n, n);
    a.setFromTriplets(entries.begin(), entries.end());
    return solve_limit_system(a, b, matrix, freedom, 1e-3);
  }

  // The functionals are those of the depths that were right for the data: now with those that are right
  // for the result, and some more steps if that makes a difference.
  void check()
  {
    for (int k = 0; k < 3; ++k) {
      if (report_.steps > 0) {
        Iterate same = best_;
        evaluate_at(same);
        best_.residual = same.residual;
      }
      note_evaluation(functionals_, report_);
      if (report_.steps == 0 || k == 2 || best_.residual <= data_.tolerance) break;
      const double before = best_.residual;
      iterate(make_limit_matrix(data_, functionals_, unknowns_));
      if (!(best_.residual < before)) break;
    }
    for (std::size_t i = 0; i < functionals_.size(); ++i) {
      const auto v = data_.vertices[i];
      const double slip = (data_.points[v] - functionals_[i].limit(best_.points)).norm();
      report_.slip = (std::max)(report_.slip, slip);
      if (data_.edge_length[v] > 0)
        report_.slip_of_edge = (std::max)(report_.slip_of_edge, slip / data_.edge_length[v]);
    }
  }

  const Data& data_;
  Source& source_;
  Unknowns unknowns_;
  std::vector<Functionals> functionals_;
  std::vector<Directions> directions_; // of the vertices that are interpolated
  Iterate best_;
  Limit_interpolation report_;
};

// Normals M that are those of the surface that slides along them: the surface that interpolates with M
// tells its normals at the points P, and they become the next M. The normal at P is that at the limit
// point L, carried from L to P by the second fundamental form.
class Natural_normals
{
public:
  // the data, the normals of which are the first ones
  Natural_normals(Interpolation_data<3>& data, Surface_limits& source)
    : data_(data)
    , source_(source)
  {}

  void operator()()
  {
    double last_change = 0;
    for (unsigned k = 0; k < most_rounds; ++k) {
      const auto result = Slide_interpolation<3, 2>(data_, source_)();
      if (result.report.steps == 0) return; // they are exact
      Vectors<3> next = next_normals(result.points);
      double change = 0;
      for (const auto v : data_.vertices)
        change = (std::max)(change, (next[v] - data_.normals[v]).norm());
      if (k > 0 && !(change < 0.8 * last_change)) return;
      data_.normals = std::move(next);
      if (change <= 1e-5) return;
      last_change = change;
    }
  }

private:
  static constexpr unsigned most_rounds = 10;

  Vectors<3> next_normals(const Vectors<3>& points)
  {
    Limit_precision precision = data_.precision();
    precision.second_forms = 2e-5;
    const auto functionals =
      source_(to_values<3>(points, data_.normals, data_), data_.vertices, precision);
    Vectors<3> next = data_.normals;
    for (std::size_t i = 0; i < functionals.size(); ++i) {
      const auto v = data_.vertices[i];
      const auto& f = functionals[i];
      if (data_.is_at_border[v] != 0 || !f.has_tangents) continue;
      const Eigen_vector<3> nu = f.surface_normal(points, data_.normals[v]);
      const Eigen_vector<3> n = nu - f.second_form * (data_.points[v] - f.limit(points));
      const double length = n.norm();
      if (!(length > 0.1) || !std::isfinite(length) || n.dot(data_.normals[v]) <= 0) continue;
      next[v] = n / length;
    }
    return next;
  }

  Interpolation_data<3>& data_;
  Surface_limits& source_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_SLIDE_INTERPOLATION_H
