// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WEIGHTS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WEIGHTS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_row.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_masks.h>
#include <CGAL/PN_subdivision_3/internal/numbers/Weight_number.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// whether a row times the matrix is the row, exactly
template <class FT>
bool is_left_eigenvector(const std::vector<std::pair<std::uint32_t, FT>>& row,
                         const Ring_matrix<FT>& matrix)
{
  std::vector<FT> difference(matrix.size(), FT(0));
  for (const auto& [i, x] : row) {
    difference[i] -= x;
    for (const auto& [j, weight] : matrix[i]) difference[j] += x * weight;
  }
  return std::all_of(difference.begin(), difference.end(), [](const FT& x) { return x == FT(0); });
}

// The limit mask in the number type FT. The weights sum to 1 as those of all rows do: the largest
// comes last and is what the others leave. In exact types they are the fractions that they are close
// to, if these make it the limit mask exactly; otherwise they are rounded, as those of the rows are. Other
// types than those of the processor get them from the matrix, with all the precision that they have.
template <class FT>
std::vector<std::pair<std::uint32_t, FT>>
limit_weights(const Ring_masks::Vector& limit, [[maybe_unused]] const Ring_matrix<FT>& matrix)
{
  if constexpr (!is_exact_v<FT> && !std::is_floating_point_v<FT>) return Limit_row<FT>(matrix)();
  std::size_t largest = 0;
  for (std::size_t i = 0; i < limit.size(); ++i)
    if (std::abs(limit[i]) > std::abs(limit[largest])) largest = i;
  const auto row_of = [&](const auto& weight_of) {
    std::vector<std::pair<std::uint32_t, FT>> row;
    FT sum(0);
    for (std::size_t i = 0; i < limit.size(); ++i) {
      if (i == largest || std::abs(limit[i]) <= 1e-17L) continue;
      row.emplace_back(static_cast<std::uint32_t>(i), weight_of(limit[i]));
      sum += row.back().second;
    }
    row.emplace_back(static_cast<std::uint32_t>(largest), FT(1) - sum);
    return row;
  };
  if constexpr (is_exact_v<FT>) {
    auto row = row_of([](long double x) {
      const auto fraction = as_fraction(x);
      return fraction ? FT(FT(fraction->first) / FT(fraction->second)) : rounded_weight<FT>(x);
    });
    if (is_left_eigenvector(row, matrix)) return row;
  }
  return row_of([](long double x) { return rounded_weight<FT>(x); });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WEIGHTS_H
