// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The upsampling schemes against CGAL's linear mask, and against closed forms: straight edges stay straight, arcs of great
// circles are halved.

#include "Messages.h"
#include "Scheme_runs.h"
#include "Schemes.h"
#include "support/Options.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/subdivision_methods_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

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

// CGAL's Linear_mask_3 sets no border vertices
TYPED_TEST(Upsampling, IsCgalsLinearMaskOnClosedMeshes)
{
  std::size_t tried = 0;
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    if (!test_meshes::is_closed(control) || test_meshes::has_isolated_vertex(control)) continue;
    Surface_mesh ours = to_surface_mesh(control), cgal = ours;
    for (auto v : ours.vertices()) normal_map(ours)[v] = normal_map(cgal)[v] = CGAL::NULL_VECTOR;
    refine_linearly<TypeParam>(ours, 1);
    const CGAL::Linear_mask_3<Surface_mesh> mask(&cgal, get(CGAL::vertex_point, cgal));
    if (TypeParam::degree == 3)
      CGAL::Subdivision_method_3::PTQ(cgal, mask, np::number_of_iterations(1));
    else
      CGAL::Subdivision_method_3::PQQ(cgal, mask, np::number_of_iterations(1));
    EXPECT_TRUE(is_within(difference(result_of(ours), result_of(cgal)), 1e-14)) << control.name;
    ASSERT_EQ(ours.number_of_vertices(), cgal.number_of_vertices());
    for (auto v : ours.vertices())
      EXPECT_LE(CGAL::squared_distance(ours.point(v), cgal.point(v)), 1e-28) << control.name;
    ++tried;
  }
  EXPECT_GE(tried, 5u);
}

// A round keeps every old vertex, and every new one is the exact mean of what it lies between; areas and volumes of
// triangles are what they were, exactly.
TYPED_TEST(Upsampling, LeavesTheGeometryAloneExactly)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Exact::Point_3>;
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    if (control.points.size() > 40 || !test_meshes::is_closed(control)) continue;
    if (!test_meshes::all_faces_have_degree(control, 3)) continue;
    Mesh mesh;
    for (const auto& p : control.points) mesh.add_vertex(Exact::Point_3(p[0], p[1], p[2]));
    for (const reference::Face& f : control.faces)
      mesh.add_face(Mesh::Vertex_index(unsigned(f[0])), Mesh::Vertex_index(unsigned(f[1])),
                    Mesh::Vertex_index(unsigned(f[2])));
    const Exact::FT volume = CGAL::Polygon_mesh_processing::volume(mesh);
    PN::subdivide(mesh, PN::linear(TypeParam::scheme()), np::number_of_iterations(2));
    if (TypeParam::degree == 3) {
      EXPECT_EQ(CGAL::Polygon_mesh_processing::volume(mesh), volume) << control.name;
    }
    Exact::FT fans(0); // planar quads have that of their fans
    for (auto f : mesh.faces()) {
      const auto h = mesh.halfedge(f);
      const Exact::Point_3& a = mesh.point(mesh.target(h));
      for (auto g = mesh.next(h); mesh.next(g) != h; g = mesh.next(g))
        fans += CGAL::volume(Exact::Point_3(0, 0, 0), a, mesh.point(mesh.target(g)),
                             mesh.point(mesh.target(mesh.next(g))));
    }
    EXPECT_EQ(fans, volume) << control.name;
  }
}

// With the normals of the sphere, k rounds put 2^k - 1 points on every edge, at equal angles on the great circle.
TYPED_TEST(Upsampling, CutsArcsOfCirclesIntoEqualParts)
{
  constexpr unsigned rounds = 3, parts = 1u << rounds;
  std::size_t edges = 0;
  for (Control_mesh control : meshes_for<TypeParam>()) {
    if (control.points.size() > 60) continue;
    bool is_cut = false; // a vertex at the center
    for (std::size_t i = 0; i < control.points.size(); ++i) {
      auto& p = control.points[i];
      const double length = std::hypot(p[0], p[1], p[2]);
      is_cut = is_cut || length < 1e-3;
      for (double& x : p) x /= length;
      control.normals[i] = p;
    }
    if (is_cut) continue;
    const Surface_mesh old = to_surface_mesh(control);
    Surface_mesh mesh = old;
    refine<TypeParam>(mesh, rounds);
    std::set<std::array<long long, 3>> found;
    const auto key = [](const Kernel::Vector_3& p) {
      return std::array<long long, 3>{std::llround(p.x() * 1e9), std::llround(p.y() * 1e9),
                                      std::llround(p.z() * 1e9)};
    };
    for (auto v : mesh.vertices()) found.insert(key(mesh.point(v) - CGAL::ORIGIN));
    const auto is_found = [&](const Kernel::Vector_3& p) {
      const auto k = key(p); // rounded one way or the other
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z)
            if (found.count({k[0] + x, k[1] + y, k[2] + z}) != 0) return true;
      return false;
    };
    for (auto e : old.edges()) {
      const Kernel::Vector_3 a = old.point(old.vertex(e, 0)) - CGAL::ORIGIN,
                             b = old.point(old.vertex(e, 1)) - CGAL::ORIGIN;
      const double angle = std::acos((std::max)(-1., (std::min)(1., a * b)));
      if (angle < 1e-3 || angle > 2.2) continue; // beyond 135 degrees normals fade
      for (unsigned j = 0; j <= parts; ++j) {
        const double t = double(j) / parts;
        const Kernel::Vector_3 on_arc =
          (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
        EXPECT_TRUE(is_found(on_arc)) << control.name << ", edge " << e << ", part " << j;
      }
      ++edges;
    }
  }
  EXPECT_GE(edges, 100u);
}

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
