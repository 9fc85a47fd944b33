// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Points by one scheme, normals by another: the PN rule with two rows.

#include "Scheme_runs.h"
#include "Schemes.h"

namespace {

namespace PN = CGAL::PN_subdivision_3;
using test_meshes::Control_mesh;

template <class Points_, class Normals_>
struct Pair
{
  using Points = Points_;
  using Normals = Normals_;
};

template <class>
class Normal_scheme : public testing::Test
{};
using Pairs = testing::Types<Pair<CatmullClark_description, Kobbelt_description>,
                             Pair<Kobbelt_description, CatmullClark_description>,
                             Pair<Loop_description, Butterfly_description>,
                             Pair<Butterfly_description, Loop_description>,
                             Pair<Loop_description, Loop_description>>;
TYPED_TEST_SUITE(Normal_scheme, Pairs, );

template <class Case>
std::vector<Control_mesh> meshes()
{
  std::vector<Control_mesh> result;
  for (const Control_mesh& mesh : test_meshes::all())
    if (takes<typename Case::Points>(mesh) && takes<typename Case::Normals>(mesh))
      result.push_back(mesh);
  return result;
}

template <class Case>
void refine_by_both(Surface_mesh& mesh, unsigned rounds)
{
  PN::subdivide(mesh, PN::with_normal_scheme(Case::Points::scheme(), Case::Normals::scheme()),
                CGAL::parameters::vertex_normal_map(normal_map(mesh)).number_of_iterations(rounds));
}

TYPED_TEST(Normal_scheme, EqualsReference)
{
  for (Control_mesh control : meshes<TypeParam>())
    for (bool wild : {false, true}) {
      if (wild) test_meshes::set_wild_normals(control, 2);
      Surface_mesh mesh = to_surface_mesh(control);
      const reference::Face_list list = face_list(mesh);
      const reference::Refined points = TypeParam::Points::refine(list, 1);
      const reference::Refined normals = TypeParam::Normals::refine(list, 1);
      const reference::Values old = result_of(mesh).values;
      Result expected{{}, points.faces};
      for (std::size_t i = 0; i < points.points.size(); ++i) {
        const auto value = reference::pn_rule(points.points[i], normals.points[i], old);
        expected.values.points.push_back(value.point);
        expected.values.normals.push_back(value.normal);
      }
      refine_by_both<TypeParam>(mesh, 1);
      EXPECT_TRUE(is_within(difference_by_index(result_of(mesh), expected), wild ? 1e-11 : 1e-13))
        << control.name;
    }
}

TYPED_TEST(Normal_scheme, KeepsOldNormalsBitForBitIfTheirSchemeInterpolates)
{
  if (!TypeParam::Normals::is_interpolatory)
    GTEST_SKIP() << "does not apply: the normals are not interpolated";
  for (const Control_mesh& control : meshes<TypeParam>()) {
    Surface_mesh mesh = to_surface_mesh(control);
    Surface_mesh old = mesh;
    refine_by_both<TypeParam>(mesh, 2);
    for (auto v : old.vertices())
      EXPECT_EQ(normal_map(mesh)[v], normal_map(old)[v]) << control.name << ", vertex " << v;
  }
}

} // namespace
