// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Estimated curvatures of degenerate and refused input, and of other meshes, kernels and maps; a part of
// the program of test_estimate_curvature.cpp.

#include "Estimated_curvatures.h"
#include "Messages.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include <limits>
#include <stdexcept>

using namespace estimated_curvatures;
namespace params = CGAL::parameters;

// --- degenerate input ---

// What has no neighbors is not estimated, what has, is.
TEST(Estimate_curvature, ComponentsAndVerticesWithoutFaces)
{
  Sampled_surface s = lay(square(6, Faces::quads, 0), waves);
  const Curvatures alone = from_points(s.soup);
  const std::size_t n = s.soup.points.size();
  for (std::size_t v = 0; v < n; ++v) {
    const Triple p = s.soup.points[v];
    s.soup.points.push_back({p[0], p[1], p[2] + 1e-3}); // a second layer, closer than an edge
  }
  const std::size_t number_of_faces = s.soup.faces.size();
  for (std::size_t f = 0; f < number_of_faces; ++f) {
    Polygon face = s.soup.faces[f];
    for (std::size_t& v : face) v += n;
    s.soup.faces.push_back(face);
  }
  s.soup.points.push_back({0, 0, 0});
  const Curvatures c = from_points(s.soup);
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_EQ(c[v].mean, alone[v].mean);
    EXPECT_NEAR(c[n + v].mean, alone[v].mean, 1e-9);
  }
  EXPECT_FALSE(c.back().is_estimated);
  EXPECT_EQ(c.back().gaussian, 0);
  EXPECT_EQ(c.back().mean, 0);
  EXPECT_EQ(triple(c.back().minimal_direction), (Triple{0, 0, 0}));
  EXPECT_TRUE(from_points(Soup{}).empty());
}

TEST(Estimate_curvature, TooFewVertices)
{
  Soup triangle{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}};
  for (const Curvature& c : from_points(triangle)) EXPECT_FALSE(c.is_estimated);
  // its normals tell more, if it is not too large a part of the sphere
  triangle.points = {{0.8, 0, 0.6}, {0, 0.6, 0.8}, {0, 0, 1}};
  for (const Curvature& c : from_normals(triangle, triangle.points)) {
    EXPECT_NEAR(c.gaussian, 1, 1e-12);
    EXPECT_NEAR(c.mean, 1, 1e-12);
  }
  for (const Curvature& c : from_points(tetrahedron())) EXPECT_FALSE(c.is_estimated);
  // two rows of vertices do not tell how the surface bends across them
  Sampled_surface strip{{}, {}};
  for (double x = 0; x < 9; ++x)
    for (double y : {0., 1.}) {
      strip.exact.push_back(cylinder(y, 0.2 * x));
      strip.soup.points.push_back(strip.exact.back().point);
    }
  for (std::size_t i = 0; i < 8; ++i)
    strip.soup.faces.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2, 2 * i});
  for (const Curvature& c : from_points(strip.soup)) EXPECT_FALSE(c.is_estimated);
  EXPECT_LT(error(from_normals(strip.soup, normals_of(strip)), strip), 1e-12);
}

// Three rows determine a quadric, not a cubic: the error is of first order, the cylinder of any.
TEST(Estimate_curvature, ThreeRowsGiveAQuadric)
{
  double last = 0;
  for (double h : {0.1, 0.05, 0.025}) {
    Soup soup;
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t j = 0; j < 3; ++j) soup.points.push_back({h * double(i), h * double(j), 0});
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        soup.faces.push_back({3 * i + j, 3 * i + j + 3, 3 * i + j + 4, 3 * i + j + 1});
    const Sampled_surface s = lay(soup, waves);
    const double e = error(from_points(s.soup), s);
    EXPECT_LT(e, 2 * h);
    if (last != 0) {
      EXPECT_LT(1.7 * e, last);
    }
    last = e;
  }
}

TEST(Estimate_curvature, EdgesWithoutLengthAndFacesWithoutArea)
{
  Sampled_surface s = lay(square(16, Faces::triangles, 0), waves);
  const double before = error(from_points(s.soup), s);
  for (std::size_t v : {40u, 100u, 150u}) {
    s.soup.points[v] = s.soup.points[v + 1];
    s.exact[v] = s.exact[v + 1];
  }
  EXPECT_LT(error(from_points(s.soup), s), 2 * before);
  EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 2 * before);

  // all at one place, on a line, or folded back onto itself: no normal, nothing to fit
  for (const Triple& direction :
       {Triple{0, 0, 0}, Triple{1, 2, 3}, Triple{1 / 3., 1 / 7., 1 / 11.}}) {
    Soup soup = square(4, Faces::quads, 0);
    for (Triple& p : soup.points) {
      const double t = p[0] + 0.37 * p[1];
      p = {t * direction[0], t * direction[1], t * direction[2]};
    }
    for (const Curvature& c : from_points(soup)) EXPECT_FALSE(c.is_estimated);
    const std::vector<Triple> normals(soup.points.size(), Triple{0.6, 0, 0.8});
    for (const Curvature& c : from_normals(soup, normals)) EXPECT_FALSE(c.is_estimated);
  }
  const Soup folded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 2}}};
  for (const Curvature& c : from_points(folded)) EXPECT_FALSE(c.is_estimated);
}

// In a thin plate the vertices of the other side are near, but no neighbors.
TEST(Estimate_curvature, OtherSideOfAPlateIsLeftOut)
{
  constexpr std::size_t n = 6, side = n + 1;
  Soup soup = square(n, Faces::quads, 0);
  const std::vector<Polygon> top = soup.faces;
  for (std::size_t v = 0; v < side * side; ++v) {
    const Triple p = soup.points[v];
    soup.points.push_back({p[0], p[1], -0.02});
  }
  for (Polygon f : top) {
    for (std::size_t& v : f) v += side * side;
    std::reverse(f.begin(), f.end());
    soup.faces.push_back(f);
  }
  Polygon rim; // counterclockwise
  for (std::size_t i = 0; i < n; ++i) rim.push_back(i * side);
  for (std::size_t i = 0; i < n; ++i) rim.push_back(n * side + i);
  for (std::size_t i = n; i > 0; --i) rim.push_back(i * side + n);
  for (std::size_t i = n; i > 0; --i) rim.push_back(i);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t a = rim[i], b = rim[(i + 1) % rim.size()];
    soup.faces.push_back({b, a, a + side * side, b + side * side});
  }
  const Curvatures c = from_points(soup);
  for (std::size_t v = 0; v < side * side; ++v) {
    const std::size_t i = v / side, j = v % side;
    if (i == 0 || i == n || j == 0 || j == n) continue;
    ASSERT_TRUE(c[v].is_estimated);
    EXPECT_NEAR(c[v].minimal, 0, 1e-12);
    EXPECT_NEAR(c[v].maximal, 0, 1e-12);
  }
}

// Where there is no normal, the point counts and the faces tell the side; the vertex itself is estimated from points.
TEST(Estimate_curvature, MissingNormals)
{
  const Sampled_surface s = lay(square(12, Faces::mixed, 0.1), waves);
  const double of_points = error(from_points(s.soup), s);
  EXPECT_LT(2 * error(from_normals(s.soup, normals_of(s)), s), of_points);
  std::vector<Triple> n = normals_of(s);
  for (std::size_t v = 0; v < n.size(); v += 3) n[v] = {0, 0, 0};
  const Curvatures some = from_normals(s.soup, n);
  EXPECT_LT(error(some, s), 1.5 * of_points);
  for (std::size_t v = 0; v < n.size(); ++v)
    if (v % 3 != 0) {
      EXPECT_NEAR(some[v].mean, s.exact[v].mean, 0.5 * of_points);
    }
  n.assign(n.size(), Triple{0, 0, 0});
  EXPECT_LT(error(from_normals(s.soup, n), s), 1.5 * of_points);
}

// Gaussian curvatures of 1e400 and more
TEST(Estimate_curvature, CurvaturesOutOfRange)
{
  Sampled_surface s = lay(square(4, Faces::quads, 0), sphere);
  for (Triple& p : s.soup.points) p = {1e-200 * p[0], 1e-200 * p[1], 1e-200 * p[2]};
  for (const Curvatures& c : {from_points(s.soup), from_normals(s.soup, normals_of(s))})
    for (const Curvature& d : c) {
      EXPECT_FALSE(d.is_estimated);
      EXPECT_EQ(d.gaussian, 0);
      EXPECT_EQ(d.maximal, 0);
    }
}

TEST(Estimate_curvature, NumbersThatAreNotFiniteAreRefused)
{
  const Sampled_surface s = lay(square(3, Faces::quads, 0), waves);
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (bool in_normal : {false, true}) {
      Mesh mesh = mesh_of(s.soup);
      const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
      put_normals(normals_of(s), mesh, n);
      if (in_normal)
        n[Vertex(7)] = {0, bad, 1};
      else
        mesh.point(Vertex(7)) = {0, bad, 1};
      Curvature untouched;
      untouched.mean = 42;
      const auto c = mesh.add_property_map<Vertex, Curvature>("c", untouched).first;
      messages::expect_refused(
        [&] { PN::estimate_curvature(mesh, c, params::vertex_normal_map(n)); },
        {in_normal ? "normal of vertex 7" : "point of vertex 7"});
      for (Vertex v : mesh.vertices()) EXPECT_EQ(c[v].mean, 42);
    }
  }
}

TEST(Estimate_curvature, BowTiesAreRefused)
{
  Mesh mesh = mesh_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}}});
  mesh.add_face(Vertex(0), Vertex(3), Vertex(4));
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  EXPECT_THROW(PN::estimate_curvature(mesh, c), std::invalid_argument);
}

// --- types ---

TEST(Estimate_curvature, OtherMeshesKernelsAndMaps)
{
  const Sampled_surface s = lay(square(6, Faces::mixed, 0.2), waves);
  const Curvatures expected = from_points(s.soup);
  const auto expect_near = [&](const auto& c, double tolerance) {
    ASSERT_EQ(c.size(), expected.size());
    for (std::size_t v = 0; v < c.size(); ++v) {
      EXPECT_NEAR(c[v].mean, expected[v].mean, tolerance);
      const auto& d = c[v].minimal_direction;
      const Triple m{CGAL::to_double(d.x()), CGAL::to_double(d.y()), CGAL::to_double(d.z())};
      EXPECT_NEAR(std::abs(dot(m, triple(expected[v].minimal_direction))), 1, tolerance + 1e-14);
    }
  };
  {
    CGAL::Polyhedron_3<Kernel> mesh;
    build(s.soup, mesh);
    const auto c = get(CGAL::dynamic_vertex_property_t<Curvature>(), mesh);
    const auto& constant = mesh;
    PN::estimate_curvature(constant, c);
    expect_near(all_of(mesh, c), 0);
  }
  {
    using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
    CGAL::Surface_mesh<Epeck::Point_3> mesh;
    build(s.soup, mesh);
    const auto c =
      mesh.add_property_map<CGAL::SM_Vertex_index, PN::Vertex_curvature<Epeck>>("c").first;
    PN::estimate_curvature(mesh, c);
    expect_near(all_of(mesh, c), 1e-12);
  }
  {
    CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> mesh;
    build(s.soup, mesh);
    const auto c = mesh.add_property_map<CGAL::SM_Vertex_index, Curvature>("c").first;
    PN::estimate_curvature(mesh, c);
    expect_near(all_of(mesh, c), 1e-3);
  }
  {
    Mesh mesh;
    const auto p = mesh.add_property_map<Vertex, Kernel::Point_3>("p").first;
    build(s.soup, mesh, p);
    for (Vertex v : mesh.vertices()) mesh.point(v) = Kernel::Point_3(0, 0, 0);
    const Vertex removed = mesh.add_vertex({0, 0, 0});
    mesh.remove_vertex(removed); // garbage
    const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
    PN::estimate_curvature(mesh, c, params::vertex_point_map(p).geom_traits(Kernel()));
    expect_near(all_of(mesh, c), 0);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Estimate_curvature, IsTheSameInParallel)
{
  const Sampled_surface s = lay(square(70, Faces::mixed, 0.2), waves);
  const auto expect_same = [](const Curvatures& a, const Curvatures& b) {
    for (std::size_t v = 0; v < a.size(); ++v) {
      EXPECT_EQ(a[v].gaussian, b[v].gaussian);
      EXPECT_EQ(a[v].mean, b[v].mean);
      EXPECT_EQ(a[v].minimal_direction, b[v].minimal_direction);
    }
  };
  expect_same(from_points(mesh_of(s.soup)), from_points<CGAL::Parallel_tag>(mesh_of(s.soup)));
  expect_same(from_normals(s.soup, normals_of(s)),
              from_normals<CGAL::Parallel_tag>(s.soup, normals_of(s)));
}
#endif
