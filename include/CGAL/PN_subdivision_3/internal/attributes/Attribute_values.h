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
#include <CGAL/PN_subdivision_3/internal/attributes/Columns.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/number_type_basic.h>

#include <boost/container/small_vector.hpp>
#include <boost/container/vector.hpp>

#include <algorithm>
#include <any>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The values of an attribute of vertices or corners through the rounds. All levels have arrays of their own; a level is computed
// from the one before.
template <class FT>
class Row_values
{
public:
  using Index = Level_connectivity::Index;
  using Entry = typename Entry_row<FT>::Entry;
  static constexpr Index null = Level_connectivity::null;

  Row_values() = default;
  Row_values(const Row_values&) = delete;
  Row_values& operator=(const Row_values&) = delete;
  virtual ~Row_values() = default;

  // see Column
  virtual bool are_equal(Index a, Index b) const = 0;
  virtual void commit() noexcept = 0;
  virtual std::any take_list() = 0;

  // value i of the first level is the value of control element sources[i], any value where this is null
  virtual void begin(const std::vector<Index>& sources) = 0;
  virtual void begin_round(std::size_t number_of_values) = 0;
  // Begins a round whose first values, one for each element, are put. This may be at once, but by several threads only if the
  // column allows it; then all is_put() after the round.
  virtual void begin_last_round(std::size_t number_of_values, std::size_t number_of_elements,
                                bool has_threads) = 0;
  virtual void evaluate(Index value, const Entry* begin, const Entry* end) = 0;
  // for the rows from value `first` on; from several threads
  virtual void evaluate(Index first, const Stencil_block<FT>& rows) = 0;
  // a value of the new level
  virtual void copy(Index from, Index to) = 0;
  virtual void end_round() = 0;
  virtual bool is_put() const = 0;
  // puts the values of the last level: for element i value sources[i]; an element keeps its value if this is null
  virtual void put(const std::vector<Index>& sources) = 0;

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

template <class FT, class Kind>
class Rows final : public Row_values<FT>
{
public:
  using Number = typename Kind::Number;
  using Of_column = typename Kind::Of_column;
  using typename Row_values<FT>::Index;
  using typename Row_values<FT>::Entry;
  using Row_values<FT>::null;

  explicit Rows(std::unique_ptr<Column<Of_column>> column, bool are_directions = false)
    : column_(std::move(column))
    , n_(column_->numbers_of_value())
    , are_directions_(are_directions)
  {}

  bool are_equal(Index a, Index b) const override { return column_->are_equal(a, b); }
  void commit() noexcept override { column_->commit(); }
  std::any take_list() override { return column_->take_list(); }

  void begin(const std::vector<Index>& sources) override
  {
    old_.clear();
    old_.resize(sources.size() * n_);
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i] != null) read(sources[i], old_.data() + i * n_);
  }
  void begin_round(std::size_t number_of_values) override
  {
    new_.resize(number_of_values * n_, boost::container::default_init);
  }
  void begin_last_round(std::size_t number_of_values, std::size_t number_of_elements,
                        bool has_threads) override
  {
    puts_at_once_ = !has_threads || column_->has_concurrent_put();
    if (puts_at_once_)
      column_->begin(number_of_elements);
    else
      begin_round(number_of_values);
  }
  void evaluate(Index value, const Entry* begin, const Entry* end) override
  {
    if (!puts_at_once_) return Kind::average(begin, end, n_, old_.data(), new_.data() + value * n_);
    Buffer average(n_);
    Kind::average(begin, end, n_, old_.data(), average.data());
    put(value, 1, average);
  }
  void evaluate(Index first, const Stencil_block<FT>& rows) override
  {
    if (!puts_at_once_) return averages(rows, new_.data() + first * n_);
    Buffer results(rows.number_of_rows() * n_);
    averages(rows, results.data());
    put(first, rows.number_of_rows(), results);
  }
  void copy(Index from, Index to) override
  {
    for (std::size_t c = 0; !puts_at_once_ && c < n_; ++c) new_[to * n_ + c] = new_[from * n_ + c];
  }
  void end_round() override
  {
    if (puts_at_once_) return;
    old_ = std::move(new_);
    new_ = Values();
  }

  bool is_put() const override { return puts_at_once_; }
  void put(const std::vector<Index>& sources) override
  {
    column_->begin(sources.size());
    put(0, sources.size(), old_, sources.data());
  }

  std::unique_ptr<Row_values<FT>> part(const std::vector<Index>& sources) const override
  {
    auto result = std::make_unique<Rows>(column_->part(), are_directions_);
    result->old_.resize(sources.size() * n_);
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i] != null)
        std::copy_n(old_.begin() + sources[i] * n_, n_, result->old_.begin() + i * n_);
    return result;
  }

private:
  using Values = boost::container::vector<Number>;
  using Buffer = boost::container::small_vector<Number, 32>;

  void read(Index element, Number* to) const
  {
    if constexpr (std::is_same_v<Number, Of_column>)
      column_->read(element, to);
    else
      *to = Number(element);
  }
  void averages(const Stencil_block<FT>& rows, Number* results) const
  {
    const std::size_t number = rows.number_of_rows();
    if constexpr (std::is_floating_point_v<Number>)
      if (n_ == 1 && rows.uniform_length() > 1)
        return scalar_averages(rows.begin(0), rows.uniform_length(), number, old_.data(), results);
    for (std::size_t r = 0; r < number; ++r)
      Kind::average(rows.begin(r), rows.end(r), n_, old_.data(), results + r * n_);
  }
  // all values are changed to what the column takes
  template <class Any_values>
  void put(Index first, std::size_t number, Any_values& values, const Index* sources = nullptr)
  {
    if constexpr (std::is_same_v<Number, Of_column>) {
      if constexpr (std::is_same_v<Kind, Number_values<FT>>)
        if (are_directions_) make_units(n_, values);
      column_->put(first, number, values.data(), sources);
    } else {
      boost::container::small_vector<Of_column, 32> nearest;
      for (const Number& shares : values) nearest.push_back(shares.nearest());
      column_->put(first, number, nearest.data(), sources);
    }
  }

  const std::unique_ptr<Column<Of_column>> column_;
  const std::size_t n_; // the numbers of a value
  const bool are_directions_;
  Values old_, new_;
  bool puts_at_once_ = false;
};

// \name The attributes of a call

// Those that are copied without rows.
struct Columns_of_call
{
  template <class Number>
  using List = std::vector<std::unique_ptr<Column<Number>>>;

  List<Level_connectivity::Index> edges, faces;
  List<Origin_and_face> vertex_origins, edge_origins, face_origins;

  void take_parts_of_columns(const Columns_of_call& whole)
  {
    const auto take = [](auto& parts, const auto& columns) {
      for (const auto& column : columns) parts.push_back(column->part());
    };
    take(edges, whole.edges);
    take(faces, whole.faces);
    take(vertex_origins, whole.vertex_origins);
    take(edge_origins, whole.edge_origins);
    take(face_origins, whole.face_origins);
  }
  Level_origins::Kinds needed_origins() const
  {
    return {!vertex_origins.empty(), !edge_origins.empty() || !edges.empty(),
            !face_origins.empty() || !faces.empty()};
  }
};

// The attributes of a call, read from the mesh and its maps before the first round.
template <class FT>
struct Control_attributes : Columns_of_call
{
  std::vector<std::unique_ptr<Row_values<FT>>> vertices, corners;
  std::vector<Corner_rule> corner_rules;

  void commit() noexcept
  {
    const auto commit_all = [](auto&... lists) {
      const auto commit_list = [](auto& list) {
        for (auto& column : list) column->commit();
      };
      (commit_list(lists), ...);
    };
    commit_all(vertices, corners, edges, faces, vertex_origins, edge_origins, face_origins);
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_VALUES_H
