// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Modeling with normals: the points stay on a circle, every second normal is rotated. The curve
// follows as long as neighboring normals do not come near to opposite ones. Prints what becomes of control
// points and control normals, and how often the curve crosses itself.
//
//   curve_normal_edit [OUTPUT.svg]

#include "analysis/Curve_svg.h"

#include <CGAL/PN_subdivision_curve.h>

#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace curve_svg = PN::curve_svg;
using curve_svg::Curve;

namespace {

const double pi = std::acos(-1);

Curve circle(int n)
{
  Curve polygon;
  for (int i = 0; i < n; ++i) {
    const curve_svg::Vector normal(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n));
    polygon.emplace_back(CGAL::ORIGIN + normal, normal);
  }
  return polygon;
}

constexpr int rounds = 6;

// Control point i is point 2^rounds i of the curve.
void print_control_data(const Curve& polygon, const Curve& curve)
{
  std::size_t kept = 0;
  double angle = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t k = i << rounds, n = curve.size();
    if (curve[k].first == polygon[i].first) ++kept;
    const curve_svg::Vector along = curve[(k + 1) % n].first - curve[(k + n - 1) % n].first;
    const double sine = along * polygon[i].second / std::sqrt(along.squared_length());
    angle = (std::max)(angle, std::asin(std::abs(sine)) * 180 / pi);
  }
  std::cout << kept << " of " << polygon.size()
            << " control points are kept, control normals are off the curve's by up to " << angle
            << " degrees, ";
}

std::size_t number_of_crossings(const Curve& curve)
{
  const std::size_t n = curve.size();
  const auto segment = [&](std::size_t i) {
    return curve_svg::Kernel::Segment_2(curve[i].first, curve[(i + 1) % n].first);
  };
  std::size_t crossings = 0;
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t j = i + 2; j < n - (i == 0 ? 1 : 0); ++j)
      if (CGAL::do_intersect(segment(i), segment(j))) ++crossings;
  return crossings;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string output = argc > 1 ? argv[1] : "curve_normal_edit.svg";
  const PN::Curve_end closed = PN::Curve_end::closed;
  std::vector<curve_svg::Panel> panels;
  for (const int degrees : {40, 90, 150}) {
    Curve polygon = circle(12);
    PN::rotate_control_normals(polygon, degrees * pi / 180, {0, 2, 4, 6, 8, 10});
    const Curve curve = PN::subdivide_curve(polygon, PN::Dubuc_Deslauriers_mask(10), closed,
                                            CGAL::parameters::number_of_iterations(rounds));
    std::cout << degrees << " degrees: ";
    print_control_data(polygon, curve);
    std::cout << number_of_crossings(curve) << " crossings" << std::endl;
    panels.push_back(
      curve_svg::panel("rotated by " + std::to_string(degrees) + "\u00b0", polygon, curve, closed));
    panels.back().comb = nullptr; // the curvature varies too wildly to be drawn
  }
  const bool written =
    curve_svg::write(output, "PN 10-point curves, every second normal rotated", panels);
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
