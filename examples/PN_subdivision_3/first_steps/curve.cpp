// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Points in the plane, two numbers a line, become a smooth closed curve.
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Simple_cartesian.h>
#include <fstream>
#include <iterator>
#include <vector>
using Point = CGAL::Simple_cartesian<double>::Point_2;
namespace PN = CGAL::PN_subdivision_3;

int main(int argc, char** argv)
{
  std::ifstream in(argc < 3 ? "" : argv[1]);
  const std::vector<Point> polygon(std::istream_iterator<Point>(in), {});
  if (polygon.size() < 3) return 1;
  const auto rounds = CGAL::parameters::number_of_iterations(5);
  const auto curve =
    PN::subdivide_curve(polygon, PN::B_spline_mask(3), PN::Curve_end::closed, rounds);
  std::ofstream out(argv[2]);
  for (const auto& [point, normal] : curve) out << point << '\n';
  return out ? 0 : 1;
}
