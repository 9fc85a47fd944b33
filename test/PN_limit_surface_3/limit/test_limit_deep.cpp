// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Normals of surfaces and tangents of curves where the tolerance cannot be met, however deep the rounds go.

#include "support/Options.h"
#include <CGAL/Gmpfr.h>
#include <CGAL/PN_curves/curve_limit_points.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;

using Triple = std::array<double, 3>;

double sine(const Triple& a, const Triple& b)
{
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];
  const double z = a[0] * b[1] - a[1] * b[0];
  const auto length = [](const Triple& v) { return std::hypot(v[0], v[1], v[2]); };
  return std::hypot(x, y, z) / (length(a) * length(b));
}

template <class Point_or_vector>
Triple triple(const Point_or_vector& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// A sphere about the origin: the normal of the surface is the direction of the limit point.
template <class FT>
struct Sphere
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;

  static FT root(const FT& x) { return FT(CGAL::sqrt(x)); }

  // a tetrahedron with the corners of a cube, or turned
  Sphere(const Vector& a_center, bool is_turned)
    : center(a_center)
  {
    const FT a = is_turned ? FT(3) / FT(5) : FT(1), b = is_turned ? FT(4) / FT(5) : FT(0);
    const FT c = is_turned ? FT(5) / FT(13) : FT(1), d = is_turned ? FT(12) / FT(13) : FT(0);
    for (const auto& [i, j, k] : {Integers{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}) {
      const FT x = a * FT(i) - b * FT(j), y = b * FT(i) + a * FT(j);
      const Vector n(x, c * y - d * FT(k), d * y + c * FT(k));
      const Vertex v = mesh.add_vertex(CGAL::ORIGIN + (n + center));
      normals[v] = n / root(n * n);
    }
    const Vertex v[] = {Vertex(0), Vertex(1), Vertex(2), Vertex(3)};
    mesh.add_face(v[0], v[1], v[2]);
    mesh.add_face(v[0], v[2], v[3]);
    mesh.add_face(v[0], v[3], v[1]);
    mesh.add_face(v[1], v[3], v[2]);
  }

  struct Error
  {
    double sine, claimed;
  };
  template <class Scheme>
  std::vector<Error> errors(const Scheme& scheme, unsigned depth)
  {
    test_options::Limit_options options;
    options.tolerance = options.normal_tolerance = 0;
    options.max_depth = depth;
    options.surface_normals = true;
    PN::limit_points(
      mesh, scheme, limits,
      PN::parameters::join(options.pack(), CGAL::parameters::vertex_normal_map(normals)));
    std::vector<Error> result;
    for (Vertex v : mesh.vertices())
      result.push_back(
        {sine(triple(limits[v].surface_normal), triple((limits[v].point - CGAL::ORIGIN) - center)),
         limits[v].normal_error});
    return result;
  }

  using Integers = std::array<int, 3>;
  Vector center;
  Mesh mesh;
  typename Mesh::template Property_map<Vertex, Vector> normals =
    mesh.template add_property_map<Vertex, Vector>("normals").first;
  typename Mesh::template Property_map<Vertex, PN::Limit_point<Kernel>> limits =
    mesh.template add_property_map<Vertex, PN::Limit_point<Kernel>>("limits").first;
};

constexpr unsigned depths[] = {1,  2,  3,  4,  5,  6,  8,  10, 12, 14, 17, 20,
                               23, 26, 30, 35, 40, 45, 50, 55, 60, 70, 85, 100};

// what is claimed is true, and as good as double can do
template <class FT>
void expect_true_claims(const typename Sphere<FT>::Vector& center, double least,
                        unsigned rounds = 0)
{
  for (const bool is_turned : {false, true}) {
    Sphere<FT> sphere(center, is_turned);
    PN::subdivide(sphere.mesh, PN::Loop_scheme(),
                  CGAL::parameters::vertex_normal_map(sphere.normals).number_of_iterations(rounds));
    for (const unsigned depth : depths)
      for (const auto& e : sphere.errors(PN::Loop_scheme(), depth)) {
        EXPECT_LE(e.sine, 2 * e.claimed + 1e-13) << depth;
        if (depth >= 20) {
          EXPECT_LE(e.claimed, least) << depth;
        }
      }
  }
}

TEST(Deep_surface_normals, OfASphereInDouble)
{
  expect_true_claims<double>({0, 0, 0}, 1e-12);
  expect_true_claims<double>({1000, 2000, -3000}, 1e-9);
  expect_true_claims<double>({0, 0, 0}, 1e-10, 2);
}

TEST(Deep_surface_normals, OfASphereInAHundredDigits)
{
  using FT = CGAL::Gmpfr;
  const auto old = FT::set_default_precision(333);
  expect_true_claims<FT>({FT(0), FT(0), FT(0)}, 1e-12);
  FT::set_default_precision(old);
}

// normals that are not those of a sphere: the one of depth 100 is as good as the best
TEST(Deep_surface_normals, OfAnUnevenMeshStayAtTheBest)
{
  Sphere<double> uneven({0, 0, 0}, true);
  uneven.mesh.point(Sphere<double>::Vertex(1)) = {2, -0.5, -1};
  Sphere<long double> precise({0, 0, 0}, true);
  precise.mesh.point(Sphere<long double>::Vertex(1)) = {2, -0.5, -1};
  const auto first = Sphere<double>::Vertex(0);
  const auto best_first = Sphere<long double>::Vertex(0);
  precise.errors(PN::Loop_scheme(), 17);
  for (const unsigned depth : {20u, 30u, 40u, 60u, 100u}) {
    uneven.errors(PN::Loop_scheme(), depth);
    const auto& l = uneven.limits[first];
    EXPECT_LE(sine(triple(l.surface_normal), triple(precise.limits[best_first].surface_normal)),
              2 * l.normal_error + 1e-11)
      << depth;
    EXPECT_LE(l.normal_error, 1e-9) << depth;
  }
}

// --- curves ---

// the tangent of a circle about the origin is perpendicular to the limit point
template <class FT>
void expect_true_tangents(double least)
{
  using K = CGAL::Simple_cartesian<FT>;
  std::vector<std::pair<typename K::Point_2, typename K::Vector_2>> polygon;
  for (const auto& [p, q, r] :
       {std::array<int, 3>{3, 4, 5}, {-5, 12, 13}, {-15, -8, 17}, {7, -24, 25}}) {
    const FT x = FT(p) / FT(r), y = FT(q) / FT(r);
    polygon.emplace_back(typename K::Point_2(x, y), typename K::Vector_2(x, y));
  }
  test_options::Curve_limit_options options;
  options.tolerance = options.normal_tolerance = 0;
  options.curve_normals = true;
  for (const unsigned depth : depths) {
    options.max_depth = depth;
    const auto limits =
      PN::curve_limit_points(polygon, PN::B_spline_mask(3), PN::Curve_end::closed, options.pack())
        .first;
    for (const auto& l : limits) {
      const double x = CGAL::to_double(l.point.x()), y = CGAL::to_double(l.point.y());
      const double cosine = CGAL::to_double(l.tangent.x()) * x + CGAL::to_double(l.tangent.y()) * y;
      EXPECT_LE(std::abs(cosine) / std::hypot(x, y), 2 * l.tangent_error + 1e-13) << depth;
      if (depth >= 20) {
        EXPECT_LE(l.tangent_error, least) << depth;
      }
    }
  }
}

TEST(Deep_tangents, OfACircleInDouble)
{
  expect_true_tangents<double>(1e-9);
}

TEST(Deep_tangents, OfACircleInAHundredDigits)
{
  using FT = CGAL::Gmpfr;
  const auto old = FT::set_default_precision(333);
  expect_true_tangents<FT>(1e-12);
  FT::set_default_precision(old);
}

} // namespace
