// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Rounds on tagged meshes against an implementation that shares nothing with the package.

#include "Extent.h"
#include "Random_creases.h"
#include "reference/Crease_tangents.h"
#include "reference/Creases.h"
#include "reference/Semi_sharp.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <gtest/gtest.h>

namespace {

using namespace random_creases;

// \name The state of a run as the reference has it
template <class Run>
reference::Creased_mesh state(const Run& run, const Control& control)
{
  const Level_connectivity& level = run.level();
  reference::Creased_mesh mesh;
  mesh.is_linear = !Run::is_pn;
  mesh.has_fixed_border = control.border == Border::fixed;
  std::vector<Face> faces(level.number_of_faces());
  std::vector<Edge> edges;
  const auto vector = [](const auto& x) { return reference::Vector(x[0], x[1], x[2]); };
  for (Index e = 0; e < level.number_of_edges(); ++e)
    edges.emplace_back(int(level.source(2 * e)), int(level.target(2 * e)));
  run.for_each_corner([&](Index f, Index v, Index slot) {
    faces[f].push_back(int(v));
    mesh.normals[{int(f), int(v)}] = vector(run.normal(slot));
    mesh.roundness[{int(f), int(v)}] = run.roundness(slot);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(run.point(slot)[std::size_t(k)], run.point(v)[std::size_t(k)])
        << "slots of one vertex at different points";
  });
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    mesh.points.push_back(vector(run.point(v)));
  mesh.mesh = reference::Face_list(int(level.number_of_vertices()), faces, edges);
  for (const auto& e : run.creases().edges) {
    const int a = int(level.source(2 * e.edge)), b = int(level.target(2 * e.edge));
    mesh.sharp_edges[undirected(a, b)] = e.sharpness;
    mesh.tangents[{a, b}] = vector(e.tangent_from[0]);
    mesh.tangents[{b, a}] = vector(e.tangent_from[1]);
  }
  for (const auto& s : run.creases().stars)
    if (s.sharpness > 0) mesh.sharp_vertices[int(s.vertex)] = s.sharpness;
  return mesh;
}

struct Greatest_differences
{
  double point = 0, normal = 0, roundness = 0, tangent = 0;

  void expect_small() const
  {
    EXPECT_LE(point, 1e-13);
    EXPECT_LE(normal, 1e-12);
    EXPECT_LE(roundness, 1e-13);
    EXPECT_LE(tangent, 1e-12);
  }
};

template <class Key, class Number>
void expect_same_sharpness(const std::map<Key, Number>& a, const std::map<Key, Number>& b)
{
  EXPECT_EQ(a.size(), b.size());
  for (const auto& [key, s] : a) {
    const auto it = b.find(key);
    ASSERT_TRUE(it != b.end());
    EXPECT_EQ(it->second, s);
  }
}

void compare(const reference::Creased_mesh& got, const reference::Creased_mesh& expected,
             Greatest_differences& differences)
{
  const auto grow = [](double& greatest, const reference::Vector& a, const reference::Vector& b) {
    const double d = double((a - b).norm());
    if (!(d <= greatest)) greatest = d;
  };
  ASSERT_EQ(got.points.size(), expected.points.size());
  ASSERT_EQ(got.mesh.number_of_faces(), expected.mesh.number_of_faces());
  for (std::size_t v = 0; v < got.points.size(); ++v)
    grow(differences.point, got.points[v], expected.points[v]);
  for (int f = 0; f < got.mesh.number_of_faces(); ++f) {
    const Face& face = got.mesh.faces()[std::size_t(f)];
    const int g = expected.mesh.face(face[0], face[1]);
    ASSERT_GE(g, 0);
    for (const int v : face) {
      grow(differences.normal, got.normals.at({f, v}), expected.normals.at({g, v}));
      const auto w = [](reference::Real x) { return reference::Vector(x, 0, 0); };
      grow(differences.roundness, w(got.round({f, v})), w(expected.round({g, v})));
    }
  }
  expect_same_sharpness(got.sharp_edges, expected.sharp_edges);
  expect_same_sharpness(got.sharp_vertices, expected.sharp_vertices);
  if (got.is_linear) return;
  ASSERT_EQ(got.tangents.size(), expected.tangents.size());
  for (const auto& [end, t] : got.tangents) grow(differences.tangent, t, expected.tangents.at(end));
}

template <class Scheme>
void compare_rounds(const Control& control, const Scheme& scheme, bool is_loop, bool is_modified,
                    int rounds)
{
  Crease_run<double, Scheme> run(control, scheme);
  for (int k = 1; k <= rounds; ++k) {
    SCOPED_TRACE("round " + std::to_string(k));
    const reference::Creased_mesh old = state(run, control);
    run.refine();
    Greatest_differences d;
    if (old.is_linear)
      compare(state(run, control), reference::Crease_round(old, is_loop, is_modified).result(), d);
    else
      compare(state(run, control), reference::Semi_sharp_round(old, is_loop, is_modified).result(),
              d);
    d.expect_small();
    if (::testing::Test::HasFailure()) return;
  }
}

void compare_all(const Control& control, int rounds)
{
  // of the rules of a third round all are those of the first two
  const int of_others = tests_are_full ? rounds : (std::min)(rounds, 2);
  compare_rounds(control, CatmullClark_scheme(), false, false, rounds);
  compare_rounds(control, linear(CatmullClark_scheme()), false, false, of_others);
  compare_rounds(control, CatmullClark_scheme::Tuned(), false, true, of_others);
  const Control triangles = triangulated(control);
  compare_rounds(triangles, Loop_scheme(), true, false, rounds);
  compare_rounds(triangles, linear(Loop_scheme()), true, false, of_others);
  compare_rounds(triangles, Loop_scheme::Tuned(), true, true, of_others);
}

struct Case
{
  const char* name;
  Control (*shape)();
  Border border;
  double share;
  std::vector<double> values;

  Control control(std::mt19937& random) const
  {
    Control c = shape();
    c.border = border;
    perturb(c, random);
    tag(c, random, share, values);
    return c;
  }
};

std::string name_of(const ::testing::TestParamInfo<Case>& info)
{
  return info.param.name;
}

class Creases : public ::testing::TestWithParam<Case>
{};

TEST_P(Creases, Rounds_are_those_of_the_reference)
{
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Control c = GetParam().control(random);
    give_normals(c, random);
    compare_all(c, seed == 1 ? 3 : 2);
    if (HasFailure()) return;
  }
}

// where normals are estimated, the mesh without what is less than 1 stands for it in the first round
template <class Scheme>
void compare_first_round(const Control& control, const Scheme& scheme, bool is_loop)
{
  Control untagged = control;
  for (auto& vertex : untagged.sharp_vertices)
    if (vertex.second < 1) vertex.second = 0;
  Crease_run<double, Scheme> run(control, scheme);
  for (const auto& e : run.creases().edges) {
    const int a = int(run.level().source(2 * e.edge)), b = int(run.level().target(2 * e.edge));
    untagged.sharp_edges[undirected(a, b)] = e.sharpness < 1 ? 0 : e.sharpness;
  }
  const Crease_run<double, Scheme> gone(untagged, scheme);
  const reference::Creased_mesh old = state(run, control), other = state(gone, untagged);
  run.refine();
  Greatest_differences d;
  compare(state(run, control), reference::Semi_sharp_round(old, other, is_loop).result(), d);
  d.expect_small();
}

TEST_P(Creases, First_rounds_with_estimated_normals_are_those_of_the_reference)
{
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Control c = GetParam().control(random);
    compare_first_round(c, CatmullClark_scheme(), false);
    compare_first_round(triangulated(c), Loop_scheme(), true);
    if (HasFailure()) return;
  }
}

// \name Control data

// other normals of the wedges: any directions, and none
void turn_normals(Control& c, std::mt19937& random)
{
  std::map<Triple, Triple> turned;
  for (auto& corner : c.normals) {
    Triple& n = corner.second;
    const auto [it, is_new] = turned.try_emplace(n, n);
    if (is_new) {
      const auto x = [&] { return random_between(random, -1, 1); };
      Triple m{x(), x(), x()};
      const double length = random() % 4 == 0 ? infinity : std::hypot(m[0], m[1], m[2]);
      for (double& y : m) y /= length;
      it->second = m;
    }
    n = it->second;
  }
}

std::size_t expect_tangents(const Control& c)
{
  const Crease_run<double, CatmullClark_scheme> run(c, CatmullClark_scheme());
  const reference::Creased_mesh mesh = state(run, c);
  const reference::Crease_tangents expected(mesh);
  std::size_t number_of_short = 0;
  for (const auto& [ends, t] : mesh.tangents) {
    const reference::Vector& e = expected.at(ends.first, ends.second);
    EXPECT_LE((t - e).norm(), 1e-12) << ends.first << " to " << ends.second;
    number_of_short += e.norm() < 0.99;
  }
  return number_of_short;
}

TEST_P(Creases, Tangents_are_those_of_the_reference)
{
  std::size_t number_of_short = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Control c = GetParam().control(random);
    give_normals(c, random);
    expect_tangents(c);
    turn_normals(c, random);
    number_of_short += expect_tangents(c);
    for (auto& n : c.normals) n.second = {0, 0, 0};
    expect_tangents(c);
    // all but folded onto a line, some edges without length
    for (std::size_t v = 0; v < c.points.size(); ++v)
      c.points[v] = {std::floor(c.points[v][0]), 0.03 * c.points[v][1] * double(v % 3), 0};
    number_of_short += expect_tangents(c);
    if (HasFailure()) return;
  }
  EXPECT_GE(number_of_short, 20u);
}

// estimated normals are orthogonal to the tangents beside their wedges
TEST_P(Creases, Estimated_normals_are_orthogonal_to_creases)
{
  std::size_t number = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    Control c = GetParam().control(random);
    const Crease_run<double, CatmullClark_scheme> run(c, CatmullClark_scheme());
    const reference::Creased_mesh mesh = state(run, c);
    for (int v = 0; v < mesh.mesh.number_of_vertices(); ++v) {
      if (!reference::is_crease_vertex(mesh, v)) continue;
      const reference::Vector& t = mesh.tangent(v, reference::sharp_neighbors(mesh, v)[0]);
      for (const int u : mesh.mesh.ring(v))
        if (mesh.mesh.face(v, u) >= 0) {
          EXPECT_LE(std::abs(mesh.normal({mesh.mesh.face(v, u), v}).dot(t)), 1e-12);
          ++number;
        }
    }
  }
  EXPECT_TRUE(number >= 5 || GetParam().border == Border::fixed);
}

INSTANTIATE_TEST_SUITE_P(
  Meshes, Creases,
  ::testing::Values(
    Case{"sharp_box", box, Border::surface, 0.25, {infinity}},
    Case{"few_sharp_edges_of_a_box", box, Border::surface, 0.08, {infinity}},
    Case{"semi_sharp_box", box, Border::surface, 0.3, {0.25, 0.5, 0.8, 1, 1.5, 2, infinity}},
    Case{"few_semi_sharp_edges", box, Border::surface, 0.1, {0.3, 0.6, 1.2, 1.7}},
    Case{"sharp_patch", patch, Border::surface, 0.15, {infinity}},
    Case{"semi_sharp_patch", patch, Border::surface, 0.3, {0.25, 0.5, 0.8, 1, 1.5, 2}},
    Case{"patch_with_border_curve", patch, Border::curve, 0.15, {0.5, 1.5, infinity}},
    Case{"patch_with_corners", patch, Border::corners, 0.1, {0.5, 1.5, infinity}},
    Case{"patch_with_fixed_border", patch, Border::fixed, 0.1, {0.5, 1.5, infinity}}),
  name_of);

} // namespace
