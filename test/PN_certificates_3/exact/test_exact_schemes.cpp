// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The linear twins in exact numbers against CGAL's functions, whose weights are those of double.

#include "Mesh_cases.h"
#include "Scheme_runs.h"
#include "Schemes.h"

#include <CGAL/Gmpq.h>

namespace {

using test_meshes::Control_mesh;

using Rational_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<CGAL::Gmpq>::Point_3>;

template <class Description>
class Exact_scheme : public testing::Test
{};
TYPED_TEST_SUITE(Exact_scheme, Schemes, Scheme_names);

// The values at the same vertices: by index, or by position where CGAL has an order of its own.
template <class Any_mesh>
Result rounded_result(const Any_mesh& mesh)
{
  Result result;
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.values.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                      CGAL::to_double(p.z()));
  }
  return result;
}

// What of a mesh CGAL treats with rational weights: all but irregular vertices, or faces, of the
// schemes with cosines.
bool has_rational_weights(const ::CatmullClark&, const Control_mesh&, int)
{
  return true;
}
bool has_rational_weights(const ::Loop&, const Control_mesh& control, int new_vertex)
{
  const reference::Face_list list = test_meshes::face_list(control);
  return new_vertex >= list.number_of_vertices() || list.is_border(new_vertex) ||
         list.ring(new_vertex).size() == 6;
}
bool has_rational_weights(const ::DooSabin&, const Control_mesh& control, int)
{
  return test_meshes::all_faces_have_degree(control, 4);
}
bool has_rational_weights(const ::Sqrt3&, const Control_mesh& control, int new_vertex)
{
  return new_vertex >= int(control.points.size());
}

TYPED_TEST(Exact_scheme, LinearTwinEqualsCgalWhereWeightsAreRational)
{
  if constexpr (has_cgal_peer<TypeParam>) {
    std::size_t equal = 0, close = 0;
    for (const Control_mesh& control : meshes_for_cgal<TypeParam>()) {
      Rational_mesh ours = mesh_cases::built<Rational_mesh>(control), cgal = ours;
      CGAL::PN_subdivision_3::subdivide(ours, CGAL::PN_subdivision_3::linear(TypeParam::scheme()));
      TypeParam::Cgal::linear(cgal, CGAL::parameters::number_of_iterations(1));
      cgal.collect_garbage();
      ASSERT_EQ(ours.number_of_vertices(), cgal.number_of_vertices());
      const Result a = rounded_result(ours), b = rounded_result(cgal);
      std::vector<int> match = match_by_position(a, b);
      if (TypeParam::is_primal)
        for (std::size_t i = 0; i < match.size(); ++i) match[i] = int(i);
      for (auto v : ours.vertices()) {
        ASSERT_NE(match[v], -1);
        const CGAL::SM_Vertex_index partner(
          static_cast<CGAL::SM_Vertex_index::size_type>(match[v]));
        const auto &p = ours.point(v), &q = cgal.point(partner);
        if (has_rational_weights(typename TypeParam::Cgal(), control, int(v.idx()))) {
          ++equal;
          EXPECT_TRUE(p == q) << control.name << ", " << v;
        } else {
          ++close;
          const double distance = std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
          EXPECT_LE(distance, 1e-15 * size_of(a.values)) << control.name << ", " << v;
        }
      }
    }
    std::cout << equal << " vertices equal, " << close << " within 1e-15\n";
    EXPECT_GT(equal, 0u);
  } else
    GTEST_SKIP() << "does not apply: CGAL has no such function";
}

} // namespace
