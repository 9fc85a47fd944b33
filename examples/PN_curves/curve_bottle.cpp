// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A bottle by three schemes. The combs show what the schemes promise: with quadratic B-splines the
// curvature jumps, with cubic ones it does not, and normals by the four-point scheme spoil it again.
// Prints how far the curvatures at neighboring points differ, which tends to 0 where it is continuous.
//
//   curve_bottle [OUTPUT.svg]

#include "analysis/Curve_svg.h"
#include "analysis/curve_analysis.h"

#include <CGAL/PN_subdivision_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace curve_svg = PN::curve_svg;
using curve_svg::Curve;
using curve_svg::Point;

namespace {

// Counterclockwise, so that the estimated normals point outwards.
Curve bottle()
{
  const Point right_side[] = {{1.2, 0.0},  {2.3, 0.35},  {2.5, 1.6}, {2.5, 3.2},
                              {2.5, 4.8},  {2.3, 6.2},   {1.5, 7.4}, {1.0, 8.6},
                              {0.95, 9.9}, {0.95, 11.1}, {0.6, 11.8}};
  std::vector<Point> points(std::begin(right_side), std::end(right_side));
  for (auto p = std::rbegin(right_side); p != std::rend(right_side); ++p)
    points.emplace_back(-p->x(), p->y());
  return PN::estimate_control_normals(points, PN::Curve_end::closed);
}

double largest_jump_of_curvature(const Curve& curve)
{
  std::vector<Point> points;
  for (const auto& point_and_normal : curve) points.push_back(point_and_normal.first);
  const std::vector<double> curvature = PN::discrete_curvature(points, PN::Curve_end::closed);
  double jump = 0;
  for (std::size_t i = 0; i < curvature.size(); ++i)
    jump = (std::max)(jump, std::abs(curvature[i] - curvature[(i + 1) % curvature.size()]));
  return jump;
}

template <class Mask>
curve_svg::Panel panel(const std::string& caption, const Curve& polygon, const Mask& mask)
{
  const PN::Curve_end closed = PN::Curve_end::closed;
  const auto refined = [&](unsigned rounds) {
    return PN::subdivide_curve(polygon, mask, closed,
                               CGAL::parameters::number_of_iterations(rounds));
  };
  std::cout << caption << ": largest jump of the curvature after 6, 8, 10 rounds";
  for (const unsigned rounds : {6u, 8u, 10u})
    std::cout << ' ' << largest_jump_of_curvature(refined(rounds));
  std::cout << std::endl;
  const Curve curve = refined(6);
  return curve_svg::panel(caption, polygon, curve, closed);
}

} // namespace

int main(int argc, char** argv)
{
  const std::string output = argc > 1 ? argv[1] : "curve_bottle.svg";
  const Curve polygon = bottle();
  const PN::B_spline_mask quadratic(2), cubic(3);
  const PN::Dubuc_Deslauriers_mask four_point(4);
  const bool written = curve_svg::write(output, "A bottle by three point-normal schemes",
                                        {panel("PN quadratic B-spline", polygon, quadratic),
                                         panel("PN cubic B-spline", polygon, cubic),
                                         panel("PN cubic B-spline, 4-point normals", polygon,
                                               PN::with_normal_mask(cubic, four_point))});
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
