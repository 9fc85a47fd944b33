// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Tessellations of parts with creases and borders, whose surfaces are known.

#include "Crease_shapes.h"
#include "Tagged_meshes.h"
#include "Tessellation_cases.h"

#include <CGAL/PN_subdivision_3/tessellate.h>
#include <CGAL/Surface_mesh.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using namespace tessellation_cases;
using crease_shapes::Part;
using Mesh = CGAL::Surface_mesh<Point>;

void expect_part(const std::string& name, Part part, double eps)
{
  SCOPED_TRACE(name);
  part.place();
  const auto data = part.control();
  tagged_meshes::Tagged<Mesh> control(data);
  Mesh out;
  const auto result = PN::tessellate(
    control.mesh, PN::internal::with_border(PN::CatmullClark_scheme(), data.border), eps, out,
    params::vertex_normal_map(control.normals)
      .edge_is_constrained_map(control.sharp)
      .vertex_is_constrained_map(control.corners));
  EXPECT_TRUE(result.reached);
  EXPECT_LE(result.bound, eps);
  expect_conforming(out, control.mesh);
  double error = 0;
  for_each_sample(triangles(out), [&](const Point& p) {
    crease_shapes::Real least = crease_shapes::infinity;
    for (const auto& surface : part.surfaces)
      least = (std::min)(least, surface.distance({p.x(), p.y(), p.z()}));
    error = (std::max)(error, double(least));
  });
  EXPECT_LE(error, eps);
  for (auto e : out.edges()) {
    if (!out.is_border(e)) continue;
    for (const double t : {0., 0.3, 0.5}) {
      const Point p = CGAL::ORIGIN + (out.point(out.vertex(e, 0)) - CGAL::ORIGIN) * t +
                      (out.point(out.vertex(e, 1)) - CGAL::ORIGIN) * (1 - t);
      crease_shapes::Real least = crease_shapes::infinity;
      for (const auto& surface : part.of_border)
        least = (std::min)(least, surface.distance({p.x(), p.y(), p.z()}));
      EXPECT_LE(double(least), eps);
    }
  }
}

TEST(Tessellate, Parts)
{
  for (const double eps : {0.05, 0.01}) {
    expect_part("capped cylinder", crease_shapes::capped_cylinder(crease_shapes::uneven(7)), eps);
    expect_part("half ball", crease_shapes::half_ball(), eps);
    expect_part("lens", crease_shapes::lens(), eps);
    expect_part("washer", crease_shapes::washer(), eps);
    expect_part("D-section", crease_shapes::d_section(), eps);
    expect_part("rounded box", crease_shapes::rounded_box(), eps);
  }
}
TEST(Tessellate, PartsWithBorders)
{
  for (const double eps : {0.05, 0.01}) {
    expect_part("plate with hole", crease_shapes::plate_with_hole(), eps);
    expect_part("ball cap", crease_shapes::ball_cap(), eps);
    expect_part("octant", crease_shapes::octant(), eps);
  }
}
// as a rim, not as an area
void expect_growth_of_rim(Part part)
{
  part.place();
  const auto data = part.control();
  tagged_meshes::Tagged<Mesh> control(data);
  std::vector<std::size_t> numbers;
  for (const double eps : {0.01, 0.0025, 0.000625}) {
    Mesh out;
    PN::tessellate(control.mesh, PN::internal::with_border(PN::CatmullClark_scheme(), data.border),
                   eps, out,
                   params::vertex_normal_map(control.normals)
                     .edge_is_constrained_map(control.sharp)
                     .vertex_is_constrained_map(control.corners));
    expect_conforming(out, control.mesh);
    numbers.push_back(out.number_of_faces());
  }
  EXPECT_LE(double(numbers[2] - numbers[1]), 2.6 * double(numbers[1] - numbers[0]));
}
TEST(Tessellate, PlanesStayCoarse)
{
  expect_growth_of_rim(crease_shapes::plate_with_hole());
}
TEST(Tessellate, RulingsStayUndivided)
{
  expect_growth_of_rim(crease_shapes::capped_cylinder(crease_shapes::uneven(7)));
}

} // namespace
