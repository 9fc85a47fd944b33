// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Queries at creases of a part whose surface is known.

#include "Crease_shapes.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_subdivision_3/Limit_surface_queries.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using Queries = PN::Limit_surface_queries<Surface_mesh, Kernel>;

double length(const Vector& v)
{
  return std::sqrt(v.squared_length());
}

void expect_point(const Queries::Hit& hit, const Point& expected, double distance)
{
  EXPECT_LE(length(hit.point - expected), 2e-5) << hit.point << " not " << expected;
  EXPECT_NEAR(hit.distance, distance, 2e-5);
}

// A closed cylinder of radius 1 between z = 0 and z = 2, whose rims are sharp.
TEST(LimitSurfaceQueries, RimsOfACylinder)
{
  const auto data = crease_shapes::capped_cylinder(crease_shapes::uneven(7)).control();
  tagged_meshes::Tagged<Surface_mesh> control(data);
  const PN::Limit_surface surface(control.mesh, PN::CatmullClark_scheme(),
                                  PN::parameters::border(data.border)
                                    .tolerance(2e-6)
                                    .vertex_normal_map(control.normals)
                                    .edge_is_constrained_map(control.sharp)
                                    .vertex_is_constrained_map(control.corners));
  const Queries queries(surface);
  for (int i = 0; i < 2; ++i) {
    const double angle = 0.2 + 2.9 * i, x = std::cos(angle), y = std::sin(angle);
    const auto at = [&](double r, double z) { return Point(r * x, r * y, z); };
    expect_point(queries.closest_point(at(1.3, 2.4)), at(1, 2), 0.5); // of the rims
    expect_point(queries.closest_point(at(1.05, -0.12)), at(1, 0), 0.13);
    expect_point(queries.closest_point(at(1.5, 1.99)), at(1, 1.99), 0.5); // beside them
    expect_point(queries.closest_point(at(0.98, 2.5)), at(0.98, 2), 0.5);
    const auto on_side = queries.first_intersection(at(3, 1.98), Vector(-x, -y, 0));
    ASSERT_TRUE(on_side);
    expect_point(*on_side, at(1, 1.98), 2);
    EXPECT_LE(length(on_side->normal - Vector(x, y, 0)), 1e-3);
    const auto on_top = queries.first_intersection(at(0.98, 4), Vector(0, 0, -1));
    ASSERT_TRUE(on_top);
    expect_point(*on_top, at(0.98, 2), 2);
    EXPECT_FALSE(queries.first_intersection(at(1.02, 4), Vector(0, 0, -1)));
  }
}

} // namespace
