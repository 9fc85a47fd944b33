// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// `pn_subdivide surface --scheme grid-catmull-clark`: tori stay tori, and what the scheme has no rules for is refused by name.

#include "Command_test.h"

#include <cmath>

namespace {

class Grid : public Command_test
{
protected:
  Outcome refine(const std::string& input, const std::string& options) const
  {
    return run("surface '" + std::string(PN_DATA_DIR) + "/" + input + "' '" +
               folder.file("fine.off") + "' --levels 2 --scheme grid-catmull-clark " + options);
  }
  // the largest distance from the torus of torus_quads.ply
  double distance() const
  {
    std::istringstream file(content("fine.off"));
    std::string off;
    std::size_t vertices = 0, faces = 0, edges = 0;
    file >> off >> vertices >> faces >> edges;
    EXPECT_EQ(faces, 16u * 180);
    double largest = 0, x = 0, y = 0, z = 0;
    for (std::size_t i = 0; i < vertices && file >> x >> y >> z; ++i)
      largest = (std::max)(largest, std::abs(std::hypot(std::hypot(x, y) - 2, z) - .75));
    EXPECT_TRUE(file.good());
    return largest;
  }
};

TEST_F(Grid, KeepsATorus)
{
  done(refine("torus_quads.ply", "--output-normals none"));
  EXPECT_LT(distance(), 1e-13);
  done(refine("torus_quads.ply", "--output-normals none --linear"));
  EXPECT_GT(distance(), 1e-2);
  done(refine("torus_quads.ply", "--output-normals none --roundness 0.5"));
  EXPECT_GT(distance(), 1e-2);
}

TEST_F(Grid, IsRefusedByNameWhereItHasNoRules)
{
  for (const std::string option :
       {"--limit", "--surface-normals", "--interpolate slide", "--check", "--pieces 2",
        "--sharp angle:40", "--border curve", "--normal-scheme catmull-clark"}) {
    SCOPED_TRACE(option);
    expect_one_line(refine("torus_quads.ply", option), 2, "grid-catmull-clark");
    EXPECT_EQ(folder.number_of_files(), 0u);
  }
  expect_one_line(refine("sphere_triangles.ply", ""), 1, "quadrilaterals only");
  expect_one_line(run("surface a.ply b.ply --scheme loop --normal-scheme grid-catmull-clark"), 2,
                  "grid-catmull-clark");
}

} // namespace
