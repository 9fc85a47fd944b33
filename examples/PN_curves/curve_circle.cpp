// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Points of a circle at uneven distances, with the circle's normals: every scheme gives the circle.
// The six-point scheme keeps the points and their spacing, the cubic B-spline evens them out.
//
//   curve_circle [OUTPUT.svg]

#include "analysis/Curve_svg.h"

#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace PN = CGAL::PN_subdivision_3;
namespace curve_svg = PN::curve_svg;
using curve_svg::Curve;

namespace {

Curve uneven_circle()
{
  Curve polygon;
  for (const double degrees : {0, 24, 64, 85, 140, 168, 222, 246, 300, 326}) {
    const double t = degrees * std::acos(-1) / 180;
    const curve_svg::Vector normal(std::cos(t), std::sin(t));
    polygon.emplace_back(CGAL::ORIGIN + normal, normal);
  }
  return polygon;
}

double largest_over_smallest_distance(const Curve& curve)
{
  double smallest = std::numeric_limits<double>::max(), largest = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto edge = curve[(i + 1) % curve.size()].first - curve[i].first;
    smallest = (std::min)(smallest, std::sqrt(edge.squared_length()));
    largest = (std::max)(largest, std::sqrt(edge.squared_length()));
  }
  return largest / smallest;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string output = argc > 1 ? argv[1] : "curve_circle.svg";
  const Curve polygon = uneven_circle();
  const PN::Curve_end closed = PN::Curve_end::closed;
  const auto rounds = CGAL::parameters::number_of_iterations(6);
  const Curve interpolating =
    PN::subdivide_curve(polygon, PN::Dubuc_Deslauriers_mask(6), closed, rounds);
  const Curve approximating = PN::subdivide_curve(polygon, PN::B_spline_mask(3), closed, rounds);

  bool kept = true;
  for (const Curve* curve : {&interpolating, &approximating}) {
    const double deviation =
      PN::curve_deviation(*curve, curve_svg::Kernel::Circle_2({0, 0}, 1)).distance.sup();
    std::cout << curve->size() << " points, off the circle by " << deviation
              << ", distances of neighbors up to 1 : " << largest_over_smallest_distance(*curve)
              << std::endl;
    kept = kept && deviation <= 8 * std::numeric_limits<double>::epsilon();
  }

  const bool written =
    curve_svg::write(output, "An uneven polygon on a circle, refined",
                     {curve_svg::panel("PN 6-point", polygon, interpolating, closed),
                      curve_svg::panel("PN cubic B-spline", polygon, approximating, closed)});
  return kept && written ? EXIT_SUCCESS : EXIT_FAILURE;
}
