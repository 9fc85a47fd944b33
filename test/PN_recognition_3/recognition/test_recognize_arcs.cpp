// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Lines and arcs of drawings: the pieces are those that the drawing was made of, and refined points are on them.

#include "Curve_cases.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_recognition_3/recognize_arcs.h>

#include <cstdio>
#include <cstdlib>

using namespace curve_cases;

namespace {

using Kind = PN::Recognized_arc::Kind;
using Point = Double::Point_2;
using Polygon = std::vector<Point>;

const double pi = std::acos(-1.);

enum class Rounding { exact, to_float, six_digits };
const Rounding all_roundings[] = {Rounding::exact, Rounding::to_float, Rounding::six_digits};

double rounded(double x, Rounding rounding)
{
  if (rounding == Rounding::to_float) return double(float(x));
  if (rounding == Rounding::exact) return x;
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", x);
  return std::atof(text);
}
Polygon rounded(Polygon p, Rounding rounding)
{
  for (Point& q : p) q = Point(rounded(q.x(), rounding), rounded(q.y(), rounding));
  return p;
}
double rounding_unit(const Polygon& p, Rounding rounding)
{
  double largest = 0;
  for (const Point& q : p) largest = std::max({largest, std::abs(q.x()), std::abs(q.y())});
  return rounding == Rounding::to_float ? largest * 0x1p-24
         : rounding == Rounding::six_digits
           ? 0.5 * std::pow(10., std::floor(std::log10(largest)) - 5)
           : largest * 0x1p-50;
}

// A pen that draws lines and arcs, and remembers what it has drawn.
struct Drawing
{
  struct Piece
  {
    Kind kind;
    std::size_t first, last;
    Point center; // of a line a point
    double radius, direction;
  };
  Polygon points{Point(0, 0)};
  std::vector<Piece> pieces;
  double heading = 0;

  Point ahead(double angle, double length) const
  {
    const Point& p = points.back();
    return Point(p.x() + length * std::cos(angle), p.y() + length * std::sin(angle));
  }
  void line(double length, int edges = 1)
  {
    const std::size_t first = points.size() - 1;
    const Point start = points.back();
    for (int i = 1; i <= edges; ++i)
      points.push_back(Point(start.x() + length * i / edges * std::cos(heading),
                             start.y() + length * i / edges * std::sin(heading)));
    pieces.push_back({Kind::line, first, points.size() - 1, start, 0, heading});
  }
  // to the left if the angle is positive
  void arc(double radius, double angle, int edges)
  {
    const double side = angle > 0 ? 1 : -1, from = heading - side * pi / 2;
    const Point center = ahead(from + pi, radius);
    const std::size_t first = points.size() - 1;
    for (int i = 1; i <= edges; ++i)
      points.push_back(Point(center.x() + radius * std::cos(from + angle * i / edges),
                             center.y() + radius * std::sin(from + angle * i / edges)));
    pieces.push_back({Kind::circle, first, points.size() - 1, center, radius, 0});
    heading += angle;
  }
  void turn(double angle) { heading += angle; }
  // the last point is the first one
  void close() { points.pop_back(); }
};

double distance(const Drawing::Piece& piece, const Point& p)
{
  const double x = p.x() - piece.center.x(), y = p.y() - piece.center.y();
  return piece.kind == Kind::circle
           ? std::abs(std::hypot(x, y) - piece.radius)
           : std::abs(y * std::cos(piece.direction) - x * std::sin(piece.direction));
}

template <class Range>
auto refined_parts(const Range& polygon, Curve_end end, const std::vector<PN::Recognized_arc>& arcs,
                   unsigned levels)
{
  auto parts = PN::split_at_arcs(polygon, end, arcs);
  for (auto& part : parts)
    part =
      PN::subdivide_curve(part, PN::B_spline_mask(3), parts.size() == 1 ? end : Curve_end::reflect,
                          params::number_of_iterations(levels));
  return parts;
}

void expect_pieces(const Drawing& drawing, Curve_end end, const std::string& name)
{
  for (const Rounding rounding : all_roundings) {
    SCOPED_TRACE(name + ", rounding " + std::to_string(int(rounding)));
    const Polygon polygon = rounded(drawing.points, rounding);
    const auto arcs = PN::recognize_arcs(polygon, end);
    ASSERT_EQ(arcs.size(), drawing.pieces.size());
    const auto parts = refined_parts(polygon, end, arcs, 4);
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      const Drawing::Piece& truth = drawing.pieces[k];
      EXPECT_EQ(arcs[k].kind, truth.kind) << k;
      EXPECT_EQ(arcs[k].first, truth.first) << k;
      EXPECT_EQ(arcs[k].last, truth.last) << k;
      const double unit = rounding_unit(polygon, rounding);
      EXPECT_LE(arcs[k].residual, 2 * unit) << k;
      for (const auto& item : parts[k]) EXPECT_LE(distance(truth, item.first), 8 * unit) << k;
    }
  }
}

Drawing rounded_rectangle(int edges, int line_edges = 1)
{
  Drawing d;
  for (int i = 0; i < 4; ++i) {
    d.line(i % 2 == 0 ? 5 : 3, line_edges);
    d.arc(1, pi / 2, edges);
  }
  d.close();
  return d;
}

TEST(Recognize_arcs, RoundedRectangles)
{
  for (const int edges : {2, 3, 4, 5, 6, 9, 16, 30})
    for (const int line_edges : {1, 2, 7})
      expect_pieces(rounded_rectangle(edges, line_edges), Curve_end::closed,
                    "rectangle of " + std::to_string(edges));
}

TEST(Recognize_arcs, SlotsAndKeyholes)
{
  for (const int edges : {3, 4, 8, 13, 40}) {
    Drawing slot;
    for (int i = 0; i < 2; ++i) {
      slot.line(4);
      slot.arc(1, pi, edges);
    }
    slot.close();
    expect_pieces(slot, Curve_end::closed, "slot of " + std::to_string(edges));
  }
  for (const int edges : {12, 25, 70}) {
    const double sine = edges < 20 ? 0.6 : 0.25, half = std::asin(sine);
    Drawing disk; // with a flat
    disk.turn(half);
    disk.arc(2, 2 * (pi - half), edges);
    Drawing keyhole = disk;
    disk.heading = 0;
    disk.line(4 * sine);
    disk.close();
    expect_pieces(disk, Curve_end::closed, "flat disk of " + std::to_string(edges));
    for (const double direction : {-pi / 2, 0., pi / 2}) {
      keyhole.heading = direction;
      keyhole.line(direction == 0 ? 4 * sine : 3);
    }
    keyhole.close();
    expect_pieces(keyhole, Curve_end::closed, "keyhole of " + std::to_string(edges));
  }
}

// open, with corners and smooth joints
Drawing random_drawing(std::mt19937& engine)
{
  const auto number = [&](double a, double b) {
    return a + (b - a) * double(engine() >> 5) * 0x1p-27;
  };
  Drawing d;
  d.heading = number(-pi, pi);
  double last_radius = 0; // 0: a line
  const int pieces = 2 + int(engine() % 6);
  for (int k = 0; k < pieces; ++k) {
    const bool turns = k > 0 && engine() % 2 == 0;
    if (turns) d.turn((engine() % 2 == 0 ? 1 : -1) * number(1.1, 2.2));
    if (engine() % 2 == 0 && (k == 0 || turns || last_radius > 0)) {
      d.line(number(0.5, 3), 1 + int(engine() % 4));
      last_radius = 0;
    } else {
      last_radius = last_radius == 1 ? 1.7 : 1;
      const int edges = 4 + int(engine() % 9);
      d.arc(last_radius, (engine() % 2 == 0 ? 1 : -1) * number(1, 2.5), edges);
    }
  }
  return d;
}

TEST(Recognize_arcs, RandomDrawings)
{
  std::mt19937 engine(1);
  for (int i = 0; i < 300; ++i)
    expect_pieces(random_drawing(engine), Curve_end::reflect, "drawing " + std::to_string(i));
}

TEST(Recognize_arcs, ClosedDrawingsBeginAtTheFirstCorner)
{
  const Polygon polygon = rounded_rectangle(4).points;
  for (std::size_t shift = 0; shift < polygon.size(); ++shift) {
    Polygon turned = polygon;
    std::rotate(turned.begin(), turned.begin() + std::ptrdiff_t(shift), turned.end());
    const auto arcs = PN::recognize_arcs(turned, Curve_end::closed);
    ASSERT_EQ(arcs.size(), 8u);
    EXPECT_LT(arcs[0].first, 4u);
    EXPECT_EQ(arcs.back().last, arcs[0].first + turned.size());
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_EQ(arcs[k].first, k > 0 ? arcs[k - 1].last : arcs[0].first);
      EXPECT_EQ(arcs[k].last - arcs[k].first, arcs[k].kind == Kind::line ? 1u : 4u);
    }
  }
}

// --- normals ---

TEST(Recognize_arcs, SmoothJointsHaveOneNormalAndCornersTwo)
{
  Drawing d;
  d.line(2);
  d.arc(1, pi / 2, 6);
  d.turn(pi / 2);
  d.line(1);
  const auto arcs = PN::recognize_arcs(d.points, Curve_end::reflect);
  const auto parts = PN::split_at_arcs(d.points, Curve_end::reflect, arcs);
  ASSERT_EQ(parts.size(), 3u);
  const auto is_near = [](const Double::Vector_2& n, double x, double y) {
    return std::abs(n.x() - x) + std::abs(n.y() - y) < 1e-12;
  };
  // to the right of the direction of travel
  EXPECT_TRUE(is_near(parts[0].back().second, 0, -1));
  EXPECT_TRUE(is_near(parts[1].front().second, 0, -1));
  EXPECT_TRUE(is_near(parts[1].back().second, 1, 0));
  EXPECT_TRUE(is_near(parts[2].front().second, 0, 1));
  const auto whole = PN::join_at_corners(parts, Curve_end::reflect);
  EXPECT_TRUE(is_near(whole[1].second, 0, -1));
  EXPECT_TRUE(is_near(whole[7].second, std::sqrt(0.5), std::sqrt(0.5)));
  // clockwise, too
  Drawing right;
  right.arc(1, -pi / 2, 6);
  const auto part = PN::split_at_arcs(right.points, Curve_end::reflect,
                                      PN::recognize_arcs(right.points, Curve_end::reflect));
  EXPECT_TRUE(is_near(part[0].front().second, 0, -1));
}

TEST(Recognize_arcs, UnknownPiecesMeetTheirNeighborsSmoothly)
{
  // a line that goes over into a parabola
  Polygon polygon{Point(-2, 0), Point(-1.5, 0), Point(-1, 0), Point(0, 0)};
  for (int i = 1; i <= 8; ++i) polygon.push_back(Point(0.25 * i, 0.02 * i * i));
  const auto arcs = PN::recognize_arcs(polygon, Curve_end::reflect);
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[1].kind, Kind::unknown);
  const auto parts = PN::split_at_arcs(polygon, Curve_end::reflect, arcs);
  EXPECT_EQ(parts[1].front().second, parts[0].back().second);
  const auto estimated =
    PN::estimate_control_normals(Polygon(polygon.begin() + 3, polygon.end()), Curve_end::reflect);
  EXPECT_NE(estimated.front().second, parts[1].front().second);
  for (std::size_t i = 1; i < parts[1].size(); ++i) EXPECT_EQ(parts[1][i], estimated[i]) << i;
  // not at corners
  Polygon bent{Point(-2, 0), Point(-1.5, 0), Point(-1, 0), Point(0, 0)};
  for (int i = 1; i <= 8; ++i) bent.push_back(Point(0.2 * i, 0.2 * i + 0.02 * i * i));
  const auto corner =
    PN::split_at_arcs(bent, Curve_end::reflect, PN::recognize_arcs(bent, Curve_end::reflect));
  ASSERT_EQ(corner.size(), 2u);
  EXPECT_EQ(corner[1], PN::estimate_control_normals(Polygon(bent.begin() + 3, bent.end()),
                                                    Curve_end::reflect));
  // normals that are given stay, but for those of lines and arcs
  Curve_2<Double> with_normals;
  for (const Point& p : polygon) with_normals.push_back({p, Double::Vector_2(0.6, 0.8)});
  const auto given = PN::split_at_arcs(with_normals, Curve_end::reflect, arcs);
  EXPECT_EQ(given[0][1].second, Double::Vector_2(0, -1));
  EXPECT_EQ(given[1][3].second, Double::Vector_2(0.6, 0.8));
}

// --- what is no drawing ---

void expect_unknown(const Polygon& polygon, const std::string& name)
{
  for (const Rounding rounding : all_roundings) {
    SCOPED_TRACE(name + ", rounding " + std::to_string(int(rounding)));
    const Polygon p = rounded(polygon, rounding);
    const auto arcs = PN::recognize_arcs(p, Curve_end::closed);
    ASSERT_EQ(arcs.size(), 1u);
    EXPECT_EQ(arcs[0].kind, Kind::unknown);
    EXPECT_EQ(arcs[0].last, p.size());
    const auto parts = PN::split_at_arcs(p, Curve_end::closed, arcs);
    EXPECT_EQ(parts[0], PN::estimate_control_normals(p, Curve_end::closed));
  }
}

TEST(Recognize_arcs, EllipsesAreUnknown)
{
  for (const int n : {12, 24, 100, 1000, 2000})
    for (const double phase : {0., 0.5, 0.3}) {
      Polygon ellipse;
      for (int i = 0; i < n; ++i) {
        const double t = 2 * pi * (i + phase) / n;
        ellipse.push_back(Point(3 * std::cos(t), 2 * std::sin(t)));
      }
      expect_unknown(ellipse, "ellipse of " + std::to_string(n));
    }
}

TEST(Recognize_arcs, ThreePointsOfAFreeFormCurveAreNoLine)
{
  const Polygon polygon{Point(0, 0),    Point(1, 0.3), Point(2, 0.1), Point(3, 0),
                        Point(4, -0.1), Point(5, 0.3), Point(6, 0.4)};
  const auto arcs = PN::recognize_arcs(polygon, Curve_end::reflect);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].kind, Kind::unknown);
}

TEST(Recognize_arcs, NoiseIsUnknown)
{
  std::mt19937 engine(2);
  for (const double size : {1e-2, 0.1, 0.3})
    for (int i = 0; i < 20; ++i) {
      Polygon noisy = rounded_rectangle(6, 3).points;
      for (Point& p : noisy)
        p = Point(p.x() + size * (double(engine()) * 0x1p-32 - 0.5),
                  p.y() + size * (double(engine()) * 0x1p-32 - 0.5));
      expect_unknown(noisy, "noise of " + std::to_string(size));
    }
}

TEST(Recognize_arcs, PolygonsOfFewSidesAreLines)
{
  const auto regular = [](int n) {
    Polygon p;
    for (int i = 0; i < n; ++i)
      p.push_back(Point(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)));
    return p;
  };
  for (const int n : {3, 4, 5, 6, 7, 8, 12}) {
    const auto arcs = PN::recognize_arcs(regular(n), Curve_end::closed);
    EXPECT_EQ(arcs.size(), n < 8 ? std::size_t(n) : 1u) << n;
    EXPECT_EQ(arcs[0].kind, n < 8 ? Kind::line : Kind::circle) << n;
  }
  const auto six = PN::recognize_arcs(regular(6), Curve_end::closed,
                                      CGAL::PN_subdivision_3::parameters::min_facets(6));
  ASSERT_EQ(six.size(), 1u);
  EXPECT_EQ(six[0].kind, Kind::circle);
  EXPECT_NEAR(six[0].radius, 1, 1e-14);
  const auto circle = refined_parts(regular(6), Curve_end::closed, six, 3);
  for (const auto& item : circle[0])
    EXPECT_NEAR(std::hypot(item.first.x(), item.first.y()), 1, 1e-14);
}

// --- in space, other numbers, bad input ---

TEST(Recognize_arcs, PlaneCurvesInSpace)
{
  const Double::Vector_3 u(2. / 3, 2. / 3, 1. / 3), v(-2. / 3, 1. / 3, 2. / 3);
  const Polygon flat = rounded_rectangle(5, 2).points;
  std::vector<Double::Point_3> polygon;
  for (const Point& p : flat) polygon.push_back(Double::Point_3(7, 8, 9) + p.x() * u + p.y() * v);
  const auto expected = PN::recognize_arcs(flat, Curve_end::closed);
  const auto arcs = PN::recognize_arcs(polygon, Curve_end::closed);
  ASSERT_EQ(arcs.size(), expected.size());
  const auto parts = PN::split_at_arcs(polygon, Curve_end::closed, arcs);
  const auto flat_parts = PN::split_at_arcs(flat, Curve_end::closed, expected);
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    EXPECT_EQ(arcs[k].kind, expected[k].kind);
    EXPECT_EQ(arcs[k].first, expected[k].first);
    if (arcs[k].kind == Kind::circle) {
      const auto& c = arcs[k].center;
      const auto d = Double::Point_3(c[0], c[1], c[2]) - polygon[arcs[k].first];
      EXPECT_NEAR(std::sqrt(d.squared_length()), 1, 1e-12);
      EXPECT_NEAR(arcs[k].radius, 1, 1e-12);
    }
    for (std::size_t i = 0; i < parts[k].size(); ++i) {
      const auto& n = flat_parts[k][i].second; // counterclockwise: outside
      EXPECT_LE((parts[k][i].second - (n.x() * u + n.y() * v)).squared_length(), 1e-24);
    }
  }
  polygon[3] = polygon[3] + Double::Vector_3(0, 0, 0.01);
  EXPECT_THROW(PN::recognize_arcs(polygon, Curve_end::closed), std::invalid_argument);
}

TEST(Recognize_arcs, ExactNumbersAndRepeatedPoints)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::vector<Exact::Point_2> polygon;
  const Polygon points = rounded_rectangle(6).points;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 1 + i % 2; ++k)
      polygon.push_back(Exact::Point_2(points[i].x(), points[i].y()));
  const auto arcs = PN::recognize_arcs(polygon, Curve_end::closed);
  EXPECT_EQ(arcs.size(), 8u);
  std::size_t vertices = 0;
  for (const auto& part : PN::split_at_arcs(polygon, Curve_end::closed, arcs))
    vertices += part.size() - 1;
  EXPECT_EQ(vertices, polygon.size());
  EXPECT_EQ(arcs.back().last, arcs.front().first + polygon.size());
}

TEST(Recognize_arcs, FewPointsAndBadInput)
{
  for (const Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
    EXPECT_TRUE(PN::recognize_arcs(Polygon(), end).empty());
    for (std::size_t n = 1; n <= 3; ++n) {
      const Polygon same(n, Point(1, 2));
      const auto arcs = PN::recognize_arcs(same, end);
      EXPECT_EQ(PN::split_at_arcs(same, end, arcs).size(), arcs.size());
    }
    const Polygon two{Point(0, 0), Point(1, 0)};
    EXPECT_EQ(PN::split_at_arcs(two, end, PN::recognize_arcs(two, end)).size(), 1u);
  }
  const Polygon bad{Point(0, 0), Point(1, HUGE_VAL), Point(2, 0)};
  EXPECT_THROW(PN::recognize_arcs(bad, Curve_end::closed), std::invalid_argument);
  const Polygon polygon = rounded_rectangle(4).points;
  EXPECT_THROW(PN::recognize_arcs(polygon, Curve_end::closed,
                                  CGAL::PN_subdivision_3::parameters::surface_tolerance(-1.)),
               std::invalid_argument);
  auto arcs = PN::recognize_arcs(polygon, Curve_end::closed);
  arcs[0].last = 1000;
  EXPECT_THROW(PN::split_at_arcs(polygon, Curve_end::closed, arcs), std::invalid_argument);
}

} // namespace
