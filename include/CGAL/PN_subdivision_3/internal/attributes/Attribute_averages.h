// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_AVERAGES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_AVERAGES_H

#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Divides a vector by its length; zero stays zero.
template <class FT>
void make_unit(FT* begin, FT* end)
{
  FT largest(0);
  for (const FT* x = begin; x != end; ++x)
    if (const FT size = absolute_value(*x); size > largest) largest = size;
  if (!(largest > FT(0))) return;
  FT square(0);
  for (FT* x = begin; x != end; ++x) {
    *x /= largest; // whose square may be out of range
    square += *x * *x;
  }
  const FT inverse = Unit_normal_traits<FT>::inverse_length(square);
  for (FT* x = begin; x != end; ++x) *x *= inverse;
}

// divides the vectors of elements with so many numbers each by their lengths
template <class Numbers>
void make_units(std::size_t dimension, Numbers& numbers)
{
  for (std::size_t i = 0; i + dimension <= numbers.size(); i += dimension)
    make_unit(numbers.data() + i, numbers.data() + i + dimension);
}

// origin + sum, where sum = sum w_j (v_j - origin), or plain_sum() if the sum leaves the range of the numbers (infinite or
// huge values, NaN).
template <class FT, class Plain_sum>
FT average_from(const FT& origin, const FT& sum, [[maybe_unused]] const Plain_sum& plain_sum)
{
  if constexpr (std::is_floating_point_v<FT>) {
    if (sum == FT(0)) return origin; // a zero of either sign, too
    const FT result = origin + sum;
    return std::isfinite(result) ? result : plain_sum();
  } else
    return origin + sum;
}

// the average without differences, where these leave the range of the numbers
template <class FT, class Entry, class Value>
FT plain_average(const Entry* begin, const Entry* end, const Value& value)
{
  const FT& origin = value(begin->vertex);
  FT sum(0);
  bool are_equal = true;
  for (const Entry* e = begin; e != end; ++e) {
    const FT& x = value(e->vertex);
    are_equal = are_equal && x == origin;
    if (e->weight != FT(0)) sum += e->weight * x;
  }
  return are_equal ? origin : sum;
}

// The average of a row for values of n components, which follow one another.
template <class FT, class Entry, class Size>
void component_average(const Entry* begin, const Entry* end, Size n, const FT* old, FT* result)
{
  for (std::size_t c = 0; c < n; ++c) {
    const auto component = [&](auto v) -> const FT& { return old[v * std::size_t(n) + c]; };
    const FT& origin = component(begin->vertex);
    FT sum(0);
    for (const Entry* e = begin + 1; e != end; ++e)
      sum += e->weight * FT(component(e->vertex) - origin);
    result[c] =
      average_from<FT>(origin, sum, [&] { return plain_average<FT>(begin, end, component); });
  }
}

// The averages of rows of the same length of single numbers, as component_average() gives them: a few at once, since one is a
// chain of additions that waits for each.
template <class FT, class Entry>
void scalar_averages(const Entry* first, std::size_t length, std::size_t number, const FT* old,
                     FT* result)
{
  constexpr std::size_t together = 8;
  for (std::size_t begin = 0; begin < number; begin += together) {
    const std::size_t n = (std::min)(together, number - begin);
    const Entry* const rows = first + begin * length;
    FT origin[together], sum[together];
    for (std::size_t r = 0; r < together; ++r) {
      origin[r] = old[rows[(r < n ? r : 0) * length].vertex];
      sum[r] = FT(0);
    }
    for (std::size_t j = 1; j < length; ++j)
      for (std::size_t r = 0; r < together; ++r) {
        const Entry& e = rows[(r < n ? r : 0) * length + j];
        sum[r] += e.weight * FT(old[e.vertex] - origin[r]);
      }
    for (std::size_t r = 0; r < n; ++r)
      result[begin + r] = average_from<FT>(origin[r], sum[r], [&] {
        return plain_average<FT>(rows + r * length, rows + (r + 1) * length,
                                 [&](auto v) -> const FT& { return old[v]; });
      });
  }
}

// \name Kinds of values
// A value has n numbers. The average of a row that is a single entry is a copy.

// Numbers; directions become unit vectors when they are put.
template <class FT>
struct Number_values
{
  using Number = FT;
  using Of_column = FT;

  template <class Entry>
  static void average(const Entry* begin, const Entry* end, std::size_t n, const FT* old, FT* to)
  {
    using std::integral_constant;
    if (end - begin == 1)
      std::copy_n(old + begin->vertex * n, n, to);
    else if (n == 1)
      component_average(begin, end, integral_constant<std::size_t, 1>(), old, to);
    else if (n == 2)
      component_average(begin, end, integral_constant<std::size_t, 2>(), old, to);
    else if (n == 3)
      component_average(begin, end, integral_constant<std::size_t, 3>(), old, to);
    else
      component_average(begin, end, n, old, to);
  }
};

// Values of another type, one for each element.
template <class FT, class Traits>
struct Sum_values
{
  using Number = typename Traits::Sum;
  using Of_column = Number;

  template <class Entry>
  static void average(const Entry* begin, const Entry* end, std::size_t, const Number* old,
                      Number* to)
  {
    const Number& origin = old[begin->vertex];
    *to = origin;
    if (end - begin == 1) return;
    Number sum = Traits::difference(begin[1].weight, old[begin[1].vertex], origin);
    for (const Entry* e = begin + 2; e != end; ++e)
      sum = Number(sum + Traits::difference(e->weight, old[e->vertex], origin));
    *to = Number(origin + sum);
  }
};

// The shares that control vertices have in a place of the control mesh, by linear interpolation: one at a control vertex,
// two on an edge, as many as it has corners in a face.
class Control_shares
{
public:
  using Index = Level_connectivity::Index;

  Control_shares() = default;
  explicit Control_shares(Index v)
    : shares_(1, {v, 1})
  {}

  void add(const Control_shares& other, float weight)
  {
    for (const Share& added : other.shares_) {
      const auto own = std::find_if(shares_.begin(), shares_.end(),
                                    [&](const Share& s) { return s.first == added.first; });
      if (own != shares_.end())
        own->second += weight * added.second;
      else
        shares_.emplace_back(added.first, weight * added.second);
    }
  }

  // the control vertex with the largest share; of several the first
  Index nearest() const
  {
    constexpr float rounding = 1e-5f;
    float largest = 0;
    for (const Share& s : shares_) largest = (std::max)(largest, s.second);
    Index result = Level_connectivity::null;
    for (const auto& [v, share] : shares_)
      if (share >= largest - rounding) result = (std::min)(result, v); // null is the largest
    return result;
  }

private:
  using Share = std::pair<Index, float>;

  std::vector<Share> shares_;
};

// Labels: a new vertex is in the middle of the vertices with the main weights in its row, which are an old vertex, the ends of an
// edge, or the corners of a face.
template <class FT>
struct Label_values
{
  using Number = Control_shares;
  using Of_column = Level_connectivity::Index;

  template <class Entry>
  static void average(const Entry* begin, const Entry* end, std::size_t, const Control_shares* old,
                      Control_shares* to)
  {
    const auto weight = [](const FT& w) { return double(CGAL::to_double(w)); };
    double largest = 0;
    for (const Entry* e = begin; e != end; ++e) largest = (std::max)(largest, weight(e->weight));
    const auto is_main = [&](const Entry& e) { return weight(e.weight) > largest / 2; };
    const auto number = std::count_if(begin, end, is_main);
    *to = {};
    for (const Entry* e = begin; e != end; ++e)
      if (is_main(*e)) to->add(old[e->vertex], 1 / float(number));
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_AVERAGES_H
