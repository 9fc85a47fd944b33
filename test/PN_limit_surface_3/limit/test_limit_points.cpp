// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limit points of all primal schemes against brute force, on shapes, and between levels.

#include "Limit_cases.h"
#include "Mesh_files.h"
#include "Schemes.h"
#include "support/Options.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>

namespace {

using namespace limit_cases;
using reference::Real;
using reference::Vector;
using test_meshes::Cells;
using test_meshes::Control_mesh;

using Primal_schemes =
  testing::Types<CatmullClark_description, Loop_description, Sqrt3_description,
                 Butterfly_description, Kobbelt_description, Modified_CatmullClark_description,
                 Modified_Loop_description, Ct_CatmullClark_description, Ct_Loop_description>;

template <class Description>
class Limit_points : public testing::Test
{};
TYPED_TEST_SUITE(Limit_points, Primal_schemes, Scheme_names);

// few vertices of each kind, in a few meshes: brute force takes its time
template <class Description>
std::vector<Control_mesh> small_meshes()
{
  std::vector<Control_mesh> meshes;
  if (Description::degree == 3) {
    meshes = {test_meshes::with_centers(test_meshes::bipyramid(5), 3),
              test_meshes::part_of(test_meshes::grid(5, 4, false, false, Cells::triangles), 3)};
  } else {
    meshes = {test_meshes::in_quads(test_meshes::bipyramid(3)),
              test_meshes::part_of(test_meshes::grid(5, 4, false, false, Cells::quads), 2)};
    if (Description::degree == 0) meshes.push_back(test_meshes::house(5));
  }
  unsigned seed = 1;
  for (Control_mesh& mesh : meshes) test_meshes::set_uneven_normals(mesh, seed++);
  return meshes;
}

// one vertex of every kind: on the border or not, of each valence
inline std::vector<int> various_vertices(const Control_mesh& control)
{
  const reference::Face_list list = test_meshes::face_list(control);
  std::map<std::pair<bool, std::size_t>, int> kinds;
  for (int v = 0; v < list.number_of_vertices(); ++v)
    if (!list.ring(v).empty()) kinds[{list.is_border(v), list.ring(v).size()}] = v;
  std::vector<int> vertices;
  for (const auto& [kind, v] : kinds) vertices.push_back(v);
  return vertices;
}

TYPED_TEST(Limit_points, EqualBruteForce)
{
  for (const Control_mesh& control : small_meshes<TypeParam>()) {
    Surface_mesh mesh = to_surface_mesh(control);
    const Limits all = limits(mesh, TypeParam::scheme(), close(1e-13, 1e-7));
    EXPECT_LE(all.report.error, 1e-11);
    for (const int v : various_vertices(control)) {
      const Limit& l = all.at[std::size_t(v)];
      const reference::Limit expected = brute_force<TypeParam>(control, v, false);
      EXPECT_LE(double((to_vector(l.point) - expected.point).norm()), 2e-11)
        << control.name << ", vertex " << v;
      EXPECT_LE(double((to_vector(l.control_normal) - expected.control_normal).norm()), 2e-11)
        << control.name << ", vertex " << v;
      if (l.has_surface_normal) {
        EXPECT_LE(double((to_vector(l.surface_normal) - expected.surface_normal).norm()),
                  1e-5 + 2 * double(expected.normal_change))
          << control.name << ", vertex " << v;
      }
    }
  }
}

TYPED_TEST(Limit_points, LinearTwinEqualsBruteForceAtOnce)
{
  Control_mesh control = small_meshes<TypeParam>()[1];
  Surface_mesh mesh = to_surface_mesh(control);
  const Limits all = limits(mesh, PN::linear(TypeParam::scheme()), close(1e-13));
  EXPECT_EQ(all.report.error, 0);
  for (const int v : various_vertices(control)) {
    const Limit& l = all.at[std::size_t(v)];
    const reference::Limit expected = brute_force<TypeParam>(control, v, true);
    EXPECT_LE(double((to_vector(l.point) - expected.point).norm()), 2e-12) << "vertex " << v;
    EXPECT_EQ(l.control_normal, CGAL::NULL_VECTOR);
    if (l.has_surface_normal) {
      EXPECT_LE(double((to_vector(l.surface_normal) - expected.surface_normal).norm()),
                1e-5 + 2 * double(expected.normal_change))
        << "vertex " << v;
    }
  }
}

// 1, or -1 where the faces around a vertex turn their backs to its control normal.
Real side_of_faces(const Surface_mesh& mesh, const Limits& all, std::size_t v)
{
  const auto point = [&](Surface_mesh::Vertex_index w) { return all.at[std::size_t(w)].point; };
  const Kernel::Point_3 center = all.at[v].point;
  Kernel::Vector_3 area(0, 0, 0);
  for (const auto h :
       halfedges_around_target(mesh.halfedge(Surface_mesh::Vertex_index(unsigned(v))), mesh))
    if (!mesh.is_border(h))
      area = area + CGAL::cross_product(point(mesh.target(mesh.next(h))) - center,
                                        point(mesh.source(h)) - center);
  return area * all.at[v].control_normal < 0 ? -1 : 1;
}

// On a sphere and a cylinder all is exact up to rounding: at every vertex, on borders too.
TYPED_TEST(Limit_points, StayOnSpheresAndCylindersWithTheirNormals)
{
  for (Control_mesh control : meshes_for<TypeParam>()) {
    if (test_meshes::has_isolated_vertex(control)) continue;
    for (const bool sphere : {true, false}) {
      for (std::size_t i = 0; i < control.points.size(); ++i) {
        // the suite's meshes lie around the origin, or are moved there
        test_meshes::Triple p = control.points[i];
        const test_meshes::Triple n =
          test_meshes::unit({p[0] - 0.3, p[1] + 0.2, sphere ? p[2] + 2.5 : 0});
        control.normals[i] = n;
        control.points[i] = {3 * n[0], 3 * n[1], sphere ? 3 * n[2] : p[2]};
      }
      Surface_mesh mesh = to_surface_mesh(control);
      const Limits all = limits(mesh, TypeParam::scheme(), close(1e-14));
      for (std::size_t v = 0; v < all.at.size(); ++v) {
        const Limit& l = all.at[v];
        if (l.control_normal == CGAL::NULL_VECTOR) continue; // opposite ones meet
        const Vector p = to_vector(l.point);
        const Vector radial = sphere ? p : Vector(p[0], p[1], 0);
        EXPECT_NEAR(double(radial.norm()), 3, 3 * 8 * 2.3e-16 * 3) << control.name << " " << v;
        EXPECT_LE(double((to_vector(l.control_normal) - radial / 3).norm()), 4e-15)
          << control.name << " " << v;
        if (!l.has_surface_normal) continue;
        // some of the suite's meshes fold when they are moved to the sphere
        EXPECT_LE(
          double((to_vector(l.surface_normal) - side_of_faces(mesh, all, v) * radial / 3).norm()),
          1e-9)
          << control.name << " " << v;
      }
    }
  }
}

// The vertices of the mesh keep their limits in the rounds of a call.
TYPED_TEST(Limit_points, AreTheSameAtEveryLevel)
{
  for (const std::string& file : mesh_files::in_folder(PN_DATA_DIR)) {
    Surface_mesh mesh = mesh_files::read(file);
    if (!mesh_files::takes<TypeParam>(mesh) || mesh.number_of_vertices() > 400) continue;
    if (!mesh_files::has_normals(mesh)) PN::estimate_control_normals(mesh, normal_map(mesh));
    test_options::Limit_options options;
    const Limits base = limits(mesh, TypeParam::scheme(), options);
    EXPECT_TRUE(base.report.is_within_tolerance()) << file;
    options.rounds_done = 3;
    refine<TypeParam>(mesh, options.rounds_done);
    const Limits fine = limits(mesh, TypeParam::scheme(), options);
    EXPECT_TRUE(fine.report.is_within_tolerance()) << file;
    const double box = base.report.tolerance / options.tolerance;
    double largest = 0;
    for (std::size_t v = 0; v < base.at.size(); ++v)
      largest = (std::max)(
        largest, std::sqrt(CGAL::squared_distance(base.at[v].point, fine.at[v].point)) / box);
    EXPECT_LE(largest, 2e-9) << file; // the specification asks for 2e-8
  }
}

TYPED_TEST(Limit_points, AreFiniteForAnyNormals)
{
  for (Control_mesh control : meshes_for<TypeParam>()) {
    for (const int kind : {0, 1, 2}) {
      if (kind == 0)
        test_meshes::set_wild_normals(control, 5);
      else
        control.normals.assign(control.points.size(),
                               test_meshes::Triple{0, 0, kind == 1 ? 0. : 1.});
      if (kind == 2) control.points.assign(control.points.size(), {1, 2, 3}); // a single point
      Surface_mesh mesh = to_surface_mesh(control);
      const Limits all = limits(mesh, TypeParam::scheme(), test_options::Limit_options());
      for (const Limit& l : all.at) {
        ASSERT_TRUE(is_finite(l)) << control.name;
        const double length = l.control_normal.squared_length();
        EXPECT_TRUE(length == 0 || std::abs(length - 1) < 1e-14) << control.name;
        if (kind != 2) continue;
        EXPECT_LE(CGAL::squared_distance(l.point, Kernel::Point_3(1, 2, 3)), 1e-30);
      }
      EXPECT_TRUE(kind != 2 || all.report.is_within_tolerance());
    }
  }
}

// Interpolatory schemes keep points and normals bit for bit.
TYPED_TEST(Limit_points, OfInterpolatorySchemesAreTheVertices)
{
  if (!TypeParam::is_interpolatory) return;
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    Surface_mesh mesh = to_surface_mesh(control);
    const Limits all = limits(mesh, TypeParam::scheme(), test_options::Limit_options());
    EXPECT_EQ(all.report.error, 0);
    for (auto v : mesh.vertices()) {
      EXPECT_EQ(all.at[v].point, mesh.point(v));
      EXPECT_EQ(all.at[v].control_normal, normal_map(mesh)[v]);
    }
  }
}

TYPED_TEST(Limit_points, AreTheSameWithThreads)
{
  Surface_mesh mesh = to_surface_mesh(meshes_for<TypeParam>()[0]);
  refine<TypeParam>(mesh, 3);
  test_options::Limit_options options = close(1e-10, 1e-3);
  options.curvatures = true;
  const Limits one = limits(mesh, TypeParam::scheme(), options);
  const Limits many = limits<CGAL::Parallel_if_available_tag>(mesh, TypeParam::scheme(), options);
  ASSERT_EQ(one.at.size(), many.at.size());
  for (std::size_t v = 0; v < one.at.size(); ++v) {
    EXPECT_EQ(one.at[v].point, many.at[v].point);
    EXPECT_EQ(one.at[v].surface_normal, many.at[v].surface_normal);
    EXPECT_EQ(one.at[v].error, many.at[v].error);
    EXPECT_EQ(one.at[v].gaussian, many.at[v].gaussian);
  }
}

} // namespace
