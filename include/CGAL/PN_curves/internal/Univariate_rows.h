// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_UNIVARIATE_ROWS_H
#define CGAL_PN_CURVES_INTERNAL_UNIVARIATE_ROWS_H

#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

namespace internal {

// The rows of a univariate mask: new point i has the weights a_{i - 2j} on the old points j.
template <class FT>
class Univariate_rows
{
public:
  using Index = std::int64_t;

  template <class Mask>
  explicit Univariate_rows(const Mask& mask)
  {
    const std::vector<FT> a = mask.template coefficients<FT>();
    const Index first = mask.first_index();
    twice_center_ = 2 * first + static_cast<Index>(a.size()) - 1;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const Index index = first + static_cast<Index>(k);
      if (CGAL::certainly(a[k] == FT(0))) continue;
      // index = i - 2j, where i is 0 or 1
      rows_[row_of(index)].emplace_back(((index & 1) - index) / 2, a[k]);
    }
    for (const std::size_t p : {0u, 1u}) close_row(p);
  }

  bool has_same_center(const Univariate_rows& other) const
  {
    return twice_center_ == other.twice_center_;
  }

  // whether old points have new points of their own
  bool is_primal() const { return twice_center_ % 2 == 0; }

  // the first new point that is not before the first old one
  Index first_point() const
  {
    return twice_center_ >= 0 ? (twice_center_ + 1) / 2 : -(-twice_center_ / 2);
  }

  // The new points [first, last) of a polygon with n points, in the numbering of the mask.
  std::pair<Index, Index> range(Index n, Curve_end end) const
  {
    if (end == Curve_end::closed) return {first_point(), first_point() + 2 * n};
    if (end == Curve_end::reflect) {
      const Index last = twice_center_ >= 0 ? twice_center_ / 2 : -((1 - twice_center_) / 2);
      return {first_point(), (std::max)(first_point(), 2 * (n - 1) + last + 1)};
    }
    return existing_range(n);
  }

  template <class Stencil>
  void emit_row(Index i, Index n, Curve_end end, Stencil& s) const
  {
    const auto& row = rows_[row_of(i)];
    const Index shift = shift_of(i);
    if (exists(i, n)) {
      for (const auto& [offset, weight] : row)
        s.add(static_cast<std::uint32_t>(shift + offset), weight);
      return;
    }
    Merged_row<FT> merged;
    for (const auto& [offset, weight] : row) fold(shift + offset, weight, n, end, merged);
    merged.emit_row(s);
  }

private:
  using Row = std::vector<std::pair<Index, FT>>;

  static std::size_t row_of(Index i) { return (i & 1) != 0 ? 1 : 0; }
  // by how much the old points of the row of the new point i are shifted to those of the row of its parity
  static Index shift_of(Index i) { return (i - (i & 1)) / 2; }

  // puts the largest weight last and makes it 1 minus the sum of the others
  void close_row(std::size_t parity)
  {
    Row& row = rows_[parity];
    FT sum(0);
    for (const auto& entry : row) sum += entry.second;
    const FT tolerance =
      FT(4) * machine_epsilon<FT>() * FT(static_cast<int>((std::max)(row.size(), std::size_t(1))));
    if (row.empty() || !CGAL::possibly(is_at_most(FT(sum - FT(1)), tolerance)) ||
        !CGAL::possibly(is_at_most(FT(FT(1) - sum), tolerance))) // also refuses NaN
      throw std::invalid_argument("PN_subdivision_3: the mask's coefficients of " +
                                  std::string(parity == 0 ? "even" : "odd") +
                                  " index do not sum to 1");
    auto largest = row.begin();
    for (auto e = row.begin(); e != row.end(); ++e)
      if (magnitude(e->second) > magnitude(largest->second)) largest = e;
    std::iter_swap(largest, std::prev(row.end()));
    sum = FT(0);
    for (std::size_t k = 0; k + 1 < row.size(); ++k) sum += row[k].second;
    row.back().second = FT(1) - sum;
    least_[parity] = greatest_[parity] = row.front().first;
    for (const auto& entry : row) {
      least_[parity] = (std::min)(least_[parity], entry.first);
      greatest_[parity] = (std::max)(greatest_[parity], entry.first);
    }
  }

  // whether all points of the row of i exist
  bool exists(Index i, Index n) const
  {
    const Index shift = shift_of(i);
    return shift + least_[row_of(i)] >= 0 && shift + greatest_[row_of(i)] < n;
  }

  // The longest run of points whose stencils exist: as far as the points of both parities do, with
  // at each end one more of the other parity.
  std::pair<Index, Index> existing_range(Index n) const
  {
    std::array<Index, 2> first{}, last{};
    for (const std::size_t p : {0u, 1u}) {
      const Index offset = p == 0 ? 0 : 1;
      first[p] = offset - 2 * least_[p];
      last[p] = 2 * (n - 1 - greatest_[p]) + offset;
    }
    Index begin = (std::max)(first[0], first[1]), end = (std::min)(last[0], last[1]) + 1;
    if (begin >= end)
      throw std::invalid_argument("PN_subdivision_3: an open polygon of " + std::to_string(n) +
                                  " points is too short for this mask with the end rule none: give "
                                  "it more points or reflect its ends");
    if (exists(begin - 1, n)) --begin;
    if (exists(end, n)) ++end;
    return {begin, end};
  }

  // Adds old point j, which may lie beyond the ends. Reflected in an end, it is twice the end minus the
  // point on the other side of it.
  static void fold(Index j, FT weight, Index n, Curve_end end, Merged_row<FT>& row)
  {
    const auto add = [&row](Index k, const FT& w) { row.add(static_cast<std::uint32_t>(k), w); };
    if (end == Curve_end::closed) return add(((j % n) + n) % n, weight);
    if (n == 1) return add(0, weight);
    while (j < 0 || j >= n) {
      const Index beyond = j < 0 ? 0 : n - 1;
      add(beyond, FT(2) * weight);
      j = 2 * beyond - j;
      weight = -weight;
    }
    add(j, weight);
  }

  std::array<Row, 2> rows_;
  std::array<Index, 2> least_{}, greatest_{};
  Index twice_center_ = 0;
};

} // namespace internal
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CURVES_INTERNAL_UNIVARIATE_ROWS_H
