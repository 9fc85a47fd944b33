// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Curves from degenerate and bad input, and over other kernels.

#include "Curve_cases.h"
#include "Messages.h"
#include "analysis/Curve_svg.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <boost/property_map/function_property_map.hpp>

#include <numeric>

using namespace curve_cases;

namespace {

using Curve = Curve_2<Double>;
using Point = Double::Point_2;
using Vector = Double::Vector_2;

const Curve_end all_ends[] = {Curve_end::closed, Curve_end::reflect, Curve_end::none};

// --- few points ---

TEST(CurveInput, NoPoints)
{
  for (Curve_end end : all_ends) EXPECT_TRUE(refined(Curve(), {false, 3}, end, 3).empty());
}

TEST(CurveInput, OnePointIsKept)
{
  const Curve polygon = {{Point(3, 5), Vector(0, 1)}};
  for (const auto& s : schemes())
    for (Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
      const auto curve = refined(polygon, s, end, 3);
      // 2n - 2 points of a dual mask are none
      const std::size_t expected = end == Curve_end::closed ? 8 : s.primal() ? 1 : 0;
      EXPECT_EQ(curve.size(), expected) << name_of(s, end);
      for (const auto& item : curve) {
        EXPECT_NEAR(item.first.x(), 3, 1e-14);
        EXPECT_NEAR(item.first.y(), 5, 1e-14);
        EXPECT_EQ(item.second, Vector(0, 1));
      }
    }
}

TEST(CurveInput, TwoPointsWithEqualNormalsAreASegment)
{
  const Curve polygon = {{Point(0, 0), Vector(0, 1)}, {Point(1, 0), Vector(0, 1)}};
  for (const auto& s : schemes())
    for (Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
      const auto curve = refined(polygon, s, end, 4);
      EXPECT_FALSE(curve.empty());
      for (const auto& item : curve) EXPECT_NEAR(item.first.y(), 0, 1e-14);
      if (end == Curve_end::closed || !s.primal()) continue;
      EXPECT_NEAR(curve.front().first.x(), 0, 1e-14);
      EXPECT_NEAR(curve.back().first.x(), 1, 1e-14);
    }
}

TEST(CurveInput, TwoPointsOfACircleAreAnArc)
{
  const auto polygon = circle_2<>({Real(0.2), Real(1.9)}, 2);
  const auto curve = refined(polygon, {true, 2}, Curve_end::reflect, 6);
  EXPECT_EQ(curve.size(), 65u);
  EXPECT_LE(largest(curve, [](const auto& item) { return radius_error(item.first, 2); }),
            16 * Real(ulp));
}

TEST(CurveInput, RepeatedPointsKeepValuesFinite)
{
  for (const auto& s : schemes())
    for (Curve_end end : all_ends) {
      Curve polygon;
      for (const auto& item : circle_2<>(uneven_angles(12, 2, Real(6), true, 1), 1))
        polygon.insert(polygon.end(), 2, item);
      const auto curve = refined(polygon, s, end, 4);
      EXPECT_FALSE(curve.empty());
      // doubled samples of a circle are samples of it
      EXPECT_LE(largest(curve, [](const auto& item) { return radius_error(item.first, 1); }),
                64 * Real(ulp))
        << name_of(s, end);
    }
  const Curve same(5, {Point(0.1, 0.7), Vector(0.6, 0.8)});
  for (const auto& item : refined(same, {true, 3}, Curve_end::closed, 4)) {
    EXPECT_NEAR(item.first.x(), 0.1, 1e-15);
    EXPECT_NEAR(item.first.y(), 0.7, 1e-15);
  }
}

// --- refused ---

TEST(CurveInput, OpenPolygonsShorterThanTheMask)
{
  const auto polygon = circle_2<>(uneven_angles(4, 1, Real(1), false, 1), 1);
  const reference::Curve_scheme s{true, 4};
  messages::expect_refused([&] { refined(polygon, s, Curve_end::none); },
                           {"4 points", "too short", "reflect"});
  EXPECT_FALSE(refined(polygon, s, Curve_end::reflect, 3).empty());
  EXPECT_FALSE(refined(polygon, s, Curve_end::closed, 3).empty());
}

TEST(CurveInput, NumbersThatAreNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const reference::Curve_scheme cubic{false, 3};
  const auto end = Curve_end::closed;
  const std::vector<std::string> of_position{"position", "point 4", "finite"};
  for (double bad : {nan, infinity, -infinity}) {
    auto polygon = circle_2<>(uneven_angles(6, 1, Real(1), false, 1), 1);
    polygon[4].first = Point(0, bad);
    messages::expect_refused([&] { refined(polygon, cubic, end); }, of_position);
    messages::expect_refused([&] { linearly_refined(polygon, cubic, end); }, of_position);
    messages::expect_refused([&] { PN::estimate_control_normals(polygon, end); }, of_position);
    messages::expect_refused([&] { PN::discrete_curvature(polygon, end); }, {"point 4"});
    polygon[4].first = Point(0, 0);
    polygon[2].second = Vector(bad, 0);
    messages::expect_refused([&] { refined(polygon, cubic, end); },
                             {"normal", "point 2", "finite"});
  }
}

TEST(CurveInput, PointsThatOverflowAreRefusedInTheEnd)
{
  const double x = 1.7e308;
  const Curve polygon = {{Point(x, x), Vector(1, 0)},
                         {Point(-x, x), Vector(0, 1)},
                         {Point(-x, -x), Vector(-1, 0)},
                         {Point(x, -x), Vector(0, -1)}};
  for (bool linear : {false, true})
    for (unsigned rounds : {1u, 2u}) {
      const auto refuse = [&] {
        const PN::Dubuc_Deslauriers_mask mask(4);
        const auto np = CGAL::parameters::number_of_iterations(rounds);
        if (linear)
          PN::subdivide_curve(polygon, PN::linear(mask), Curve_end::closed, np);
        else
          PN::subdivide_curve(polygon, mask, Curve_end::closed, np);
      };
      messages::expect_refused<std::overflow_error>(refuse, {"point 1 of the curve"});
    }
  // near the end of the range is not beyond it
  Curve half;
  for (const auto& [p, n] : polygon) half.emplace_back(Point(p.x() / 8, p.y() / 8), n);
  EXPECT_EQ(refined(half, {false, 3}, Curve_end::closed, 1).size(), 8u);
}

// Maps need not be default constructible: those of lambdas are not.
TEST(CurveInput, TooManyPointsAreRefusedBeforeTheFirstRound)
{
  const Curve polygon = {
    {Point(0, 0), Vector(0, 1)}, {Point(1, 0), Vector(0, 1)}, {Point(2, 1), Vector(0, 1)}};
  // 3 * 2^31 is the first size beyond 2^32 - 2; before that, memory would be gone
  const reference::Curve_scheme cubic{false, 3};
  messages::expect_refused<std::length_error>(
    [&] { refined(polygon, cubic, Curve_end::closed, 60); },
    {"round 31 of 60", "6442450944 points", "fewer rounds"});
  // a single point never becomes more
  const Curve point(polygon.begin(), polygon.begin() + 1);
  EXPECT_EQ(refined(point, cubic, Curve_end::reflect, 60).size(), 1u);
}

// Each of its old points is reflected in the ends a quarter of a million times.
TEST(CurveInput, MasksMuchLongerThanThePolygon)
{
  const int n = 250000;
  std::vector<double> a(static_cast<std::size_t>(4 * n + 1), 0);
  a.front() = a.back() = a[1] = a[a.size() - 2] = 0.5;
  const Curve polygon = {{Point(0, 0), Vector(0, 0)}, {Point(1, 0), Vector(0, 0)}};
  const Curve curve =
    PN::subdivide_curve(polygon, PN::Univariate_mask<double>(-2 * n, a), Curve_end::reflect);
  ASSERT_EQ(curve.size(), 3u);
  // reflection continues a line evenly, and the mask takes the mean of two points of it
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(curve[i].first.x(), 0.5 * double(i), 1e-6);
}

TEST(CurveInput, MapsMadeOfLambdas)
{
  const auto polygon = circle_2<>(uneven_angles(6, 1, Real(1), false, 1), 1);
  std::vector<std::size_t> items(polygon.size());
  std::iota(items.begin(), items.end(), std::size_t(0));
  const auto points = boost::make_function_property_map<std::size_t>(
    [&polygon](std::size_t i) { return polygon[i].first; });
  const auto normals = boost::make_function_property_map<std::size_t>(
    [&polygon](std::size_t i) { return polygon[i].second; });
  EXPECT_EQ(PN::subdivide_curve(items, PN::B_spline_mask(3), Curve_end::closed,
                                CGAL::parameters::normal_map(normals).point_map(points)),
            refined(polygon, {false, 3}, Curve_end::closed, 1));
}

TEST(CurveInput, CoefficientsThatDoNotSumToOne)
{
  const auto polygon = circle_2<>(uneven_angles(6, 1, Real(1), false, 1), 1);
  const auto with = [&](std::vector<double> a) {
    return [&polygon, a] {
      PN::subdivide_curve(polygon, PN::Univariate_mask<double>(-1, a), Curve_end::closed);
    };
  };
  messages::expect_refused(with({0.5, 1, 0.6}), {"odd", "sum to 1"});
  messages::expect_refused(with({0.5, 1.1, 0.5}), {"even", "sum to 1"});
  messages::expect_refused(with({}), {"sum to 1"});
  messages::expect_refused(with({1}), {"even", "sum to 1"});
  messages::expect_refused(with({0.5, std::numeric_limits<double>::quiet_NaN(), 0.5}),
                           {"even", "sum to 1"});
  EXPECT_NO_THROW(with({0.5, 1, 0.5})());
}

TEST(CurveInput, MasksThatDoNotGoTogether)
{
  const auto polygon = circle_2<>(uneven_angles(6, 1, Real(1), false, 1), 1);
  messages::expect_refused(
    [&] {
      PN::subdivide_curve(polygon, PN::with_normal_mask(PN::B_spline_mask(3), PN::B_spline_mask(2)),
                          Curve_end::closed);
    },
    {"primal", "dual"});
  for (int bad : {0, -1, 31}) EXPECT_THROW(PN::B_spline_mask{bad}, std::invalid_argument);
  for (int bad : {0, 3, 22, -2})
    EXPECT_THROW(PN::Dubuc_Deslauriers_mask{bad}, std::invalid_argument);
}

// --- normals ---

TEST(CurveInput, NormalsOfAnyLength)
{
  const auto polygon = circle_2<>(uneven_angles(9, 2, Real(6), true, 1), 1);
  const auto expected = refined(polygon, {false, 3}, Curve_end::closed, 3);
  for (double length : {2., 1e-300, 1e300, 0.1}) {
    auto scaled = polygon;
    for (auto& [p, n] : scaled) n = Vector(n.x() * length, n.y() * length);
    const auto curve = refined(scaled, {false, 3}, Curve_end::closed, 3);
    ASSERT_EQ(curve.size(), expected.size());
    for (std::size_t i = 0; i < curve.size(); ++i)
      EXPECT_LE(CGAL::squared_distance(curve[i].first, expected[i].first), 1e-29) << length;
    // without rounds they are unit vectors as well
    for (const auto& item : refined(scaled, {false, 3}, Curve_end::closed, 0))
      EXPECT_NEAR(item.second.squared_length(), 1, 4 * ulp);
  }
}

TEST(CurveInput, NoNormalsAreTheLinearScheme)
{
  auto polygon = circle_2<>(uneven_angles(9, 2, Real(6), true, 1), 1);
  for (auto& item : polygon) item.second = Vector(0, 0);
  EXPECT_EQ(refined(polygon, {true, 2}, Curve_end::closed, 3),
            linearly_refined(polygon, {true, 2}, Curve_end::closed, 3));
}

TEST(Curve_svg, TextIsEscapedAndFailuresAreTold)
{
  namespace svg = CGAL::PN_subdivision_3::curve_svg;
  const std::string title = "x < y & y > z";
  EXPECT_NE(svg::drawing(title, {}).find("<title>x &lt; y &amp; y &gt; z</title>"),
            std::string::npos);
  EXPECT_FALSE(svg::write("no such folder/drawing.svg", title, {}));
}

struct Commas : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

TEST(Curve_svg, NumbersAreThoseOfSvgInEveryLocale)
{
  namespace svg = CGAL::PN_subdivision_3::curve_svg;
  const Curve square = {
    {Point(0, 0), Vector(-1, -1)}, {Point(4, 0), Vector(1, -1)}, {Point(4, 3), Vector(1, 1)}};
  const auto drawing = [&] {
    return svg::drawing("title", {svg::panel("", square, square, Curve_end::closed)});
  };
  const std::string expected = drawing();
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
  const std::string with_commas = drawing();
  std::locale::global(before);
  EXPECT_EQ(with_commas, expected);
}

// --- intervals ---

using Interval = CGAL::Interval_nt<>;
using Interval_kernel = CGAL::Simple_cartesian<Interval>;

Curve_2<Interval_kernel> interval_triangle(const Interval_kernel::Vector_2& third_normal)
{
  using P = Interval_kernel::Point_2;
  using V = Interval_kernel::Vector_2;
  return {{P(1, 0), V(1, 0)}, {P(0, 1), V(0, 1)}, {P(-1, 0), third_normal}};
}

TEST(CurveIntervals, NormalThatMayBeZeroIsNamed)
{
  const Interval near_zero(-1e-3, 1e-3);
  const auto polygon = interval_triangle(Interval_kernel::Vector_2(near_zero, near_zero));
  messages::expect_refused<std::domain_error>(
    [&] { PN::subdivide_curve(polygon, PN::B_spline_mask(3), Curve_end::closed); }, {"point 2"});
}

// 1/3 is no double
TEST(CurveIntervals, CoefficientsThatAreIntervals)
{
  const Interval third = Interval(1) / 3, rest = Interval(1) - third;
  const auto polygon = interval_triangle(Interval_kernel::Vector_2(-1, 0));
  const auto curve = [&](const std::vector<Interval>& a) {
    return PN::subdivide_curve(polygon, PN::linear(PN::Univariate_mask<Interval>(0, a)),
                               Curve_end::closed);
  };
  std::vector<Interval_kernel::Point_2> points;
  for (const auto& item : curve({third, rest, rest, third})) points.push_back(item.first);
  ASSERT_EQ(points.size(), 6u);
  // corners are cut at thirds: the six points of those of the triangle, each once
  const std::vector<Point> expected = {{2. / 3, 1. / 3},  {1. / 3, 2. / 3}, {-1. / 3, 2. / 3},
                                       {-2. / 3, 1. / 3}, {-1. / 3, 0},     {1. / 3, 0}};
  for (const Point& e : expected)
    EXPECT_EQ(std::count_if(points.begin(), points.end(),
                            [&](const auto& p) {
                              return CGAL::abs(p.x() - e.x()).sup() < 1e-15 &&
                                     CGAL::abs(p.y() - e.y()).sup() < 1e-15;
                            }),
              1);
  messages::expect_refused([&] { curve({third, rest, third, rest}); }, {"even", "sum to 1"});
}

// --- kernels ---

template <class K>
Real difference_from_long_double(unsigned rounds, Curve_end end)
{
  const auto reference = refined(wavy<Long_double>(9), {false, 3}, end, rounds);
  Curve_2<K> polygon;
  for (const auto& [p, n] : wavy<Long_double>(9))
    polygon.emplace_back(typename K::Point_2(double(p.x()), double(p.y())),
                         typename K::Vector_2(double(n.x()), double(n.y())));
  const auto curve = refined(polygon, {false, 3}, end, rounds);
  if (curve.size() != reference.size()) return std::numeric_limits<Real>::infinity();
  Real d = 0;
  for (std::size_t i = 0; i < curve.size(); ++i)
    for (int c = 0; c < 2; ++c)
      for (Real x : {Real(CGAL::to_double(curve[i].first[c])) - reference[i].first[c],
                     Real(CGAL::to_double(curve[i].second[c])) - reference[i].second[c]})
        if (!(std::abs(x) <= d)) d = std::abs(x);
  return d;
}

TEST(CurveKernels, CloseToLongDouble)
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  for (Curve_end end : all_ends) {
    EXPECT_LE(difference_from_long_double<Double>(4, end), 1e-14L);
    EXPECT_LE(difference_from_long_double<Epick>(4, end), 1e-14L);
    EXPECT_LE(difference_from_long_double<Epeck>(1, end), 1e-13L);
  }
}

TEST(CurveKernels, Float)
{
  using K = CGAL::Simple_cartesian<float>;
  const auto polygon = circle_2<K>(uneven_angles(12, 2, Real(6), true, 1), 1);
  const auto curve = refined(polygon, {true, 2}, Curve_end::closed, 5);
  EXPECT_EQ(curve.size(), 384u);
  EXPECT_LE(largest(curve, [](const auto& item) { return radius_error(item.first, 1); }), 1e-6L);
}

TEST(CurveKernels, LinearTwinsAreExactInRationals)
{
  using K = CGAL::Simple_cartesian<CGAL::Gmpq>;
  Curve_2<K> polygon;
  for (int i = 0; i < 24; ++i)
    polygon.emplace_back(K::Point_2(CGAL::Gmpq(i * i % 7, 3), CGAL::Gmpq(i * 5 % 11, 7)),
                         K::Vector_2(0, 1));
  for (const auto& s : schemes())
    for (Curve_end end : all_ends) {
      const auto curve = linearly_refined(polygon, s, end);
      const reference::Curve_rows rows(s, 24, reference_end(end));
      ASSERT_EQ(static_cast<long>(curve.size()), rows.size());
      for (long i = 0; i < rows.size(); ++i) {
        CGAL::Gmpq x = 0, y = 0;
        for (const auto& [j, w] : rows[i]) { // weights are dyadic: exact as double
          x += CGAL::Gmpq(double(w)) * polygon[std::size_t(j)].first.x();
          y += CGAL::Gmpq(double(w)) * polygon[std::size_t(j)].first.y();
        }
        EXPECT_EQ(curve[std::size_t(i)].first, K::Point_2(x, y)) << name_of(s, end) << i;
      }
    }
}

} // namespace
