// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The average along a crease in its matrix form: every entry is carried by T_j = 1 - (t_j + t)t'/d_j.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASE_RULE_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASE_RULE_H

#include "PN_rule.h"

namespace reference {

struct Crease_entries
{
  std::vector<Real> weights;
  std::vector<Vector> points, tangents;
};

inline Real smooth_step(Real x)
{
  x = (std::min)(Real(1), (std::max)(Real(0), x));
  return x * x * (3 - 2 * x);
}

class Crease_rule
{
public:
  explicit Crease_rule(const Crease_entries& entries,
                       Real epsilon = std::numeric_limits<double>::epsilon())
    : entries_(entries)
    , threshold_(4096 * epsilon)
    , tangent_(Vector::Zero())
  {
    const std::size_t n = entries.weights.size();
    Vector q = Vector::Zero(), sum = Vector::Zero();
    Real lengths = 0;
    for (std::size_t j = 0; j < n; ++j) {
      q += entries.weights[j] * entries.points[j];
      sum += entries.weights[j] * entries.tangents[j];
      lengths += std::abs(entries.weights[j]) * entries.tangents[j].norm();
    }
    if (sum.norm() > threshold_ * lengths)
      tangent_ = smooth_step(8 * sum.norm() / lengths) * sum / sum.norm();
    if (tangent_.norm() < Real(1e-6)) tangent_ = Vector::Zero(); // short ones are not kept
    Real all = 0;
    Square mean = Square::Zero();
    for (std::size_t j = 0; j < n; ++j) {
      const Vector& t = entries.tangents[j];
      const Real d = 1 + t.dot(tangent_);
      const Real w = entries.weights[j] * smooth_step((d - Real(1) / 64) / (Real(15) / 64));
      carry_.push_back(
        w == 0 ? Square(Square::Zero())
               : Square(w * (Square::Identity() - (t + tangent_) * tangent_.transpose() / d)));
      all += w;
      mean += carry_.back();
    }
    point_ = linear_point_ = q;
    if (all < Real(1) / 64) return;
    // q + sum w T (p - q) / W
    point_ -= mean * q / all;
    for (std::size_t j = 0; j < n; ++j) point_ += carry_[j] * entries.points[j] / all;
  }

  const Vector& point() const { return point_; }
  // at this part of the way from the linear point
  Vector point(Real w) const { return linear_point_ + w * (point_ - linear_point_); }
  const Vector& tangent() const { return tangent_; }
  Vector normal(const std::vector<Vector>& normals) const
  {
    Vector sum = Vector::Zero();
    Real lengths = 0;
    for (std::size_t j = 0; j < normals.size(); ++j) {
      sum += carry_[j] * normals[j];
      lengths += std::abs(entries_.weights[j]) * normals[j].norm();
    }
    return sum.norm() > threshold_ * lengths ? Vector(sum / sum.norm()) : Vector(Vector::Zero());
  }

private:
  Crease_entries entries_;
  Real threshold_;
  Vector tangent_, point_, linear_point_;
  std::vector<Square> carry_;
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASE_RULE_H
