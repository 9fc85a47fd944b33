// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Modeling with normals: the points stay on a circle, every second normal is rotated. The curve
// follows as long as neighboring normals do not come near to opposite ones.
//
//   curve_normal_edit [OUTPUT.svg]

#include <CGAL/PN_subdivision_3/curves/Curve_svg.h>
#include <CGAL/PN_subdivision_curve.h>

#include <cmath>
#include <cstdlib>
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

} // namespace

int main(int argc, char** argv)
{
  const std::string output = argc > 1 ? argv[1] : "curve_normal_edit.svg";
  const PN::Curve_end closed = PN::Curve_end::closed;
  std::vector<curve_svg::Panel> panels;
  for (const int degrees : {40, 90, 150}) {
    Curve polygon = circle(12);
    PN::rotate_control_normals(polygon, degrees * pi / 180, PN::every_kth_vertex(polygon, 2));
    const Curve curve = PN::subdivide_curve(polygon, PN::Dubuc_Deslauriers_mask(10), closed,
                                            CGAL::parameters::number_of_iterations(6));
    panels.push_back(
      curve_svg::panel("rotated by " + std::to_string(degrees) + "\u00b0", polygon, curve, closed));
    panels.back().comb = nullptr; // the curvature varies too wildly to be drawn
  }
  const bool written =
    curve_svg::write(output, "PN 10-point curves, every second normal rotated", panels);
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
