// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "analysis/Curve_svg.h"
#include "analysis/curve_analysis.h"
#include "curve/Curve_data.h"

#include <CGAL/Default_diagonalize_traits.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <functional>

namespace pn_subdivide {
namespace {

namespace curve_svg = PN::curve_svg;
using Point_3 = Curve_kernel::Point_3;
using Vector_3 = Curve_kernel::Vector_3;

// A parallel view of space: two directions of the drawing.
class View
{
public:
  explicit View(const std::vector<Point_3>& points)
  {
    const Point_3 center = CGAL::centroid(points.begin(), points.end());
    std::array<double, 6> covariance{};
    for (const Point_3& p : points) {
      const Vector_3 d = p - center;
      int k = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) covariance[static_cast<std::size_t>(k++)] += d[i] * d[j];
    }
    std::array<double, 3> values{};
    std::array<double, 9> vectors{1, 0, 0, 0, 1, 0, 0, 0, 1};
    CGAL::Default_diagonalize_traits<double, 3>::diagonalize_selfadjoint_covariance_matrix(
      covariance, values, vectors); // in ascending order
    set_directions(Vector_3(vectors[0], vectors[1], vectors[2]));
  }

  curve_svg::Vector operator()(const Vector_3& v) const { return {v * right_, v * up_}; }
  curve_svg::Point operator()(const Point_3& p) const
  {
    return CGAL::ORIGIN + (*this)(p - CGAL::ORIGIN);
  }

private:
  // Looks against `axis` or along it: z is up and x to the right or, from above, y is up.
  void set_directions(Vector_3 axis)
  {
    const bool from_above = std::abs(axis.z()) > 0.9;
    const Vector_3 vertical = from_above ? Vector_3(0, 1, 0) : Vector_3(0, 0, 1);
    up_ = vertical - (vertical * axis) * axis;
    up_ = up_ / std::sqrt(up_.squared_length());
    right_ = CGAL::cross_product(up_, axis);
    if (right_.x() < 0) right_ = -right_;
  }

  Vector_3 right_, up_;
};

curve_svg::Panel panel(const Curve_2& polygon, const Curve_2& curve, PN::Curve_end end)
{
  return curve_svg::panel("", polygon, curve, end);
}

curve_svg::Panel panel(const Curve_3& polygon, const Curve_3& curve, PN::Curve_end end)
{
  std::vector<Point_3> points;
  for (const auto& point_and_normal : polygon) points.push_back(point_and_normal.first);
  const View view(points);

  curve_svg::Panel panel;
  panel.closed = end == PN::Curve_end::closed;
  for (const auto& [point, normal] : polygon) {
    panel.control_points.push_back(view(point));
    panel.control_normals.push_back(view(normal));
  }
  for (const auto& point_and_normal : curve) panel.curve.push_back(view(point_and_normal.first));
  panel.curvature = PN::discrete_curvature(curve, end);
  panel.comb = [&curve, end, view](double scale) {
    std::vector<curve_svg::Point> tips;
    for (const Point_3& tip : PN::curvature_comb(curve, end, scale)) tips.push_back(view(tip));
    return tips;
  };
  return panel;
}

// The exponent of the largest coordinate.
template <class Curve>
int exponent(const Curve& curve)
{
  double largest = 0;
  for (const auto& point_and_normal : curve)
    for (int i = 0; i < point_and_normal.first.dimension(); ++i)
      largest = (std::max)(largest, std::abs(point_and_normal.first[i]));
  return largest > 0 ? std::ilogb(largest) : 0;
}

Curve_kernel::Point_2 shifted(const Curve_kernel::Point_2& p, int e)
{
  return {std::ldexp(p.x(), e), std::ldexp(p.y(), e)};
}
Point_3 shifted(const Point_3& p, int e)
{
  return {std::ldexp(p.x(), e), std::ldexp(p.y(), e), std::ldexp(p.z(), e)};
}

template <class Curve>
Curve shifted(Curve curve, int e)
{
  for (auto& point_and_normal : curve) point_and_normal.first = shifted(point_and_normal.first, e);
  return curve;
}

// One drawing of all parts; their combs do not go across the corners.
template <class Curve>
curve_svg::Panel panel_of_parts(const Curve& polygon, const std::vector<Curve>& parts,
                                PN::Curve_end end)
{
  curve_svg::Panel all;
  std::vector<std::function<std::vector<curve_svg::Point>(double)>> combs;
  for (const Curve& part : parts) {
    curve_svg::Panel p = panel(polygon, part, PN::Curve_end::reflect);
    p.curve.insert(p.curve.begin(), all.curve.begin(), all.curve.end());
    p.curvature.insert(p.curvature.begin(), all.curvature.begin(), all.curvature.end());
    combs.push_back(p.comb);
    all = p;
  }
  all.comb = [combs](double scale) {
    std::vector<curve_svg::Point> tips;
    for (const auto& comb : combs)
      for (const curve_svg::Point& tip : comb(scale)) tips.push_back(tip);
    return tips;
  };
  all.closed = end == PN::Curve_end::closed;
  return all;
}

} // namespace

std::string curve_picture(const std::string& caption, const Curve_data& polygon,
                          const std::vector<Curve_data>& parts, PN::Curve_end end, bool has_corners)
{
  return std::visit(
    [&](const auto& first) {
      using Curve = std::decay_t<decltype(first)>;
      // a size about 1, so that no square overflows or vanishes
      int e = INT_MIN;
      for (const Curve_data& part : parts)
        e = (std::max)(e, exponent(std::get<Curve>(part.points)));
      const Curve control = shifted(std::get<Curve>(polygon.points), -e);
      std::vector<Curve> drawn;
      drawn.reserve(parts.size());
      for (const Curve_data& part : parts)
        drawn.push_back(shifted(std::get<Curve>(part.points), -e));
      curve_svg::Panel p =
        has_corners ? panel_of_parts(control, drawn, end) : panel(control, drawn.front(), end);
      p.caption = caption;
      return curve_svg::drawing(caption, {p});
    },
    parts.front().points);
}

} // namespace pn_subdivide
