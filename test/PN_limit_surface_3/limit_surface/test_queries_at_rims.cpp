// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Queries at creases of a part whose surface is known; derivatives, rays and closest points of all schemes in all kinds of faces.

#include "Crease_shapes.h"
#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "Surface_checks.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_limit_surface_3/Limit_surface_queries.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_by_name.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Queries = PN::Limit_surface_queries<Surface_mesh, Kernel>;

using surface_checks::length;

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

// \name All schemes, in all kinds of faces, at borders and creases

using Surface = PN::Limit_surface<Surface_mesh, Kernel>;
using test_meshes::Cells;
using test_meshes::Control_mesh;

// so many sides of the first face are sharp
struct Sharp
{
  int edges;
};

void expect_surface(const std::string& scheme, Control_mesh shape, Sharp sharp, double roundness,
                    double tolerance, const surface_checks::Derivative_bounds& bounds)
{
  SCOPED_TRACE(scheme + ", " + shape.name + ", " + std::to_string(sharp.edges) +
               " sharp edges, roundness " + std::to_string(roundness) + ", tolerance " +
               std::to_string(-std::log10(tolerance)) + " digits");
  test_meshes::set_uneven_normals(shape, 5);
  Surface_mesh mesh = to_surface_mesh(shape);
  const auto is_sharp =
    mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  auto h = mesh.halfedge(Surface_mesh::Face_index(0));
  for (int i = 0; i < sharp.edges; ++i, h = mesh.next(h)) is_sharp[mesh.edge(h)] = true;
  const Surface surface(mesh, PN::any_scheme(scheme),
                        PN::parameters::roundness(roundness)
                          .tolerance(tolerance)
                          .vertex_normal_map(normal_map(mesh))
                          .edge_is_constrained_map(is_sharp));
  surface_checks::expect_derivatives(
    surface, [&](Surface_mesh::Face_index f) { return mesh.degree(f); }, bounds);
  const surface_checks::Fine_triangles fine(surface, 4);
  const Queries queries(surface, 2);
  surface_checks::expect_rays(surface, queries, fine, 4);
  surface_checks::expect_closest_points(surface, queries, fine, 2);
}

// the linear surfaces
TEST(LimitSurfaceQueries, SplinesOfAllSchemes)
{
  const surface_checks::Derivative_bounds bounds{2, 1e-4, 1e-2};
  for (const std::string scheme : {"catmull-clark", "modified-catmull-clark", "ct-catmull-clark",
                                   "loop", "modified-loop", "ct-loop"}) {
    const bool is_loop = scheme.find("loop") != std::string::npos;
    const Control_mesh other = is_loop ? test_meshes::bipyramid(7) : named_shapes::prism(5),
                       open = is_loop ? test_meshes::star(5, 1, Cells::triangles)
                                      : test_meshes::single_polygon(6);
    for (const int edges : {0, 3})
      expect_surface(scheme, named_shapes::tetrahedron(), {edges}, 0, 1e-12, bounds);
    expect_surface(scheme, other, {2}, 0, 1e-7, bounds);
    expect_surface(scheme, open, {0}, 0, 1e-9, bounds);
  }
}

// On creases and borders second derivatives across are not those of the limit.
TEST(LimitSurfaceQueries, RoundSurfaces)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::string scheme : {"catmull-clark", "loop"}) {
    expect_surface(scheme, named_shapes::tetrahedron(), {0}, 1, 1e-9, {2, 1e-3, 5e-2});
    expect_surface(scheme, named_shapes::tetrahedron(), {3}, 1, 1e-7, {2, 5e-3, infinity});
  }
}

// between the limits of a level that is fine enough there are patches
TEST(LimitSurfaceQueries, PatchesOfAllSchemes)
{
  for (const std::string scheme : {"kobbelt", "butterfly"})
    expect_surface(scheme, scheme == "kobbelt" ? named_shapes::cube() : named_shapes::tetrahedron(),
                   {0}, 1, 1e-7, {1, 0.02, 0});
}

} // namespace
