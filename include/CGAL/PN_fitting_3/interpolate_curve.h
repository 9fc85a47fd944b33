// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERPOLATE_CURVE_H
#define CGAL_PN_FITTING_3_INTERPOLATE_CURVE_H

#include <CGAL/PN_subdivision_3/internal/needs_eigen.h>

#include <CGAL/PN_curves/subdivide_curve.h>
#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// interpolates the points of a polygon
template <int dimension>
Interpolation_result<dimension> interpolate_polygon(bool is_closed,
                                                    const Interpolation_options& options,
                                                    Interpolation_data<dimension>& data);

// Whether limits are those of cubic splines, and not the points themselves.
template <class Mask>
bool has_cubic_limits(const Mask& mask)
{
  const std::vector<double> a = mask.template coefficients<double>();
  const auto at = [&](int i) {
    const int k = i - mask.first_index();
    return k >= 0 && k < static_cast<int>(a.size()) ? a[static_cast<std::size_t>(k)] : 0.;
  };
  const int last = mask.first_index() + static_cast<int>(a.size()) - 1;
  bool interpolates = at(0) == 1, is_cubic = true;
  for (int i = mask.first_index(); i <= last; ++i) {
    if (i != 0 && i % 2 == 0 && at(i) != 0) interpolates = false;
    const int d = i < 0 ? -i : i;
    const double cubic = d == 0 ? 6. / 8 : d == 1 ? 4. / 8 : d == 2 ? 1. / 8 : 0.;
    if (std::abs(at(i) - cubic) > 1e-15) is_cubic = false;
  }
  if (interpolates) return false;
  if (is_cubic && mask.first_index() <= -2 && last >= 2) return true;
  throw std::invalid_argument(
    "PN_subdivision_3: interpolation is not known for this mask: take the "
    "cubic B-spline, or a mask that interpolates");
}

// The points of a polygon with unit normals, zero where it has none.
template <class Range, class NamedParameters>
auto points_with_normals(const Range& polygon, const NamedParameters& np)
{
  using Points = Curve_points<Range, NamedParameters>;
  constexpr int dimension = Points::dimension;
  using FT = typename Points::FT;
  std::vector<std::pair<typename Points::Point, typename Points::Vector>> result;
  const auto points = Points::template get_all<double>(polygon, np); // checked
  const auto point_map = Points::point_map(np);
  for (const auto& item : polygon) {
    result.emplace_back(get(point_map, item), CGAL::NULL_VECTOR);
    if constexpr (Points::has_normals) {
      const auto name = [&] { return "point " + std::to_string(result.size() - 1); };
      const typename Points::Vector n = get(Points::normal_map(np), item);
      auto c = coordinates_of<FT, dimension>(n);
      check_finite<FT, dimension>(c, "normal", name);
      normalize_control_normal<FT, dimension>(c, name);
      result.back().second = from_coordinates<typename Points::Vector>(c);
    }
  }
  return result;
}

// estimates the normals that are zero
template <class Point, class Vector>
void estimate_missing(std::vector<std::pair<Point, Vector>>& curve, Curve_end end)
{
  const auto is_missing = [](const auto& item) { return item.second == CGAL::NULL_VECTOR; };
  if (std::none_of(curve.begin(), curve.end(), is_missing)) return;
  const auto estimated = estimate_control_normals(curve, end);
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (is_missing(curve[i])) curve[i].second = estimated[i].second;
}

template <int dimension, class Point, class Vector>
Interpolation_data<dimension> curve_data(const std::vector<std::pair<Point, Vector>>& curve)
{
  Interpolation_data<dimension> data;
  for (const auto& [point, normal] : curve) {
    data.vertices.push_back(static_cast<std::uint32_t>(data.points.size()));
    Eigen_vector<dimension>& p = data.points.emplace_back();
    Eigen_vector<dimension>& n = data.normals.emplace_back();
    for (int k = 0; k < dimension; ++k) {
      p[k] = close_double(point.cartesian(k));
      n[k] = close_double(normal.cartesian(k));
    }
  }
  return data;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Interpolation

returns a control polygon whose limit curve passes through the points of a polygon. The method is that of
`interpolate_limit_points()`. In mode `slide` control points move along the normals, in space along the binormals,
too. Samples of circles with exact normals, however uneven, are their own control polygon. In mode `strict` each point
is the limit of its vertex. In space `slide` leaves a point off the curve: by the square of its slip times the
curvature and the sine of the angle between its normal and the principal normal. Use `strict` if that matters.

For corners split the polygon by `split_at_corners()` and interpolate part by part.

\param polygon as for `subdivide_curve()`; where a normal is zero, `slide` estimates one as by
  `estimate_control_normals()`
\param mask the cubic `B_spline_mask`, a mask that interpolates, or its `linear()` twin
\param end whether the polygon is closed; the ends of an open one are reflected, and their limit is the
  points themselves
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`, `normal_map`,
  `geom_traits` and `roundness`, that of the curve, as for `subdivide_curve()`, and `interpolation_mode`,
  `interpolation_normals`, `tolerance`, `max_depth` and `max_steps` of `CGAL::PN_subdivision_3::parameters`

\returns the points and normals of the control polygon, and what was reached

\throws std::invalid_argument for another mask, for `Curve_end::none`, if a point or normal is not finite, or
  if the options are wrong
<br><b>Cost:</b> linear in the size of the polygon
*/
template <class Range, class Mask, class NamedParameters = parameters::Default_named_parameters>
auto interpolate_curve(const Range& polygon, const Mask& mask, Curve_end end,
                       const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::Normal_rows<double, Mask>::differ &&
                  !internal::is_level_dependent_v<Mask>,
                "PN_subdivision_3: interpolation is for one mask of points and normals");
  internal::check_are_read<NamedParameters, internal::roundness_t, internal::interpolation_mode_t,
                           internal::interpolation_normals_t, internal::tolerance_t,
                           internal::max_depth_t, internal::max_steps_t>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  constexpr int dimension = Points::dimension;
  const internal::Interpolation_options options = internal::interpolation_options(np);
  internal::check_interpolation_options(options);
  if (options.free != Limit_interpolation::Free::fixed)
    throw std::invalid_argument("PN_subdivision_3: all points of a curve are interpolated: take "
                                "Limit_interpolation::Free::fixed");
  if (options.normals == Limit_interpolation::Normals::natural)
    throw std::invalid_argument("PN_subdivision_3: a curve has no natural normals here: take "
                                "estimate_control_normals()");
  const bool is_cubic = internal::has_cubic_limits(mask);
  if (end == Curve_end::none)
    throw std::invalid_argument("PN_subdivision_3: a curve without its ends does not pass through "
                                "them: take Curve_end::reflect");
  const auto roundness = internal::Curve_parameters<Range, NamedParameters>::roundness(np);
  auto result = internal::points_with_normals(polygon, np);
  Limit_interpolation report;
  if (is_cubic) {
    constexpr bool is_linear = internal::is_linear_mask_v<Mask>;
    const bool slides = options.mode == Limit_interpolation::Mode::slide;
    if (slides || (!is_linear && !Points::has_normals)) internal::estimate_missing(result, end);
    internal::Interpolation_data<dimension> data = internal::curve_data<dimension>(result);
    internal::divide_by_size(data);
    data.takes_normals = !is_linear;
    if constexpr (internal::Curve_parameters<Range, NamedParameters>::has_roundness)
      data.roundness.assign(result.size(), internal::close_double(roundness));
    internal::set_demand(options, data);
    auto solution = internal::interpolate_polygon(end == Curve_end::closed, options, data);
    internal::multiply_by_size<typename Points::FT>(data, solution);
    report = solution.report;
    for (std::size_t i = 0; i < result.size(); ++i) {
      if (solution.points[i] != data.points[i])
        result[i].first = internal::from_coordinates<typename Points::Point>(
          internal::to_coordinates<dimension>(solution.points[i]));
      if (solution.normals[i] != data.normals[i])
        result[i].second = internal::from_coordinates<typename Points::Vector>(
          internal::to_coordinates<dimension>(solution.normals[i]));
    }
  }
  return std::make_pair(std::move(result), report);
}

} // namespace CGAL::PN_subdivision_3

#ifndef CGAL_PN_SUBDIVISION_3_FITTING // the library has it
#  include <CGAL/PN_fitting_3/internal/find_control_net.h>
#endif

#endif // CGAL_PN_FITTING_3_INTERPOLATE_CURVE_H
