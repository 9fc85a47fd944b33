// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Every mode of the command at every scale: the scaled result, bit for bit, or a refusal by name.

#include "Command_test.h"
#include "Extent.h"
#include "Part_files.h"
#include "io/mesh_io.h"

#include <cmath>
#include <cstdio>

using namespace pn_subdivide;

namespace {

const std::vector<int> exponents = {-600, -300, -100, 100, 300, 600};

// Of the k-th of many alike: one of the extremes, where squares are no numbers, and one of the other sign.
std::vector<int> exponents_of(std::size_t k)
{
  if (tests_are_full) return exponents;
  const int sign = k % 2 == 0 ? -1 : 1;
  return {sign * 600, -sign * (k % 4 < 2 ? 300 : 100)};
}

std::string number(double x)
{
  char text[40];
  std::snprintf(text, sizeof text, " %.17g", x);
  return text;
}

// in quads or triangles, without one of its six sides if it is open
std::string box(bool is_triangles, bool is_open, int exponent)
{
  Part part = uneven_box(is_triangles, is_open);
  part.points = {{-1, -1.1, -0.9},  {1.2, -1, -1}, {1, 0.9, -1},     {-0.9, 1.05, -1.1},
                 {-1.15, -0.95, 1}, {1, -1.2, 1},  {1.05, 1.1, 0.9}, {-1, 0.8, 1.2}};
  for (Triple& p : part.points)
    for (double& x : p) x = std::ldexp(x, exponent);
  return part.off();
}

std::string circle(int exponent)
{
  std::string text;
  for (int i = 0; i < 9; ++i)
    text += number(std::ldexp(3 * std::cos(0.7 * i), exponent)) +
            number(std::ldexp(std::sin(0.7 * i) + 0.2 * (i % 2), exponent)) + "\n";
  return text;
}

struct Mode
{
  std::string scheme, options;
};

std::vector<Mode> modes()
{
  std::vector<Mode> result;
  for (const std::string scheme : {"catmull-clark", "loop", "doo-sabin", "sqrt3", "butterfly",
                                   "kobbelt", "modified-catmull-clark", "modified-loop",
                                   "ct-catmull-clark", "ct-loop", "midpoint", "bilinear"}) {
    const bool is_spline =
      scheme.find("loop") != std::string::npos || scheme.find("catmull") != std::string::npos;
    for (const char* const options : {"", "--linear", "--normals angle"})
      result.push_back({scheme, options});
    if (scheme != "doo-sabin")
      for (const char* const options :
           {"--limit", "--surface-normals", "--linear --limit --surface-normals"})
        result.push_back({scheme, options});
    if (!is_spline) continue;
    for (const char* const options :
         {"--sharp angle:60", "--sharp angle:60 --sharpness 0.5",
          "--sharp angle:60 --limit --surface-normals", "--border curve --limit --surface-normals"})
      result.push_back({scheme, options});
    if (scheme.rfind("ct-", 0) == 0) continue;
    for (const char* const options :
         {"--interpolate slide", "--interpolate points", "--interpolate points --normals angle"})
      result.push_back({scheme, options});
  }
  return result;
}

class Pn_subdivide_scale : public Command_test
{
protected:
  Mesh_data refined(const Mode& mode, bool is_open, int exponent)
  {
    const std::string input =
      folder.write("i.off", box(takes_triangles(mode.scheme), is_open, exponent));
    const std::string output = folder.file("o.ply");
    // the limits of one round are those of two
    const bool has_limits = mode.options.find("--limit") != std::string::npos;
    const std::string levels = has_limits && !tests_are_full ? "1" : "2";
    const Outcome outcome =
      done(surface(input, output,
                   "--quiet --levels " + levels + " --scheme " + mode.scheme + " " + mode.options));
    return outcome.code == 0 ? read_mesh(output) : Mesh_data();
  }
};

Triple scaled(const Triple& p, int exponent)
{
  return {std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent)};
}

} // namespace

TEST_F(Pn_subdivide_scale, SurfacesAreScaledBitForBit)
{
  std::size_t k = 0;
  for (const Mode& mode : modes())
    for (const bool is_open : {false, true}) {
      if (is_open && mode.options.find("--border") == std::string::npos && mode.options != "")
        continue;
      const Mesh_data one = refined(mode, is_open, 0);
      for (const int e : exponents_of(k++)) {
        const Mesh_data mesh = refined(mode, is_open, e);
        ASSERT_EQ(mesh.points.size(), one.points.size());
        std::vector<Triple> points;
        for (const Triple& p : one.points) points.push_back(scaled(p, e));
        EXPECT_TRUE(mesh.points == points) << mode.scheme << ' ' << mode.options << ' ' << e;
        EXPECT_TRUE(mesh.normals == one.normals) << mode.scheme << ' ' << mode.options << ' ' << e;
        EXPECT_TRUE(mesh.corner_normals == one.corner_normals)
          << mode.scheme << ' ' << mode.options;
      }
    }
}

TEST_F(Pn_subdivide_scale, CurvaturesAreScaledOrRefused)
{
  for (const std::string kind : {"gaussian", "mean"}) {
    const int dimension = kind == "mean" ? 1 : 2;
    const Mode mode{"catmull-clark", "--curvature " + kind};
    const auto values = [&](const Mesh_data& mesh) {
      return mesh.attributes.of_vertices.at(0).values;
    };
    std::vector<double> one = values(refined(mode, false, 0));
    for (const int e : {-400, -300, -100, 100, 300, 400}) {
      std::vector<double> expected;
      for (const double x : one) expected.push_back(std::ldexp(x, -dimension * e));
      EXPECT_TRUE(values(refined(mode, false, e)) == expected) << kind << e;
    }
    for (const int e : {-1000, -600, -500, 500, 600, 1000}) {
      const std::string input = folder.write("i.off", box(false, false, e));
      const std::string output = folder.file("none.ply");
      for (const char* part : {"--curvature: the mesh has a size of", "scale its coordinates"})
        expect_one_line(surface(input, output, "--levels 1 --quiet --curvature " + kind), 1, part);
      EXPECT_EQ(Temporary_folder::content(output), "");
    }
  }
}

TEST_F(Pn_subdivide_scale, CurvesAreScaledBitForBit)
{
  for (const std::string options :
       {"--scheme bspline:3", "--scheme bspline:3 --closed", "--scheme 4-point --closed",
        "--scheme chaikin", "--scheme bspline:3 --limit",
        "--scheme bspline:3 --closed --interpolate slide",
        "--scheme bspline:3 --interpolate points",
        "--scheme bspline:3 --linear --interpolate points"}) {
    const auto refined = [&](int e) {
      folder.write("i.txt", circle(e));
      done(curve("i.txt", "o.txt", "--quiet --levels 2 " + options));
      return rows_of(content("o.txt"));
    };
    const auto one = refined(0);
    EXPECT_GT(one.size(), 20u);
    for (const int e : exponents) {
      auto expected = one;
      for (auto& row : expected)
        for (std::size_t k = 0; k < 2 && k < row.size(); ++k) row[k] = std::ldexp(row[k], e);
      EXPECT_TRUE(refined(e) == expected) << options << ' ' << e;
    }
  }
}
