// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The point-normal rule in its matrix form, in long double: the new point is a sum of matrices
// times old points.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_PN_RULE_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_PN_RULE_H

#include "Face_list.h"

#include <limits>

namespace reference {

using Vector = Eigen::Matrix<Real, 3, 1>;
using Square = Eigen::Matrix<Real, 3, 3>;

struct Values
{
  std::vector<Vector> points, normals;
};

struct Point_normal
{
  Vector point, normal;
};

// The part that an entry keeps whose normal makes (n_j + n).n = d with the new normal.
inline Real share(Real d)
{
  const Real t = (std::min)(Real(1), (std::max)(Real(0), (256 * d - 24) / 51));
  return t * t * (3 - 2 * t);
}

// p = sum (a_j (I - sum w_l A_l) + w_j A_j) p_j with A_j = n (n_j + n)^T / ((n_j + n).n); w is a
// itself unless an entry fades.
inline Point_normal pn_rule(const Row& a, const Row& b, const Values& old,
                            Real epsilon = std::numeric_limits<double>::epsilon())
{
  Vector normal_sum = Vector::Zero();
  Real lengths = 0;
  for (Eigen::Index j = 0; j < a.size(); ++j) {
    normal_sum += b[j] * old.normals[std::size_t(j)];
    lengths += std::abs(b[j]) * old.normals[std::size_t(j)].norm();
  }
  const bool vanishes = normal_sum.norm() <= 4096 * epsilon * lengths;
  const Vector n = vanishes ? Vector::Zero() : Vector(normal_sum / normal_sum.norm());

  Row w = a;
  std::vector<Square> arcs(std::size_t(a.size()), Square::Zero());
  if (!vanishes) {
    for (Eigen::Index j = 0; j < a.size(); ++j) {
      if (a[j] == 0) continue;
      const Vector s = old.normals[std::size_t(j)] + n;
      w[j] *= share(s.dot(n));
      if (w[j] != 0) arcs[std::size_t(j)] = n * s.transpose() / s.dot(n);
    }
    if (w != a) w = w.sum() < Real(1) / 64 ? Row(Row::Zero(a.size())) : Row(w / w.sum());
  }
  Square common = Square::Identity();
  for (Eigen::Index j = 0; j < a.size(); ++j) common -= w[j] * arcs[std::size_t(j)];
  Vector point = Vector::Zero();
  for (Eigen::Index j = 0; j < a.size(); ++j)
    if (a[j] != 0)
      point += (a[j] * common + w[j] * arcs[std::size_t(j)]) * old.points[std::size_t(j)];
  return {point, n};
}

inline Values pn_round(const Matrix& weights, const Values& old)
{
  Values result;
  for (Eigen::Index i = 0; i < weights.rows(); ++i) {
    const Row row = weights.row(i);
    const Point_normal value = pn_rule(row, row, old);
    result.points.push_back(value.point);
    result.normals.push_back(value.normal);
  }
  return result;
}

inline Values linear_round(const Matrix& weights, const Values& old)
{
  Values result;
  for (Eigen::Index i = 0; i < weights.rows(); ++i) {
    Vector p = Vector::Zero();
    for (Eigen::Index j = 0; j < weights.cols(); ++j)
      p += weights(i, j) * old.points[std::size_t(j)];
    result.points.push_back(p);
  }
  result.normals.assign(result.points.size(), Vector::Zero());
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_PN_RULE_H
