// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Every scheme against CGAL, against PN_mask_3 in CGAL's hosts, and against the reference form.

#include "Mesh_files.h"
#include "Schemes.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>

namespace {

using test_meshes::Control_mesh;

template <class Description>
class Scheme : public testing::Test
{};
TYPED_TEST_SUITE(Scheme, Schemes, Scheme_names);

TYPED_TEST(Scheme, LinearTwinEqualsCgal)
{
  if constexpr (has_cgal_peer<TypeParam>) {
    double largest = 0;
    for (const Control_mesh& control : meshes_for_cgal<TypeParam>())
      for (unsigned rounds = 1; rounds <= 3; ++rounds) {
        Surface_mesh ours = to_surface_mesh(control), cgal = ours;
        for (auto v : ours.vertices())
          put(normal_map(ours), v, CGAL::NULL_VECTOR), put(normal_map(cgal), v, CGAL::NULL_VECTOR);
        refine_linearly<TypeParam>(ours, rounds);
        TypeParam::Cgal::linear(cgal, CGAL::parameters::number_of_iterations(rounds));
        const Difference d = difference(result_of(ours), result_of(cgal));
        EXPECT_TRUE(is_within(d, 1e-13)) << control.name << ", rounds " << rounds;
        largest = (std::max)(largest, d.points);
      }
    std::cout << "largest difference " << largest << '\n';
  } else
    GTEST_SKIP() << "does not apply: CGAL has no such function";
}

// The meshes of data/, and real ones where they are found; estimated normals where a file has none.
TYPED_TEST(Scheme, AgreesWithCgalOnMeshFiles)
{
  if constexpr (has_cgal_peer<TypeParam>) {
    std::size_t files = 0;
    for (const std::string& file : mesh_files::all()) {
      Surface_mesh mesh = mesh_files::read(file);
      if (!mesh_files::takes<TypeParam>(mesh) || mesh.number_of_faces() > 4000) continue;
      for (auto v : mesh.vertices()) // CGAL's hosts cannot have them
        if (mesh.is_isolated(v)) mesh.remove_vertex(v);
      mesh.collect_garbage();
      ASSERT_TRUE(is_valid_manifold(mesh)) << file;
      if (!mesh_files::has_normals(mesh))
        CGAL::PN_subdivision_3::estimate_control_normals(mesh, normal_map(mesh));
      Surface_mesh ours = mesh, cgal = mesh;
      refine<TypeParam>(ours, 1);
      const auto map = CGAL::PN_subdivision_3::Zipped_point_normal_map(
        get(CGAL::vertex_point, cgal), normal_map(cgal));
      TypeParam::Cgal::host(cgal, TypeParam::Cgal::mask(cgal, map),
                            CGAL::parameters::vertex_point_map(map));
      EXPECT_TRUE(is_within(difference(result_of(ours), result_of(cgal)), 1e-12)) << file;
      ++files;
    }
    EXPECT_GE(files, 4u);
  } else
    GTEST_SKIP() << "does not apply: CGAL has no such mask";
}

// One round, vertex by vertex in the documented order.
TYPED_TEST(Scheme, EqualsReferenceInDocumentedOrder)
{
  double largest = 0;
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    Surface_mesh pn = to_surface_mesh(control), linear = pn;
    for (auto v : linear.vertices()) put(normal_map(linear), v, CGAL::NULL_VECTOR);
    const Result pn_expected = reference_result<TypeParam>(pn, 1, Rule::pn);
    const Result linear_expected = reference_result<TypeParam>(linear, 1, Rule::linear);
    refine<TypeParam>(pn, 1);
    refine_linearly<TypeParam>(linear, 1);
    const Difference d = difference_by_index(result_of(pn), pn_expected);
    EXPECT_TRUE(is_within(d, 1e-13)) << control.name;
    EXPECT_TRUE(is_within(difference_by_index(result_of(linear), linear_expected), 1e-13))
      << control.name;
    largest = (std::max)({largest, d.points, d.normals});
  }
  std::cout << "largest difference " << largest << '\n';
}

TYPED_TEST(Scheme, EqualsReferenceOverSeveralRounds)
{
  for (const Control_mesh& control : meshes_for<TypeParam>())
    for (unsigned rounds = 2; rounds <= 3; ++rounds) {
      if (double(control.faces.size()) * std::pow(TypeParam::growth, rounds) > 700) continue;
      Surface_mesh pn = to_surface_mesh(control);
      const Result expected = reference_result<TypeParam>(pn, rounds, Rule::pn);
      refine<TypeParam>(pn, rounds);
      EXPECT_TRUE(is_within(difference(result_of(pn), expected), 1e-13))
        << control.name << ", rounds " << rounds;
    }
}

// Missing, fading and opposite normals. Where they nearly cancel, rounding is magnified.
TYPED_TEST(Scheme, EqualsReferenceForWildNormals)
{
  for (Control_mesh control : meshes_for<TypeParam>())
    for (unsigned seed = 0; seed < 3; ++seed) {
      test_meshes::set_wild_normals(control, seed);
      Surface_mesh pn = to_surface_mesh(control);
      const Result expected = reference_result<TypeParam>(pn, 1, Rule::pn);
      refine<TypeParam>(pn, 1);
      EXPECT_TRUE(is_within(difference_by_index(result_of(pn), expected), 1e-11))
        << control.name << ", seed " << seed;
    }
}

} // namespace
