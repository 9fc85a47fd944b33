// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_PN_AVERAGE_BLOCK_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_PN_AVERAGE_BLOCK_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/rows/Vectorized_PN_average.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// How many rows are averaged at once. One PN average is a chain of a square root and divisions;
// many independent ones side by side hide its latency. Other number types gain nothing from it.
template <class FT>
constexpr std::size_t block_size_v =
  std::is_floating_point_v<FT> ? Stencil_block<FT>::maximum_number_of_rows : 1;

// The average of every row of a block by the row's own rule: any number type, and the linear rule.
template <class Average>
class Average_block
{
public:
  using FT = typename Average::FT;
  using Value = typename Average::Value;

  Average_block() = default;
  explicit Average_block(const Average& average)
    : average_(average)
  {}

  void operator()(const Stencil_block<FT>& rows, const Value* old, Value* result) const
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r)
      result[r] = average_(rows.begin(r), rows.end(r), old);
  }

  // normals by rows of their own
  void operator()(const Stencil_block<FT>& rows, const Stencil_block<FT>& normal_rows,
                  const Value* old, Value* result) const
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r)
      result[r] =
        average_(rows.begin(r), rows.end(r), normal_rows.begin(r), normal_rows.end(r), old);
  }

private:
  Average average_{};
};

// The PN average in hardware floating point, in three passes over a block: sums, normalization,
// heights. It is PN_average but for the order in which heights are added and for normals that are
// multiplied by 1/|N|, not divided by |N|; a row that fades or whose normal may vanish is left to
// PN_average itself. Rows of the same length are averaged several at once, where the processor has the
// registers for it, which changes no bit of the result.
template <class Average_, int dimension,
          class Vectorized = Vectorized_PN_average<typename Average_::FT, dimension>>
class Staged_PN_average_block
{
public:
  using FT = typename Average_::FT;
  using Average = Average_;
  using Value = typename Average::Value;

  Staged_PN_average_block() = default;
  explicit Staged_PN_average_block(const Average& average)
    : average_(average)
  {}

  void operator()(const Stencil_block<FT>& rows, const Value* old, Value* result) const
  {
    if (rows.uniform_length() == 1) return copy(rows, old, result);
    if constexpr (Vectorized::maximum_length != 0)
      if (Vectorized::is_available()) return vectorized(rows, old, result);
    staged(rows, rows, 0, rows.number_of_rows(), old, result);
  }

  void operator()(const Stencil_block<FT>& rows, const Stencil_block<FT>& normal_rows,
                  const Value* old, Value* result) const
  {
    staged(rows, normal_rows, 0, rows.number_of_rows(), old, result);
  }

private:
  static constexpr std::size_t capacity = block_size_v<FT>;
  using Entry = typename Stencil_block<FT>::Entry;
  using Rows = Stencil_block<FT>;

  static std::size_t length(const Rows& rows, std::size_t r)
  {
    return static_cast<std::size_t>(rows.end(r) - rows.begin(r));
  }

  static void copy(const Stencil_block<FT>& rows, const Value* old, Value* result)
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r) result[r] = old[rows.begin(r)->vertex];
  }

  void vectorized(const Stencil_block<FT>& rows, const Value* old, Value* result) const
  {
    for (std::size_t first = 0, end; first < rows.number_of_rows(); first = end) {
      const std::size_t n = length(rows, first);
      end = end_of_run(rows, first);
      // one or two rows fill too little of the registers
      if (end - first < 3 || n == 1 || n > Vectorized::maximum_length) {
        staged(rows, rows, first, end, old, result);
        continue;
      }
      std::uint32_t fails =
        Vectorized::average(rows.begin(first), n, end - first, old,
                            average_.roundness ? &*average_.roundness : nullptr, result + first);
      for (std::size_t r = first; r < end && fails != 0; ++r, fails >>= 1)
        if ((fails & 1) != 0) result[r] = careful_row(rows, rows, r, old);
    }
  }

  // the end of the rows from `first` on that have the same length and are averaged together
  static std::size_t end_of_run(const Rows& rows, std::size_t first)
  {
    const std::size_t most =
      (std::min)(rows.number_of_rows(), first + Vectorized::maximum_number_of_rows);
    std::size_t end = first + 1;
    while (end < most && length(rows, end) == length(rows, first)) ++end;
    return end;
  }

  void staged(const Rows& rows, const Rows& normal_rows, std::size_t begin, std::size_t end,
              const Value* old, Value* result) const
  {
    FT scale[capacity];
    for (std::size_t r = begin; r < end; ++r) {
      result[r] = sums(rows, normal_rows, r, old);
      scale[r] = (std::max)(dot(result[r].normal, result[r].normal), least_squared_length<FT>());
    }
    for (std::size_t r = begin; r < end; ++r) scale[r] = std::sqrt(scale[r]);
    for (std::size_t r = begin; r < end; ++r) scale[r] = FT(1) / scale[r];
    for (std::size_t r = begin; r < end; ++r) {
      for (int c = 0; c < dimension; ++c) result[r].normal[c] *= scale[r];
      FT least_denominator(2);
      FT h = height(rows, r, old, result[r], least_denominator);
      h *= result[r].roundness;
      add_multiple(result[r].point, h, result[r].normal);
      if (!(least_denominator >= fade_begin<FT>() && scale[r] < greatest_scale<FT>()) ||
          length(rows, r) == 1 || length(normal_rows, r) == 1)
        result[r] = careful_row(rows, normal_rows, r, old);
    }
  }

  Value sums(const Rows& rows, const Rows& normal_rows, std::size_t r, const Value* old) const
  {
    Value result{};
    for (const Entry* e = rows.begin(r); e != rows.end(r); ++e)
      add_multiple(result.point, e->weight, old[e->vertex].point);
    result.roundness = average_.roundness.value_or(FT(0));
    for (const Entry* e = rows.begin(r); !average_.roundness && e != rows.end(r); ++e)
      result.roundness += e->weight * old[e->vertex].roundness;
    for (const Entry* e = normal_rows.begin(r); e != normal_rows.end(r); ++e)
      add_multiple(result.normal, e->weight, old[e->vertex].normal);
    return result;
  }

  // Two sums by turns; their order depends on nothing but the row.
  static FT height(const Rows& rows, std::size_t r, const Value* old, const Value& result,
                   FT& least_denominator)
  {
    FT even(0), odd(0), last(0);
    const auto weighted = [&](const Entry& e) {
      const auto h = pn_height<FT, dimension>(old[e.vertex], result.point, result.normal);
      least_denominator = (std::min)(least_denominator, h.denominator);
      return e.weight * (h.numerator / (std::max)(fade_begin<FT>(), h.denominator));
    };
    const Entry* e = rows.begin(r);
    for (; rows.end(r) - e > 1; e += 2) {
      even += weighted(e[0]);
      odd += weighted(e[1]);
    }
    if (e != rows.end(r)) last = weighted(*e);
    return even + odd + last;
  }

  BOOST_NOINLINE Value careful_row(const Rows& rows, const Rows& normal_rows, std::size_t r,
                                   const Value* old) const
  {
    if (&rows == &normal_rows) return average_(rows.begin(r), rows.end(r), old);
    return average_(rows.begin(r), rows.end(r), normal_rows.begin(r), normal_rows.end(r), old);
  }

  Average average_{};
};

template <class Average>
struct Block_of
{
  using type = Average_block<Average>;
};

template <class FT, int dimension>
struct Block_of<PN_average<FT, dimension>>
{
  using Average = PN_average<FT, dimension>;
  using type =
    std::conditional_t<std::is_floating_point_v<FT>, Staged_PN_average_block<Average, dimension>,
                       Average_block<Average>>;
};

// the average of rows, with normals or without
template <bool with_normals, class FT, int dimension>
using Average_of =
  std::conditional_t<with_normals, PN_average<FT, dimension>, Linear_average<FT, dimension>>;

// the average of values that have one roundness; of points alone it plays no part
template <class Average>
Average average_of_roundness([[maybe_unused]] const typename Average::FT& roundness)
{
  Average average{};
  if constexpr (has_normal_v<typename Average::Value>) average.roundness = roundness;
  return average;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_PN_AVERAGE_BLOCK_H
