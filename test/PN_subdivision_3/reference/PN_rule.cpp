// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "PN_rule.h"

namespace reference {

Point_normal pn_rule(const Row& a, const Row& b, const Values& old, Real epsilon)
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

Values pn_round(const Matrix& weights, const Values& old)
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

Values linear_round(const Matrix& weights, const Values& old)
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
