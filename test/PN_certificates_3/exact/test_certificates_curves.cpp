// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Certificates of curves: one round from rational samples of a circle, cylinder or sphere ends
// exactly on it, by every mask and at every end. And what else holds exactly in exact numbers.

#include "Curve_cases.h"
#include "One_root_number.h"
#include "Rational_shapes.h"

using namespace curve_cases;

namespace {

using Number = One_root_number;
using Rational = rational_shapes::Rational;
using rational_shapes::Shape;
using Exact = One_root_kernel;
using Circle_curve = Curve_2<Exact>;
using Space_curve = Curve_3<Exact>;

const double tiny = std::ldexp(1., -60);

// --- masks ---

// f(name, mask, number of coefficients) for every mask of the package
template <class Function>
void for_each_mask(const Function& f)
{
  for (int degree : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 15, 30})
    f("B-spline " + std::to_string(degree), PN::B_spline_mask(degree),
      static_cast<std::size_t>(degree + 2));
  for (int points = 2; points <= 20; points += 2)
    f(std::to_string(points) + "-point", PN::Dubuc_Deslauriers_mask(points),
      static_cast<std::size_t>(2 * points - 1));
}

// f as above for every end, with numbers of control points from about half a row to two masks
template <class Function>
void for_each_mask_and_end(const Function& f)
{
  for_each_mask([&](const std::string& name, const auto& mask, std::size_t length) {
    for (Curve_end end : {Curve_end::closed, Curve_end::reflect, Curve_end::none})
      for (std::size_t n : {length / 2 + 3, 2 * length}) {
        const char* const ends[] = {" closed ", " reflect ", " none "};
        f(name + ends[static_cast<int>(end)] + std::to_string(n), mask, end, n);
      }
  });
}

// --- control polygons ---

// Uneven angles: all around for closed polygons, about 220 degrees for open ones.
std::array<double, 2> direction(std::size_t i, std::size_t n, Curve_end end)
{
  const double arc = end == Curve_end::closed ? 6.28 : 3.8;
  const double a = arc * (double(i) + 0.3 * std::sin(2.7 * double(i))) / double(n);
  return {std::cos(a), std::sin(a)};
}

const std::array<Rational, 2> center{Rational(1, 2), Rational(-5, 3)};
const Rational radius(7, 3);

Circle_curve circle(std::size_t n, Curve_end end)
{
  Circle_curve polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const auto d = direction(i, n, end);
    const std::array<Rational, 2> c = rational_shapes::unit_2(d[0], d[1]);
    polygon.emplace_back(Exact::Point_2(center[0] + radius * c[0], center[1] + radius * c[1]),
                         Exact::Vector_2(c[0], c[1]));
  }
  return polygon;
}

// on a cylinder something like a helix, on a sphere a spiral
Space_curve on(const Shape& shape, std::size_t n, Curve_end end)
{
  Space_curve polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const auto d = direction(i, n, end);
    const double h = double(i) / double(n) - 0.4;
    const auto s =
      shape.is_sphere() ? shape.sample({d[0], d[1], h}) : shape.sample({h, d[0], d[1]});
    polygon.emplace_back(Exact::Point_3(s.point[0], s.point[1], s.point[2]),
                         Exact::Vector_3(s.normal[0], s.normal[1], s.normal[2]));
  }
  return polygon;
}

bool is_on(const Exact::Point_2& p, const Exact::Vector_2& n)
{
  return n * n == Number(1) && p.x() - Number(center[0]) == Number(radius) * n.x() &&
         p.y() - Number(center[1]) == Number(radius) * n.y();
}

std::size_t number_off_circle(const Circle_curve& curve)
{
  std::size_t off = 0;
  for (const auto& [p, n] : curve) off += !is_on(p, n);
  return off;
}

std::size_t number_off(const Shape& shape, const Space_curve& curve)
{
  std::size_t off = 0;
  for (const auto& [p, n] : curve)
    off +=
      !rational_shapes::is_exactly_on<Number>(shape, {p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()});
  return off;
}

// --- certificates ---

TEST(CurveCertificate, OneRoundKeepsCirclesExactly)
{
  std::size_t points = 0;
  for_each_mask_and_end(
    [&](const std::string& name, const auto& mask, Curve_end end, std::size_t n) {
      const auto curve = PN::subdivide_curve(circle(n, end), mask, end);
      EXPECT_EQ(number_off_circle(curve), 0u) << name;
      points += curve.size();
    });
  std::cout << points << " points certified\n";
}

TEST(CurveCertificate, OneRoundKeepsCylindersAndSpheresExactly)
{
  std::size_t points = 0;
  for (const Shape& shape : {rational_shapes::cylinder(), rational_shapes::sphere()})
    for_each_mask_and_end(
      [&](const std::string& name, const auto& mask, Curve_end end, std::size_t n) {
        const auto curve = PN::subdivide_curve(on(shape, n, end), mask, end);
        EXPECT_EQ(number_off(shape, curve), 0u) << name;
        points += curve.size();
      });
  std::cout << points << " points certified\n";
}

// rational numbers stay so: two rounds where no round shortens the polygon
auto rounds_of(Curve_end end)
{
  return params::number_of_iterations(end == Curve_end::none ? 1u : 2u);
}

// 3 x + 4 y = 5 with its normal: in rational numbers, several rounds
TEST(CurveCertificate, LinesStayLinesExactly)
{
  const Exact::Vector_2 normal(Rational(3, 5), Rational(4, 5));
  for_each_mask_and_end([&](const std::string& name, const auto& mask, Curve_end end,
                            std::size_t n) {
    Circle_curve polygon;
    for (std::size_t i = 0; i < n; ++i) {
      const Rational t(static_cast<int>(7 * i + i * i % 5), 3);
      polygon.emplace_back(Exact::Point_2(Rational(3, 5) + 4 * t, Rational(4, 5) - 3 * t), normal);
    }
    const auto curve = PN::subdivide_curve(polygon, mask, end, rounds_of(end));
    for (const auto& [p, m] : curve) {
      EXPECT_TRUE(3 * p.x() + 4 * p.y() == 5) << name;
      EXPECT_TRUE(m == normal) << name;
    }
  });
}

// --- what a certificate tells apart ---

// An exact mask whose coefficients miss 2^-60 is none; other coefficients that sum to 1 keep circles.
TEST(CurveCertificate, ChangedCoefficientsAreRefusedUnlessTheySumToOne)
{
  for_each_mask([](const std::string& name, const auto& mask, std::size_t length) {
    const std::vector<Number> original = mask.template coefficients<Number>();
    for (std::size_t k = 0; k < original.size(); ++k) {
      auto changed = original;
      changed[k] += Number(tiny);
      EXPECT_THROW(PN::subdivide_curve(circle(length, Curve_end::closed),
                                       PN::Univariate_mask<Number>(mask.first_index(), changed),
                                       Curve_end::closed),
                   std::invalid_argument)
        << name << ", coefficient " << k;
      if (k + 2 >= original.size()) continue;
      changed[k + 2] -= Number(tiny);
      const auto curve = PN::subdivide_curve(
        circle(length, Curve_end::closed), PN::Univariate_mask<Number>(mask.first_index(), changed),
        Curve_end::closed);
      EXPECT_EQ(number_off_circle(curve), 0u) << name << ", coefficient " << k;
    }
  });
}

// Constants are kept: in floating point, since rows sum to 1 in the order of their emission.
template <class FT>
void expect_constants()
{
  using K = CGAL::Simple_cartesian<FT>;
  for_each_mask_and_end(
    [&](const std::string& name, const auto& mask, Curve_end end, std::size_t n) {
      const Curve_2<K> polygon(
        n, {typename K::Point_2(FT(1), FT(-2)), typename K::Vector_2(FT(0), FT(0))});
      for (const auto& item : PN::subdivide_curve(polygon, PN::linear(mask), end))
        EXPECT_TRUE(item.first == polygon[0].first) << name;
    });
}

TEST(ExactCurve, RowsSumToOne)
{
  expect_constants<float>();
  expect_constants<double>();
  expect_constants<long double>();
  expect_constants<Rational>();
}

} // namespace
