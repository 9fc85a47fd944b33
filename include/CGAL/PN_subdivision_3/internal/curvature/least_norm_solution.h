// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_LEAST_NORM_SOLUTION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_LEAST_NORM_SOLUTION_H

#include <CGAL/PN_subdivision_3/internal/average/number_functions.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class FT>
using Triple_of = std::array<FT, 3>;

template <class FT>
FT dot_of_triples(const Triple_of<FT>& a, const Triple_of<FT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The shortest x with A x = b, for the columns of a 3x3 matrix A. Singular values below 1e-8 of the
// largest count as 0. By rotations of pairs of columns until all are perpendicular (one-sided Jacobi
// method), always in the same order.
template <class FT>
Triple_of<FT> least_norm_solution(std::array<Triple_of<FT>, 3> columns, const Triple_of<FT>& b)
{
  std::array<Triple_of<FT>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr std::size_t pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int sweep = 0; sweep < 12; ++sweep)
    for (const auto& [i, j] : pairs) {
      const FT product = dot_of_triples(columns[i], columns[j]);
      if (product == FT(0)) continue;
      const FT difference =
        dot_of_triples(columns[j], columns[j]) - dot_of_triples(columns[i], columns[i]);
      // tan of the smaller angle that makes them perpendicular
      const FT zeta = difference / (2 * product);
      const FT t = sign_of(zeta) / (absolute_value(zeta) + square_root_of<FT>(1 + zeta * zeta));
      const FT c = 1 / square_root_of<FT>(1 + t * t), s = c * t;
      for (auto* m : {&columns, &axes})
        for (std::size_t r = 0; r < 3; ++r) {
          const FT x = (*m)[i][r], y = (*m)[j][r];
          (*m)[i][r] = c * x - s * y;
          (*m)[j][r] = s * x + c * y;
        }
    }
  FT largest(0);
  for (const auto& column : columns) {
    const FT square = dot_of_triples(column, column);
    if (square > largest) largest = square;
  }
  Triple_of<FT> x{};
  for (std::size_t k = 0; k < 3; ++k) {
    const FT square = dot_of_triples(columns[k], columns[k]);
    if (!(square > FT(1e-16) * largest)) continue;
    const FT share = dot_of_triples(columns[k], b) / square;
    for (std::size_t r = 0; r < 3; ++r) x[r] += share * axes[k][r];
  }
  return x;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_LEAST_NORM_SOLUTION_H
