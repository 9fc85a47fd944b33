// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_EXACT_LIMIT_ROW_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_EXACT_LIMIT_ROW_H

#include <CGAL/PN_subdivision_3/internal/limit/Ring_masks.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The row l with l S = l and sum 1 in an exact field, by elimination; empty if there is not exactly one.
template <class FT>
Ring_row<FT> exact_limit_row(const Ring_matrix<FT>& matrix)
{
  const std::size_t n = matrix.size();
  // Equations for l: a row for each column of S - 1, of which the first depends on the others as rows of S
  // sum to 1; the sum takes its place. The right side is in column n.
  std::vector<std::vector<FT>> a(n, std::vector<FT>(n + 1, FT(0)));
  for (std::size_t i = 0; i < n; ++i) {
    a[i][i] -= FT(1);
    for (const auto& [j, weight] : matrix[i]) a[j][i] += weight;
  }
  a[0].assign(n + 1, FT(1));
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && a[pivot][k] == FT(0)) ++pivot;
    if (pivot == n) return {};
    std::swap(a[k], a[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || a[i][k] == FT(0)) continue;
      const FT factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j <= n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  Ring_row<FT> row;
  for (std::size_t k = 0; k < n; ++k) {
    const FT weight = a[k][n] / a[k][k];
    if (weight != FT(0)) row.emplace_back(static_cast<std::uint32_t>(k), weight);
  }
  return row;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_EXACT_LIMIT_ROW_H
