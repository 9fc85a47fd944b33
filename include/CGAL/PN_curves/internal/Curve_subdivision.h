// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_CURVE_SUBDIVISION_H
#define CGAL_PN_CURVES_INTERNAL_CURVE_SUBDIVISION_H

#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rows/PN_average_block.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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
  // by how much the row of the new point i is shifted against the row of its parity
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

template <class Mask>
constexpr bool is_linear_mask_v = false;
template <class Mask>
inline constexpr bool is_linear_mask_v<Linear_mask<Mask>> = true;

// The rows of the normals: the points' own, or those of another mask with the same center.
template <class FT, class Mask>
struct Normal_rows
{
  static constexpr bool differ = false;
  explicit Normal_rows(const Mask&) {}
};
template <class FT, class Mask, class Normal_mask>
struct Normal_rows<FT, Mask_with_normals<Mask, Normal_mask>>
{
  static constexpr bool differ = true;
  explicit Normal_rows(const Mask_with_normals<Mask, Normal_mask>& m)
    : rows(m.normal_mask)
  {}
  Univariate_rows<FT> rows;
};

template <class FT, int dimension, class Mask>
class Curve_subdivision
{
  using Round_mask = Mask_in_round<Mask>;

public:
  static constexpr bool is_pn = !is_linear_mask_v<Round_mask>;
  using Average = Average_of<is_pn, FT, dimension>;
  using Value = typename Average::Value;
  using Index = typename Univariate_rows<FT>::Index;
  using Vector_coordinates = Coordinates<FT, dimension>;

  // the roundness is that of all points
  Curve_subdivision(const Mask& mask, Curve_end end, const FT& roundness = FT(1))
    : block_(average_of_roundness<Average>(roundness))
    , mask_(mask)
    , rows_(mask_in_round(mask, 1))
    , normal_rows_(mask_in_round(mask, 1))
    , end_(end)
  {
    check_centers();
  }

  template <class Point, class Vector>
  void add(const Point& point, const Vector& normal)
  {
    const auto name = [this] { return "point " + std::to_string(values_.size()); };
    Point_normal<FT, dimension> value{coordinates_of<FT, dimension>(point),
                                      coordinates_of<FT, dimension>(normal)};
    check_finite<FT, dimension>(value.point, "position", name);
    check_finite<FT, dimension>(value.normal, "normal", name);
    if (is_near_overflow<FT, dimension>(value.point)) is_near_overflow_ = true;
    if constexpr (is_pn) {
      normalize_control_normal<FT, dimension>(value.normal, name);
      values_.push_back(value);
    } else
      values_.push_back(value.point);
  }

  template <class Point, class Vector>
  std::vector<std::pair<Point, Vector>> result(unsigned iterations)
  {
    return result<std::pair<Point, Vector>>(iterations, [](const Value& value) {
      return std::pair<Point, Vector>(from_coordinates<Point>(point_of(value)),
                                      from_coordinates<Vector>(normal_of(value)));
    });
  }

  // the curve as items that make_item(value) returns; the last round writes nothing else
  template <class Item, class Make_item>
  std::vector<Item> result(unsigned iterations, const Make_item& make_item)
  {
    std::vector<Item> curve;
    const auto append = [&](const Value* values, std::size_t n) {
      for (std::size_t i = 0; i < n; ++i) {
        if (is_near_overflow_)
          check_in_range<FT, dimension>(point_of(values[i]), [&] {
            return "point " + std::to_string(curve.size()) + " of the curve";
          });
        curve.push_back(make_item(values[i]));
      }
    };
    if (iterations == 0 || values_.empty()) {
      curve.reserve(values_.size());
      for (const Value& value : values_) curve.push_back(make_item(value));
      return curve;
    }
    check_sizes(iterations);
    begin_round(1);
    for (unsigned k = 1; k < iterations; ++k) {
      refine();
      begin_round(k + 1);
    }
    const auto [first, last] = range(size());
    curve.reserve(static_cast<std::size_t>(last - first));
    evaluate(first, last, append);
    return curve;
  }

  bool is_primal() const { return rows_.is_primal(); }
  Index size() const { return static_cast<Index>(values_.size()); }

  void begin_round([[maybe_unused]] unsigned k)
  {
    if constexpr (is_level_dependent_v<Mask>) {
      const Round_mask mask = mask_in_round(mask_, k);
      rows_ = Univariate_rows<FT>(mask);
      normal_rows_ = Normal_rows<FT, Round_mask>(mask);
      check_centers();
    }
  }

  // the new points of a polygon with n points
  std::pair<Index, Index> range(Index n) const
  {
    std::pair<Index, Index> r = rows_.range(n, end_);
    if constexpr (Normal_rows<FT, Round_mask>::differ) {
      const std::pair<Index, Index> other = normal_rows_.rows.range(n, end_);
      r = {(std::max)(r.first, other.first), (std::min)(r.second, other.second)};
    }
    return r;
  }

  // a round; by how many places it leaves out new points at the beginning
  Index refine()
  {
    const auto [first, last] = range(size());
    Values refined(static_cast<std::size_t>(last - first), boost::container::default_init);
    Value* next = refined.data();
    evaluate(first, last, [&next](const Value* values, std::size_t n) {
      for (std::size_t i = 0; i < n; ++i) *next++ = values[i];
    });
    values_ = std::move(refined);
    return first - rows_.first_point();
  }

  static Vector_coordinates normal_of([[maybe_unused]] const Value& value)
  {
    if constexpr (is_pn)
      return value.normal;
    else
      return zero_vector<FT, dimension>();
  }

private:
  using Block = typename Block_of<Average>::type;
  using Values = boost::container::vector<Value>;

  void check_centers() const
  {
    if constexpr (Normal_rows<FT, Round_mask>::differ)
      if (!rows_.has_same_center(normal_rows_.rows))
        throw std::invalid_argument(
          "PN_subdivision_3: the masks of points and normals must both be "
          "primal or both dual, with the same center");
  }

  // before the first round: none may need more points than can be numbered
  void check_sizes(unsigned iterations)
  {
    Index n = size();
    for (unsigned k = 1; k <= iterations; ++k) {
      begin_round(k);
      const auto [first, last] = range(n);
      if (last - first >= static_cast<Index>(UINT32_MAX))
        throw std::length_error("PN_subdivision_3: round " + std::to_string(k) + " of " +
                                std::to_string(iterations) + " would make " +
                                std::to_string(last - first) +
                                " points, more than can be numbered: ask for fewer rounds");
      if (last - first == n && !is_level_dependent_v<Mask>) return; // in all further rounds, too
      n = last - first;
    }
  }

  // Computes the new points [first, last) and hands them to sink(values, how many) in their order.
  // Rows of the same parity, which are equally long, are averaged together.
  template <class Sink>
  void evaluate(Index first, Index last, const Sink& sink) const
  {
    constexpr auto half = static_cast<Index>(block_size_v<FT>);
    Stencil_block<FT> rows, normal_rows;
    std::array<Value, static_cast<std::size_t>(half)> values;
    std::array<Value, static_cast<std::size_t>(2 * half)> ordered;
    for (Index begin = first; begin < last; begin += 2 * half) {
      const Index end = (std::min)(begin + 2 * half, last);
      for (const Index start : {begin, begin + 1}) {
        emit_row(rows_, start, end, rows);
        if constexpr (Normal_rows<FT, Round_mask>::differ)
          emit_row(normal_rows_.rows, start, end, normal_rows);
        average(rows, normal_rows, values.data(), start);
        for (std::size_t r = 0; r < rows.number_of_rows(); ++r)
          ordered[static_cast<std::size_t>(start - begin) + 2 * r] = values[r];
      }
      sink(ordered.data(), static_cast<std::size_t>(end - begin));
    }
  }

  void emit_row(const Univariate_rows<FT>& source, Index start, Index end,
                Stencil_block<FT>& rows) const
  {
    rows.clear();
    for (Index i = start; i < end; i += 2) {
      source.emit_row(i, size(), end_, rows.row());
      rows.close_row();
    }
  }

  void average(const Stencil_block<FT>& rows, [[maybe_unused]] const Stencil_block<FT>& normal_rows,
               Value* result, Index start) const
  try {
    if (rows.number_of_rows() == 0) return;
    if constexpr (Normal_rows<FT, Round_mask>::differ)
      block_(rows, normal_rows, values_.data(), result);
    else
      block_(rows, values_.data(), result);
  } catch (const Uncertain_conversion_exception&) {
    throw std::domain_error(
      "PN_subdivision_3: the precision of the number type does not decide whether "
      "the normal of new point " +
      std::to_string(start) + " vanishes or is opposite to a neighbor's: use a higher precision");
  }

  Block block_;
  const Mask& mask_;
  Univariate_rows<FT> rows_;
  Normal_rows<FT, Round_mask> normal_rows_;
  Curve_end end_;
  Values values_;
  bool is_near_overflow_ = false;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CURVES_INTERNAL_CURVE_SUBDIVISION_H
