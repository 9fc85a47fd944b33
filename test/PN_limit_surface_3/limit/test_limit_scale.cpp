// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Surface normals: on the side of the faces around, whatever the side of the control normals; limits of meshes of any
// scale are those of the mesh at scale 1, bit for bit.

#include "Extent.h"
#include "support/Options.h"
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;

template <class FT>
struct Shape
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  using Limit = PN::Limit_point<Kernel>;

  // a bent box, of quads or triangles, without its last face if it is open
  Shape(bool is_triangles, int exponent, double side, bool is_open = false)
  {
    normals = mesh.template add_property_map<Vertex, Vector>("v:normal", CGAL::NULL_VECTOR).first;
    for (int i = 0; i < 8; ++i) {
      const double x = i % 4 == 0 || i % 4 == 3 ? -1 : 1.25, y = i % 4 < 2 ? -1 : 1.125,
                   z = i < 4 ? -1 : 1 + 0.0625 * i;
      const Vertex v =
        mesh.add_vertex(Point(scaled(x, exponent), scaled(y, exponent), scaled(z, exponent)));
      const double length = std::sqrt(x * x + y * y + z * z) * side;
      normals[v] = Vector(FT(x / length), FT(y / length), FT(z / length));
    }
    const std::array<std::array<unsigned, 4>, 6> faces = {
      {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    for (std::size_t f = 0; f < (is_open ? 5u : 6u); ++f) {
      const auto v = [&](std::size_t i) { return Vertex(faces[f][i]); };
      if (is_triangles) {
        mesh.add_face(v(0), v(1), v(2));
        mesh.add_face(v(0), v(2), v(3));
      } else
        mesh.add_face(v(0), v(1), v(2), v(3));
    }
  }
  static FT scaled(double x, int exponent) { return FT(std::ldexp(x, exponent)); }

  Mesh mesh;
  typename Mesh::template Property_map<Vertex, Vector> normals;
};

test_options::Limit_options surface_normals()
{
  test_options::Limit_options options;
  options.surface_normals = options.curvatures = true;
  return options;
}

template <class FT, class Scheme>
std::vector<typename Shape<FT>::Limit> limits(Shape<FT>& s, const Scheme& scheme)
{
  const auto map =
    s.mesh
      .template add_property_map<typename Shape<FT>::Vertex, typename Shape<FT>::Limit>("v:limit")
      .first;
  PN::limit_points(
    s.mesh, scheme, map,
    PN::parameters::join(surface_normals().pack(), np::vertex_normal_map(s.normals)));
  std::vector<typename Shape<FT>::Limit> result;
  for (const auto v : s.mesh.vertices()) result.push_back(map[v]);
  return result;
}

// Heights do not change if all normals are turned round: the surface is the same.
template <class Scheme>
void expect_normals_of_the_faces(const char* name, bool is_triangles, const Scheme& scheme)
{
  for (const bool is_open : {false, true}) {
    Shape<double> outwards(is_triangles, 0, 1, is_open), inwards(is_triangles, 0, -1, is_open);
    const auto a = limits(outwards, scheme), b = limits(inwards, scheme);
    for (std::size_t v = 0; v < a.size(); ++v) {
      ASSERT_EQ(a[v].has_surface_normal, b[v].has_surface_normal);
      if (!a[v].has_surface_normal) continue;
      const auto p = outwards.mesh.point(CGAL::SM_Vertex_index(unsigned(v))) - CGAL::ORIGIN;
      EXPECT_GT(a[v].surface_normal * p, 0) << name << ' ' << v;
      EXPECT_GT(b[v].surface_normal * p, 0) << name << ' ' << v;
      EXPECT_NEAR(std::sqrt((a[v].surface_normal - b[v].surface_normal).squared_length()), 0,
                  1e-12);
    }
  }
}

} // namespace

TEST(Limit_normals, AreOnTheSideOfTheFaces)
{
  expect_normals_of_the_faces("catmull-clark", false, PN::CatmullClark_scheme());
  expect_normals_of_the_faces("loop", true, PN::Loop_scheme());
}

// a vertex of one face, of a bent grid whose control normals look inwards
TEST(Limit_normals, OfCornersAreOnTheSideOfTheFace)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Vertex = Mesh::Vertex_index;
  Mesh mesh;
  const auto normals =
    mesh.add_property_map<Vertex, CGAL::Simple_cartesian<double>::Vector_3>("v:normal", {0, 0, -1})
      .first;
  for (int i = 0; i < 9; ++i) mesh.add_vertex({i % 3 - 1., i / 3 - 1., -0.1 * (i % 3) * (i / 3)});
  for (const unsigned i : {0u, 1u, 3u, 4u})
    mesh.add_face(Vertex(i), Vertex(i + 1), Vertex(i + 4), Vertex(i + 3));
  const auto of_limits = mesh.add_property_map<Vertex, Shape<double>::Limit>("v:limit").first;
  PN::limit_points(mesh, PN::Kobbelt_scheme(), of_limits,
                   PN::parameters::join(surface_normals().pack(), np::vertex_normal_map(normals)));
  for (const unsigned corner : {0u, 2u, 6u, 8u}) {
    ASSERT_TRUE(of_limits[Vertex(corner)].has_surface_normal);
    EXPECT_GT(of_limits[Vertex(corner)].surface_normal.z(), 0) << corner;
  }
}

TEST(Limit_normals, OfFacesAreOnTheirSide)
{
  Shape<double> s(false, 0, -1);
  using Face = Shape<double>::Mesh::Face_index;
  const auto map = s.mesh.add_property_map<Face, Shape<double>::Limit>("f:limit").first;
  PN::limit_points(
    s.mesh, PN::DooSabin_scheme(), map,
    PN::parameters::join(surface_normals().pack(), np::vertex_normal_map(s.normals)));
  for (const Face f : s.mesh.faces()) {
    ASSERT_TRUE(map[f].has_surface_normal);
    EXPECT_GT(map[f].surface_normal * (map[f].point - CGAL::ORIGIN), 0) << f;
  }
}

// in the wedges of creases, whose control normals look inwards
TEST(Limit_normals, OfWedgesAreOnTheSideOfTheirFaces)
{
  using S = Shape<double>;
  S s(false, 0, -1);
  const auto sharp = s.mesh.add_property_map<S::Mesh::Edge_index, bool>("e:sharp", false).first;
  for (const auto h : s.mesh.halfedges_around_face(s.mesh.halfedge(S::Mesh::Face_index(1))))
    sharp[s.mesh.edge(h)] = true;
  const auto normals =
    s.mesh.add_property_map<S::Mesh::Halfedge_index, S::Vector>("h:normal", CGAL::NULL_VECTOR)
      .first;
  for (const auto h : s.mesh.halfedges()) normals[h] = s.normals[s.mesh.target(h)];
  PN::subdivide(s.mesh, PN::linear(PN::CatmullClark_scheme()),
                np::edge_is_constrained_map(sharp).number_of_iterations(2));
  for (const auto h : s.mesh.halfedges()) {
    const S::Vector n = CGAL::ORIGIN - s.mesh.point(s.mesh.target(h));
    normals[h] = n / std::sqrt(n.squared_length());
  }
  test_options::Limit_options options;
  options.surface_normals = true;
  PN::subdivide_to_limit(
    s.mesh, PN::CatmullClark_scheme(),
    PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                         np::edge_is_constrained_map(sharp).vertex_normal_map(normals)));
  int smooth = 0;
  for (const auto v : s.mesh.vertices()) {
    int creases = 0;
    for (const auto h : s.mesh.halfedges_around_target(s.mesh.halfedge(v)))
      creases += sharp[s.mesh.edge(h)];
    if (creases != 0) continue;
    ++smooth;
    EXPECT_GT(normals[s.mesh.halfedge(v)] * (s.mesh.point(v) - CGAL::ORIGIN), 0) << v;
  }
  EXPECT_GT(smooth, 40);
}

// --- scale ---

template <class FT, class Scheme>
void expect_scaled(const char* name, bool is_triangles, const Scheme& scheme,
                   const std::vector<int>& exponents)
{
  for (const bool is_open : {false, true}) {
    Shape<FT> one(is_triangles, 0, 1, is_open);
    const auto expected = limits(one, scheme);
    for (const int e : exponents) {
      Shape<FT> s(is_triangles, e, 1, is_open);
      const auto result = limits(s, scheme);
      for (std::size_t v = 0; v < result.size(); ++v) {
        for (int k = 0; k < 3; ++k)
          ASSERT_EQ(result[v].point[k], std::ldexp(expected[v].point[k], e)) << name << e;
        ASSERT_EQ(result[v].control_normal, expected[v].control_normal) << name << e;
        ASSERT_EQ(result[v].has_surface_normal, expected[v].has_surface_normal) << name << e;
        ASSERT_EQ(result[v].surface_normal, expected[v].surface_normal) << name << e;
        ASSERT_EQ(result[v].normal_error, expected[v].normal_error) << name << e;
        ASSERT_EQ(result[v].error, std::ldexp(expected[v].error, e)) << name << e;
        if (std::abs(e) > 500 || !result[v].has_curvature) continue; // squares are no numbers
        ASSERT_EQ(result[v].mean, std::ldexp(expected[v].mean, -e)) << name << e;
        ASSERT_EQ(result[v].gaussian, std::ldexp(expected[v].gaussian, -2 * e)) << name << e;
      }
    }
  }
}

TEST(Limits_at_any_scale, InDouble)
{
  const std::vector<int> exponents = {-600, -515, -300, -100, -1, 100, 300, 515, 600, 900};
  expect_scaled<double>("CatmullClark", false, PN::CatmullClark_scheme(), exponents);
  expect_scaled<double>("linear CatmullClark", false, PN::linear(PN::CatmullClark_scheme()),
                        exponents);
  expect_scaled<double>("Loop", true, PN::Loop_scheme(), exponents);
  expect_scaled<double>("ct_Loop", true, PN::Loop_scheme::Transfer(), exponents);
}

TEST(Limits_at_any_scale, InFloat)
{
  long_test([](auto) {
    const std::vector<int> exponents = {-80, -60, -30, 30, 60, 100};
    expect_scaled<float>("Loop", true, PN::Loop_scheme(), exponents);
    expect_scaled<float>("ct_Loop", true, PN::Loop_scheme::Transfer(), exponents);
  });
}
