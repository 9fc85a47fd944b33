// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits of meshes with creases: linear schemes, the functions that compute them, and what is refused.

#include "Creased_limit_cases.h"
#include "Messages.h"
#include "support/Options.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace creased_limit_cases;

// --- linear schemes ---

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

// on a crease (1, 4, 1)/6 of the control points, at corners the point itself, exactly
TEST(Limit_creases, LinearLimitsAreThoseOfTheCubicSpline)
{
  using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;
  const Control c = random_net(1);
  Exact_mesh mesh;
  for (const Triple& p : c.points) mesh.add_vertex(Exact::Point_3(p[0], p[1], p[2]));
  for (const Face& f : c.faces) {
    std::vector<CGAL::SM_Vertex_index> corners;
    for (const int v : f) corners.emplace_back(CGAL::SM_Vertex_index::size_type(v));
    mesh.add_face(corners);
  }
  auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, double>("e:sharp", 0).first;
  auto fixed = mesh.add_property_map<CGAL::SM_Vertex_index, bool>("v:fixed", false).first;
  for (const auto& v : c.sharp_vertices)
    fixed[CGAL::SM_Vertex_index(CGAL::SM_Vertex_index::size_type(v.first))] = v.second > 0;
  std::vector<std::vector<int>> ends(c.points.size());
  for (const auto e : mesh.edges()) {
    const auto a = int(mesh.vertex(e, 0)), b = int(mesh.vertex(e, 1));
    const auto it = c.sharp_edges.find(undirected(a, b));
    if (it == c.sharp_edges.end() || !(it->second > 0)) continue;
    sharp[e] = it->second;
    ends[std::size_t(a)].push_back(b);
    ends[std::size_t(b)].push_back(a);
  }
  const Exact_mesh control = mesh;
  PN::subdivide_to_limit(mesh, PN::linear(PN::CatmullClark_scheme()),
                         np::edge_is_constrained_map(sharp).vertex_is_constrained_map(fixed));
  const auto x = [&](int v) {
    return control.point(CGAL::SM_Vertex_index(CGAL::SM_Vertex_index::size_type(v))).x();
  };
  int creases = 0, corners = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const int v = int(i);
    const Exact::FT limit =
      mesh.point(CGAL::SM_Vertex_index(CGAL::SM_Vertex_index::size_type(i))).x();
    const auto sharp_vertex = c.sharp_vertices.find(v);
    const bool is_fixed = sharp_vertex != c.sharp_vertices.end() && sharp_vertex->second > 0;
    if (ends[i].size() == 2 && !is_fixed) {
      EXPECT_EQ(limit, (x(ends[i][0]) + Exact::FT(4) * x(v) + x(ends[i][1])) / Exact::FT(6));
      ++creases;
    } else if (ends[i].size() > 2 || is_fixed) {
      EXPECT_EQ(limit, x(v));
      ++corners;
    }
  }
  EXPECT_GT(creases, 0);
  EXPECT_GT(corners, 0);
}

// one-sided, at vertices on creases, too, but not where a side has a single face
TEST(Limit_creases, LinearSurfaceNormalsOfFlatSidesAreTheirs)
{
  Part part = capped_cylinder(uneven(7));
  const Control control = part.control();
  Tagged<Mesh> t(control);
  test_options::Limit_options options;
  options.surface_normals = true;
  const PN::Limit_report report = to_limit(t, PN::linear(PN::CatmullClark_scheme()), 2, options);
  EXPECT_EQ(report.number_of_stand_ins, 14u);
  for (const auto f : t.mesh.faces()) {
    const Surface& s = *surface_of(part, t, f);
    if (s.kind != Surface::plane) continue;
    for (const auto h : t.mesh.halfedges_around_face(t.mesh.halfedge(f))) {
      const Vector n = vector(get(t.normals, h));
      const bool has_normal = t.mesh.target(h).idx() >= control.points.size();
      EXPECT_LE(double((n - (has_normal ? s.direction : Vector(0, 0, 0))).norm()), 1e-12);
    }
  }
}

// --- calls ---

TEST(Limit_creases, SubdivideAndMoveAreTheSameByTwoCalls)
{
  for (const int seed : {1, 3, 4}) {
    const Control c = random_net(seed);
    for (const bool surface_normals : {false, true}) {
      Tagged<Mesh> one(c), two(c);
      test_options::Limit_options options;
      options.surface_normals = surface_normals;
      const auto tangents_of = [](Mesh& mesh) {
        return mesh.add_property_map<Mesh::Halfedge_index, Vector_3>("h:t", Vector_3(0, 0, 0))
          .first;
      };
      const auto tangents = tangents_of(one.mesh), others = tangents_of(two.mesh);
      const auto scheme = [&](const auto& map) {
        return PN::internal::with_crease_tangents(
          PN::internal::with_border(PN::CatmullClark_scheme(), c.border), map);
      };
      const PN::Limit_report report = to_limit(one, scheme(tangents), 2, options);
      two.subdivide(scheme(others), 2);
      options.rounds_done = 2;
      const PN::Limit_report moved = PN::subdivide_to_limit(
        two.mesh, scheme(others),
        PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                             np::edge_is_constrained_map(two.sharp)
                               .vertex_is_constrained_map(two.corners)
                               .vertex_normal_map(two.normals)));
      EXPECT_TRUE(state(one) == state(two)) << seed;
      for (const auto h : one.mesh.halfedges()) EXPECT_EQ(tangents[h], others[h]);
      EXPECT_EQ(report.error, moved.error);
      EXPECT_EQ(report.number_of_stand_ins, moved.number_of_stand_ins);
      EXPECT_EQ(report.number_of_stand_ins > 0, surface_normals);
    }
  }
}

// that of limit_points() is the mean of those of the corners
TEST(Limit_creases, VerticesHaveTheMeanOfTheirWedges)
{
  const Control c = random_net(3);
  Tagged<Mesh> corners(c), points(c);
  using Limit = PN::Limit_point<Kernel>;
  const auto limits = points.mesh.add_property_map<Mesh::Vertex_index, Limit>("v:l").first;
  const PN::CatmullClark_scheme scheme;
  to_limit(corners, scheme, 0, test_options::Limit_options());
  PN::limit_points(points.mesh, scheme, limits,
                   np::edge_is_constrained_map(points.sharp)
                     .vertex_is_constrained_map(points.corners)
                     .vertex_normal_map(points.normals));
  for (const auto v : corners.mesh.vertices()) {
    EXPECT_EQ(limits[v].point, corners.mesh.point(v));
    std::set<Triple> wedges;
    for (const auto h : corners.mesh.halfedges_around_target(corners.mesh.halfedge(v)))
      if (!corners.mesh.is_border(h)) wedges.insert(triple(get(corners.normals, h)));
    Vector mean = Vector::Zero();
    for (const Triple& n : wedges) mean += crease_shapes::vector(n);
    EXPECT_LE(double((vector(limits[v].control_normal) - mean.normalized()).norm()), 1e-14);
  }
}

TEST(Limit_creases, AreTheSameInPolyhedraAndByThreads)
{
  const Control c = random_net(1);
  Tagged<Mesh> s(c);
  Tagged<CGAL::Polyhedron_3<Kernel>> p(c);
  const auto scheme = PN::internal::with_border(PN::CatmullClark_scheme(), c.border);
  to_limit(s, scheme, 2, test_options::Limit_options());
  to_limit(p, scheme, 2, test_options::Limit_options());
  EXPECT_TRUE(state(s) == state(p));
#ifdef CGAL_LINKED_WITH_TBB
  Tagged<Mesh> parallel(c);
  to_limit<Mesh, std::decay_t<decltype(scheme)>, CGAL::Parallel_tag>(parallel, scheme, 2,
                                                                     test_options::Limit_options());
  EXPECT_TRUE(state(s) == state(parallel));
#endif
}

TEST(Limit_creases, OfAnEmptyMeshAreNone)
{
  Tagged<Mesh> none{Control()};
  EXPECT_TRUE(to_limit(none, PN::CatmullClark_scheme(), 2, test_options::Limit_options())
                .is_within_tolerance());
  EXPECT_EQ(none.mesh.number_of_vertices(), 0u);
}

// --- what is refused ---

template <class Scheme>
void expect_refusal(const Control& control, const Scheme& scheme, unsigned rounds,
                    const std::string& what)
{
  Tagged<Mesh> t(control);
  const State before = state(t);
  messages::expect_refused([&] { to_limit(t, scheme, rounds, test_options::Limit_options()); },
                           {what});
  EXPECT_TRUE(state(t) == before);
}

TEST(Limit_creases, WhatIsNotSharpForEverIsRefused)
{
  Control c = cube().control();
  c.normals.clear();
  const PN::CatmullClark_scheme scheme;
  c.sharp_edges.begin()->second = 2.5;
  expect_refusal(c, scheme, 0, "is 2.5");
  expect_refusal(c, scheme, 1, "by 2 more rounds");
  expect_refusal(c, scheme, 2, "by 1 more round,");
  expect_refusal(c, scheme, 2, "the edge of half-edge");
  Tagged<Mesh> smooth(c);
  EXPECT_NO_THROW(to_limit(smooth, scheme, 3, test_options::Limit_options()));
  c.sharp_edges.begin()->second = infinity;
  c.sharp_vertices[5] = 1.25;
  expect_refusal(c, scheme, 1, "the sharpness of vertex 5 is 1.25");
  Tagged<Mesh> corner(c);
  EXPECT_NO_THROW(to_limit(corner, scheme, 2, test_options::Limit_options()));
}

} // namespace
