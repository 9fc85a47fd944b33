// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_CURVES_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_CURVES_H

#include "Order_samples.h"

#include <CGAL/PN_curves/curve_limit_points.h>
#include <CGAL/PN_subdivision_curve.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// The same for curves: the section y = 0.2 of the surface.
namespace order_samples {

using Polygon = std::vector<std::pair<Kernel::Point_2, Kernel::Vector_2>>;

inline double curve_height(double x)
{
  return height(x, .2);
}

inline Kernel::Vector_2 curve_normal(double x)
{
  const Vector n = steep_normal(x, .2);
  return Kernel::Vector_2(n.x(), 1) / std::hypot(n.x(), 1);
}

inline double curve_distance(const Kernel::Point_2& p)
{
  double x = p.x();
  for (int i = 0; i < 20; ++i) {
    const Kernel::Vector_2 n = curve_normal(x), off = p - Kernel::Point_2(x, curve_height(x));
    x += (off - (off * n) * n).x();
  }
  return std::abs((p - Kernel::Point_2(x, curve_height(x))) * curve_normal(x));
}

// 41 points at distances of about h; smooth are warped ones, the others are moved at random
inline Polygon open_polygon(double h, bool smooth, bool is_linear)
{
  Polygon polygon;
  Random random;
  for (int i = -20; i <= 20; ++i) {
    const double x = middle[0] + h * (smooth ? i : i + .3 * random());
    const double at = smooth ? warped({x, 0})[0] : x;
    polygon.emplace_back(Kernel::Point_2(at, curve_height(at)),
                         is_linear ? Kernel::Vector_2(0, 0) : curve_normal(at));
  }
  return polygon;
}

// the largest distance of the limit curve in the middle of the polygon, for each length h
template <class Mask>
std::vector<double> curve_errors(const Mask& mask, const std::vector<double>& lengths, bool smooth,
                                 bool is_linear)
{
  namespace PN = CGAL::PN_subdivision_3;
  std::vector<double> errors;
  for (const double h : lengths) {
    const Polygon fine =
      PN::subdivide_curve(open_polygon(h, smooth, is_linear), mask, PN::Curve_end::reflect,
                          CGAL::parameters::number_of_iterations(3));
    const auto found =
      PN::curve_limit_points(fine, mask, PN::Curve_end::reflect, PN::parameters::tolerance(1e-13));
    const double x0 = (smooth ? warped({middle[0], 0}) : middle)[0];
    double largest = 0;
    for (const auto& l : found.first)
      if (std::abs(l.point.x() - x0) <= 6 * h)
        largest = (std::max)(largest, curve_distance(l.point));
    errors.push_back(largest);
  }
  return errors;
}

} // namespace order_samples

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_CURVES_H
