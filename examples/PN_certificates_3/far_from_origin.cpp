// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Where double is not enough, and what recentering buys. A unit sphere and a unit circle are sampled
// at distances of 1 to 10^12 from the origin, where doubles are 2^-53 to 10^-4 apart, and refined:
//  - in place;
//  - recentered: the control points are translated to the origin before and the result back after;
//  - recentered and kept there: the translation is added last, if at all, by what draws or measures;
//  - made about the origin in the first place, the translation a separate number.
// Printed are the largest deviation from the shape (for results that are kept at the origin, from the
// translated one) and the largest relative error of the discrete curvature of the circle.
//
//   far_from_origin [OUTPUT.csv [OUTPUT.svg]]

#include "Log_plot_svg.h"
#include "Sampled_shapes.h"
#include "analysis/curve_analysis.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;

using K = CGAL::Simple_cartesian<double>;
using Point_2 = K::Point_2;
using Point_3 = K::Point_3;

namespace {

enum Way { in_place, recentered, recentered_and_kept, made_at_origin, number_of_ways };
const char* const names[] = {"in place", "recentered, moved back", "recentered, kept there",
                             "made at the origin"};

struct Errors
{
  double sphere, circle, curvature;
};

// what is added before and after, and where the shape's center is in the end
template <class Vector>
struct Translation
{
  Translation(Way way, const Vector& c)
    : made_at(way == made_at_origin ? 0. * c : c)
    , before(way == recentered || way == recentered_and_kept ? -c : 0. * c)
    , after(way == recentered ? c : 0. * c)
    , center(way == in_place || way == recentered ? c : 0. * c)
  {}
  Vector made_at, before, after, center;
};

double sphere_deviation(Way way, const K::Vector_3& center)
{
  const Translation<K::Vector_3> t(way, center);
  sampled_shapes::Mesh<K> mesh;
  const auto normals = sampled_shapes::make_sphere<K>(mesh, CGAL::ORIGIN + t.made_at);
  for (Point_3& p : mesh.points()) p = p + t.before;
  PN::subdivide(mesh, PN::CatmullClark_scheme(),
                CGAL::parameters::number_of_iterations(4).vertex_normal_map(normals));
  for (Point_3& p : mesh.points()) p = p + t.after;
  return PN::mesh_deviation(mesh, K::Sphere_3(CGAL::ORIGIN + t.center, 1)).distance.sup();
}

sampled_shapes::Curve<K> refined_circle(const Translation<K::Vector_2>& t)
{
  auto polygon = sampled_shapes::circle<K>(CGAL::ORIGIN + t.made_at);
  for (auto& item : polygon) item.first = item.first + t.before;
  auto curve = PN::subdivide_curve(polygon, PN::B_spline_mask(3), PN::Curve_end::closed,
                                   CGAL::parameters::number_of_iterations(5));
  for (auto& item : curve) item.first = item.first + t.after;
  return curve;
}

Errors errors(Way way, double distance)
{
  Errors e;
  // 1/9 (1, -8, 4) and 1/5 (3, -4) have the length 1; whole numbers can be subtracted exactly
  e.sphere =
    sphere_deviation(way, K::Vector_3(std::round(distance / 9), -std::round(distance * 8 / 9),
                                      std::round(distance * 4 / 9)));
  const Translation<K::Vector_2> t(
    way, K::Vector_2(std::round(distance * 3 / 5), -std::round(distance * 4 / 5)));
  const auto curve = refined_circle(t);
  e.circle = PN::curve_deviation(curve, K::Circle_2(CGAL::ORIGIN + t.center, 1)).distance.sup();
  e.curvature = 0;
  for (const double c : PN::discrete_curvature(curve, PN::Curve_end::closed))
    e.curvature = (std::max)(e.curvature, std::abs(c - 1));
  return e;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<log_plot_svg::Panel> panels{{"deviation from the sphere", {}},
                                          {"error of the curvature of the circle", {}}};
  std::ofstream csv(argc > 1 ? argv[1] : "far_from_origin.csv");
  csv << "way,distance,sphere,circle,curvature\n";
  std::cout << "                        |c|/R    sphere, in 2^-52    circle, in 2^-52   curvature\n"
            << std::setprecision(3);
  for (int way = 0; way < number_of_ways; ++way) {
    for (log_plot_svg::Panel& panel : panels) panel.lines.push_back({names[way], {}});
    for (int exponent = 0; exponent <= 12; ++exponent) {
      const double distance = std::pow(10., exponent);
      const Errors e = errors(static_cast<Way>(way), distance);
      if (exponent % 2 == 0)
        std::cout << std::left << std::setw(22) << names[way] << std::right << std::setw(8)
                  << distance << std::setw(11) << e.sphere << std::setw(10) << e.sphere * 0x1p52
                  << std::setw(11) << e.circle << std::setw(10) << e.circle * 0x1p52
                  << std::setw(11) << e.curvature << '\n';
      csv << names[way] << ',' << distance << ',' << e.sphere << ',' << e.circle << ','
          << e.curvature << '\n';
      panels[0].lines.back().values.push_back(e.sphere);
      panels[1].lines.back().values.push_back(e.curvature);
    }
  }
  const log_plot_svg::Plot plot{"Far from the origin, in double",
                                "decimal logarithm of the distance in radii",
                                "relative error",
                                "sampled and refined",
                                -16,
                                0,
                                panels,
                                2,
                                false,
                                220};
  const bool written =
    csv.flush() && log_plot_svg::write(argc > 2 ? argv[2] : "far_from_origin.svg", plot);
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
