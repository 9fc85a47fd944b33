// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_PRESCRIPTION_H
#define CGAL_PN_FITTING_3_INTERNAL_PRESCRIPTION_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/Smooth_correction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Control points for prescribed limit points and surface normals, with the control normals as they are:
// limit points and tangents are linear in the control points, so that one system of conditions is
// solved, together with the smoothest change.
template <int dimension>
class Prescription
{
public:
  using Functionals = Surface_limits::Functionals;

  // rings: how far from the vertices control points may move
  Prescription(const Level_connectivity& level, const Interpolation_data<dimension>& data,
               Surface_limits& source, std::vector<Prescribed_vertex> prescribed, unsigned rings)
    : data_(data)
    , source_(source)
    , prescribed_(std::move(prescribed))
    , vertices_(vertices_of(prescribed_))
    , correction_(level, vertices_, rings)
  {}

  Interpolation_result<3> operator()()
  {
    Interpolation_result<3> result;
    result.normals = data_.normals;
    result.points = data_.points;
    result.report.tolerance = data_.tolerance;
    meet(result.points, result.normals, result.report);
    return result;
  }

  // Brings the points to what is prescribed, if they are not there, with these control normals; returns
  // by how many tolerances they still miss it.
  double meet(Vectors<3>& points, const Vectors<3>& normals, Limit_interpolation& report)
  {
    double best = evaluate(points, normals);
    // with the functionals that are right for the data, then for the result
    for (unsigned k = 0; k < 3 && best > 1 && report.steps < data_.max_steps; ++k) {
      if (!correction_.set_conditions(conditions())) break;
      ++report.steps;
      Vectors<3> next = points;
      // what the first solution leaves is due to rounding
      for (unsigned refinement = 0; refinement < 3; ++refinement)
        if (!correction_.add_to(next, defects(next))) break;
      const double now = evaluate(next, normals);
      if (!(now < best)) break;
      best = now;
      points = std::move(next);
    }
    evaluate(points, normals);
    note_evaluation(functionals_, report);
    report.residual = point_residual(points);
    report.normal_residual = normal_residual(points);
    return best;
  }

  // the functionals of the last points, of each vertex
  const std::vector<Functionals>& functionals() const { return functionals_; }

private:
  using Vector = Eigen_vector<3>;
  using Index = Level_connectivity::Index;
  using Condition = typename Smooth_correction<dimension>::Condition;

  static constexpr double normal_tolerance = 1e-12; // in radians
  static constexpr unsigned most_rounds = 100;      // of normals

  static std::vector<Index> vertices_of(const std::vector<Prescribed_vertex>& prescribed)
  {
    std::vector<Index> vertices;
    vertices.reserve(prescribed.size());
    for (const Prescribed_vertex& p : prescribed) vertices.push_back(p.vertex);
    return vertices;
  }

  // Surface normals converge slowly, and there are few of these vertices.
  Limit_precision precision() const
  {
    Limit_precision p = data_.precision();
    p.tangents = normal_tolerance / 10;
    p.max_depth = (std::max)(p.max_depth, most_rounds);
    return p;
  }

  double evaluate(const Vectors<3>& points, const Vectors<3>& normals)
  {
    functionals_ = source_(to_values<3>(points, normals, data_), vertices_, precision());
    // the two are of different kinds: by how much they miss what is asked
    return point_residual(points) / (std::max)(data_.tolerance, 1e-300) +
           normal_residual(points) / normal_tolerance;
  }

  double point_residual(const Vectors<3>& points) const
  {
    double largest = 0;
    for (std::size_t i = 0; i < prescribed_.size(); ++i)
      if (prescribed_[i].point)
        largest = (std::max)(
          largest,
          finite_or_infinite((*prescribed_[i].point - functionals_[i].limit(points)).norm()));
    return largest;
  }
  double normal_residual(const Vectors<3>& points) const
  {
    double largest = 0;
    for (std::size_t i = 0; i < prescribed_.size(); ++i)
      if (prescribed_[i].normal) {
        const Vector& m = *prescribed_[i].normal;
        const Vector nu = functionals_[i].surface_normal(points, m);
        largest =
          (std::max)(largest, finite_or_infinite(std::atan2(m.cross(nu).norm(), m.dot(nu))));
      }
    return largest;
  }

  // of the vector x.p of the functional's rows [first, first + 3), times `row`; of length 1
  static Condition scaled(const Functionals& f, int first, const Vector& row, double& scale)
  {
    Condition c;
    double square = 0;
    for (const auto& e : f.entries) {
      c.emplace_back(e.vertex, e.block.template middleRows<3>(first).transpose() * row);
      square += c.back().second.squaredNorm();
    }
    scale = square > 0 ? 1 / std::sqrt(square) : 0;
    for (auto& entry : c) entry.second *= scale;
    return c;
  }

  std::vector<Condition> conditions()
  {
    std::vector<Condition> all;
    scales_.clear();
    for (std::size_t i = 0; i < prescribed_.size(); ++i) {
      if (prescribed_[i].point)
        for (int k = 0; k < 3; ++k)
          all.push_back(scaled(functionals_[i], 0, Vector::Unit(k), scales_.emplace_back()));
      if (prescribed_[i].normal)
        for (int a = 0; a < 2; ++a)
          all.push_back(
            scaled(functionals_[i], 3 * (1 + a), *prescribed_[i].normal, scales_.emplace_back()));
    }
    return all;
  }

  // what the conditions lack
  std::vector<double> defects(const Vectors<3>& points) const
  {
    std::vector<double> d;
    for (std::size_t i = 0; i < prescribed_.size(); ++i) {
      if (prescribed_[i].point) {
        const Vector x = *prescribed_[i].point - functionals_[i].limit(points);
        for (int k = 0; k < 3; ++k) d.push_back(scales_[d.size()] * x[k]);
      }
      if (prescribed_[i].normal)
        for (int a = 0; a < 2; ++a)
          d.push_back(-scales_[d.size()] *
                      prescribed_[i].normal->dot(functionals_[i].tangent(a, points)));
    }
    return d;
  }

  const Interpolation_data<3>& data_;
  Surface_limits& source_;
  const std::vector<Prescribed_vertex> prescribed_;
  const std::vector<Index> vertices_;
  Smooth_correction<dimension> correction_;
  std::vector<Functionals> functionals_;
  std::vector<double> scales_; // of the conditions
};

// the first vertex of a prescribed normal where the scheme has no tangent plane
inline std::optional<Level_connectivity::Index>
vertex_without_tangents(const std::vector<Prescribed_vertex>& prescribed,
                        const Interpolation_data<3>& data, Surface_limits& source)
{
  std::vector<Level_connectivity::Index> vertices;
  for (const Prescribed_vertex& p : prescribed)
    if (p.normal) vertices.push_back(p.vertex);
  Limit_precision precision = data.precision();
  precision.max_depth = 0;
  precision.with_blocks = false;
  const auto functionals =
    source(to_values<3>(data.points, data.normals, data), vertices, precision);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!functionals[i].has_tangents) return vertices[i];
  return std::nullopt;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_PRESCRIPTION_H
