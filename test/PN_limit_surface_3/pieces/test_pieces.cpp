// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Every scheme in pieces gives the surface of subdivide(), bit for bit and under the same numbers.

#include "Messages.h"
#include "Pieces_cases.h"

#include <CGAL/PN_limit_surface_3/internal/pieces/Divided_level.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Bilinear_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Midpoint_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>

#include <boost/mp11.hpp>

#include <set>

using namespace pieces_cases;

namespace {

template <class Scheme>
class Pieces_of_scheme : public testing::Test
{};

namespace mp = boost::mp11;
template <class Scheme>
using Halves_edges = std::bool_constant<PN::splits_edges_v<Scheme>>;
using All = mp::mp_rename<mp::mp_filter<Halves_edges, PN::Shipped_schemes::apply<mp::mp_list>>,
                          testing::Types>;

struct Names
{
  template <class Scheme>
  static std::string GetName(int)
  {
    return Scheme::name();
  }
};
TYPED_TEST_SUITE(Pieces_of_scheme, All, Names);

std::vector<Control_mesh> random_controls(Kind kind, int number)
{
  std::mt19937 generator(17);
  std::vector<Control_mesh> controls;
  while (number-- > 0) {
    controls.push_back(random_meshes::random_mesh(kind, generator));
    controls.back().name += " " + std::to_string(number);
  }
  return controls;
}

TYPED_TEST(Pieces_of_scheme, IsTheWholeSurface)
{
  constexpr Kind kind = kind_of<TypeParam>();
  for (const Control_mesh& control : random_controls(kind, 8)) {
    expect_as_subdivide<double>(control, TypeParam(), 2, {1, 3});
    expect_as_subdivide<double>(control, TypeParam(), 3, {2, 7, 64});
    if (this->HasFailure()) return;
  }
  expect_as_subdivide<double>(random_controls(kind, 1)[0], TypeParam(), 4, {3});
  expect_as_subdivide<double>(random_controls(kind, 1)[0], TypeParam(), 0, {1, 2, 7, 1000});
}

TYPED_TEST(Pieces_of_scheme, NeedsAllOfItsRings)
{
  constexpr unsigned rings = PN::internal::Ghost_rings<TypeParam>::value;
  constexpr Kind kind = kind_of<TypeParam>();
  std::vector<Control_mesh> controls;
  for (const unsigned one_in : {1, 3, 12})
    controls.push_back(torus_with_turned_edges(kind, one_in));
  if (kind == Kind::quads) {
    controls.push_back(test_meshes::in_quads(torus_with_turned_edges(Kind::triangles, 2)));
    test_meshes::set_uneven_normals(controls.back(), 3);
  }
  std::size_t with_one_less = 0;
  for (const Control_mesh& control : controls)
    for (const std::size_t pieces : {7, 20}) {
      EXPECT_EQ(number_of_defects(control, TypeParam(), 3, pieces, rings), 0u);
      with_one_less += number_of_defects(control, TypeParam(), 3, pieces, rings - 1);
    }
  // new vertices between those of one face need no ring, but 0 says that none is known
  constexpr bool needs_none = std::is_same_v<TypeParam, PN::Midpoint_scheme> ||
                              std::is_same_v<TypeParam, PN::Bilinear_scheme>;
  EXPECT_EQ(with_one_less == 0, needs_none);
}

TEST(Pieces, OfLinearSchemes)
{
  const auto expect = [](const auto& scheme, Kind kind) {
    for (const Control_mesh& control : random_controls(kind, 4))
      expect_as_subdivide<double>(control, PN::linear(scheme), 3, {2, 7});
  };
  expect(PN::CatmullClark_scheme(), Kind::polygons);
  expect(PN::Loop_scheme::Tuned(), Kind::triangles);
}

TEST(Pieces, InFloat)
{
  const auto expect = [](const auto& scheme, Kind kind) {
    for (const Control_mesh& control : random_controls(kind, 4))
      expect_as_subdivide<float>(control, scheme, 3, {2, 7});
  };
  expect(PN::CatmullClark_scheme(), Kind::polygons);
  expect(PN::linear(PN::Butterfly_scheme()), Kind::triangles);
}

TEST(Pieces, WithNormalsOfAnotherScheme)
{
  for (const Control_mesh& control : random_controls(Kind::triangles, 4))
    expect_as_subdivide<double>(
      control, PN::with_normal_scheme(PN::Loop_scheme(), PN::Loop_scheme::Tuned()), 4, {2, 7});
}

TEST(Pieces, ThatDoNotExistAreRefused)
{
  const Control<double> control(random_controls(Kind::polygons, 1).front());
  const auto np = CGAL::parameters::number_of_iterations(2);
  EXPECT_THROW((PN::Surface_pieces(control.mesh, PN::CatmullClark_scheme(),
                                   PN::parameters::join(PN::parameters::number_of_pieces(0), np))),
               std::invalid_argument);
  const PN::Surface_pieces pieces(control.mesh, PN::CatmullClark_scheme(),
                                  PN::parameters::join(PN::parameters::number_of_pieces(3), np));
  EXPECT_GT(pieces.piece(2).number_of_faces(), 0u);
  EXPECT_THROW(pieces.piece(3), std::out_of_range);
  EXPECT_NO_THROW(pieces.piece(2, 1));
  EXPECT_THROW(pieces.piece(2, 2), std::invalid_argument); // than a round leaves right
}

// At compile time and at run time; the message says what to use instead.
TEST(Pieces, OfSchemesThatDoNotHalveEdgesAreRefused)
{
  const Control<double> control(random_controls(Kind::triangles, 1).front());
  const auto expect_refused = [&](const auto& scheme, const std::string& name) {
    messages::expect_refused(
      [&] { PN::Surface_pieces(control.mesh, scheme, PN::parameters::number_of_pieces(2)); },
      {name, "does not split edges in halves", "subdivide()", "Catmull-Clark"});
  };
  expect_refused(PN::DooSabin_scheme(), "doo-sabin");
  expect_refused(PN::linear(PN::DooSabin_scheme()), "doo-sabin");
  expect_refused(PN::Sqrt3_scheme(), "sqrt3");
  expect_refused(PN::Any_scheme<double>(PN::Sqrt3_scheme()), "sqrt3");
}

// --- how faces are divided, against a slow way to the same, and the order of the elements of a piece ---

namespace in = CGAL::PN_subdivision_3::internal;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Level = CGAL::PN_subdivision_3::Level_connectivity;
using Index = Level::Index;
using Center = std::array<double, 3>;

// a grid of faces, many of whose centers have a coordinate in common
Mesh grid(int n, int m)
{
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) mesh.add_vertex({double(i), double(j), double(i * j % 3)});
  const auto at = [m](int i, int j) { return Mesh::Vertex_index(unsigned(i * (m + 1) + j)); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return mesh;
}

Level level_of(const Mesh& mesh)
{
  Level level;
  in::with_mesh_access(mesh, [&](const auto& access) { level = in::checked_level(access); });
  return level;
}

// Halves that are sorted in full, and shares that are counted face by face.
class Slow_division
{
public:
  // corners: how many each face has
  Slow_division(const std::vector<Center>& centers, const std::vector<double>& corners,
                std::size_t number)
    : centers_(centers)
    , corners_(corners)
    , piece(centers.size())
  {
    std::vector<Index> faces(centers.size());
    for (Index f = 0; f < faces.size(); ++f) faces[f] = f;
    divide(faces, 0, number);
  }

private:
  const std::vector<Center>& centers_;
  const std::vector<double>& corners_;

public:
  std::vector<std::size_t> piece;

private:
  double extent(const std::vector<Index>& faces, std::size_t axis) const
  {
    std::set<double> all;
    for (const Index f : faces) all.insert(centers_[f][axis]);
    return *all.rbegin() - *all.begin();
  }

  void divide(std::vector<Index> faces, std::size_t first, std::size_t number)
  {
    if (number == 1 || faces.empty()) {
      for (const Index f : faces) piece[f] = first;
      return;
    }
    std::size_t axis = 0;
    for (const std::size_t i : {1u, 2u})
      if (extent(faces, i) > extent(faces, axis)) axis = i;
    std::sort(faces.begin(), faces.end(), [&](Index f, Index g) {
      return std::pair(centers_[f][axis], f) < std::pair(centers_[g][axis], g);
    });
    const std::size_t half = number / 2;
    double all = 0;
    for (const Index f : faces) all += corners_[f];
    // a face belongs to the half in which its middle is, of the corners in a row
    std::size_t middle = 0;
    for (double before = 0; middle < faces.size(); before += corners_[faces[middle++]])
      if (before + corners_[faces[middle]] / 2 >= all * (double(half) / double(number))) break;
    const auto end_of_half = faces.begin() + std::ptrdiff_t(middle);
    divide({faces.begin(), end_of_half}, first, half);
    divide({end_of_half, faces.end()}, first + half, number - half);
  }
};

void expect_halves(bool is_mixed)
{
  for (const auto& [n, m] :
       {std::pair(1, 1), std::pair(7, 3), std::pair(12, 17), std::pair(20, 20)}) {
    Mesh mesh = grid(n, m);
    for (unsigned f = 0; is_mixed && f < unsigned(n * m) / 2; ++f) {
      const auto h = mesh.halfedge(Mesh::Face_index(f));
      CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
    }
    const Level level = level_of(mesh);
    const auto point = [&](Index v) {
      const auto& p = mesh.point(Mesh::Vertex_index(v));
      return Center{p[0], p[1], p[2]};
    };
    std::vector<Center> centers;
    std::vector<double> corners;
    for (const auto f : mesh.faces()) {
      const double degree = mesh.degree(f);
      Center c{0, 0, 0};
      for (const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
        for (std::size_t i = 0; i < 3; ++i) c[i] += point(Index(mesh.target(h)))[i] / degree;
      centers.push_back(c);
      corners.push_back(degree);
    }
    for (const std::size_t number : {1u, 2u, 3u, 5u, 16u, 37u, 500u}) {
      const in::Face_division division(level, number, point);
      const Slow_division expected(centers, corners, number);
      for (Index f = 0; f < level.number_of_faces(); ++f)
        EXPECT_EQ(division.piece_of_face(f), expected.piece[f]) << n << ' ' << number << ' ' << f;
    }
  }
}

TEST(Piece_division, EqualFacesAreHalvedByCount)
{
  expect_halves(false);
}

TEST(Piece_division, OtherFacesAreHalvedByTheirCorners)
{
  expect_halves(true);
}

// One list after the other in the same table.
TEST(Piece_division, ListsKnowTheirPlaces)
{
  std::mt19937 random(2);
  in::Element_list list(1000);
  for (int round = 0; round < 50; ++round) {
    std::set<Index> expected;
    list.clear();
    for (int i = 0; i < 60; ++i) {
      const Index x = random() % 1000;
      expected.insert(x);
      list.add(x);
    }
    list.sort();
    ASSERT_EQ(list.elements(), std::vector<Index>(expected.begin(), expected.end()));
    for (Index x = 0; x < 1000; ++x) {
      ASSERT_EQ(list.contains(x), expected.count(x) != 0);
      if (list.contains(x)) {
        EXPECT_EQ(list.elements()[list.place(x)], x);
      }
    }
  }
}

} // namespace
