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
#include <CGAL/PN_subdivision_3/internal/average/Lanes.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/rows/Wide_PN_average.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

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
  // what old values are stored as
  using Stored_value = Value;

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

// A point and a normal as p_x n_x p_y n_y ...: both are summed, and their differences to q and -n
// taken, two coordinates at once from where they lie.
template <class FT, int dimension>
struct Interleaved_point_normal
{
  using Value = Point_normal<FT, dimension>;

  Interleaved_point_normal() = default;
  Interleaved_point_normal(const Value& v)
  {
    for (int c = 0; c < dimension; ++c) pairs[c] = Lanes<FT>::of(v.point[c], v.normal[c]);
  }
  operator Value() const
  {
    Value v;
    for (int c = 0; c < dimension; ++c) {
      v.point[c] = pairs[c][0];
      v.normal[c] = pairs[c][1];
    }
    return v;
  }
  Lanes<FT> pair(int c) const { return pairs[c]; }

  Lanes<FT> pairs[dimension];
};

// The same with a roundness. Pairs are read from numbers one after another: their alignment would make
// an eighth number of the seven, and new memory is what a round waits for.
template <class FT, int dimension>
struct Interleaved_point_normal_roundness
{
  using Value = Point_normal_roundness<FT, dimension>;

  Interleaved_point_normal_roundness() = default;
  Interleaved_point_normal_roundness(const Value& v)
    : roundness(v.roundness)
  {
    for (int c = 0; c < dimension; ++c) {
      pairs[c][0] = v.point[c];
      pairs[c][1] = v.normal[c];
    }
  }
  operator Value() const
  {
    Value v;
    for (int c = 0; c < dimension; ++c) {
      v.point[c] = pairs[c][0];
      v.normal[c] = pairs[c][1];
    }
    v.roundness = roundness;
    return v;
  }
  Lanes<FT> pair(int c) const { return Lanes<FT>::at(pairs[c]); }

  FT pairs[dimension][2];
  FT roundness;
};

template <class FT, int dimension, class Value>
using Interleaved =
  std::conditional_t<has_roundness_v<Value>, Interleaved_point_normal_roundness<FT, dimension>,
                     Interleaved_point_normal<FT, dimension>>;

// The PN average in hardware floating point, in three passes over a block: sums, normalization,
// heights. It is PN_average but for the order in which heights are added and for normals that are
// multiplied by 1/|N|, not divided by |N|; a row that fades or whose normal may vanish is left to
// PN_average itself. Rows of the same length are left to Wide, where the processor has the
// registers for it; it changes no bit of the result.
template <class Average_, int dimension,
          class Wide = Wide_PN_average<typename Average_::FT, dimension, typename Average_::Value>>
class Staged_PN_average_block
{
public:
  using FT = typename Average_::FT;
  using Average = Average_;
  using Value = typename Average::Value;
  using Stored_value = Interleaved<FT, dimension, Value>;

  Staged_PN_average_block() = default;
  explicit Staged_PN_average_block(const Average& average)
    : average_(average)
  {}

  void operator()(const Stencil_block<FT>& rows, const Stored_value* old, Value* result) const
  {
    if (rows.uniform_length() == 1) return copy(rows, old, result);
    if constexpr (Wide::maximum_length != 0)
      if (Wide::is_available()) return wide(rows, old, result);
    staged(rows, rows, 0, rows.number_of_rows(), old, result);
  }

  void operator()(const Stencil_block<FT>& rows, const Stencil_block<FT>& normal_rows,
                  const Stored_value* old, Value* result) const
  {
    staged(rows, normal_rows, 0, rows.number_of_rows(), old, result);
  }

private:
  static constexpr std::size_t capacity = block_size_v<FT>;
  using Vector = Coordinates<FT, dimension>;
  using Entry = typename Stencil_block<FT>::Entry;

  using Rows = Stencil_block<FT>;

  static std::size_t length(const Rows& rows, std::size_t r)
  {
    return static_cast<std::size_t>(rows.end(r) - rows.begin(r));
  }

  static void copy(const Stencil_block<FT>& rows, const Stored_value* old, Value* result)
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r) result[r] = old[rows.begin(r)->vertex];
  }

  void wide(const Stencil_block<FT>& rows, const Stored_value* old, Value* result) const
  {
    for (std::size_t first = 0, end; first < rows.number_of_rows(); first = end) {
      const std::size_t n = length(rows, first);
      end = end_of_run(rows, first);
      // one or two rows fill too little of the registers
      if (end - first < 3 || n == 1 || n > Wide::maximum_length) {
        staged(rows, rows, first, end, old, result);
        continue;
      }
      std::uint32_t fails =
        Wide::average(rows.begin(first), n, end - first, old, average_.roundness, result + first);
      for (std::size_t r = first; r < end && fails != 0; ++r, fails >>= 1)
        if ((fails & 1) != 0) result[r] = careful_row(rows, rows, r, old);
    }
  }

  // the end of the rows from `first` on that have the same length and are averaged together
  static std::size_t end_of_run(const Rows& rows, std::size_t first)
  {
    const std::size_t most =
      (std::min)(rows.number_of_rows(), first + Wide::maximum_number_of_rows);
    std::size_t end = first + 1;
    while (end < most && length(rows, end) == length(rows, first)) ++end;
    return end;
  }

  void staged(const Rows& rows, const Rows& normal_rows, std::size_t begin, std::size_t end,
              const Stored_value* old, Value* result) const
  {
    FT scale[capacity];
    for (std::size_t r = begin; r < end; ++r) {
      result[r] = sums(rows, normal_rows, r, old);
      scale[r] = (std::max)(dot<FT, dimension>(result[r].normal, result[r].normal),
                            least_squared_length<FT>());
    }
    for (std::size_t r = begin; r < end; ++r) scale[r] = std::sqrt(scale[r]);
    for (std::size_t r = begin; r < end; ++r) scale[r] = FT(1) / scale[r];
    for (std::size_t r = begin; r < end; ++r) {
      for (int c = 0; c < dimension; ++c) result[r].normal[c] *= scale[r];
      FT least_denominator(2);
      FT h = height(rows, r, old, result[r], least_denominator);
      if constexpr (has_roundness_v<Value>)
        h *= result[r].roundness;
      else
        h *= average_.roundness;
      add_multiple<FT, dimension>(result[r].point, h, result[r].normal);
      if (!(least_denominator >= fade_begin<FT>() && scale[r] < greatest_scale<FT>()) ||
          length(rows, r) == 1 || length(normal_rows, r) == 1)
        result[r] = careful_row(rows, normal_rows, r, old);
    }
  }

  static Value sums(const Rows& rows, const Rows& normal_rows, std::size_t r,
                    const Stored_value* old)
  {
    const Entry* const e = rows.begin(r);
    Value result = sum(e, length(rows, r), old);
    if (&rows != &normal_rows)
      result.normal = sum(normal_rows.begin(r), length(normal_rows, r), old).normal;
    return result;
  }

  static Value sum(const Entry* e, std::size_t length, const Stored_value* old)
  {
    Interleaved_point_normal<FT, dimension> result;
    [[maybe_unused]] FT roundness(0);
    for (Lanes<FT>& pair : result.pairs) pair = Lanes<FT>::both(0);
    for (std::size_t j = 0; j < length; ++j) {
      const Lanes<FT> weight = Lanes<FT>::both(e[j].weight);
      for (int c = 0; c < dimension; ++c)
        result.pairs[c] = result.pairs[c] + weight * old[e[j].vertex].pair(c);
      if constexpr (has_roundness_v<Value>) roundness += e[j].weight * old[e[j].vertex].roundness;
    }
    const Point_normal<FT, dimension> v = result;
    if constexpr (has_roundness_v<Value>)
      return {v.point, v.normal, roundness};
    else
      return v;
  }

  // Two entries at a time; the order of the sums depends on nothing but the row.
  static FT height(const Rows& rows, std::size_t r, const Stored_value* old, const Value& result,
                   FT& least_denominator)
  {
    using Two = Lanes<FT>;
    Two offset[dimension], normal[dimension];
    for (int c = 0; c < dimension; ++c) {
      offset[c] = Two::of(-result.point[c], result.normal[c]);
      normal[c] = Two::both(result.normal[c]);
    }
    Two sum = Two::both(0), least = Two::both(2);
    const Entry* const e = rows.begin(r);
    const std::size_t length = Staged_PN_average_block::length(rows, r);
    for (std::size_t j = 0; j + 1 < length; j += 2) {
      const Stored_value& v0 = old[e[j].vertex];
      const Stored_value& v1 = old[e[j + 1].vertex];
      Two numerator = Two::both(0), denominator = numerator; // else g++ 14 warns
      for (int c = 0; c < dimension; ++c) {
        // (p_j - q, n_j + n) of two entries
        const Two a = v0.pair(c) + offset[c], b = v1.pair(c) + offset[c];
        const Two s = second_of(a, b);
        const Two numerator_c = s * first_of(a, b), denominator_c = s * normal[c];
        numerator = c == 0 ? numerator_c : numerator + numerator_c;
        denominator = c == 0 ? denominator_c : denominator + denominator_c;
      }
      sum = sum + Two::of(e[j].weight, e[j + 1].weight) *
                    (numerator / greater(denominator, Two::both(fade_begin<FT>())));
      least = lesser(denominator, least);
    }
    FT last(0);
    least_denominator = (std::min)(least[0], least[1]);
    if (length % 2 != 0) {
      const Entry& odd = e[length - 1];
      const auto h = pn_height<FT, dimension>(Value(old[odd.vertex]), result.point, result.normal);
      least_denominator = (std::min)(least_denominator, h.denominator);
      last = odd.weight * (h.numerator / (std::max)(h.denominator, fade_begin<FT>()));
    }
    return sum[0] + sum[1] + last;
  }

  BOOST_NOINLINE Value careful_row(const Rows& rows, const Rows& normal_rows, std::size_t r,
                                   const Stored_value* old) const
  {
    const Old_values values{old};
    if (&rows == &normal_rows) return average_(rows.begin(r), rows.end(r), values);
    return average_(rows.begin(r), rows.end(r), normal_rows.begin(r), normal_rows.end(r), values);
  }

  // the stored values as PN_average wants them
  struct Old_values
  {
    Value operator[](std::size_t v) const { return stored[v]; }
    const Stored_value* stored;
  };

  Average average_{};
};

template <class Average>
struct Block_of
{
  using type = Average_block<Average>;
};

template <class FT, int dimension, class Value>
struct Block_of<PN_average<FT, dimension, Value>>
{
  using Average = PN_average<FT, dimension, Value>;
  using type =
    std::conditional_t<std::is_floating_point_v<FT>, Staged_PN_average_block<Average, dimension>,
                       Average_block<Average>>;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_PN_AVERAGE_BLOCK_H
