// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_CURVE_LIMITS_H
#define CGAL_PN_CURVES_INTERNAL_CURVE_LIMITS_H

#include <CGAL/PN_curves/internal/Curve_subdivision.h>
#include <CGAL/PN_curves/internal/Curve_windows.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Settled_neighborhood.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What is asked of the limit of a curve; tolerances are absolute.
struct Curve_limit_demand
{
  double tolerance = 0, normal_tolerance = 0;
  unsigned max_depth = 0;
  bool normals = false, curvatures = false;
};

template <class Average, int dimension>
struct Curve_limit_result
{
  typename Average::Value value; // point and control normal
  Coordinates<double, dimension> tangent{}, curvature_vector{};
  double error = 0, tangent_error = 0;
  unsigned depth = 0; // rounds
  bool has_tangent = false, has_curvature = false;
};

// The limits of a control polygon. Each has a window of points, which is refined round by round on its own until
// the averages of the limit mask over it no longer change; see Limit_tower, which does the same on surfaces.
template <class FT, int dimension_, class Mask>
class Curve_limits
{
  static_assert(!Is_level_dependent<Mask>::value,
                "PN_subdivision_3: limits are known of masks that are the same from some round on: "
                "make the mask of a vector of masks, level_dependent_mask(masks)");

public:
  static constexpr int dimension = dimension_;
  static constexpr bool is_pn = !Is_linear_mask<Mask>::value;
  using Average = Average_of<is_pn, FT, dimension>;
  using Value = typename Average::Value;
  using Result = Curve_limit_result<Average, dimension>;
  using Index = std::int64_t;

  Curve_limits(const Mask& mask, Curve_end end, const Curve_limit_demand& demand,
               const FT& roundness = FT(1))
    : average_(average_of_roundness<Average>(roundness))
    , roundness_(close_double(roundness))
    , windows_(mask)
    , end_(end)
    , demand_(demand)
  {
    if constexpr (has_normal_mask) {
      Curve_windows<FT>& normals = own_normal_windows_.emplace(mask.normal_mask);
      if (!windows_.has_same_center(normals))
        throw std::invalid_argument("PN_subdivision_3: the masks of points and normals must both "
                                    "be primal or both dual, with the same center");
      windows_.widen(normals.full());
      normals.widen(windows_.full());
    }
    const Window& inner = windows_.at(windows_.full());
    const Window& inner_normals = normal_windows().at(windows_.full());
    // an end shows nothing of what the curve does next to it
    has_curvature_ = inner.has_curvature && !inner_normals.first_derivative.empty();
  }

  static Coordinates<FT, dimension>& point_of(Value& v)
  {
    if constexpr (is_pn)
      return v.point;
    else
      return v;
  }
  static Coordinates<FT, dimension> point_of(const Value& v)
  {
    if constexpr (is_pn)
      return v.point;
    else
      return v;
  }

  bool is_primal() const { return windows_.is_primal(); }

  // the first and the number of the vertices, or of the edges if the mask is dual, that have a limit
  std::pair<Index, Index> range(Index n) const
  {
    if (n == 0) return {0, 0};
    windows_.check_size(n, end_);
    if constexpr (has_normal_mask) own_normal_windows_->check_size(n, end_);
    const Index all = is_primal() || end_ == Curve_end::closed ? n : n - 1;
    if (end_ != Curve_end::none) return {0, all};
    const Window_size full = windows_.full();
    return {full.first, (std::max)(Index(0), n - full.first - full.second)};
  }

  // of vertex or edge v
  Result operator()(const std::vector<Value>& values, Index v)
  try {
    const auto n = static_cast<Index>(values.size());
    Window_size size = windows_.full();
    if (end_ != Curve_end::closed)
      size = {(std::min)(size.first, v), (std::min)(size.second, n - 1 - v)};
    const Coordinates<FT, dimension> center = point_of(values[static_cast<std::size_t>(v)]);
    window_.clear();
    for (Index j = v - size.first; j <= v + size.second; ++j)
      window_.push_back(
        relative(values[static_cast<std::size_t>(((j % n) + n) % n)], center, FT(-1)));
    Result result;
    for (; windows_.at(size).next != size; ++result.depth) size = refine(size);
    converge(size, result);
    result.value = relative(result.value, center, FT(1));
    return result;
  } catch (const Uncertain_conversion_exception&) {
    throw std::domain_error(
      "PN_subdivision_3: the precision of the number type does not decide whether a normal next to "
      "point " +
      std::to_string(v) + " vanishes or is opposite to a neighbor's: use a higher precision");
  }

private:
  using Window = Curve_window<FT>;
  using Vector = Coordinates<double, dimension>;
  static constexpr bool has_normal_mask = Normal_rows<FT, Mask>::differ;

  // the error of a curvature falls by 1/4 a round, or by 1/2 at an end
  static constexpr unsigned curvature_depth = 10;
  // in smaller windows than those of so many rounds second differences are those of rounding
  static constexpr unsigned most_curvature_depth = 12;

  Curve_windows<FT>& normal_windows()
  {
    return own_normal_windows_ ? *own_normal_windows_ : windows_;
  }

  // Floating point keeps more digits of a window about the origin; intervals would only grow.
  static Value relative(Value v, [[maybe_unused]] const Coordinates<FT, dimension>& center,
                        [[maybe_unused]] const FT& sign)
  {
    if constexpr (std::is_floating_point_v<FT>)
      add_multiple<FT, dimension>(point_of(v), sign, center);
    return v;
  }

  using Row = std::vector<typename Window::Entry>;
  Value average(const Row& row, [[maybe_unused]] const Row& normal_row) const
  {
    const auto* const first = row.data();
    if constexpr (has_normal_mask)
      return average_(first, first + row.size(), normal_row.data(),
                      normal_row.data() + normal_row.size(), window_.data());
    else
      return average_(first, first + row.size(), window_.data());
  }

  Window_size refine(const Window_size& size)
  {
    const Window& points = windows_.at(size);
    const Window& normals = normal_windows().at(size);
    next_.clear();
    for (std::size_t i = 0; i < points.rows.size(); ++i)
      next_.push_back(average(points.rows[i], normals.rows[i]));
    window_.swap(next_);
    return points.next;
  }

  void converge(const Window_size& size, Result& result)
  {
    const Window& points = windows_.at(size);
    const Window& normals = normal_windows().at(size);
    const bool is_exact = !is_pn || (points.limit_row.size() == 1 && normals.limit_row.size() == 1);
    if (!is_exact) refuse_intervals<FT>();
    const bool has_curvature =
      demand_.curvatures && has_curvature_ && points.has_curvature && points.rows.size() > 1;
    // as on surfaces: that of the geometric series which the differences become
    const double ratio =
      (std::min)(0.9, (std::max)(1. / 16, points.largest_other * points.largest_other));
    const double factor = limit_error_factor(ratio);
    Value last = Value();
    double last_step = 0;
    Tangents tangents;
    for (unsigned depth = 0;; ++depth, ++result.depth) {
      if (depth != 0) refine(size);
      result.value = average(points.limit_row, normals.limit_row);
      if (depth != 0 && !is_exact)
        result.error =
          limit_error(factor, ratio, distance(point_of(result.value), point_of(last)), last_step);
      bool is_last = (is_exact || depth != 0) && result.error <= demand_.tolerance;
      if (demand_.normals && !points.first_derivative.empty())
        is_last = note_tangent(points, depth, tangents, result) && is_last;
      if (has_curvature && is_pn && depth < curvature_depth) is_last = false;
      is_last = is_last || depth >= demand_.max_depth;
      if (has_curvature &&
          (is_last ? depth <= most_curvature_depth : depth == most_curvature_depth))
        note_curvature(points, normals, result);
      if (is_last) break;
      last = result.value;
    }
  }

  static double distance(const Coordinates<FT, dimension>& a, const Coordinates<FT, dimension>& b)
  {
    double square = 0;
    for (std::size_t c = 0; c < dimension; ++c) {
      const double d = close_double(FT(a[c] - b[c]));
      square = std::hypot(square, d);
    }
    return square;
  }

  static Point_normal<double, dimension> to_double_value(const Value& v)
  {
    Point_normal<double, dimension> value{};
    for (std::size_t c = 0; c < dimension; ++c) {
      value.point[c] = close_double(point_of(v)[c]);
      if constexpr (is_pn) value.normal[c] = close_double(v.normal[c]);
    }
    return value;
  }

  // of the window about its limit, which is taken away before coordinates are rounded to double
  Window_geometry<dimension> geometry(const Result& result)
  {
    double_window_.clear();
    double largest = 0;
    const Coordinates<FT, dimension> center = point_of(result.value);
    for (Value v : window_) {
      for (const FT& x : point_of(v)) largest = (std::max)(largest, std::abs(close_double(x)));
      add_multiple<FT, dimension>(point_of(v), FT(-1), center);
      double_window_.push_back(to_double_value(v));
    }
    rounding_ = largest * close_double(machine_epsilon<FT>());
    Point_normal<double, dimension> limit = to_double_value(result.value);
    limit.point = {};
    return Window_geometry<dimension>(double_window_, limit, roundness_);
  }

  // those of the rounds so far
  struct Tangents
  {
    Vector last{};
    double last_change = 0;
  };

  // whether it meets the tolerance, or no further round will make it better
  bool note_tangent(const Window& points, unsigned depth, Tangents& tangents, Result& result)
  {
    Vector t = geometry(result).derivative(points.first_derivative);
    double largest = 0;
    for (const double x : t) largest = (std::max)(largest, std::abs(x));
    if (!(largest > 0) || !std::isfinite(largest)) return true; // nor will there be one
    for (double& x : t) x /= largest; // its square neither overflows nor underflows now
    const double length = std::sqrt(dot<double, dimension>(t, t));
    for (double& x : t) x /= length;
    const Vector last = std::exchange(tangents.last, t);
    if (!is_pn || depth == 0 || !result.has_tangent) {
      result.tangent = t;
      result.has_tangent = true;
      return !is_pn;
    }
    double change = 0;
    for (std::size_t c = 0; c < dimension; ++c) change = std::hypot(change, t[c] - last[c]);
    // small windows have the rounding of large coordinates
    const double rounding = 4 * (rounding_ / largest + std::numeric_limits<double>::epsilon());
    // as for points, with 1/2 = 3/2 of 1/4 + 1/16 + ..., but 1 while it is not this series yet
    const double error = (std::max)({change, tangents.last_change / 4, rounding});
    tangents.last_change = change;
    // further rounds have more rounding still
    if (result.tangent_error > 0 && rounding >= result.tangent_error) return true;
    result.tangent = t;
    result.tangent_error = error;
    return error <= demand_.normal_tolerance;
  }

  void note_curvature(const Window& points, const Window& normals, Result& result)
  {
    const Vector k = geometry(result).curvature_vector(
      points.first_derivative, normals.first_derivative, points.second_derivative);
    for (const double x : k)
      if (!std::isfinite(x)) return;
    result.curvature_vector = k;
    result.has_curvature = true;
  }

  Average average_;
  double roundness_;
  Curve_windows<FT> windows_;
  std::optional<Curve_windows<FT>> own_normal_windows_; // if they differ
  Curve_end end_;
  Curve_limit_demand demand_;
  bool has_curvature_ = false;
  std::vector<Value> window_, next_;
  std::vector<Point_normal<double, dimension>> double_window_;
  double rounding_ = 0; // of the coordinates that it was taken from
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CURVES_INTERNAL_CURVE_LIMITS_H
