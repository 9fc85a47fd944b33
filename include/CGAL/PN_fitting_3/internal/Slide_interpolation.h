// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_SLIDE_INTERPOLATION_H
#define CGAL_PN_FITTING_3_INTERNAL_SLIDE_INTERPOLATION_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/find_root.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// takes vertices without a normal off those to be interpolated; how many
template <int dimension>
std::size_t leave_out_without_normal(Interpolation_data<dimension>& data)
{
  const auto has_none = [&](auto v) { return data.normals[v].isZero(0); };
  const std::size_t before = data.vertices.size();
  data.vertices.erase(std::remove_if(data.vertices.begin(), data.vertices.end(), has_none),
                      data.vertices.end());
  return before - data.vertices.size();
}

// the connected component of each vertex
inline std::vector<Level_connectivity::Index> components_of(const Level_connectivity& level)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> component(level.number_of_vertices(), Level_connectivity::null), open;
  Index number = 0;
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    if (component[v] != Level_connectivity::null) continue;
    component[v] = number;
    open.assign(1, v);
    while (!open.empty()) {
      const Index u = open.back();
      open.pop_back();
      if (level.is_isolated(u)) continue;
      level.for_each_neighbor(level.halfedge_of_vertex(u), [&](Index w) {
        if (component[w] != Level_connectivity::null) return;
        component[w] = number;
        open.push_back(w);
      });
    }
    ++number;
  }
  return component;
}

// where the border is, how long the edges are, and what is connected
inline void set_surroundings(const Level_connectivity& level, Interpolation_data<3>& data)
{
  using Index = Level_connectivity::Index;
  const Index n = level.number_of_vertices();
  data.is_at_border.assign(n, 0);
  data.edge_length.assign(n, 0.);
  data.components = components_of(level);
  for (Index v = 0; v < n; ++v) {
    if (level.is_isolated(v)) continue;
    data.is_at_border[v] = level.is_border_vertex(v) ? 1 : 0;
    unsigned edges = 0;
    level.for_each_neighbor(level.halfedge_of_vertex(v), [&](Index w) {
      data.edge_length[v] += (data.points[w] - data.points[v]).norm();
      ++edges;
    });
    data.edge_length[v] /= edges;
  }
}

// the mean length of the edges at each point; binormals of curves in space
template <int dimension>
void set_curve_surroundings(bool is_closed, Interpolation_data<dimension>& data)
{
  using Vector = Eigen_vector<dimension>;
  const std::size_t n = data.points.size();
  data.is_at_border.assign(n, 0);
  data.components.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_end = !is_closed && (i == 0 || i + 1 == n);
    data.is_at_border[i] = is_end ? 1 : 0;
    const std::size_t before = i > 0 ? i - 1 : is_closed ? n - 1 : 0;
    const std::size_t after = i + 1 < n ? i + 1 : is_closed ? 0 : i;
    const Vector e = data.points[i] - data.points[before], f = data.points[after] - data.points[i];
    data.edge_length.push_back((e.norm() + f.norm()) / (is_end ? 1 : 2));
    if constexpr (dimension == 3) {
      const Vector b = data.normals[i].cross(e + f);
      data.binormals.push_back(b.norm() > 0 ? Vector(b.normalized())
                                            : Vector(data.normals[i].unitOrthogonal()));
    }
  }
}

// Control points p_v = P_v + s_v M_v, control normals M_v: P_v and the limit point L_v with the normal
// nu_v of the limit surface shall lie on one PN arc,
//   w_v = (M_v + nu_v) . (P_v - L_v) / ((M_v + nu_v) . nu_v) = 0.
// The limits are near the control points: s goes by w, in each component of its own, and no further than an edge. On borders
// the limit control normal is taken for nu. A curve in space slides along its binormal too, along which L_v shall
// not be away from P_v.
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
    , points_(data.points)
  {
    for (std::size_t i = 0; i < data.vertices.size(); ++i) {
      const auto v = data.vertices[i];
      Directions& d = directions_.emplace_back();
      d.col(0) = data.normals[v];
      if constexpr (freedom == 2) d.col(1) = data.binormals[v];
      const std::size_t component = data.components[v];
      if (components_.size() <= component) components_.resize(component + 1);
      components_[component].push_back(i);
    }
  }

  Result operator()()
  {
    // functionals to the depths that are right for the data, then for the result
    for (int k = 0; k < 3; ++k) {
      functionals_ = source_(to_values<dimension>(points_, data_.normals, data_), data_.vertices,
                             data_.precision());
      bool is_changed = false;
      for (const Rows& rows : components_)
        if (slide(rows)) is_changed = true;
      if (!is_changed) break;
    }
    Result result;
    note_evaluation(functionals_, report_);
    report_.tolerance = data_.tolerance;
    for (std::size_t i = 0; i < functionals_.size(); ++i) {
      const auto v = data_.vertices[i];
      const double slip = this->slip(i);
      report_.residual = (std::max)(report_.residual, finite_or_infinite(w(i).norm()));
      report_.slip = (std::max)(report_.slip, slip);
      if (data_.edge_length[v] > 0)
        report_.slip_of_edge = (std::max)(report_.slip_of_edge, slip / data_.edge_length[v]);
    }
    result.points = std::move(points_);
    result.normals = data_.normals;
    result.report = report_;
    return result;
  }

private:
  using Vector = Eigen_vector<dimension>;
  using Functionals = typename Source::Functionals;
  using Directions = Eigen::Matrix<double, dimension, freedom>;
  using Offset = Eigen::Matrix<double, freedom, 1>;
  using Rows = std::vector<std::size_t>; // positions of vertices of the data

  // Changes the points of a component as long as that makes it better; whether it has.
  bool slide(const Rows& rows)
  {
    const auto n = static_cast<Eigen::Index>(rows.size());
    Eigen::VectorXd x(freedom * n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t i = rows[static_cast<std::size_t>(j)];
      const auto v = data_.vertices[i];
      x.segment<freedom>(freedom * j) = directions_[i].transpose() * (points_[v] - data_.points[v]);
    }
    Root root = find_root(
      std::move(x),
      [&](Eigen::VectorXd& offsets, Eigen::VectorXd& r) {
        put(rows, offsets);
        r.resize(offsets.size());
        return residual(rows, r);
      },
      data_.tolerance, data_.max_steps);
    put(rows, root.x);
    report_.steps = (std::max)(report_.steps, root.steps);
    return root.residual < root.first;
  }

  // moves the control points, by an edge at most
  void put(const Rows& rows, Eigen::VectorXd& x)
  {
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const auto v = data_.vertices[rows[j]];
      auto s = x.segment<freedom>(freedom * static_cast<Eigen::Index>(j));
      const double length = s.norm();
      if (length > data_.edge_length[v]) s *= data_.edge_length[v] / length;
      points_[v] = data_.points[v] + directions_[rows[j]] * s;
    }
  }

  // What P - L shall be perpendicular to: (M + nu) / ((M + nu) . nu), and a binormal.
  Directions conditions(std::size_t i) const
  {
    const auto v = data_.vertices[i];
    const Functionals& f = functionals_[i];
    Vector m = data_.normals[v];
    const bool has_control_normal = f.control_normal.squaredNorm() > 0.5;
    const Vector nu = data_.is_at_border[v] ? (has_control_normal ? f.control_normal : m)
                                            : f.surface_normal(points_, m);
    if (m.dot(nu) < 0) m = -m;
    const Vector sum = m + nu;
    Directions d;
    d.col(0) = sum / (std::max)(sum.dot(nu), 1e-3);
    if constexpr (freedom == 2) {
      const Vector b =
        f.has_tangents ? Vector(nu.cross(f.tangent(0, points_))) : Vector(Vector::Zero());
      d.col(1) = b.norm() > 0 ? Vector(b.normalized()) : Vector(directions_[i].col(1));
    }
    return d;
  }

  Offset w(std::size_t i) const { return conditions(i).transpose() * missing(i); }
  Vector missing(std::size_t i) const
  {
    return data_.points[data_.vertices[i]] - functionals_[i].limit(points_);
  }
  double slip(std::size_t i) const { return missing(i).norm(); }

  // sets w; the largest one, where an arc that is longer than an edge counts by its length
  double residual(const Rows& rows, Eigen::VectorXd& r) const
  {
    double largest = 0;
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const Offset w = this->w(rows[j]);
      r.segment<freedom>(freedom * static_cast<Eigen::Index>(j)) = w;
      const double slip = this->slip(rows[j]);
      const bool is_far = slip > data_.edge_length[data_.vertices[rows[j]]];
      largest = (std::max)(largest, finite_or_infinite(is_far ? slip : w.norm()));
    }
    return largest;
  }

  const Data& data_;
  Source& source_;
  std::vector<Functionals> functionals_;
  std::vector<Directions>
    directions_; // in which control points slide, of the vertices that are interpolated
  std::vector<Rows> components_;
  Vectors<dimension> points_;
  Limit_interpolation report_;
};

// The points that have a normal are interpolated; the residual is their distance from the limit, of which w is an estimate. Where
// the limit point is the point, nothing need be sought. Where the net is so coarse that arcs may mislead, a component for which the data
// would be the better net becomes these.
template <int dimension, int tangents>
Interpolation_result<dimension>
interpolate_by_sliding(Interpolation_data<dimension>& data,
                       Limit_source<dimension, tangents>& source,
                       typename Limit_source<dimension, tangents>::Farthest farthest_point)
{
  constexpr double coarse_slip = 0.25;
  constexpr unsigned most_changes = 8;
  const std::size_t left_out = leave_out_without_normal(data);
  auto result = Slide_interpolation<dimension, tangents>(data, source)();
  Limit_interpolation& report = result.report;
  report.left_out = left_out;
  if (report.slip <= report.tolerance) return result;
  const auto farthest_of = [&](const Vectors<dimension>& points) {
    return farthest_point(to_values<dimension>(points, result.normals, data), data.points,
                          data.vertices, data.tolerance / 8);
  };
  Farthest_point farthest = farthest_of(result.points);
  for (unsigned k = 0; k < most_changes && report.slip_of_edge > coarse_slip; ++k) {
    Vectors<dimension> points = result.points;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (data.components[v] == data.components[farthest.vertex]) points[v] = data.points[v];
    const Farthest_point next = farthest_of(points);
    if (!(next.distance < farthest.distance)) break;
    farthest = next;
    result.points = std::move(points);
  }
  report.residual = finite_or_infinite(farthest.distance);
  report.error = finite_or_infinite(farthest.error);
  return result;
}

// Normals M that are those of the surface that slides along them: the surface that interpolates with M
// tells its normals at the points P, and they become the next M. The normal at P is that at the limit
// point L, carried from L to P by the second fundamental form.
template <int dimension>
Vectors<3> next_natural_normals(const Interpolation_data<dimension>& data, Surface_limits& source,
                                const Vectors<3>& points)
{
  Limit_precision precision = data.precision();
  precision.second_forms = 2e-5;
  const auto functionals =
    source(to_values<3>(points, data.normals, data), data.vertices, precision);
  Vectors<3> next = data.normals;
  for (std::size_t i = 0; i < functionals.size(); ++i) {
    const auto v = data.vertices[i];
    const auto& f = functionals[i];
    if (data.is_at_border[v] != 0 || !f.has_tangents) continue;
    const Eigen_vector<3> nu = f.surface_normal(points, data.normals[v]);
    const Eigen_vector<3> n = nu - f.second_form * (data.points[v] - f.limit(points));
    const double length = n.norm();
    if (!(length > 0.1) || !std::isfinite(length) || n.dot(data.normals[v]) <= 0) continue;
    next[v] = n / length;
  }
  return next;
}

template <int dimension>
void find_natural_normals(Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source)
{
  constexpr unsigned most_rounds = 10;
  double last_change = 0;
  for (unsigned k = 0; k < most_rounds; ++k) {
    const auto result = Slide_interpolation<3, 2>(data, source)();
    if (result.report.steps == 0) return; // they are exact
    Vectors<3> next = next_natural_normals(data, source, result.points);
    double change = 0;
    for (const auto v : data.vertices)
      change = (std::max)(change, (next[v] - data.normals[v]).norm());
    if (k > 0 && !(change < 0.8 * last_change)) return;
    data.normals = std::move(next);
    if (change <= 1e-5) return;
    last_change = change;
  }
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_SLIDE_INTERPOLATION_H
