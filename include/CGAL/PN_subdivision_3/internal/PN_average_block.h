// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PN_AVERAGE_BLOCK_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PN_AVERAGE_BLOCK_H

#include <CGAL/PN_subdivision_3/PN_average.h>
#include <CGAL/PN_subdivision_3/Stencil.h>
#include <CGAL/PN_subdivision_3/internal/Lanes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// How many rows are averaged at once. One PN average is a chain of a square root and divisions;
// many independent ones side by side hide its latency. Other number types gain nothing from it.
template <class FT>
constexpr std::size_t block_size_v =
  std::is_floating_point_v<FT> ? Stencil<FT>::maximum_number_of_rows : 1;

// The average of every row of a block by the row's own rule: any number type, and the linear rule.
template <class Average>
class Average_block
{
public:
  using FT = typename Average::FT;
  using Value = typename Average::Value;

  void operator()(const Stencil<FT>& rows, const Value* old, Value* result) const
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r)
      result[r] = average_(rows.begin(r), rows.end(r), old);
  }

  // normals by rows of their own
  void operator()(const Stencil<FT>& rows, const Stencil<FT>& normal_rows, const Value* old,
                  Value* result) const
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r)
      result[r] =
        average_(rows.begin(r), rows.end(r), normal_rows.begin(r), normal_rows.end(r), old);
  }

private:
  Average average_;
};

// The PN average in hardware floating point, in three passes over a block: sums, normalization,
// heights. It is PN_average but for the order in which heights are added; a row that fades or whose
// normal may vanish is left to PN_average itself.
template <class FT_, int dimension>
class Staged_PN_average_block
{
public:
  using FT = FT_;
  using Average = PN_average<FT, dimension>;
  using Value = typename Average::Value;

  void operator()(const Stencil<FT>& rows, const Value* old, Value* result) const
  {
    switch (rows.uniform_length()) { // the lengths that regular meshes have
    case 1:
      return copy(rows, old, result);
    case 2:
      return staged(Row<2>(rows), Row<2>(rows), old, result);
    case 3:
      return staged(Row<3>(rows), Row<3>(rows), old, result);
    case 4:
      return staged(Row<4>(rows), Row<4>(rows), old, result);
    case 6:
      return staged(Row<6>(rows), Row<6>(rows), old, result);
    case 7:
      return staged(Row<7>(rows), Row<7>(rows), old, result);
    case 8:
      return staged(Row<8>(rows), Row<8>(rows), old, result);
    case 9:
      return staged(Row<9>(rows), Row<9>(rows), old, result);
    case 16:
      return staged(Row<16>(rows), Row<16>(rows), old, result);
    default:
      return staged(Row<0>(rows), Row<0>(rows), old, result);
    }
  }

  void operator()(const Stencil<FT>& rows, const Stencil<FT>& normal_rows, const Value* old,
                  Value* result) const
  {
    staged(Row<0>(rows), Row<0>(normal_rows), old, result);
  }

private:
  static constexpr std::size_t capacity = block_size_v<FT>;
  using Vector = Coordinates<FT, dimension>;
  using Entry = typename Stencil<FT>::Entry;

  // The rows of a block; their length is known at compile time unless it is 0.
  template <std::size_t uniform_length>
  struct Row
  {
    explicit Row(const Stencil<FT>& s)
      : rows(s)
      , first(s.begin(0))
    {}
    const Entry* begin(std::size_t r) const
    {
      if constexpr (uniform_length == 0)
        return rows.begin(r);
      else
        return first + r * uniform_length;
    }
    std::size_t length(std::size_t r) const
    {
      if constexpr (uniform_length == 0)
        return static_cast<std::size_t>(rows.end(r) - rows.begin(r));
      else
        return uniform_length;
    }
    const Entry* end(std::size_t r) const { return begin(r) + length(r); }
    const Stencil<FT>& rows;
    const Entry* first;
  };

  static void copy(const Stencil<FT>& rows, const Value* old, Value* result)
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r) result[r] = old[rows.begin(r)->vertex];
  }

  template <class Rows, class Normal_rows>
  static void staged(const Rows& rows, const Normal_rows& normal_rows, const Value* old,
                     Value* result)
  {
    const std::size_t size = rows.rows.number_of_rows();
    FT length[capacity];
    bool careful[capacity];
    for (std::size_t r = 0; r < size; ++r) result[r] = sums(rows, normal_rows, r, old);
    for (std::size_t r = 0; r < size; ++r)
      length[r] = dot<FT, dimension>(result[r].normal, result[r].normal);
    // a length of 1/4 is far from vanishing for any mask that is of use
    for (std::size_t r = 0; r < size; ++r) careful[r] = !(length[r] > FT(1) / FT(16));
    for (std::size_t r = 0; r < size; ++r) length[r] = std::sqrt(length[r]);
    for (std::size_t r = 0; r < size; ++r)
      for (int c = 0; c < dimension; ++c) result[r].normal[c] /= length[r];
    for (std::size_t r = 0; r < size; ++r) {
      FT least_denominator(2);
      const FT h = height(rows, r, old, result[r], least_denominator);
      if (!(least_denominator >= fade_begin<FT>())) careful[r] = true;
      add_multiple<FT, dimension>(result[r].point, h, result[r].normal);
    }
    for (std::size_t r = 0; r < size; ++r)
      if (careful[r] || rows.length(r) == 1 || normal_rows.length(r) == 1)
        result[r] = careful_row(rows, normal_rows, r, old);
  }

  template <class Rows, class Normal_rows>
  static Value sums(const Rows& rows, const Normal_rows& normal_rows, std::size_t r,
                    const Value* old)
  {
    const Entry* const e = rows.begin(r);
    const std::size_t length = rows.length(r);
    if (&rows.rows == &normal_rows.rows) {
      Packed_value sum;
      for (std::size_t j = 0; j < length; ++j) sum.add_multiple(e[j].weight, old[e[j].vertex]);
      return sum.value();
    }
    Value sum;
    sum.point.fill(FT(0));
    sum.normal.fill(FT(0));
    for (std::size_t j = 0; j < length; ++j)
      add_multiple<FT, dimension>(sum.point, e[j].weight, old[e[j].vertex].point);
    const Entry* const m = normal_rows.begin(r);
    for (std::size_t j = 0; j < normal_rows.length(r); ++j)
      add_multiple<FT, dimension>(sum.normal, m[j].weight, old[m[j].vertex].normal);
    return sum;
  }

  // The 2 * dimension coordinates of a point and its normal, two by two.
  struct Packed_value
  {
    static_assert(sizeof(Value) == dimension * sizeof(Lanes<FT>), "coordinates without padding");

    Packed_value()
    {
      for (Lanes<FT>& l : lanes) l = Lanes<FT>::both(0);
    }
    void add_multiple(FT factor, const Value& v)
    {
      const char* const bytes = reinterpret_cast<const char*>(&v);
      for (int i = 0; i < dimension; ++i)
        lanes[i] =
          lanes[i] + Lanes<FT>::both(factor) * Lanes<FT>::load(bytes + i * sizeof(Lanes<FT>));
    }
    Value value() const
    {
      Value v;
      std::memcpy(&v, lanes, sizeof(Value));
      return v;
    }
    Lanes<FT> lanes[dimension];
  };

  // Two entries at a time; the order of the sums depends on nothing but the row.
  template <class Rows>
  static FT height(const Rows& rows, std::size_t r, const Value* old, const Value& result,
                   FT& least_denominator)
  {
    using Two = Lanes<FT>;
    Two point[dimension], normal[dimension];
    for (int c = 0; c < dimension; ++c) {
      point[c] = Two::both(result.point[c]);
      normal[c] = Two::both(result.normal[c]);
    }
    Two sum = Two::both(0), least = Two::both(2);
    const Entry* const e = rows.begin(r);
    const std::size_t length = rows.length(r);
    for (std::size_t j = 0; j + 1 < length; j += 2) {
      const Value& p0 = old[e[j].vertex];
      const Value& p1 = old[e[j + 1].vertex];
      Two s = Two::of(p0.normal[0], p1.normal[0]) + normal[0];
      Two numerator = s * (Two::of(p0.point[0], p1.point[0]) - point[0]);
      Two denominator = s * normal[0];
      for (int c = 1; c < dimension; ++c) {
        s = Two::of(p0.normal[c], p1.normal[c]) + normal[c];
        numerator = numerator + s * (Two::of(p0.point[c], p1.point[c]) - point[c]);
        denominator = denominator + s * normal[c];
      }
      sum = sum + Two::of(e[j].weight, e[j + 1].weight) * (numerator / denominator);
      least = lesser(denominator, least);
    }
    FT last(0);
    least_denominator = (std::min)(least[0], least[1]);
    if (length % 2 != 0) {
      const Entry& odd = e[length - 1];
      const auto h = pn_height<FT, dimension>(old[odd.vertex], result.point, result.normal);
      least_denominator = (std::min)(least_denominator, h.denominator);
      last = odd.weight * (h.numerator / h.denominator);
    }
    return sum[0] + sum[1] + last;
  }

  template <class Rows, class Normal_rows>
  static Value careful_row(const Rows& rows, const Normal_rows& normal_rows, std::size_t r,
                           const Value* old)
  {
    if (&rows.rows == &normal_rows.rows) return Average()(rows.begin(r), rows.end(r), old);
    return Average()(rows.begin(r), rows.end(r), normal_rows.begin(r), normal_rows.end(r), old);
  }
};

template <class Average>
struct Block_of
{
  using type = Average_block<Average>;
};

template <class FT, int dimension>
struct Block_of<PN_average<FT, dimension>>
{
  using type =
    std::conditional_t<std::is_floating_point_v<FT>, Staged_PN_average_block<FT, dimension>,
                       Average_block<PN_average<FT, dimension>>>;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PN_AVERAGE_BLOCK_H
