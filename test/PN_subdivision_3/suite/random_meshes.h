// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// What holds for every scheme on every mesh, tried on meshes that are made from a seed. A failure names the seed
// and the command that runs it again.
//
//   PN_TEST_SEED    the first seed                            (1)
//   PN_TEST_SEEDS   how many are tried from there on          (24)

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUITE_RANDOM_MESHES_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUITE_RANDOM_MESHES_H

#include "Random_meshes.h"
#include "Scheme_runs.h"

#include <cstdlib>
#include <functional>

namespace random_meshes {

inline unsigned from_environment(const char* name, unsigned otherwise)
{
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : unsigned(std::strtoul(text, nullptr, 10));
}

template <class Description>
constexpr Kind kind_for = Description::degree == 3   ? Kind::triangles
                          : Description::degree == 4 ? Kind::quads
                                                     : Kind::polygons;

// f(mesh, generator) for meshes of all seeds, until one of them fails
template <class Description>
void for_each_seed(const std::function<void(const Control_mesh&, std::mt19937&)>& f)
{
  const unsigned first = from_environment("PN_TEST_SEED", 1);
  const unsigned number = std::getenv("PN_TEST_SEED") != nullptr ? 1 : 24;
  for (unsigned i = 0; i < from_environment("PN_TEST_SEEDS", number); ++i) {
    const unsigned seed = first + i;
    std::mt19937 generator(seed);
    const Control_mesh mesh = random_mesh(kind_for<Description>, generator);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + mesh.name + "; again by PN_TEST_SEED=" +
                 std::to_string(seed) + " ctest --preset release -R Random_meshes");
    f(mesh, generator);
    if (testing::Test::HasFailure()) return;
  }
}

template <class Description>
Result refined(const Control_mesh& control, unsigned rounds = 2)
{
  Surface_mesh mesh = to_surface_mesh(control);
  refine<Description>(mesh, rounds);
  return result_of(mesh);
}

template <class Description>
Result linearly_refined(Control_mesh control)
{
  control.normals.assign(control.points.size(), Triple{0, 0, 0});
  Surface_mesh mesh = to_surface_mesh(control);
  refine_linearly<Description>(mesh, 2);
  return result_of(mesh);
}

template <class Description>
class Random_meshes : public testing::Test
{};
TYPED_TEST_SUITE_P(Random_meshes);

// A part of a sphere or of a cylinder with its normals is refined to points of it with their normals.
TYPED_TEST_P(Random_meshes, OnSpheresAndCylindersStayOnThem)
{
  if (!TypeParam::is_linear_for_equal_normals)
    GTEST_SKIP() << "does not apply: it solves equations of any condition";
  for_each_seed<TypeParam>([](const Control_mesh& mesh, std::mt19937& generator) {
    for (bool is_cylinder : {false, true}) {
      const Shape shape(is_cylinder, generator);
      const Result result = refined<TypeParam>(shape.moved_to(mesh));
      for (std::size_t i = 0; i < result.values.points.size(); ++i) {
        const auto [distance, normal_error] =
          shape.deviation(result.values.points[i], result.values.normals[i]);
        ASSERT_LE(distance, 1e-12) << (is_cylinder ? "cylinder, vertex " : "sphere, vertex ") << i;
        ASSERT_LE(normal_error, 1e-12)
          << (is_cylinder ? "cylinder, vertex " : "sphere, vertex ") << i;
      }
    }
  });
}

TYPED_TEST_P(Random_meshes, CommuteWithSimilarities)
{
  for_each_seed<TypeParam>([](const Control_mesh& mesh, std::mt19937& generator) {
    const Similarity s(generator);
    Result expected = refined<TypeParam>(mesh);
    for (auto& p : expected.values.points) p = s.point(p);
    for (auto& n : expected.values.normals) n = s.normal(n);
    EXPECT_TRUE(is_within(difference_by_index(refined<TypeParam>(s.moved(mesh)), expected), 1e-12));
  });
}

TYPED_TEST_P(Random_meshes, WithReversedNormalsHaveTheSamePointsBitForBit)
{
  for_each_seed<TypeParam>([](Control_mesh mesh, std::mt19937& generator) {
    set_wild_normals(mesh, unsigned(generator()));
    Result expected = refined<TypeParam>(mesh);
    for (auto& n : expected.values.normals) n = -n;
    for (Triple& n : mesh.normals) n = {-n[0], -n[1], -n[2]};
    EXPECT_TRUE(is_within(difference_by_index(refined<TypeParam>(mesh), expected), 0));
  });
}

TYPED_TEST_P(Random_meshes, WithZeroOrEqualNormalsAreRefinedLinearly)
{
  for_each_seed<TypeParam>([](Control_mesh mesh, std::mt19937& generator) {
    Result expected = linearly_refined<TypeParam>(mesh);
    mesh.normals.assign(mesh.points.size(), Triple{0, 0, 0});
    EXPECT_TRUE(is_within(difference_by_index(refined<TypeParam>(mesh), expected), 0));
    if (!TypeParam::is_linear_for_equal_normals) return; // it keeps the curvature of points
    const Triple normal = random_direction(generator);
    mesh.normals.assign(mesh.points.size(), normal);
    for (auto& n : expected.values.normals) n = {normal[0], normal[1], normal[2]};
    EXPECT_TRUE(is_within(difference_by_index(refined<TypeParam>(mesh), expected), 1e-12));
  });
}

TYPED_TEST_P(Random_meshes, AreRefinedBySingleRoundsAsAtOnce)
{
  if (!TypeParam::composes_single_rounds)
    GTEST_SKIP() << "does not apply: rounds are counted within one call";
  for_each_seed<TypeParam>([](Control_mesh mesh, std::mt19937& generator) {
    if (generator() % 2 == 0) set_wild_normals(mesh, unsigned(generator()));
    Surface_mesh once = to_surface_mesh(mesh), singly = once;
    refine<TypeParam>(once, 3);
    for (int i = 0; i < 3; ++i) refine<TypeParam>(singly, 1);
    EXPECT_TRUE(is_identical(once, singly));
    EXPECT_TRUE(is_valid_manifold(once));
  });
}

REGISTER_TYPED_TEST_SUITE_P(Random_meshes, OnSpheresAndCylindersStayOnThem, CommuteWithSimilarities,
                            WithReversedNormalsHaveTheSamePointsBitForBit,
                            WithZeroOrEqualNormalsAreRefinedLinearly,
                            AreRefinedBySingleRoundsAsAtOnce);

} // namespace random_meshes

// Both suites for some descriptions of schemes.
#define PN_INSTANTIATE_SUITES(Name, ...)                                                           \
  using Name##_schemes = testing::Types<__VA_ARGS__>;                                              \
  namespace named_shapes {                                                                         \
  INSTANTIATE_TYPED_TEST_SUITE_P(Name, Named_shapes, Name##_schemes, Scheme_names);                \
  }                                                                                                \
  namespace random_meshes {                                                                        \
  INSTANTIATE_TYPED_TEST_SUITE_P(Name, Random_meshes, Name##_schemes, Scheme_names);               \
  }

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUITE_RANDOM_MESHES_H
