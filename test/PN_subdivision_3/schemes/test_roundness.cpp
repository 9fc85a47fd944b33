// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// p = q + w H n: with roundness of the vertices a round lies between the linear one and the point-normal one.

#include "Extent.h"
#include "Messages.h"
#include "Scheme_runs.h"
#include "Schemes.h"
#include "support/Options.h"

#include <CGAL/Gmpq.h>
#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>

namespace PN = CGAL::PN_subdivision_3;

namespace {

using test_meshes::Control_mesh;
using Roundness_map = Surface_mesh::Property_map<Surface_mesh::Vertex_index, double>;

Roundness_map roundness_map(Surface_mesh& mesh, double initial = 0.5)
{
  return mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:roundness", initial).first;
}

// fractions of 64, 0 and 1 among them
Roundness_map uneven_roundness(Surface_mesh& mesh)
{
  std::mt19937 random(7);
  const Roundness_map map = roundness_map(mesh);
  for (auto v : mesh.vertices()) map[v] = double(random() % 65) / 64;
  return map;
}

template <class Description, class Tag = CGAL::Sequential_tag>
void refine_with_roundness(Surface_mesh& mesh, unsigned rounds)
{
  PN::subdivide<Tag>(mesh, Description::scheme(),
                     PN::parameters::vertex_roundness_map(roundness_map(mesh))
                       .number_of_iterations(rounds)
                       .vertex_normal_map(normal_map(mesh)));
}

template <class Description>
void refine_with_constant(Surface_mesh& mesh, double w, unsigned rounds)
{
  PN::subdivide(
    mesh, Description::scheme(),
    PN::parameters::roundness(w).number_of_iterations(rounds).vertex_normal_map(normal_map(mesh)));
}

void expect_same_points(const Surface_mesh& a, const Surface_mesh& b, const std::string& what)
{
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices()) << what;
  for (auto v : a.vertices()) ASSERT_EQ(a.point(v), b.point(v)) << what << ", vertex " << v.idx();
}

template <class Description>
class Roundness : public testing::Test
{};
TYPED_TEST_SUITE(Roundness, Schemes, Scheme_names);

// The dense rows of the literature: w is refined by those of the points, and scales the height alone.
TYPED_TEST(Roundness, IsThatOfDenseRows)
{
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    Surface_mesh mesh = to_surface_mesh(control);
    const Roundness_map map = uneven_roundness(mesh);
    const reference::Face_list list = face_list(mesh);
    const reference::Values old = result_of(mesh).values;
    std::vector<reference::Real> w_of_old;
    for (auto v : mesh.vertices()) w_of_old.push_back(map[v]);
    const reference::Matrix rows = TypeParam::refine(list, 1).weights(list.number_of_vertices());
    const reference::Values linear = reference::linear_round(rows, old);
    const reference::Values round = reference::pn_round(rows, old);
    refine_with_roundness<TypeParam>(mesh, 1);
    const double size = size_of(old);
    ASSERT_EQ(mesh.number_of_vertices(), linear.points.size()) << control.name;
    for (auto v : mesh.vertices()) {
      const std::size_t i = v.idx();
      reference::Real w = 0;
      for (std::size_t j = 0; j < w_of_old.size(); ++j)
        w += rows(Eigen::Index(i), Eigen::Index(j)) * w_of_old[j];
      ASSERT_NEAR(double(w), roundness_map(mesh)[v], 1e-14) << control.name << ", vertex " << i;
      const reference::Vector p = linear.points[i] + w * (round.points[i] - linear.points[i]);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(double(p[c]), mesh.point(v)[c], 1e-12 * size)
          << control.name << ", vertex " << i;
    }
  }
}

TYPED_TEST(Roundness, OfOneIsTheSchemeAndOfZeroItsLinearTwinBitForBit)
{
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    const Surface_mesh mesh = to_surface_mesh(control);
    Surface_mesh round = mesh, linear = mesh, one = mesh, zero = mesh, ones = mesh;
    refine<TypeParam>(round, 2);
    refine_linearly<TypeParam>(linear, 2);
    refine_with_constant<TypeParam>(one, 1, 2);
    refine_with_constant<TypeParam>(zero, 0, 2);
    roundness_map(ones, 1);
    refine_with_roundness<TypeParam>(ones, 2);
    expect_same_points(round, one, control.name + " (1)");
    expect_same_points(round, ones, control.name + " (map of 1)");
    expect_same_points(linear, zero, control.name + " (0)");
    for (auto v : round.vertices()) {
      ASSERT_EQ(normal_map(round)[v], normal_map(one)[v]) << control.name;
      if (TypeParam::is_linear_for_equal_normals) { // others make normals of points
        ASSERT_EQ(normal_map(round)[v], normal_map(zero)[v]) << control.name;
      }
      ASSERT_EQ(roundness_map(ones)[v], 1) << control.name;
    }
  }
}

TYPED_TEST(Roundness, OfOneIsTheSchemeAtTheLimitBitForBit)
{
  if constexpr (TypeParam::is_primal)
    for (const Control_mesh& control : meshes_for<TypeParam>()) {
      if (control.faces.empty()) continue;
      Surface_mesh round = to_surface_mesh(control), ones = round;
      const auto np = [](Surface_mesh& m) {
        return CGAL::parameters::number_of_iterations(1).vertex_normal_map(normal_map(m));
      };
      PN::subdivide_to_limit(round, TypeParam::scheme(), np(round));
      PN::subdivide_to_limit(
        ones, TypeParam::scheme(),
        PN::parameters::join(PN::parameters::vertex_roundness_map(roundness_map(ones, 1)),
                             np(ones)));
      expect_same_points(round, ones, control.name);
      for (auto v : round.vertices()) ASSERT_EQ(roundness_map(ones)[v], 1) << control.name;
    }
  else
    GTEST_SKIP() << "does not apply: its limits are those of faces";
}

TYPED_TEST(Roundness, GoesFromCallToCallByItsMap)
{
  if constexpr (TypeParam::composes_single_rounds)
    for (const Control_mesh& control : meshes_for<TypeParam>()) {
      Surface_mesh once = to_surface_mesh(control);
      uneven_roundness(once);
      Surface_mesh twice = once;
      refine_with_roundness<TypeParam>(once, 2);
      for (int k = 0; k < 2; ++k) refine_with_roundness<TypeParam>(twice, 1);
      expect_same_points(once, twice, control.name);
      for (auto v : once.vertices()) ASSERT_EQ(roundness_map(once)[v], roundness_map(twice)[v]);
    }
  else
    GTEST_SKIP() << "does not apply: the rules depend on the round";
}

template <class Description>
void expect_composition(const Control_mesh& control, bool has_normals)
{
  Surface_mesh mesh = to_surface_mesh(control);
  uneven_roundness(mesh);
  const auto run = [&](const auto& np) {
    Surface_mesh plain = mesh;
    const auto scheme = Description::scheme();
    const auto with_map = [&](Surface_mesh& m) {
      return PN::parameters::join(PN::parameters::vertex_roundness_map(roundness_map(m)), np(m));
    };
    PN::subdivide(plain, scheme, with_map(plain));
    if constexpr (!PN::internal::Has_curvature_transfer<std::decay_t<decltype(scheme)>>::value) {
      const PN::Surface_refiner refiner(mesh, scheme, with_map(mesh));
      ASSERT_EQ(refiner.points().size(), plain.number_of_vertices());
      for (auto v : plain.vertices())
        ASSERT_EQ(plain.point(v), refiner.points()[v.idx()]) << control.name << ", refiner";
    }
    if constexpr (PN::splits_edges_v<std::decay_t<decltype(scheme)>>) {
      const PN::Surface_pieces pieces(
        mesh, scheme, PN::parameters::join(PN::parameters::number_of_pieces(3), with_map(mesh)));
      for (std::size_t k = 0; k < pieces.number_of_pieces(); ++k) {
        const auto piece = pieces.piece(k);
        for (std::size_t i = 0; i < piece.number_of_vertices(); ++i) {
          const Surface_mesh::Vertex_index v(
            static_cast<Surface_mesh::size_type>(piece.vertex_number(i)));
          ASSERT_EQ(plain.point(v), piece.points()[i]) << control.name << ", piece";
        }
      }
    }
    if constexpr (Description::is_primal) {
      Surface_mesh at_limit = mesh;
      const auto at_once = PN::subdivide_to_limit(at_limit, scheme, with_map(at_limit));
      test_options::Limit_options later;
      later.rounds_done = 2;
      normal_map(plain); // of the refined mesh
      if (has_normals) {
        PN::subdivide_to_limit(
          plain, scheme,
          PN::parameters::join(CGAL::parameters::number_of_iterations(0), later.pack(),
                               PN::parameters::vertex_roundness_map(roundness_map(plain))
                                 .vertex_normal_map(normal_map(plain))));
        double largest = 0;
        for (auto v : plain.vertices())
          largest = (std::max)(largest, CGAL::squared_distance(plain.point(v), at_limit.point(v)));
        EXPECT_EQ(largest, 0) << control.name << ", limit";
        EXPECT_LE(at_once.error, at_once.tolerance) << control.name;
      }
    }
  };
  if (has_normals)
    run([](Surface_mesh& m) {
      return CGAL::parameters::number_of_iterations(2).vertex_normal_map(normal_map(m));
    });
  else
    run([](Surface_mesh&) { return CGAL::parameters::number_of_iterations(2); });
}

TYPED_TEST(Roundness, IsTheSameInRefinersAndPiecesAndAtTheLimit)
{
  std::size_t k = 0;
  for (const Control_mesh& control : meshes_for<TypeParam>())
    if (k++ % 4 == 0 && !control.faces.empty()) {
      expect_composition<TypeParam>(control, true);
      expect_composition<TypeParam>(control, false);
    }
}

// Along creases, too: roundness is refined as the linear twin refines a coordinate, and scales what is beside q.
template <class Description>
void expect_roundness_beside_creases(const Control_mesh& control)
{
  Surface_mesh mesh = to_surface_mesh(control);
  uneven_roundness(mesh);
  const auto sharp = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  for (auto e : mesh.edges()) sharp[e] = e.idx() % 3 != 2;
  Surface_mesh linear = mesh, round = mesh, number = mesh;
  for (auto v : mesh.vertices()) number.point(v) = Kernel::Point_3(roundness_map(mesh)[v], 0, 0);
  const auto edges = [](Surface_mesh& m) {
    return CGAL::parameters::edge_is_constrained_map(
      m.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp").first);
  };
  const auto scheme = Description::scheme();
  PN::subdivide(linear, PN::linear(scheme), edges(linear));
  PN::subdivide(number, PN::linear(scheme), edges(number));
  PN::subdivide(round, scheme, edges(round).vertex_normal_map(normal_map(round)));
  PN::subdivide(mesh, scheme,
                PN::parameters::join(PN::parameters::vertex_roundness_map(roundness_map(mesh)),
                                     edges(mesh).vertex_normal_map(normal_map(mesh))));
  for (auto v : mesh.vertices()) {
    const double w = number.point(v).x();
    ASSERT_NEAR(roundness_map(mesh)[v], w, 1e-14) << control.name << ", vertex " << v.idx();
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(mesh.point(v)[c],
                  linear.point(v)[c] + w * (round.point(v)[c] - linear.point(v)[c]), 1e-12)
        << control.name << ", vertex " << v.idx();
  }
}

TEST(Roundness_of_values, IsRefinedAlongCreases)
{
  for (const Control_mesh& control : test_meshes::all()) {
    expect_roundness_beside_creases<CatmullClark_description>(control);
    if (takes<Loop_description>(control))
      expect_roundness_beside_creases<Loop_description>(control);
  }
}

Surface_mesh bipyramid_in_quads(int n)
{
  Control_mesh control = test_meshes::in_quads(test_meshes::bipyramid(n));
  test_meshes::set_wild_normals(control, 5);
  return to_surface_mesh(control);
}

TEST(Roundness_of_values, OutsideOfItsRangeIsRefusedAndTheMeshIsAsItWas)
{
  const Surface_mesh control = bipyramid_in_quads(3);
  for (const double w : {-0.75, 1.75, std::nan("")}) {
    Surface_mesh mesh = control;
    roundness_map(mesh)[Surface_mesh::Vertex_index(2)] = w;
    messages::expect_refused([&] { refine_with_roundness<CatmullClark_description>(mesh, 2); },
                             {"of vertex 2 is"});
    EXPECT_THROW(refine_with_constant<CatmullClark_description>(mesh, w, 2), std::invalid_argument);
    expect_same_points(control, mesh, "as it was");
  }
}

// A number is no map: rows do not sum it, and the result is the same bit for bit.
TYPED_TEST(Roundness, OfANumberIsThatOfAConstantMap)
{
  for (const Control_mesh& control : meshes_for<TypeParam>())
    for (const double w : {0.25, 0.5}) {
      Surface_mesh number = to_surface_mesh(control), map = number;
      roundness_map(map, w);
      refine_with_constant<TypeParam>(number, w, 2);
      refine_with_roundness<TypeParam>(map, 2);
      expect_same_points(number, map, control.name);
    }
}

TEST(Roundness_of_values, OfANumberIsThatOfAConstantMapAlongCreases)
{
  Surface_mesh number = bipyramid_in_quads(4);
  auto sharp = number.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  for (auto e : number.edges()) sharp[e] = e.idx() % 3 == 0; // creases, corners, darts
  for (const unsigned rounds : {1u, 3u}) {
    Surface_mesh a = number, b = number;
    const auto edges = [](Surface_mesh& m) {
      return m.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
    };
    const auto np = [&](Surface_mesh& m) {
      return CGAL::parameters::number_of_iterations(rounds)
        .vertex_normal_map(normal_map(m))
        .edge_is_constrained_map(edges(m));
    };
    PN::subdivide(a, PN::CatmullClark_scheme(),
                  PN::parameters::join(PN::parameters::roundness(0.5), np(a)));
    PN::subdivide(
      b, PN::CatmullClark_scheme(),
      PN::parameters::join(PN::parameters::vertex_roundness_map(roundness_map(b, 0.5)), np(b)));
    expect_same_points(a, b, "creases");
  }
}

// numbers of another type, and a map that is only read
TEST(Roundness_of_values, MayBeFloatsAndConstant)
{
  Surface_mesh mesh = bipyramid_in_quads(3);
  Surface_mesh other = mesh;
  refine_with_constant<CatmullClark_description>(mesh, 0.5, 2);
  PN::subdivide(other, PN::CatmullClark_scheme(),
                PN::parameters::vertex_roundness_map(
                  CGAL::Constant_property_map<Surface_mesh::Vertex_index, float>(0.5f))
                  .number_of_iterations(2)
                  .vertex_normal_map(normal_map(other)));
  expect_same_points(mesh, other, "constant");
}

TEST(Roundness_of_values, IsExactInExactNumbers)
{
  long_test([](auto) {
    using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
    using Mesh = CGAL::Surface_mesh<Exact::Point_3>;
    Mesh linear;
    const auto v = [&](int x, int y, int z) { return linear.add_vertex(Exact::Point_3(x, y, z)); };
    const auto a = v(1, 0, 0), b = v(0, 2, 0), c = v(0, 0, 3), d = v(-1, -1, -1);
    for (const auto& f :
         {std::array{a, b, c}, std::array{a, c, d}, std::array{a, d, b}, std::array{b, d, c}})
      linear.add_face(f[0], f[1], f[2]);
    Mesh round = linear, half = linear;
    const auto np = [](Mesh& m, int n) {
      auto normals = m.add_property_map<Mesh::Vertex_index, Exact::Vector_3>("n").first;
      for (auto w : m.vertices()) normals[w] = Exact::Vector_3(0, n * 3, n * 4);
      return normals;
    };
    PN::subdivide(round, PN::Loop_scheme(), CGAL::parameters::vertex_normal_map(np(round, 1)));
    PN::subdivide(half, PN::Loop_scheme(),
                  PN::parameters::roundness(CGAL::Gmpq(1, 2)).vertex_normal_map(np(half, 1)));
    PN::subdivide(linear, PN::linear(PN::Loop_scheme()));
    for (auto w : half.vertices())
      EXPECT_EQ(half.point(w), CGAL::midpoint(linear.point(w), round.point(w)));
  });
}

} // namespace
