// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PN_AVERAGE_BLOCK_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PN_AVERAGE_BLOCK_H

#include <CGAL/PN_subdivision_3/PN_average.h>
#include <CGAL/PN_subdivision_3/Stencil.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// How many rows are averaged at once. One PN average is a chain of a square root and divisions;
// many independent ones side by side hide its latency. Other number types gain nothing from it.
template <class FT>
constexpr std::size_t block_size_v = std::is_floating_point_v<FT> ? 32 : 1;

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
// heights. Operation for operation it is PN_average; a row that fades or whose normal may vanish is
// left to PN_average itself.
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

  // Row r of a block; the length is known at compile time unless it is 0.
  template <std::size_t length>
  struct Row
  {
    explicit Row(const Stencil<FT>& s)
      : rows(s)
      , first(s.begin(0))
    {
    }
    const Entry* begin(std::size_t r) const
    {
      if constexpr (length == 0)
        return rows.begin(r);
      else
        return first + r * length;
    }
    const Entry* end(std::size_t r) const
    {
      if constexpr (length == 0)
        return rows.end(r);
      else
        return first + (r + 1) * length;
    }
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
    bool careful[capacity];
    FT length[capacity];
    for (std::size_t r = 0; r < size; ++r) sum_row(rows, normal_rows, r, old, result[r]);
    for (std::size_t r = 0; r < size; ++r) {
      const FT squared = dot<FT, dimension>(result[r].normal, result[r].normal);
      // a length of 1/4 is far from vanishing for any mask that is of use
      careful[r] = !(squared > FT(1) / FT(16));
      length[r] = squared;
    }
    for (std::size_t r = 0; r < size; ++r) length[r] = std::sqrt(length[r]);
    for (std::size_t r = 0; r < size; ++r)
      for (int c = 0; c < dimension; ++c) result[r].normal[c] /= length[r];
    for (std::size_t r = 0; r < size; ++r) {
      FT least_denominator(2);
      const FT h = height(rows, r, old, result[r], least_denominator);
      careful[r] = careful[r] || !(least_denominator >= fade_begin<FT>());
      add_multiple<FT, dimension>(result[r].point, h, result[r].normal);
    }
    for (std::size_t r = 0; r < size; ++r)
      if (careful[r] || rows.end(r) - rows.begin(r) == 1)
        result[r] = careful_row(rows, normal_rows, r, old);
  }

  template <class Rows, class Normal_rows>
  static void sum_row(const Rows& rows, const Normal_rows& normal_rows, std::size_t r,
                      const Value* old, Value& result)
  {
    Value sum;
    sum.point.fill(FT(0));
    sum.normal.fill(FT(0));
    const Entry* const end = rows.end(r);
    for (const Entry* e = rows.begin(r); e != end; ++e) {
      const Value& pj = old[e->vertex];
      add_multiple<FT, dimension>(sum.point, e->weight, pj.point);
      if (&rows.rows == &normal_rows.rows)
        add_multiple<FT, dimension>(sum.normal, e->weight, pj.normal);
    }
    if (&rows.rows != &normal_rows.rows) {
      const Entry* const normal_end = normal_rows.end(r);
      for (const Entry* e = normal_rows.begin(r); e != normal_end; ++e)
        add_multiple<FT, dimension>(sum.normal, e->weight, old[e->vertex].normal);
    }
    result = sum;
  }

  template <class Rows>
  static FT height(const Rows& rows, std::size_t r, const Value* old, const Value& result,
                   FT& least_denominator)
  {
    const Value local = result;
    FT sum(0), least(2);
    const Entry* const end = rows.end(r);
    for (const Entry* e = rows.begin(r); e != end; ++e) {
      const auto h = pn_height<FT, dimension>(old[e->vertex], local.point, local.normal);
      least = std::min(least, h.denominator);
      sum += e->weight * (h.numerator / h.denominator);
    }
    least_denominator = least;
    return sum;
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
