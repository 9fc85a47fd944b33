// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Many rounds in interval arithmetic: the intervals of the radii contain the radius, and their widths
// grow by a factor a round that is measured.

#include "Curve_cases.h"
#include "Rational_shapes.h"
#include "Scheme_runs.h"
#include "Schemes.h"

#include <CGAL/Interval_nt.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using rational_shapes::Shape;
using test_meshes::Control_mesh;

using Interval = CGAL::Interval_nt<true>;
using Interval_kernel = CGAL::Simple_cartesian<Interval>;

// What intervals say of a point: that the squared radius, and the squared length of the normal, relative
// to what they should be, are in an interval about 1.
struct Widths
{
  double radius = 0, normal = 0;
  std::size_t refuted = 0;

  void add(const Interval& squared_radius, const Interval& squared_length)
  {
    refuted += !squared_radius.do_overlap(Interval(1)) || !squared_length.do_overlap(Interval(1));
    radius = (std::max)(radius, squared_radius.sup() - squared_radius.inf());
    normal = (std::max)(normal, squared_length.sup() - squared_length.inf());
  }
};

Interval relative_squared_radius(const Shape& shape, const Interval_kernel::Point_3& p)
{
  const auto axis = rational_shapes::in<Interval>(shape.axis);
  auto r = rational_shapes::sum<Interval>({p.x(), p.y(), p.z()}, -1,
                                          rational_shapes::in<Interval>(shape.center));
  r = rational_shapes::sum<Interval>(r, -rational_shapes::dot(r, axis), axis);
  return (CGAL::square(r[0]) + CGAL::square(r[1]) + CGAL::square(r[2])) /
         CGAL::square(rational_shapes::in<Interval>(shape.radius));
}

template <class Description>
Widths widths_after(unsigned rounds, const Shape& shape, const Control_mesh& control)
{
  rational_shapes::Samples<Interval_kernel> samples(shape, control);
  PN::subdivide(samples.mesh, Description::scheme(),
                params::vertex_normal_map(samples.normals).number_of_iterations(rounds));
  // the package's own predicates: indeterminate, not false
  EXPECT_TRUE(samples.is_on_shape([](const auto& deviation) {
    return CGAL::possibly(deviation.points_are_on_shape) &&
           CGAL::possibly(deviation.normals_are_exact);
  }));
  Widths widths;
  for (auto v : samples.mesh.vertices())
    widths.add(relative_squared_radius(shape, samples.mesh.point(v)),
               samples.normals[v].squared_length());
  return widths;
}

// Control meshes without folds: on a sphere, and patches rolled about a cylinder.
template <class Description>
std::vector<std::pair<Shape, Control_mesh>> control_data()
{
  using namespace test_meshes;
  std::vector<std::pair<Shape, Control_mesh>> result;
  for (const Control_mesh& control :
       {with_centers(bipyramid(5), 2), bipyramid(12), in_quads(bipyramid(3)), house(7)})
    if (takes<Description>(control)) result.emplace_back(rational_shapes::sphere(), control);
  for (Cells cells : {Cells::triangles, Cells::quads, Cells::mixed}) {
    Control_mesh patch = grid(3, 3, false, false, cells);
    if (cells == Cells::triangles) patch = with_centers(patch, 3);
    if (!takes<Description>(patch)) continue;
    for (Triple& p : patch.points)
      p = {p[0] / 3, std::cos(0.5 * p[1] + 0.3), std::sin(0.5 * p[1] + 0.3)};
    result.emplace_back(rational_shapes::cylinder(), patch);
  }
  return result;
}

template <class Description>
class Interval_certificate : public testing::Test
{};
TYPED_TEST_SUITE(Interval_certificate, Schemes_elsewhere, Scheme_names);

// p = q + h n, where h has the differences p_j - q: three widths of points make one new one, more
// where weights are negative.
TYPED_TEST(Interval_certificate, NoRoundIsRefutedAndWidthsGrowByAFactor)
{
  constexpr unsigned rounds = 5;
  if (!TypeParam::takes_intervals) { // where it would have something to compute in double
    std::size_t refused = 0;
    for (const auto& [shape, control] : control_data<TypeParam>()) try {
        widths_after<TypeParam>(3, shape, control);
      } catch (const std::invalid_argument& e) {
        EXPECT_NE(std::string(e.what()).find("number type"), std::string::npos) << e.what();
        ++refused;
      }
    EXPECT_GT(refused, 0u);
    return;
  }
  double least = HUGE_VAL, greatest = 0, greatest_of_normals = 0, widest = 0;
  for (const auto& [shape, control] : control_data<TypeParam>()) {
    std::array<Widths, rounds + 1> w;
    for (unsigned k = 1; k <= rounds; ++k) {
      w[k] = widths_after<TypeParam>(k, shape, control);
      EXPECT_EQ(w[k].refuted, 0u) << control.name << ", round " << k;
    }
    const double growth = std::cbrt(w[rounds].radius / w[rounds - 3].radius);
    least = (std::min)(least, growth);
    greatest = (std::max)(greatest, growth);
    greatest_of_normals =
      (std::max)(greatest_of_normals, std::cbrt(w[rounds].normal / w[rounds - 3].normal));
    widest = (std::max)(widest, w[rounds].radius);
  }
  std::cout << "width of r^2/R^2 after " << rounds << " rounds up to " << widest
            << ", growth a round " << least << " to " << greatest << ", of n^2 up to "
            << greatest_of_normals << '\n';
  EXPECT_GT(least, 2);
  EXPECT_LT(greatest, 5);
  EXPECT_LT(widest, 1e-10);
}

// --- curves ---

TEST(Interval_certificate_of_curves, NoRoundIsRefutedAndWidthsGrowByAFactor)
{
  constexpr unsigned rounds = 10;
  for (const auto& s : curve_cases::schemes()) {
    curve_cases::Curve_2<Interval_kernel> polygon;
    for (int i = 0; i < 24; ++i) {
      const double a = 0.26 * (i + 0.3 * std::sin(2.7 * i));
      const auto c = rational_shapes::unit_2(std::cos(a), std::sin(a));
      const auto x = rational_shapes::in<Interval>(c[0]), y = rational_shapes::in<Interval>(c[1]);
      polygon.emplace_back(Interval_kernel::Point_2(x, y), Interval_kernel::Vector_2(x, y));
    }
    const Interval_kernel::Circle_2 circle({0, 0}, 1);
    std::array<Widths, rounds + 1> w;
    for (unsigned k = 1; k <= rounds; ++k) {
      // one call: each call normalizes normals that may be unit vectors or not
      const auto curve = curve_cases::refined(polygon, s, curve_cases::Curve_end::closed, k);
      EXPECT_TRUE(CGAL::possibly(PN::curve_deviation(curve, circle).points_are_on_shape));
      for (const auto& [p, n] : curve)
        w[k].add(CGAL::square(p.x()) + CGAL::square(p.y()),
                 CGAL::square(n.x()) + CGAL::square(n.y()));
      EXPECT_EQ(w[k].refuted, 0u) << curve_cases::name_of(s) << ", round " << k;
    }
    const double growth = std::pow(w[rounds].radius / w[rounds - 5].radius, 1 / 5.);
    std::cout << curve_cases::name_of(s) << ": width of r^2 after " << rounds << " rounds "
              << w[rounds].radius << ", growth a round " << growth << '\n';
    EXPECT_GT(growth, 2);
    EXPECT_LT(growth, s.interpolating ? 5 : 3.3);
    EXPECT_LT(w[rounds].radius, 1e-7);
  }
}

} // namespace
