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
Point_normal pn_rule(const Row& a, const Row& b, const Values& old,
                     Real epsilon = std::numeric_limits<double>::epsilon());

Values pn_round(const Matrix& weights, const Values& old);

Values linear_round(const Matrix& weights, const Values& old);

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_PN_RULE_H
