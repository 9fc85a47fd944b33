// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits have the precision of the number type: masks from the literature, in 300 bits and in intervals.

#include "Extent.h"
#include "Messages.h"
#include "Test_meshes.h"
#include "support/Options.h"

#include <CGAL/Gmpfr.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_curves/curve_limit_points.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using test_meshes::Cells;
using test_meshes::Control_mesh;

// Gmpfr with 300 bits
class Limit_precision : public testing::Test
{
protected:
  using FT = CGAL::Gmpfr;
  static constexpr int bits = 300;

  Limit_precision()
    : old_(FT::set_default_precision(bits))
  {}
  ~Limit_precision() override { FT::set_default_precision(old_); }

private:
  FT::Precision_type old_;
};

CGAL::Gmpfr power_of_two(int exponent)
{
  CGAL::Gmpfr x(1);
  for (; exponent < 0; ++exponent) x /= 2;
  return x;
}

// 2 cos(2 pi / n) by its minimal polynomial, with Newton's iteration from double: no trigonometry
CGAL::Gmpfr twice_cosine(int n)
{
  using FT = CGAL::Gmpfr;
  const std::vector<int> polynomial = n == 5   ? std::vector<int>{-1, 1, 1} // x^2 + x - 1
                                      : n == 7 ? std::vector<int>{-1, -2, 1, 1}
                                               // x^3 + x^2 - 2x - 1
                                               : std::vector<int>{1, -3, 0, 1}; // 9: x^3 - 3x + 1
  FT x(2 * std::cos(2 * std::acos(-1.) / n));
  for (int step = 0; step < 8; ++step) {
    FT value(0), slope(0);
    for (std::size_t i = polynomial.size(); i-- > 0;) {
      slope = slope * x + value;
      value = value * x + FT(polynomial[i]);
    }
    x -= value / slope;
  }
  return x;
}

template <class FT>
struct Star
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Vertex = typename Mesh::Vertex_index;

  // the x of vertex i is 1 if i is `one`
  Star(int valence, Cells cells, std::size_t one)
  {
    const Control_mesh control = test_meshes::star(valence, 2, cells);
    for (std::size_t i = 0; i < control.points.size(); ++i)
      mesh.add_vertex({FT(i == one ? 1 : 0), FT(0), FT(0)});
    for (const auto& face : control.faces) {
      std::vector<Vertex> corners;
      for (int v : face) corners.emplace_back(static_cast<typename Vertex::size_type>(v));
      mesh.add_face(corners);
    }
  }

  // the weight of vertex `one` in the limit mask of vertex 0
  template <class Scheme>
  FT weight(const Scheme& scheme)
  {
    using Limit = PN::Limit_point<Kernel>;
    const auto map = mesh.template add_property_map<Vertex, Limit>("limit").first;
    PN::limit_points(mesh, PN::linear(scheme), map);
    return map[Vertex(0)].point.x();
  }

  Mesh mesh;
};

// of vertex 0 and its first neighbor: vertex 1 of the star
template <class FT, class Scheme>
std::pair<FT, FT> weights(const Scheme& scheme, int valence, Cells cells)
{
  return {Star<FT>(valence, cells, 0).weight(scheme), Star<FT>(valence, cells, 1).weight(scheme)};
}

void expect_weights(const std::pair<CGAL::Gmpfr, CGAL::Gmpfr>& w, const CGAL::Gmpfr& vertex,
                    const CGAL::Gmpfr& neighbor, int valence)
{
  const CGAL::Gmpfr tolerance = power_of_two(-295);
  EXPECT_LE(CGAL::abs(w.first - vertex), tolerance) << valence;
  EXPECT_LE(CGAL::abs(w.second - neighbor), tolerance) << valence;
}

// 2 cos(2 pi / n)
CGAL::Gmpfr twice_any_cosine(int n)
{
  return n == 3   ? CGAL::Gmpfr(-1)
         : n == 4 ? CGAL::Gmpfr(0)
         : n == 6 ? CGAL::Gmpfr(1)
                  : twice_cosine(n);
}

// alpha / (3/8 + alpha), alpha = 5/8 - (3 + 2 cos)^2 / 64, is the weight of all neighbors
TEST_F(Limit_precision, OfLoop)
{
  for (const int n : {3, 4, 5, 6, 7, 9}) {
    const FT a = FT(3) + twice_any_cosine(n), alpha = FT(5) / FT(8) - a * a / FT(64);
    const FT all = alpha / (FT(3) / FT(8) + alpha);
    expect_weights(weights<FT>(PN::Loop_scheme(), n, Cells::triangles), FT(1) - all, all / FT(n),
                   n);
  }
}

TEST_F(Limit_precision, OfCatmullClark)
{
  for (const int n : {3, 4, 5, 7})
    expect_weights(weights<FT>(PN::CatmullClark_scheme(), n, Cells::quads), FT(n) / FT(n + 5),
                   FT(4) / FT(n * (n + 5)), n);
}

template <class FT>
using Polygon_of = std::vector<
  std::pair<CGAL::Point_2<CGAL::Simple_cartesian<FT>>, CGAL::Vector_2<CGAL::Simple_cartesian<FT>>>>;

// 0, ..., 0, 1, 0, ..., 0
template <class FT>
Polygon_of<FT> unit_polygon()
{
  using K = CGAL::Simple_cartesian<FT>;
  Polygon_of<FT> polygon;
  for (int i = 0; i < 9; ++i)
    polygon.emplace_back(typename K::Point_2(FT(i == 4 ? 1 : 0), FT(i)),
                         typename K::Vector_2(0, 1));
  return polygon;
}

// (1, 4, 1)/6
TEST_F(Limit_precision, OfTheCubicBSpline)
{
  test_options::Curve_limit_options options;
  options.tolerance = 1e-40;
  const auto limits = PN::curve_limit_points(unit_polygon<FT>(), PN::linear(PN::B_spline_mask(3)),
                                             PN::Curve_end::closed, options.pack())
                        .first;
  const FT tolerance = power_of_two(-295);
  for (int i = 0; i < 9; ++i) {
    const FT weight = i == 4 ? FT(2) / FT(3) : i == 3 || i == 5 ? FT(1) / FT(6) : FT(0);
    const auto& l = limits[static_cast<std::size_t>(i)];
    EXPECT_LE(CGAL::abs(l.point.x() - weight), tolerance) << i;
  }
}

// the transfer of curvature leaves spheres as they are: the limits of the neighbors of an apex of valence 5
TEST_F(Limit_precision, OfSchemesThatTransferCurvature)
{
  using K = CGAL::Simple_cartesian<FT>;
  using Mesh = CGAL::Surface_mesh<K::Point_3>;
  Mesh mesh;
  auto normals = mesh.add_property_map<Mesh::Vertex_index, K::Vector_3>("n").first;
  const auto limits = mesh.add_property_map<Mesh::Vertex_index, PN::Limit_point<K>>("limit").first;
  using Quadruple = std::array<int, 4>; // x, y, z, length
  for (const auto& [x, y, z, length] :
       {Quadruple{0, 0, 1, 1}, Quadruple{3, 4, 0, 5}, Quadruple{-7, 24, 0, 25},
        Quadruple{-12, -5, 0, 13}, Quadruple{0, -1, 0, 1}, Quadruple{15, -8, 0, 17},
        Quadruple{0, 0, -1, 1}}) {
    const K::Vector_3 n(FT(x) / FT(length), FT(y) / FT(length), FT(z) / FT(length));
    normals[mesh.add_vertex(CGAL::ORIGIN + n)] = n;
  }
  const auto v = [](int i) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(i)); };
  for (int i = 0; i < 5; ++i) {
    mesh.add_face(v(0), v(1 + i), v(1 + (i + 1) % 5));
    mesh.add_face(v(6), v(1 + (i + 1) % 5), v(1 + i));
  }
  test_options::Limit_options options;
  options.max_depth = 4;
  PN::limit_points(
    mesh, PN::Loop_scheme::Transfer(), limits,
    PN::parameters::join(options.pack(), CGAL::parameters::vertex_normal_map(normals)));
  for (const auto u : mesh.vertices()) {
    const K::Vector_3 p = limits[u].point - CGAL::ORIGIN;
    EXPECT_LE(CGAL::abs(FT(p * p - FT(1))), power_of_two(-285));
  }
}

// --- intervals ---

using Interval = CGAL::Interval_nt<true>;

void expect_around(const Interval& x, const CGAL::Gmpfr& exact, double width)
{
  EXPECT_LE(CGAL::Gmpfr(x.inf()), exact);
  EXPECT_GE(CGAL::Gmpfr(x.sup()), exact);
  EXPECT_LE(x.sup() - x.inf(), width);
}

// 1/5 of a tetrahedron's other vertices
TEST_F(Limit_precision, IntervalsContainTheLimitsOfLinearSchemes)
{
  for (const int n : {3, 4, 5, 7, 9}) {
    const FT a = FT(3) + twice_any_cosine(n), alpha = FT(5) / FT(8) - a * a / FT(64);
    const FT all = alpha / (FT(3) / FT(8) + alpha);
    const auto loop = weights<Interval>(PN::Loop_scheme(), n, Cells::triangles);
    expect_around(loop.first, FT(1) - all, 1e-14);
    expect_around(loop.second, all / FT(n), 1e-14);
  }
  const auto cubic = PN::curve_limit_points(unit_polygon<Interval>(),
                                            PN::linear(PN::B_spline_mask(3)), PN::Curve_end::closed)
                       .first;
  expect_around(cubic[3].point.x(), FT(1) / FT(6), 1e-15);
  expect_around(cubic[4].point.x(), FT(2) / FT(3), 1e-15);
}

// they would be intervals around an estimate
TEST(Limits_in_intervals, OfPointNormalSchemesAreRefused)
{
  using Star_of_intervals = Star<Interval>;
  Star_of_intervals star(5, Cells::triangles, 0);
  const auto map =
    star.mesh
      .add_property_map<Star_of_intervals::Vertex, PN::Limit_point<Star_of_intervals::Kernel>>(
        "limit")
      .first;
  const auto normals =
    star.mesh
      .add_property_map<Star_of_intervals::Vertex, Star_of_intervals::Kernel::Vector_3>("n",
                                                                                        {0, 0, 1})
      .first;
  const auto expect_refused = [](const auto& call) {
    messages::expect_refused(call, {"linear()"});
  };
  const auto np = CGAL::parameters::vertex_normal_map(normals);
  expect_refused([&] { PN::limit_points(star.mesh, PN::Loop_scheme(), map, np); });
  expect_refused([&] {
    PN::curve_limit_points(unit_polygon<Interval>(), PN::B_spline_mask(3), PN::Curve_end::closed);
  });
  // interpolatory ones keep the points
  EXPECT_NO_THROW(PN::limit_points(star.mesh, PN::Butterfly_scheme(), map, np));
}

} // namespace
