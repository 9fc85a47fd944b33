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
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The limit at a vertex or edge. The tangent of a curve is asked for and reported as normals of surfaces are.
template <class Value, int dimension>
struct Curve_limit_result
{
  Value value; // point and control normal
  Coordinates<double, dimension> tangent{}, curvature_vector{};
  double error = 0, normal_error = 0;
  unsigned depth = 0; // rounds
  bool has_surface_normal = false, has_curvature = false;
};

// The limits of a control polygon. Each has a window of points, which is refined round by round on its own until
// the averages of the limit mask over it no longer change.
template <class FT, int dimension, class Mask>
class Curve_limits
{
  using Subdivision = Curve_subdivision<FT, dimension, Mask>;
  using Average = typename Subdivision::Average;

public:
  static constexpr bool is_pn = Subdivision::is_pn;
  using Value = typename Average::Value;
  using Result = Curve_limit_result<Value, dimension>;
  using Index = std::int64_t;

  Curve_limits(const Mask& mask, Curve_end end, const Limit_demand& demand, const FT& roundness)
    : average_(average_of_roundness<Average>(roundness))
    , roundness_(close_double(roundness))
    , end_(end)
    , demand_(demand)
  {
    Index half = Curve_windows<FT>::half_of(mask);
    if constexpr (has_normal_mask)
      half = (std::max)(half, Curve_windows<FT>::half_of(mask.normal_mask));
    windows_.emplace_back(mask, half);
    if constexpr (has_normal_mask) windows_.emplace_back(mask.normal_mask, half);
    // an end shows nothing of what the curve does next to it
    has_curvature_ = points(full()).has_curvature && !normals(full()).first_derivative.empty();
  }

  // the first vertex, or edge if the mask is dual, that has a limit, and the one behind the last
  std::pair<Index, Index> range(Index n) const
  {
    if (end_ == Curve_end::none) return {full().first, n - full().second};
    return {0, windows_[0].is_primal() || end_ == Curve_end::closed ? n : n - 1};
  }

  // the limit of vertex or edge v
  Result operator()(const std::vector<Value>& values, Index v)
  {
    const auto n = static_cast<Index>(values.size());
    Window_size size = full();
    if (end_ != Curve_end::closed)
      size = {(std::min)(size.first, v), (std::min)(size.second, n - 1 - v)};
    const Vector center = point_of(values[static_cast<std::size_t>(v)]);
    window_.clear();
    for (Index j = v - size.first; j <= v + size.second; ++j)
      window_.push_back(
        relative(values[static_cast<std::size_t>(((j % n) + n) % n)], center, FT(-1)));
    Result result;
    for (; points(size).next != size; ++result.depth) size = refine(size);
    converge(size, result);
    result.value = relative(result.value, center, FT(1));
    return result;
  }

private:
  using Window = Curve_window<FT>;
  using Vector = Coordinates<FT, dimension>;
  using Reals = Coordinates<double, dimension>;
  static constexpr bool has_normal_mask = Normal_rows<FT, Mask>::differ;

  // the error of a curvature falls by 1/4 a round, or by 1/2 at an end
  static constexpr unsigned curvature_depth = 10;
  // beyond so many rounds windows are so small that second differences are nothing but rounding
  static constexpr unsigned most_curvature_depth = 12;

  Window_size full() const { return windows_[0].full(); }
  const Window& points(const Window_size& size) { return windows_.front().at(size); }
  const Window& normals(const Window_size& size) { return windows_.back().at(size); }

  Value average(const Entry_row<FT>& row, [[maybe_unused]] const Entry_row<FT>& normal_row) const
  {
    if constexpr (has_normal_mask)
      return average_(row.begin(), row.end(), normal_row.begin(), normal_row.end(), window_.data());
    else
      return average_(row.begin(), row.end(), window_.data());
  }

  Window_size refine(const Window_size& size)
  {
    const Window &of_points = points(size), &of_normals = normals(size);
    next_.clear();
    for (std::size_t i = 0; i < of_points.rows.size(); ++i)
      next_.push_back(average(of_points.rows[i], of_normals.rows[i]));
    window_.swap(next_);
    return of_points.next;
  }

  void converge(const Window_size& size, Result& result)
  {
    const Window &of_points = points(size), &of_normals = normals(size);
    const auto is_one = [](const auto& row) { return row.end() - row.begin() == 1; };
    const bool is_exact = !is_pn || (is_one(of_points.limit_row) && is_one(of_normals.limit_row));
    const bool has_curvature =
      demand_.curvatures && has_curvature_ && of_points.has_curvature && of_points.rows.size() > 1;
    // as on surfaces: the error of the geometric series that the differences become
    const double square = of_points.largest_other * of_points.largest_other;
    Convergence<FT, dimension> steps(demand_, is_exact,
                                     (std::min)(0.9, (std::max)(1. / 16, square)));
    Tangents tangents;
    for (unsigned depth = 0;; ++depth, ++result.depth) {
      if (depth != 0) refine(size);
      result.value = average(of_points.limit_row, of_normals.limit_row);
      bool is_all_else_found = !has_curvature || !is_pn || depth >= curvature_depth;
      if (demand_.surface_normals && !of_points.first_derivative.empty())
        is_all_else_found = note_tangent(of_points, tangents, result) && is_all_else_found;
      const bool is_last = steps.is_last(point_of(result.value), is_all_else_found);
      if (has_curvature &&
          (is_last ? depth <= most_curvature_depth : depth == most_curvature_depth))
        note_curvature(of_points, of_normals, result);
      if (is_last) break;
    }
    result.error = steps.error();
  }

  static Reals to_reals(const Vector& v)
  {
    Reals r;
    for (std::size_t c = 0; c < dimension; ++c) r[c] = close_double(v[c]);
    return r;
  }

  // Looks at the window about its limit, which is taken away before coordinates are rounded to double, in the frame of the
  // limit control normal N. There points have a part u perpendicular to N and a height z over it; slopes of normals
  // are g. With the roundness r and the point-normal height h, which is z - g.u / 2, the three u, w = z + r (h - z)
  // and g are refined linearly but for terms of third order. The offsets are u + w N.
  void look(const Result& result)
  {
    offsets_.clear();
    slopes_.clear();
    normal_ = to_reals(Subdivision::normal_of(result.value));
    const bool has_normal = dot(normal_, normal_) > 0.5;
    double largest = 0;
    for (Value v : window_) {
      for (const FT& x : point_of(v)) largest = (std::max)(largest, std::abs(close_double(x)));
      add_multiple<FT, dimension>(point_of(v), FT(-1), point_of(result.value));
      Point_normal<double, dimension> p{to_reals(point_of(v)), to_reals(Subdivision::normal_of(v))};
      if (has_normal) {
        const PN_height<double> h = pn_height<double, dimension>(p, Reals{}, normal_);
        const double of_arc = h.numerator / (std::max)(h.denominator, 1. / 1024);
        const auto z = dot(p.point, normal_);
        add_multiple<double, dimension>(p.point, roundness_ * (of_arc - z), normal_);
        slopes_.push_back(normal_);
        add_multiple<double, dimension>(slopes_.back(), -1 / dot(p.normal, normal_), p.normal);
      }
      offsets_.push_back(p.point);
    }
    rounding_ = largest * close_double(machine_epsilon<FT>());
  }

  static Reals sum(const std::vector<double>& functional, const std::vector<Reals>& values)
  {
    Reals s{};
    for (std::size_t j = 0; j < functional.size() && j < values.size(); ++j)
      add_multiple<double, dimension>(s, functional[j], values[j]);
    return s;
  }

  // the tangents of the rounds so far
  struct Tangents
  {
    Reals last{};
    double last_change = 0;
  };

  // whether it meets the tolerance, or no further round will make it better
  bool note_tangent(const Window& of_points, Tangents& tangents, Result& result)
  {
    look(result);
    Reals t = sum(of_points.first_derivative, offsets_);
    const double length = length_of(t);
    if (!(length > 0) || !std::isfinite(length)) return true; // nor will there be one
    for (double& x : t) x /= length;
    const Reals last = std::exchange(tangents.last, t);
    if (!std::exchange(result.has_surface_normal, true) || !is_pn) {
      result.tangent = t;
      return !is_pn;
    }
    const double change = length_of(difference(t, last));
    // small windows have the rounding of large coordinates
    const double rounding = 4 * (rounding_ / length + std::numeric_limits<double>::epsilon());
    // as for points, with 1/2 = 3/2 of 1/4 + 1/16 + ..., but 1 while it is not this series yet
    const double error = (std::max)({change, tangents.last_change / 4, rounding});
    tangents.last_change = change;
    // further rounds have more rounding still
    if (result.normal_error > 0 && rounding >= result.normal_error) return true;
    result.tangent = t;
    result.normal_error = error;
    return error <= demand_.normal_tolerance;
  }

  // It does not exist where the derivative is zero or normals are turned by a right angle.
  void note_curvature(const Window& of_points, const Window& of_normals, Result& result)
  {
    look(result);
    const Reals d = sum(of_points.first_derivative, offsets_);
    Reals k = sum(of_points.second_derivative, offsets_);
    const Reals slope = sum(of_normals.first_derivative, slopes_);
    add_multiple<double, dimension>(k, roundness_ * dot(slope, d), normal_);
    const auto square = dot(d, d);
    add_multiple<double, dimension>(k, -dot(d, k) / square, d);
    for (double& x : k) x /= square;
    for (const double x : k)
      if (!std::isfinite(x)) return;
    result.curvature_vector = k;
    result.has_curvature = true;
  }

  Average average_;
  double roundness_;
  std::vector<Curve_windows<FT>> windows_; // of points and, if they differ, of normals
  Curve_end end_;
  const Limit_demand& demand_;
  bool has_curvature_ = false;
  std::vector<Value> window_, next_;
  // what look() has found
  std::vector<Reals> offsets_, slopes_;
  Reals normal_{};
  double rounding_ = 0; // of the coordinates
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CURVES_INTERNAL_CURVE_LIMITS_H
