// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `pn_subdivide surface --limit --limit-tolerance --surface-normals`.

#include "Command_test.h"
#include "Part_files.h"

#include "io/mesh_io.h"

#include <cmath>

using namespace pn_subdivide;

namespace {

class Pn_subdivide_limit : public Command_test
{
protected:
  Mesh_data mesh(const std::string& file) const { return read_mesh(folder.file(file)); }
};

TEST_F(Pn_subdivide_limit, IsTheSameAtEveryLevel)
{
  for (const char* scheme : {"catmull-clark", "modified-catmull-clark", "kobbelt"}) {
    const std::string options = std::string(" --limit --surface-normals --scheme ") + scheme;
    done(surface(data("paper/torus_8.ply"), "0.ply", "--levels 0" + options));
    const Outcome outcome = surface(data("paper/torus_8.ply"), "2.ply", "--levels 2" + options);
    ASSERT_EQ(outcome.code, 0);
    expect_part(outcome.err, "limit points: estimated error");
    expect_part(outcome.err, "surface normals: estimated error");
    const Mesh_data coarse = mesh("0.ply"), fine = mesh("2.ply");
    for (std::size_t v = 0; v < coarse.points.size(); ++v) {
      EXPECT_LE(distance(coarse.points[v], fine.points[v]), 1e-7)
        << scheme; // the torus has a size of 6
      EXPECT_LE(distance(coarse.normals[v], fine.normals[v]), 3e-3) << scheme;
    }
  }
}

// Of the three, points move, normals change, or both.
TEST_F(Pn_subdivide_limit, EachOptionDoesItsOwn)
{
  const std::string control = data("saddle_5.ply");
  const std::string options = " --scheme loop --triangulate --levels 2 ";
  done(surface(control, "plain.ply", options));
  done(surface(control, "limit.ply", options + "--limit --output-normals control"));
  done(surface(control, "normals.ply", options + "--surface-normals"));
  done(surface(control, "both.ply", options + "--limit --surface-normals"));
  const Mesh_data plain = mesh("plain.ply"), limit = mesh("limit.ply"),
                  normals = mesh("normals.ply"), both = mesh("both.ply");
  EXPECT_EQ(plain.points, normals.points);
  EXPECT_EQ(limit.points, both.points);
  double moved = 0, turned = 0;
  for (std::size_t v = 0; v < plain.points.size(); ++v) {
    // what is asked for by default
    EXPECT_LE(distance(normals.normals[v], both.normals[v]), 1e-3);
    moved = std::max(moved, distance(plain.points[v], limit.points[v]));
    turned = std::max(turned, distance(limit.normals[v], both.normals[v]));
  }
  EXPECT_GT(moved, 1e-4);
  EXPECT_GT(turned, 1e-4);
}

TEST_F(Pn_subdivide_limit, LinearSurfacesHaveNormals)
{
  done(surface(data("cube.off"), "cube.ply",
               "--linear --limit --surface-normals --scheme catmull-clark --levels 1"));
  // outward, by symmetry along the point at the corners
  const Mesh_data cube = mesh("cube.ply");
  for (std::size_t v = 0; v < cube.points.size(); ++v) {
    const Triple& p = cube.points[v];
    EXPECT_GT(dot(unit(p), cube.normals.at(v)), 0.9);
  }
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
