// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `pn_subdivide curve --comb`: the drawing is well-formed XML, lies within its frame and shows what
// it says.

#include "Command_test.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cmath>
#include <iomanip>
#include <utility>

namespace {

using Tree = boost::property_tree::ptree;
using Points = std::vector<std::pair<double, double>>;

const double pi = std::acos(-1);

// The numbers of a path; M, L and Z only.
Points path_points(std::string d)
{
  EXPECT_EQ(d.find_first_not_of("MLZ 0123456789.-"), std::string::npos) << d;
  std::replace_if(
    d.begin(), d.end(), [](char c) { return c == 'M' || c == 'L' || c == 'Z'; }, ' ');
  std::istringstream in(d);
  Points points;
  for (double x = 0, y = 0; in >> x >> y;) points.emplace_back(x, y);
  EXPECT_TRUE(in.eof());
  return points;
}

struct Drawing
{
  explicit Drawing(const std::string& file)
  {
    Tree tree;
    EXPECT_NO_THROW(boost::property_tree::read_xml(file, tree)) << file;
    svg = tree.get_child("svg", Tree());
    double x = -1, y = -1;
    std::istringstream(svg.get("<xmlattr>.viewBox", "")) >> x >> y >> width >> height;
    EXPECT_EQ(x, 0);
    EXPECT_EQ(y, 0);
  }

  std::vector<Points> paths(const std::string& name) const
  {
    std::vector<Points> found;
    for (const auto& [tag, element] : svg)
      if (tag == "path" && element.get("<xmlattr>.class", "") == name)
        found.push_back(path_points(element.get("<xmlattr>.d", "")));
    return found;
  }

  Points one_path(const std::string& name) const
  {
    const std::vector<Points> found = paths(name);
    EXPECT_EQ(found.size(), 1u) << name;
    return found.empty() ? Points() : found.front();
  }

  Tree svg;
  double width = 0, height = 0;
};

// Samples of a circle in a plane through (1, 0, 0) and (0, cos tilt, sin tilt); tilt 0: planar.
std::string circle(double radius, double tilt)
{
  std::ostringstream out;
  out << std::setprecision(17);
  for (const double t : {0., 0.5, 1.2, 1.6, 2.4, 2.9, 3.8, 4.2, 5.1, 5.7}) {
    const double c = std::cos(t), u = std::sin(t) * std::cos(tilt),
                 v = std::sin(t) * std::sin(tilt);
    if (tilt == 0)
      out << radius * c << ' ' << radius * u << ' ' << c << ' ' << u << '\n';
    else
      out << radius * c << ' ' << radius * u << ' ' << radius * v << ' ' << c << ' ' << u << ' '
          << v << '\n';
  }
  return out.str();
}

const char* const wave = "0 0\n2 3\n4 3\n6 0\n8 -1.5\n10 0\n11 3\n14 3.5\n";

class Pn_subdivide_comb : public Command_test
{
protected:
  Drawing drawn(const std::string& polygon, const std::string& options) const
  {
    SCOPED_TRACE(options);
    const std::string comb = folder.file("comb.svg");
    const Outcome outcome = done(curve(folder.write("polygon.txt", polygon), "curve.txt",
                                       "--quiet --comb '" + comb + "' " + options));
    EXPECT_EQ(outcome.out + outcome.err, "");
    Drawing drawing(comb);
    for (const char* name : {"polygon", "curve", "area", "teeth", "envelope", "normal", "head"})
      for (const Points& path : drawing.paths(name)) expect_inside(path, drawing);
    return drawing;
  }

  static void expect_inside(const Points& points, const Drawing& drawing)
  {
    for (const auto& [x, y] : points) {
      EXPECT_TRUE(x > 0 && x < drawing.width) << x;
      EXPECT_TRUE(y > 0 && y < drawing.height) << y;
    }
  }

  // Returns the radius.
  static double expect_circle(const Points& points)
  {
    EXPECT_GT(points.size(), 20u);
    const auto x = std::minmax_element(points.begin(), points.end());
    const double left = x.first->first, right = x.second->first, radius = (right - left) / 2;
    double top = 1e9, bottom = -1e9;
    for (const auto& p : points) {
      top = std::min(top, p.second);
      bottom = std::max(bottom, p.second);
    }
    for (const auto& p : points)
      EXPECT_NEAR(std::hypot(p.first - (left + right) / 2, p.second - (top + bottom) / 2), radius,
                  0.4); // of a pixel; the extreme points are not drawn exactly
    return radius;
  }
};

} // namespace

TEST_F(Pn_subdivide_comb, ACircleHasARoundCombOfEvenHeight)
{
  for (const double radius : {1., 1e-3, 1e150, 1e300, 1e-150, 1e-310}) {
    const Drawing drawing = drawn(circle(radius, 0), "--closed --levels 6 --scheme 4-point");
    const double inner = expect_circle(drawing.one_path("curve")),
                 outer = expect_circle(drawing.one_path("envelope"));
    EXPECT_GT(outer, 1.2 * inner) << radius;
    EXPECT_LT(outer, 2 * inner) << radius;
    EXPECT_GT(outer, 250) << radius; // fills the drawing
    EXPECT_EQ(drawing.paths("normal").size(), 10u);
    EXPECT_EQ(drawing.one_path("polygon").size(), 10u);
    EXPECT_EQ(drawing.svg.count("circle"), 10u);
  }
}

TEST_F(Pn_subdivide_comb, ACircleInSpaceIsDrawnAsACircle)
{
  for (const double tilt : {0.3, pi / 2, 2.2}) {
    const Drawing drawing = drawn(circle(2, tilt), "--closed --levels 6 --scheme bspline:3");
    EXPECT_GT(expect_circle(drawing.one_path("envelope")),
              1.2 * expect_circle(drawing.one_path("curve")));
    EXPECT_EQ(drawing.paths("normal").size(), 10u);
  }
}

TEST_F(Pn_subdivide_comb, CurvesOfAllKindsLieInTheirFrame)
{
  for (const char* scheme : {"chaikin", "bspline:3", "4-point", "10-point"})
    for (const char* end : {"", " --closed", " --linear"}) {
      const Drawing drawing = drawn(wave, std::string("--levels 5 --scheme ") + scheme + end);
      EXPECT_GT(drawing.one_path("curve").size(), 20u);
      EXPECT_GT(drawing.one_path("teeth").size(), 100u);
      EXPECT_EQ(drawing.one_path("polygon").size(), 8u);
      EXPECT_EQ(drawing.paths("normal").size(), std::string(end) == " --linear" ? 0u : 8u);
    }
}

TEST_F(Pn_subdivide_comb, ALineHasNoComb)
{
  const Drawing drawing = drawn("0 0\n1 0.1\n3 0.3\n7 0.7\n", "--scheme bspline:3 --levels 3");
  EXPECT_TRUE(drawing.paths("teeth").empty());
  EXPECT_FALSE(drawing.one_path("curve").empty());
}

TEST_F(Pn_subdivide_comb, FewAndRepeatedPoints)
{
  for (const char* polygon : {"1 2 0 1\n", "1 2\n1 2\n1 2\n", "1 2\n3 4\n", "1 2 3 0 0 1\n",
                              "0 0 0 0 0 1\n2 0 0 0 0 1\n4 0 0 0 0 1\n"})
    for (const char* options : {"--scheme 4-point", "--scheme bspline:3 --closed --levels 2"})
      drawn(polygon, options);
}

TEST_F(Pn_subdivide_comb, SaysWhatItShows)
{
  EXPECT_EQ(
    drawn(wave, "--scheme bspline:3 --normal-scheme 4-point --levels 2").svg.get("text", ""),
    "PN cubic B-spline, normals by 4-point, 2 rounds");
  EXPECT_EQ(drawn(wave, "--scheme 6-point --linear").svg.get("text", ""),
            "Linear 6-point, 1 round");
  const std::string style = drawn(wave, "--scheme chaikin").svg.get("style", "");
  expect_part(style, "prefers-color-scheme:dark");
}

TEST_F(Pn_subdivide_comb, ALongCurveMakesASmallDrawing)
{
  drawn(wave, "--scheme bspline:3 --levels 14");
  EXPECT_LT(content("comb.svg").size(), 60000u);
}

// Control points too are drawn no closer than they can be told apart.
TEST_F(Pn_subdivide_comb, ManyControlPointsMakeASmallDrawing)
{
  std::ostringstream circle;
  circle << std::setprecision(17);
  constexpr int n = 30000;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::acos(-1.) * i / n, x = std::cos(t), y = std::sin(t);
    circle << x << ' ' << y << ' ' << x << ' ' << y << '\n';
  }
  drawn(circle.str(), "--scheme bspline:3 --closed --levels 1");
  EXPECT_LT(content("comb.svg").size(), 800000u);
}

TEST_F(Pn_subdivide_comb, ADrawingThatCannotBeWrittenLeavesAllFilesAsTheyWere)
{
  const std::string input = folder.write("wave.txt", wave), output = folder.write("old.txt", "old");
  const std::string drawing = folder.write("old.svg", "old drawing");
  const auto run_with = [&](const std::string& comb, const std::string& options) {
    return curve(input, output, "--comb '" + comb + "' " + options);
  };
  expect_one_line(run_with(folder.file("no/comb.svg"), "--scheme chaikin"), 1, "no folder");
  expect_one_line(run_with(folder.file(""), "--scheme chaikin"), 1, "directory");
  expect_one_line(run_with(output, "--scheme chaikin"), 2, "--comb");
  expect_one_line(run_with(input, "--scheme chaikin"), 2, "--comb");
  expect_one_line(run_with(drawing, "--scheme 10-point --end none"), 1, "too short");
  EXPECT_EQ(Temporary_folder::content(input), wave);
  EXPECT_EQ(Temporary_folder::content(output), "old");
  EXPECT_EQ(Temporary_folder::content(drawing), "old drawing");
  EXPECT_EQ(folder.number_of_files(), 3u);
}
