// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The upsampling schemes: their limits, their functions, and what there is nothing of.

#include "Messages.h"
#include "Scheme_runs.h"
#include "Schemes.h"
#include "support/Options.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/subdivision_methods_3.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;
using test_meshes::Control_mesh;
using Vertex = Surface_mesh::Vertex_index;

template <class Description>
class Upsampling : public testing::Test
{};
using Upsampling_schemes = testing::Types<Midpoint_description, Bilinear_description>;
TYPED_TEST_SUITE(Upsampling, Upsampling_schemes, Scheme_names);

// Vertices are their limits; surface normals there are none, and the control normals stand in.
TYPED_TEST(Upsampling, HasItsVerticesAsLimits)
{
  test_options::Limit_options options;
  options.surface_normals = options.curvatures = true;
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    Surface_mesh mesh = to_surface_mesh(control);
    const Surface_mesh old = mesh;
    const Normal_map normals = normal_map(mesh);
    std::map<Vertex, PN::Limit_point<Kernel>> limits;
    const auto report =
      PN::limit_points(mesh, TypeParam::scheme(), boost::make_assoc_property_map(limits),
                       PN::parameters::join(options.pack(), np::vertex_normal_map(normals)));
    EXPECT_EQ(report.error, 0);
    EXPECT_EQ(report.depth, 0u);
    EXPECT_EQ(report.number_of_stand_ins, mesh.number_of_vertices());
    for (auto v : mesh.vertices()) {
      const auto& l = limits[v];
      EXPECT_EQ(l.point, mesh.point(v));
      EXPECT_EQ(l.surface_normal, l.control_normal);
      EXPECT_FALSE(l.has_surface_normal || l.has_curvature);
    }
    PN::subdivide_to_limit(mesh, TypeParam::scheme(),
                           np::vertex_normal_map(normals).number_of_iterations(0));
    for (auto v : mesh.vertices()) EXPECT_EQ(mesh.point(v), old.point(v));
    Surface_mesh refined = old, to_limit = old;
    refine<TypeParam>(refined, 2);
    PN::subdivide_to_limit(to_limit, TypeParam::scheme(),
                           np::number_of_iterations(2).vertex_normal_map(normal_map(to_limit)));
    EXPECT_TRUE(is_identical(refined, to_limit)) << control.name;
  }
}

TYPED_TEST(Upsampling, LeavesNothingToInterpolate)
{
  const std::string name = TypeParam::scheme().name();
  Surface_mesh mesh = to_surface_mesh(meshes_for<TypeParam>().front()), old = mesh;
  messages::expect_refused(
    [&] {
      PN::interpolate_limit_points(mesh, TypeParam::scheme(),
                                   np::vertex_normal_map(normal_map(mesh)));
    },
    {"surfaces of the scheme " + name});
  EXPECT_TRUE(is_identical(mesh, old));
}

// the functions are these schemes
TEST(Upsampling_functions, AreTheSchemes)
{
  Control_mesh control = meshes_for<Midpoint_description>().front();
  for (bool triangles : {true, false}) {
    Surface_mesh a = to_surface_mesh(control), b = a;
    const auto two = [](Surface_mesh& mesh) {
      return np::number_of_iterations(2).vertex_normal_map(normal_map(mesh));
    };
    if (triangles) {
      PN::Midpoint_subdivision(a, two(a));
      refine<Midpoint_description>(b, 2);
    } else {
      PN::Bilinear_subdivision(a, two(a));
      refine<Bilinear_description>(b, 2);
    }
    EXPECT_TRUE(is_identical(a, b));
  }
}

} // namespace
