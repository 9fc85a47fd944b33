// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Every scheme against PN_mask_3 in CGAL's hosts, and against the reference form; its linear twin against CGAL is the subject of
// test_Subdivision_method_3.cpp.

#include "Mesh_files.h"
#include "Schemes.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>

namespace {

using test_meshes::Control_mesh;

template <class Description>
class Scheme : public testing::Test
{};
TYPED_TEST_SUITE(Scheme, Schemes, Scheme_names);

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

// The first round vertex by vertex in the documented order, further ones by position.
TYPED_TEST(Scheme, EqualsReferenceInDocumentedOrder)
{
  double largest = 0;
  for (const Control_mesh& control : meshes_for<TypeParam>())
    for (unsigned rounds = 1; rounds <= 3; ++rounds) {
      if (rounds > 1 && double(control.faces.size()) * std::pow(TypeParam::growth, rounds) > 700)
        continue;
      Surface_mesh pn = to_surface_mesh(control), linear = pn;
      for (auto v : linear.vertices()) put(normal_map(linear), v, CGAL::NULL_VECTOR);
      const Result pn_expected = reference_result<TypeParam>(pn, rounds, Rule::pn);
      const Result linear_expected = reference_result<TypeParam>(linear, rounds, Rule::linear);
      refine<TypeParam>(pn, rounds);
      refine_linearly<TypeParam>(linear, rounds);
      const auto compared = [&](Surface_mesh& mesh, const Result& expected) {
        return rounds == 1 ? difference_by_index(result_of(mesh), expected)
                           : difference(result_of(mesh), expected);
      };
      const Difference d = compared(pn, pn_expected);
      EXPECT_TRUE(is_within(d, 1e-13)) << control.name << ", rounds " << rounds;
      EXPECT_TRUE(is_within(compared(linear, linear_expected), 1e-13))
        << control.name << ", rounds " << rounds;
      largest = (std::max)({largest, d.points, d.normals});
    }
  std::cout << "largest difference " << largest << '\n';
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
