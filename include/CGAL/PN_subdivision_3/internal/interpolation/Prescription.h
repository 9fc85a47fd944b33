// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_PRESCRIPTION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_PRESCRIPTION_H

#include <CGAL/PN_subdivision_3/internal/interpolation/Interpolation_data.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Smooth_correction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What is prescribed at a vertex.
struct Prescribed_vertex
{
  Level_connectivity::Index vertex = 0;
  std::optional<Eigen_vector<3>> point;  // of the limit
  std::optional<Eigen_vector<3>> normal; // of the surface; a unit vector
};

// Control points for prescribed limit points and surface normals, with the control normals as they are:
// limit points and tangents are linear in the control points, so that one system of conditions is
// solved, together with the smoothest change.
class Prescription
{
public:
  using Functionals = Surface_limits::Functionals;

  Prescription(const Level_connectivity& level, const Interpolation_data<3>& data,
               Surface_limits& source, const std::vector<Prescribed_vertex>& prescribed)
    : level_(level)
    , data_(data)
    , source_(source)
    , prescribed_(prescribed)
  {
    for (const Prescribed_vertex& p : prescribed) vertices_.push_back(p.vertex);
  }

  // rings: how far from the vertices control points may move
  Interpolation_result<3> operator()(unsigned rings)
  {
    Interpolation_result<3> result;
    result.normals = data_.normals;
    result.points = data_.points;
    report_.tolerance = data_.tolerance;
    evaluate(result.points);
    best_ = residual_;
    Smooth_correction correction(level_, vertices_, rings);
    // with the functionals that are right for the data, then for the result
    for (unsigned k = 0; k < 3 && !is_met() && report_.steps < data_.max_steps; ++k) {
      if (!correction.set_conditions(conditions())) break;
      ++report_.steps;
      Vectors<3> points = result.points;
      // what the first solution leaves is due to rounding
      for (unsigned refinement = 0; refinement < 3; ++refinement)
        if (!correction.add_to(points, defects(points))) break;
      evaluate(points);
      if (!(residual_ < best_)) break;
      best_ = residual_;
      result.points = std::move(points);
    }
    evaluate(result.points);
    note_evaluation(functionals_, report_);
    report_.residual = point_residual(result.points);
    report_.normal_residual = normal_residual(result.points);
    result.report = report_;
    return result;
  }

  // the vertex of a prescribed normal where the scheme tells of no tangent plane
  std::optional<Level_connectivity::Index> vertex_without_tangents()
  {
    functionals_ = source_(values(data_.points), vertices_, data_.precision());
    for (std::size_t i = 0; i < prescribed_.size(); ++i)
      if (prescribed_[i].normal && !functionals_[i].has_tangents) return prescribed_[i].vertex;
    return std::nullopt;
  }

private:
  using Vector = Eigen_vector<3>;
  using Condition = Smooth_correction::Condition;

  static constexpr double normal_tolerance = 1e-12; // in radians

  std::vector<Point_normal<double, 3>> values(const Vectors<3>& points) const
  {
    return to_values<3>(points, data_.normals, data_.takes_normals);
  }

  // Surface normals converge by lambda^2 a round only, and there are few of these vertices.
  Limit_precision precision() const
  {
    constexpr unsigned depth_of_normals = 24;
    Limit_precision p = data_.precision();
    const auto has_normal = [](const Prescribed_vertex& v) { return v.normal.has_value(); };
    if (std::any_of(prescribed_.begin(), prescribed_.end(), has_normal))
      p.min_depth = p.max_depth = (std::max)(p.max_depth, depth_of_normals);
    return p;
  }

  void evaluate(const Vectors<3>& points)
  {
    functionals_ = source_(values(points), vertices_, precision());
    // the two are of different kinds: by how much they miss what is asked
    residual_ = point_residual(points) / (std::max)(data_.tolerance, 1e-300) +
                normal_residual(points) / normal_tolerance;
  }
  bool is_met() const { return best_ <= 1; }

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

  const Level_connectivity& level_;
  const Interpolation_data<3>& data_;
  Surface_limits& source_;
  const std::vector<Prescribed_vertex>& prescribed_;
  std::vector<Level_connectivity::Index> vertices_;
  std::vector<Functionals> functionals_;
  std::vector<double> scales_; // of the conditions
  double residual_ = 0, best_ = 0;
  Limit_interpolation_report report_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_PRESCRIPTION_H
