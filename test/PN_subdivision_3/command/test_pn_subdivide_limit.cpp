// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `pn_subdivide surface --limit --limit-tolerance --surface-normals`.

#include "Command_test.h"

#include <array>
#include <cmath>

namespace {

using Row = std::array<double, 6>; // a point and a normal

class Pn_subdivide_limit : public Command_test
{
protected:
  // the vertices of a text PLY with normals
  std::vector<Row> vertices(const std::string& file) const
  {
    const Values_by_name columns = columns_of(file);
    EXPECT_EQ(columns.size(), 6u) << file;
    std::vector<Row> rows(columns.at("x").size());
    for (std::size_t v = 0; v < rows.size(); ++v)
      for (std::size_t c = 0; c < 6; ++c)
        rows[v][c] =
          columns.at(c < 3 ? std::string(1, "xyz"[c]) : std::string("n") + "xyz"[c - 3])[v];
    return rows;
  }

  static double distance(const Row& a, const Row& b, std::size_t first)
  {
    return std::hypot(a[first] - b[first], a[first + 1] - b[first + 1],
                      a[first + 2] - b[first + 2]);
  }
};

TEST_F(Pn_subdivide_limit, IsTheSameAtEveryLevel)
{
  for (const char* scheme : {"catmull-clark", "modified-catmull-clark", "kobbelt"}) {
    const std::string options =
      std::string(" --ascii --limit --surface-normals --scheme ") + scheme;
    done(surface(data("paper/torus_8.ply"), "0.ply", "--levels 0" + options));
    const Outcome outcome = surface(data("paper/torus_8.ply"), "2.ply", "--levels 2" + options);
    ASSERT_EQ(outcome.code, 0);
    expect_part(outcome.err, "limit points: estimated error");
    expect_part(outcome.err, "surface normals: estimated error");
    const auto coarse = vertices("0.ply"), fine = vertices("2.ply");
    for (std::size_t v = 0; v < coarse.size(); ++v) {
      EXPECT_LE(distance(coarse[v], fine[v], 0), 1e-7) << scheme; // the torus has a size of 6
      EXPECT_LE(distance(coarse[v], fine[v], 3), 3e-3) << scheme;
    }
  }
}

// Of the three, points move, normals change, or both.
TEST_F(Pn_subdivide_limit, EachOptionDoesItsOwn)
{
  const std::string control = data("saddle_5.ply");
  const std::string options = " --ascii --scheme loop --triangulate --levels 2 ";
  done(surface(control, "plain.ply", options));
  done(surface(control, "limit.ply", options + "--limit --output-normals control"));
  done(surface(control, "normals.ply", options + "--surface-normals"));
  done(surface(control, "both.ply", options + "--limit --surface-normals"));
  const auto plain = vertices("plain.ply"), limit = vertices("limit.ply"),
             normals = vertices("normals.ply"), both = vertices("both.ply");
  double moved = 0, turned = 0;
  for (std::size_t v = 0; v < plain.size(); ++v) {
    EXPECT_EQ(distance(plain[v], normals[v], 0), 0);
    EXPECT_EQ(distance(limit[v], both[v], 0), 0);
    EXPECT_LE(distance(normals[v], both[v], 3), 1e-3); // what is asked for by default
    moved = std::max(moved, distance(plain[v], limit[v], 0));
    turned = std::max(turned, distance(limit[v], both[v], 3));
  }
  EXPECT_GT(moved, 1e-4);
  EXPECT_GT(turned, 1e-4);
}

TEST_F(Pn_subdivide_limit, LinearSurfacesHaveNormals)
{
  done(surface(data("cube.off"), "cube.ply",
               "--ascii --linear --limit --surface-normals --scheme catmull-clark --levels 1"));
  // outward, by symmetry along the point at the corners
  for (const Row& r : vertices("cube.ply")) {
    const double p = std::hypot(r[0], r[1], r[2]);
    EXPECT_GT((r[0] * r[3] + r[1] * r[4] + r[2] * r[5]) / p, 0.9);
  }
}

TEST_F(Pn_subdivide_limit, StaysOnTheSphere)
{
  done(
    surface(data("sphere_mixed.ply"), "sphere.ply",
            "--levels 2 --limit --scheme catmull-clark --verify sphere:0,0,0,1 --tolerance 1e-14"));
}

TEST_F(Pn_subdivide_limit, SaysWhereTheToleranceIsMissed)
{
  const Outcome outcome =
    done(surface(data("saddle_5.ply"), "out.ply",
                 "--levels 1 --scheme catmull-clark --limit --limit-tolerance "
                 "1e-300 --quiet"));
  EXPECT_EQ(outcome.err.rfind("warning: ", 0), 0u) << outcome.err;
  expect_part(outcome.err, "tolerance");
}

TEST_F(Pn_subdivide_limit, RefusesWhatDoesNotGoTogether)
{
  const std::string in = data("cube.off");
  expect_one_line(surface(in, "x.ply", "--scheme doo-sabin --limit"), 2,
                  "the limit points of doo-sabin belong to the faces");
  expect_one_line(surface(in, "x.ply", "--scheme doo-sabin --surface-normals"), 2, "doo-sabin");
  expect_one_line(surface(in, "x.ply", "--limit-tolerance 1e-6"), 2, "--limit");
  expect_one_line(surface(in, "x.ply", "--limit --limit-tolerance 0"), 2, "--limit-tolerance");
  expect_one_line(surface(in, "x.ply", "--limit --limit-tolerance nan"), 2, "--limit-tolerance");
  expect_one_line(surface(in, "x.ply", "--levels 0 --scheme loop --limit"), 1, "loop");
  EXPECT_FALSE(std::ifstream(folder.file("x.ply")).good());
}

} // namespace
