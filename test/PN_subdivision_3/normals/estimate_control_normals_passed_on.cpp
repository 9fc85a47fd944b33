// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// An estimate that is passed on as one thing: the surface is the one without normals, and where a normal is put it is round.

#include "Failing_map.h"
#include "Mesh_cases.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// a long box on whose top a point stands out, and a vertex without faces
Soup spired_box()
{
  Soup soup = cube();
  for (Triple& p : soup.points) p[0] *= 3;
  Polygon& face = soup.faces.back();
  const Polygon top = face;
  face = {top[0], top[1], 8};
  for (std::size_t i = 1; i < top.size(); ++i)
    soup.faces.push_back({top[i], top[(i + 1) % top.size()], 8});
  Triple middle{0, 0, 0};
  for (const std::size_t v : top)
    for (int k = 0; k < 3; ++k) middle[k] += soup.points[v][k] / 4;
  for (int k = 0; k < 3; ++k) middle[k] *= 1.2;
  soup.points.push_back(middle);
  soup.points.push_back({9, 9, 9});
  return soup;
}

const PN::CatmullClark_scheme scheme;

template <class Any_mesh>
Any_mesh built(const Soup& soup)
{
  Any_mesh mesh;
  build(soup, mesh);
  return mesh;
}

// bit for bit but for what an exact number is in double
void expect_same(const std::vector<Triple>& a, const std::vector<Triple>& b,
                 const std::string& what)
{
  if (what != "exact") {
    EXPECT_EQ(a, b) << what;
  }
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t v = 0; v < a.size(); ++v)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[v][k], b[v][k], 1e-14) << what;
}

template <class Any_mesh>
void expect_same_surface(const Soup& soup, unsigned rounds, const std::string& what)
{
  Any_mesh without = built<Any_mesh>(soup), once = without, twice = without;
  const auto normals = PN::estimate_control_normals(once);
  const auto same = normals.clone();
  PN::subdivide(without, scheme, params::number_of_iterations(rounds));
  PN::subdivide(once, scheme, params::number_of_iterations(rounds).vertex_normal_map(normals));
  for (unsigned k = 0; k < rounds; ++k)
    PN::subdivide(twice, scheme, params::vertex_normal_map(same));
  expect_same(points(once), points(without), what);
  expect_same(points(twice), points(without), what);
  expect_same(values(once, normals), values(twice, same), what);
  EXPECT_EQ(values(once, normals).size(), num_vertices(without)) << what;
}

TEST(Estimate_passed_on, IsTheSurfaceWithoutNormals)
{
  for (const Soup& soup : {spired_box(), mixed_with_border(), Soup()}) {
    expect_same_surface<Mesh>(soup, 2, "Surface_mesh");
    expect_same_surface<CGAL::Surface_mesh<Epeck::Point_3>>(soup, 1, "exact");
  }
}

// with roundness 0, 1 and between: otherwise the other tests would tell nothing
TEST(Estimate_passed_on, HasTheRoundnessOfTheMaps)
{
  Mesh mesh = built<Mesh>(spired_box());
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  const auto w = mesh.add_property_map<Vertex, double>("w").first;
  PN::estimate_control_normals(mesh, n, PN::parameters::vertex_roundness_map(w));
  const auto normals = PN::estimate_control_normals(mesh);
  double least = 1, largest = 0;
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(normals[v], n[v]);
    EXPECT_EQ(get(normals.roundness_map(), v), w[v]);
    least = (std::min)(least, w[v]);
    if (!mesh.is_isolated(v)) largest = (std::max)(largest, w[v]);
  }
  EXPECT_LT(least, .9);
  EXPECT_LT(largest, 1);
  // and into an estimate as a map of one's own
  const PN::Estimated_control_normals<Vertex, Kernel> own;
  PN::estimate_control_normals(mesh, own);
  for (const Vertex v : mesh.vertices()) EXPECT_EQ(get(own.roundness_map(), v), w[v]);
}

TEST(Estimate_passed_on, IsRoundWhereANormalIsPut)
{
  Mesh mesh = built<Mesh>(spired_box());
  const Mesh control = mesh;
  const auto normals = PN::estimate_control_normals(mesh),
             before = PN::estimate_control_normals(mesh);
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  const auto w = mesh.add_property_map<Vertex, double>("w").first;
  put(normals, Vertex(1), Kernel::Vector_3(0, .6, .8));
  put(normals, Vertex(2), before[Vertex(2)]);
  for (const Vertex v : mesh.vertices()) {
    n[v] = normals[v];
    w[v] = get(normals.roundness_map(), v);
    const bool is_put = v == Vertex(1) || v == Vertex(2);
    EXPECT_EQ(w[v], is_put ? 1. : get(before.roundness_map(), v));
  }
  EXPECT_EQ(n[Vertex(1)], Kernel::Vector_3(0, .6, .8));
  Mesh own = mesh, refined = control;
  const auto n_of_own = PN::internal::find_property_map<Vertex, Kernel::Vector_3>(own, "n").value();
  const auto w_of_own = PN::internal::find_property_map<Vertex, double>(own, "w").value();
  PN::subdivide(
    own, scheme,
    PN::parameters::vertex_roundness_map(w_of_own).number_of_iterations(2).vertex_normal_map(
      n_of_own));
  PN::subdivide(refined, scheme, params::number_of_iterations(2).vertex_normal_map(normals));
  EXPECT_EQ(points(refined), points(own));
  // what was written here left the roundness that was written here
  for (const Vertex v : refined.vertices()) EXPECT_EQ(get(normals.roundness_map(), v), w_of_own[v]);
}

TEST(Estimate_passed_on, GivesWayToAnotherRoundness)
{
  const Mesh control = built<Mesh>(spired_box());
  const auto run = [&](const auto& np_of) {
    Mesh mesh = control;
    const auto normals = PN::estimate_control_normals(mesh);
    PN::subdivide(mesh, scheme, np_of(mesh).vertex_normal_map(normals));
    for (const Vertex v : control.vertices())
      EXPECT_EQ(get(normals.roundness_map(), v),
                get(PN::estimate_control_normals(control).roundness_map(), v));
    return points(mesh);
  };
  const auto half = run([](Mesh&) { return PN::parameters::roundness(.5); });
  EXPECT_EQ(run([](Mesh& mesh) {
              return PN::parameters::vertex_roundness_map(
                mesh.add_property_map<Vertex, double>("w", .5).first);
            }),
            half);
  Mesh mesh = control;
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  PN::estimate_control_normals(mesh, n);
  PN::subdivide(mesh, scheme, PN::parameters::roundness(.5).vertex_normal_map(n));
  EXPECT_EQ(points(mesh), half);
}

template <class Any_mesh>
auto some_sharp_edges(Any_mesh& mesh, int every)
{
  const auto sharp = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  int k = 0;
  for (const auto e : edges(mesh)) put(sharp, e, k++ % every == 0);
  return sharp;
}

// of corners: creases that end, cross and close
template <class Any_mesh>
void expect_same_creases(const std::string& what)
{
  for (const int every : {1, 3, 5}) {
    Any_mesh without = built<Any_mesh>(spired_box()), with = without, put_again = without;
    const auto run = [&](Any_mesh& mesh, const auto& change) {
      const auto sharp = some_sharp_edges(mesh, every);
      const auto normals =
        PN::estimate_control_normals(mesh, params::edge_is_constrained_map(sharp));
      change(normals);
      const auto np =
        params::number_of_iterations(2).edge_is_constrained_map(sharp).vertex_normal_map(normals);
      if constexpr (std::is_same_v<Any_mesh, Mesh>) {
        const PN::Surface_refiner refiner(mesh, scheme, np);
        PN::subdivide(mesh, scheme, np);
        for (const Vertex v : mesh.vertices()) EXPECT_EQ(refiner.points()[v.idx()], mesh.point(v));
      } else
        PN::subdivide(mesh, scheme, np);
    };
    run(with, [](const auto&) {});
    PN::subdivide(
      without, scheme,
      params::number_of_iterations(2).edge_is_constrained_map(some_sharp_edges(without, every)));
    EXPECT_EQ(points(with), points(without)) << what << every;
    // who puts a normal at a corner makes its wedge round
    run(put_again, [&](const auto& normals) {
      for (const auto h : halfedges(put_again)) {
        put(normals, h, get(normals, h));
        EXPECT_EQ(get(normals.roundness_map(), h), 1);
      }
    });
    if (every > 1) { // else planes
      EXPECT_NE(points(put_again), points(without)) << what << every;
    }
  }
}

// keys without numbers, and a mesh that grows elsewhere; the vertices of the copy are others
TEST(Estimate_passed_on, GrowsWithAPolyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  for (const Soup& soup : {spired_box(), mixed_with_border()}) {
    Polyhedron without = built<Polyhedron>(soup), with = without;
    const auto normals = PN::estimate_control_normals(with);
    PN::subdivide(without, scheme, params::number_of_iterations(2));
    for (int k = 0; k < 2; ++k) PN::subdivide(with, scheme, params::vertex_normal_map(normals));
    EXPECT_EQ(points(with), points(without));
  }
}

TEST(Estimate_passed_on, IsTheSurfaceWithoutNormalsAtCreases)
{
  expect_same_creases<Mesh>("Surface_mesh");
  expect_same_creases<CGAL::Polyhedron_3<Kernel>>("Polyhedron_3");
}

// what a map of vertices says where a vertex has several wedges is not taken: neither its normals nor their roundness
TEST(Estimate_passed_on, OfVerticesIsEstimatedAgainBetweenCreases)
{
  const auto run = [&](double w) {
    Mesh mesh = built<Mesh>(spired_box());
    const auto sharp = some_sharp_edges(mesh, 3);
    const auto normals = PN::estimate_control_normals(mesh);
    std::size_t changed = 0;
    for (const Vertex v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue;
      int ends = 0;
      for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
        ends += get(sharp, mesh.edge(h));
      if (ends < 2) continue;
      put(normals, v, Kernel::Vector_3(w, 1, 0));
      put(normals.roundness_map(), v, w);
      ++changed;
    }
    EXPECT_GT(changed, 2u);
    PN::subdivide(mesh, scheme, params::vertex_normal_map(normals).edge_is_constrained_map(sharp));
    return points(mesh);
  };
  EXPECT_EQ(run(0), run(1));
}

// a call that fails leaves the normals and the roundness of the old vertices, or of the corners
template <class Estimate_of, class Keys>
void expect_strong_guarantee(const Estimate_of& estimate_of, const Keys& keys)
{
  Mesh mesh = built<Mesh>(spired_box());
  const auto normals = estimate_of(mesh), before = estimate_of(mesh);
  const auto sharp = some_sharp_edges(mesh, 3);
  const std::size_t n = mesh.number_of_vertices();
  for (int puts = 0; puts < 35; puts += 17) {
    failing_maps::Calls_left left(puts);
    const auto points = failing(get(CGAL::vertex_point, mesh), left);
    const auto np = params::vertex_normal_map(normals).edge_is_constrained_map(sharp);
    EXPECT_THROW(PN::subdivide(mesh, scheme, np.vertex_point_map(points)),
                 failing_maps::User_failure);
    ASSERT_EQ(mesh.number_of_vertices(), n);
    for (const auto key : keys(mesh)) {
      EXPECT_EQ(normals[key], before[key]);
      EXPECT_EQ(get(normals.roundness_map(), key), get(before.roundness_map(), key));
    }
  }
}

TEST(Estimate_passed_on, HasTheStrongGuarantee)
{
  expect_strong_guarantee([](Mesh& mesh) { return PN::estimate_control_normals(mesh); },
                          [](Mesh& mesh) { return vertices(mesh); });
  expect_strong_guarantee(
    [](Mesh& mesh) {
      return PN::estimate_control_normals(
        mesh, params::edge_is_constrained_map(some_sharp_edges(mesh, 3)));
    },
    [](Mesh& mesh) { return halfedges(mesh); });
  Mesh mesh = built<Mesh>(spired_box());
  mesh.point(Vertex(3)) = Kernel::Point_3(0, 0, std::nan(""));
  EXPECT_THROW(PN::estimate_control_normals(mesh), std::invalid_argument);
}

} // namespace
