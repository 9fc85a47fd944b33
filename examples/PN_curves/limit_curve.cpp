// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The limit curve at its control points: twelve samples of an ellipse with the ellipse's normals. Prints by how
// much the limit points are off the ellipse, how far the control normals are from the normals of the curve, and
// the curvature where it is greatest.

#include <CGAL/PN_curves/curve_limit_points.h>
#include <CGAL/PN_subdivision_curve.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
namespace PN = CGAL::PN_subdivision_3;

int main()
{
  const double pi = std::acos(-1), a = 3, b = 2;
  std::vector<std::pair<Kernel::Point_2, Kernel::Vector_2>> polygon;
  for (int i = 0; i < 12; ++i) {
    const double x = std::cos(pi * i / 6), y = std::sin(pi * i / 6);
    polygon.emplace_back(Kernel::Point_2(a * x, b * y), Kernel::Vector_2(x / a, y / b));
  }

  const auto [limits, report] =
    PN::curve_limit_points(polygon, PN::B_spline_mask(3), PN::Curve_end::closed,
                           PN::parameters::curve_normals(true).curvatures(true));

  double off = 0, angle = 0;
  for (const auto& l : limits) {
    const double x = l.point.x() / a, y = l.point.y() / b;
    off = (std::max)(off, std::abs(std::hypot(x, y) - 1));
    angle = (std::max)(angle, std::acos((std::min)(1., l.normal * l.control_normal)));
  }
  std::cout << "estimated error of the limit points: " << report.error << "\n"
            << "off the ellipse, relative to it:     " << off << "\n"
            << "control normals off those of the curve: " << angle * 180 / pi << " degrees\n"
            << "curvature at the end of the long axis: " << limits[0].curvature
            << ", of the ellipse " << a / (b * b) << std::endl;
}
