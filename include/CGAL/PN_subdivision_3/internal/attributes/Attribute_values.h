// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_VALUES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <any>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What the elements of the refined mesh get. Values that are put can be taken back until commit().
class Kept_values
{
public:
  using Index = Level_connectivity::Index;
  static constexpr Index null = Level_connectivity::null;

  Kept_values() = default;
  Kept_values(const Kept_values&) = delete;
  Kept_values& operator=(const Kept_values&) = delete;
  virtual ~Kept_values() = default;

  virtual void commit() noexcept = 0;
  // where the values of a part have been put: an Attribute_array, or a Map_of_numbers
  virtual std::any kept_of_part() { return {}; }
};

// The values of an attribute of the control mesh, which become the values of the refined mesh: on faces or edges
// by a copy, on vertices or corners by rows.
class Put_values : public Kept_values
{
public:
  // element i of the refined mesh gets value sources[i]
  virtual void put(const std::vector<Index>& sources) = 0;
};

// The values of control elements, and the value of a new element where the source is null.
class Copied_values : public Put_values
{
public:
  // the values for the elements of a part; this object must stay
  virtual std::unique_ptr<Copied_values> part() const = 0;
};

// All levels have arrays of their own; a level is computed from the one before.
template <class FT>
class Row_values : public Put_values
{
public:
  using Entry = typename Entry_row<FT>::Entry;

  // whether two values of the control mesh are equal
  virtual bool are_equal(Index a, Index b) const = 0;
  // value i of the first level is the value of control element sources[i], any value where this is null
  virtual void begin(const std::vector<Index>& sources) = 0;

  virtual void begin_round(std::size_t number_of_values) = 0;
  // Begins a round whose value i is put for element i. Values may be put at once, but by several threads only if the
  // map allows it; put() comes nevertheless.
  virtual void begin_last_round(std::size_t number_of_values, bool /*has_threads*/)
  {
    begin_round(number_of_values);
  }
  virtual void evaluate(Index value, const Entry* begin, const Entry* end) = 0;
  // for the rows from value `first` on; from several threads
  virtual void evaluate(Index first, const Stencil_block<FT>& rows)
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r)
      evaluate(first + Index(r), rows.begin(r), rows.end(r));
  }
  // a value of the new level
  virtual void copy(Index from, Index to) = 0;
  virtual void end_round() = 0;

  // value i for element i
  virtual void put_all(Index number) = 0;

  // put() puts the values of the last level; an element keeps its value if its source is null.

  // The values of a part of the level: value i is value sources[i], any value where this is null.
  virtual std::unique_ptr<Row_values> part(const std::vector<Index>& sources) const = 0;
};

// all control elements
inline std::vector<Level_connectivity::Index> first_indices(std::size_t n)
{
  std::vector<Level_connectivity::Index> result(n);
  std::iota(result.begin(), result.end(), 0u);
  return result;
}

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
inline void make_units(std::size_t dimension, std::vector<double>& values)
{
  for (std::size_t i = 0; i + dimension <= values.size(); i += dimension)
    make_unit(values.data() + i, values.data() + i + dimension);
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

// The average of a row for n components; component(v, c) is component c of value v.
template <class FT, class Entry, class Component, class Result>
void component_average(const Entry* begin, const Entry* end, std::size_t n,
                       const Component& component, const Result& result)
{
  for (std::size_t c = 0; c < n; ++c) {
    const FT& origin = component(begin->vertex, c);
    FT sum(0);
    for (const Entry* e = begin + 1; e != end; ++e)
      sum += e->weight * FT(component(e->vertex, c) - origin);
    result(c, average_from<FT>(origin, sum, [&] {
             return plain_average<FT>(begin, end,
                                      [&](auto v) -> const FT& { return component(v, c); });
           }));
  }
}

// The average of a row. A single entry is a copy.
template <class FT, class Traits, class Entry>
typename Traits::Sum affine_average(const Entry* begin, const Entry* end,
                                    const typename Traits::Sum* old)
{
  using Sum = typename Traits::Sum;
  const Sum& origin = old[begin->vertex];
  if (end - begin == 1) return origin;
  if constexpr (Traits::has_components) {
    Sum result;
    component_average<FT>(
      begin, end, result.size(),
      [&](Level_connectivity::Index v, std::size_t c) -> const FT& { return old[v][c]; },
      [&](std::size_t c, const FT& x) { result[c] = x; });
    return result;
  } else {
    Sum sum = Traits::difference(begin[1].weight, old[begin[1].vertex], origin);
    for (const Entry* e = begin + 2; e != end; ++e)
      sum = Sum(sum + Traits::difference(e->weight, old[e->vertex], origin));
    return Sum(origin + sum);
  }
}

// The averages of rows of the same length, as affine_average() gives them: a few at once, since one is a
// chain of additions that waits for each.
template <class FT, class Entry, class Result>
void scalar_averages(const Entry* first, std::size_t length, std::size_t number,
                     const std::array<FT, 1>* old, const Result& result)
{
  constexpr std::size_t together = 8;
  for (std::size_t begin = 0; begin < number; begin += together) {
    const std::size_t n = (std::min)(together, number - begin);
    const Entry* const rows = first + begin * length;
    FT origin[together], sum[together];
    for (std::size_t r = 0; r < together; ++r) {
      origin[r] = old[rows[(r < n ? r : 0) * length].vertex][0];
      sum[r] = FT(0);
    }
    for (std::size_t j = 1; j < length; ++j)
      for (std::size_t r = 0; r < together; ++r) {
        const Entry& e = rows[(r < n ? r : 0) * length + j];
        sum[r] += e.weight * FT(old[e.vertex][0] - origin[r]);
      }
    for (std::size_t r = 0; r < n; ++r)
      result(begin + r, std::array<FT, 1>{average_from<FT>(origin[r], sum[r], [&] {
               return plain_average<FT>(rows + r * length, rows + (r + 1) * length,
                                        [&](auto v) -> const FT& { return old[v][0]; });
             })});
  }
}

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
        shares_.push_back({added.first, weight * added.second});
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

// Values that vertices have from the nearest control vertices. A new vertex is in the middle of the vertices with the main
// weights in its row: an old vertex, the ends of an edge, or the corners of a face.
template <class FT>
class Nearest_values : public Row_values<FT>
{
public:
  using typename Row_values<FT>::Index;
  using typename Row_values<FT>::Entry;
  using Row_values<FT>::evaluate;
  using Row_values<FT>::null;

  explicit Nearest_values(std::unique_ptr<Copied_values> copied)
    : copied_(std::move(copied))
  {}
  // the values of a part
  Nearest_values(const Nearest_values& whole, const std::vector<Index>& sources)
    : copied_(whole.copied_->part())
  {
    for (const Index i : sources) old_.push_back(i == null ? Control_shares() : whole.old_[i]);
  }

  bool are_equal(Index a, Index b) const override { return a == b; }
  void begin(const std::vector<Index>& sources) override
  {
    old_.clear();
    for (const Index i : sources) old_.push_back(i == null ? Control_shares() : Control_shares(i));
  }

  void begin_round(std::size_t number_of_values) override { new_.resize(number_of_values); }
  void evaluate(Index value, const Entry* begin, const Entry* end) override
  {
    double largest = 0;
    for (const Entry* e = begin; e != end; ++e) largest = (std::max)(largest, weight(e->weight));
    const auto is_main = [&](const Entry& e) { return weight(e.weight) > largest / 2; };
    const auto number = std::count_if(begin, end, is_main);
    Control_shares& shares = new_[value] = {};
    for (const Entry* e = begin; e != end; ++e)
      if (is_main(*e)) shares.add(old_[e->vertex], 1 / float(number));
  }
  void copy(Index from, Index to) override { new_[to] = new_[from]; }
  void end_round() override
  {
    old_ = std::move(new_);
    new_.clear();
  }

  void put_all(Index number) override { put(first_indices(number)); }
  void put(const std::vector<Index>& sources) override
  {
    std::vector<Index> nearest;
    nearest.reserve(sources.size());
    for (const Index i : sources) nearest.push_back(i == null ? null : old_[i].nearest());
    copied_->put(nearest);
  }
  void commit() noexcept override { copied_->commit(); }

  std::unique_ptr<Row_values<FT>> part(const std::vector<Index>& sources) const override
  {
    return std::make_unique<Nearest_values>(*this, sources);
  }
  std::any kept_of_part() override { return copied_->kept_of_part(); }

private:
  static double weight(const FT& w) { return double(CGAL::to_double(w)); }

  std::unique_ptr<Copied_values> copied_;
  std::vector<Control_shares> old_, new_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_VALUES_H
