// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Surfaces with creases in pieces are those of subdivide(), bit for bit: points, mean normals, and the normals of
// all corners.

#include "Extent.h"
#include "Pieces_cases.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

using namespace pieces_cases;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Halfedge = Mesh::Halfedge_index;
using Any = PN::Any_scheme<>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A mesh with all that tells of creases. Where the normals of a vertex are uneven, those of its corners are more so.
struct Creased
{
  Creased(const Control_mesh& control, unsigned seed)
    : mesh(Control<double>(control).mesh)
  {
    add_maps();
    std::mt19937 generator(seed);
    const double values[] = {infinity, infinity, 0.4, 1, 1.7, 2.5, 3};
    for (const Edge e : mesh.edges())
      if (generator() % 4 == 0) sharp[e] = values[generator() % 7];
    for (const Vertex v : mesh.vertices())
      if (generator() % 9 == 0) corners[v] = values[generator() % 7];
    for (const Halfedge h : mesh.halfedges()) {
      const Vector n = normals[mesh.target(h)];
      of_corners[h] = n + Vector(0.1 * double(generator() % 5), 0.1 * double(generator() % 7), 0);
    }
  }
  Creased(const Creased& other)
    : mesh(other.mesh)
  {
    add_maps();
  }
  Creased& operator=(const Creased&) = delete;

  void add_maps()
  {
    normals = mesh.add_property_map<Vertex, Vector>("n").first;
    of_corners = mesh.add_property_map<Halfedge, Vector>("h", Vector(0, 0, 0)).first;
    tangents = mesh.add_property_map<Halfedge, Vector>("t", Vector(0, 0, 0)).first;
    sharp = mesh.add_property_map<Edge, double>("e", 0).first;
    corners = mesh.add_property_map<Vertex, double>("c", 0).first;
  }

  auto parameters(unsigned rounds) const
  {
    return params::number_of_iterations(rounds)
      .edge_is_constrained_map(sharp)
      .vertex_is_constrained_map(corners);
  }

  Mesh mesh;
  Mesh::Property_map<Vertex, Vector> normals;
  Mesh::Property_map<Halfedge, Vector> of_corners, tangents;
  Mesh::Property_map<Edge, double> sharp;
  Mesh::Property_map<Vertex, double> corners;
};

std::vector<Vector> values_of(const Creased& creased)
{
  std::vector<Vector> values;
  for (const Vertex v : creased.mesh.vertices()) values.push_back(creased.normals[v]);
  return values;
}

// an inner vertex with one sharp edge
bool is_dart(const Creased& refined, Vertex v)
{
  std::size_t sharp = 0;
  for (const Halfedge h : halfedges_around_target(refined.mesh.halfedge(v), refined.mesh))
    sharp += refined.sharp[refined.mesh.edge(h)] > 0;
  return sharp == 1 && !refined.mesh.is_border(v);
}

// of the corners of all pieces, and whether one of them is not the normal of its vertex
template <class Pieces>
bool expect_corners(const Pieces& pieces, unsigned rings, const Creased& refined)
{
  std::size_t wrong = 0, wrong_wedges = 0;
  std::vector<std::uint64_t> ends;
  bool any_wedge = false;
  for (std::size_t i = 0; i < pieces.number_of_pieces(); ++i) {
    const auto piece = pieces.piece(i, rings);
    const auto& level = piece.connectivity();
    for (unsigned f = 0; f < piece.number_of_faces(); ++f) {
      const auto first = level.halfedge_of_face(f);
      auto h = first;
      Halfedge g = refined.mesh.halfedge(Mesh::Face_index(unsigned(piece.face_number(f))));
      do {
        wrong += piece.corner_normal(h) != refined.of_corners[g];
        // the corners on both sides of an edge at a vertex are in different wedges if it is sharp there
        const auto o = PN::Level_connectivity::opposite(level.next(h));
        const Edge e = refined.mesh.edge(refined.mesh.next(g));
        if (!level.is_border(o)) {
          const bool differ = piece.corner_wedge(h) != piece.corner_wedge(o);
          wrong_wedges += differ && !(refined.sharp[e] > 0);
          if (refined.sharp[e] > 0 && !differ) ends.push_back(piece.vertex_number(level.target(h)));
        }
        any_wedge = any_wedge || piece.corner_normal(h) != piece.normals()[level.target(h)];
        h = level.next(h);
        g = refined.mesh.next(g);
      } while (h != first);
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(wrong_wedges, 0u);
  for (const auto v : ends) EXPECT_TRUE(is_dart(refined, Vertex(unsigned(v)))) << v;
  return any_wedge;
}

template <class Scheme>
using Pieces = PN::Surface_pieces<Scheme, Kernel>;

template <class Scheme>
void expect_mean_normals(const Creased& control, const Scheme& scheme, unsigned rounds,
                         const std::vector<std::size_t>& numbers, unsigned rings)
{
  Creased refined(control);
  PN::subdivide(refined.mesh, scheme,
                refined.parameters(rounds).vertex_normal_map(refined.normals));
  for (const std::size_t number : numbers) {
    SCOPED_TRACE(std::to_string(rounds) + " rounds, " + std::to_string(number) + " pieces");
    const Pieces<Scheme> pieces(
      control.mesh, scheme,
      PN::parameters::join(PN::parameters::number_of_pieces(number),
                           control.parameters(rounds).vertex_normal_map(control.normals)));
    Collected_pieces<double>(pieces).expect(refined.mesh, values_of(refined));
    Collected_pieces<double>(pieces, rings).expect(refined.mesh, values_of(refined));
  }
}

// returns whether there were wedges
template <class Scheme>
bool expect_corner_normals(const Creased& control, const Scheme& scheme, unsigned rounds,
                           const std::vector<std::size_t>& numbers, unsigned rings)
{
  bool any_wedge = false;
  Creased refined(control);
  PN::subdivide(refined.mesh, scheme,
                refined.parameters(rounds).vertex_normal_map(refined.of_corners));
  for (const std::size_t number : numbers) {
    SCOPED_TRACE(std::to_string(rounds) + " rounds, " + std::to_string(number) + " pieces");
    const Pieces<Scheme> pieces(
      control.mesh, scheme,
      PN::parameters::join(PN::parameters::number_of_pieces(number),
                           control.parameters(rounds).vertex_normal_map(control.of_corners)));
    any_wedge = expect_corners(pieces, 0, refined) || any_wedge;
    any_wedge = expect_corners(pieces, rings, refined) || any_wedge;
  }
  return any_wedge;
}

void expect_as_subdivide(const Any& scheme, Kind kind, unsigned rings)
{
  const PN::Border borders[] = {PN::Border::curve, PN::Border::corners, PN::Border::fixed,
                                PN::Border::surface};
  std::mt19937 generator(23);
  int with_wedges = 0;
  for (unsigned seed = 0; seed < (tests_are_full ? 8u : 4u); ++seed) { // each border once
    const Control_mesh control_mesh = random_meshes::random_mesh(kind, generator);
    SCOPED_TRACE(scheme.name() + ", " + control_mesh.name + ", seed " + std::to_string(seed));
    const Creased control(control_mesh, seed);
    const auto with_border = PN::internal::with_border(scheme, borders[seed % 4]);
    expect_mean_normals(control, with_border, 2, {1, 7}, rings);
    expect_mean_normals(control, with_border, 3, {2, 64}, rings);
    with_wedges += expect_corner_normals(control, with_border, 3, {1, 2, 7, 64}, rings);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(with_wedges, 1);
  // large enough for pieces of the control mesh, all of whose rounds need their rings
  const Creased torus(torus_with_turned_edges(kind, 3), 1);
  expect_mean_normals(torus, scheme, 3, {7, 20}, rings);
  expect_corner_normals(torus, scheme, 3, {20}, rings);
  const Creased control(random_meshes::random_mesh(kind, generator), 1);
  expect_mean_normals(control, PN::internal::with_border(scheme, PN::Border::curve), 4, {7, 64},
                      rings);
  expect_mean_normals(control, PN::internal::with_border(scheme, PN::Border::curve), 1, {1, 7},
                      rings);
  expect_mean_normals(control, PN::internal::with_border(scheme, PN::Border::curve), 0, {1, 7},
                      rings);
}

// as they are left by a round: with tangents
template <class Scheme>
bool expect_with_tangents(Creased control, const Scheme& scheme)
{
  PN::subdivide(control.mesh, PN::internal::with_crease_tangents(scheme, control.tangents),
                control.parameters(1).vertex_normal_map(control.of_corners));
  // others than those that would be made
  for (const Halfedge h : control.mesh.halfedges()) control.tangents[h] = 0.9 * control.tangents[h];
  Creased refined(control);
  PN::subdivide(refined.mesh, PN::internal::with_crease_tangents(scheme, refined.tangents),
                refined.parameters(2).vertex_normal_map(refined.of_corners));
  const auto with_tangents = PN::internal::with_crease_tangents(scheme, control.tangents);
  const Pieces<std::decay_t<decltype(with_tangents)>> pieces(
    control.mesh, with_tangents,
    PN::parameters::join(PN::parameters::number_of_pieces(7),
                         control.parameters(2).vertex_normal_map(control.of_corners)));
  Collected_pieces<double>(pieces).expect(refined.mesh, {});
  return expect_corners(pieces, 0, refined);
}

Creased random_creased(Kind kind, unsigned seed)
{
  std::mt19937 generator(seed);
  return {random_meshes::random_mesh(kind, generator), seed};
}

} // namespace

TEST(Pieces_creases, CatmullClark)
{
  expect_as_subdivide(Any(PN::CatmullClark_scheme()), Kind::polygons, 1);
}
TEST(Pieces_creases, Loop)
{
  expect_as_subdivide(Any(PN::Loop_scheme()), Kind::triangles, 1);
}
TEST(Pieces_creases, ModifiedCatmullClark)
{
  expect_as_subdivide(Any(PN::CatmullClark_scheme::Tuned()), Kind::polygons, 3);
}
TEST(Pieces_creases, ModifiedLoop)
{
  expect_as_subdivide(Any(PN::Loop_scheme::Tuned()), Kind::triangles, 3);
}
TEST(Pieces_creases, TransferredCurvature)
{
  expect_as_subdivide(Any(PN::CatmullClark_scheme::Transfer()), Kind::polygons, 2);
  expect_as_subdivide(Any(PN::Loop_scheme::Transfer()), Kind::triangles, 2);
}

TEST(Pieces_creases, GivenTangents)
{
  int with_wedges = 0;
  for (unsigned seed = 1; seed < 9; ++seed)
    with_wedges +=
      expect_with_tangents(random_creased(Kind::polygons, seed), PN::CatmullClark_scheme());
  EXPECT_GT(with_wedges, 2);
}

// without normals and maps of vertices
TEST(Pieces_creases, OfLinearSchemesAndEstimatedNormals)
{
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Creased control = random_creased(Kind::polygons, seed);
    const auto expect = [&](const auto& scheme) {
      Creased refined(control);
      PN::subdivide(refined.mesh, scheme,
                    params::number_of_iterations(3).edge_is_constrained_map(refined.sharp));
      const Pieces<std::decay_t<decltype(scheme)>> pieces(
        control.mesh, scheme,
        PN::parameters::number_of_pieces(7).number_of_iterations(3).edge_is_constrained_map(
          control.sharp));
      Collected_pieces<double>(pieces).expect(refined.mesh, {});
    };
    expect(PN::CatmullClark_scheme());
    expect(PN::linear(PN::CatmullClark_scheme()));
  }
}

// of vertices between sharp edges, also where these are no creases of the piece any more
TEST(Pieces_creases, AreReadOnly)
{
  const Creased control = random_creased(Kind::polygons, 3), copy(control);
  const auto scheme =
    PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), control.tangents);
  const PN::Surface_pieces pieces(
    control.mesh, scheme,
    PN::parameters::join(PN::parameters::number_of_pieces(3),
                         control.parameters(2).vertex_normal_map(control.of_corners)));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GT(pieces.piece(i).number_of_faces(), 0u);
  for (const Edge e : copy.mesh.edges()) EXPECT_EQ(control.sharp[e], copy.sharp[e]);
  for (const Vertex v : copy.mesh.vertices()) EXPECT_EQ(control.corners[v], copy.corners[v]);
  for (const Halfedge h : copy.mesh.halfedges()) {
    EXPECT_EQ(control.of_corners[h], copy.of_corners[h]);
    EXPECT_EQ(control.tangents[h], copy.tangents[h]);
  }
}

TEST(Pieces_creases, AreRefusedWithoutRules)
{
  const Creased control = random_creased(Kind::triangles, 3);
  EXPECT_THROW((Pieces<PN::Butterfly_scheme>(
                 control.mesh, PN::Butterfly_scheme(),
                 PN::parameters::join(PN::parameters::number_of_pieces(2), control.parameters(2)))),
               std::invalid_argument);
  EXPECT_THROW(
    (Pieces<Any>(control.mesh, Any(PN::Butterfly_scheme()),
                 PN::parameters::join(PN::parameters::number_of_pieces(2), control.parameters(2)))),
    std::invalid_argument);
  Creased smooth(control);
  for (const Edge e : smooth.mesh.edges()) smooth.sharp[e] = 0;
  for (const Vertex v : smooth.mesh.vertices()) smooth.corners[v] = 0;
  EXPECT_NO_THROW((Pieces<PN::Butterfly_scheme>(
    smooth.mesh, PN::Butterfly_scheme(),
    PN::parameters::join(PN::parameters::number_of_pieces(2), smooth.parameters(2)))));
  smooth.sharp[Edge(0)] = -1;
  EXPECT_THROW((Pieces<PN::Loop_scheme>(
                 smooth.mesh, PN::Loop_scheme(),
                 PN::parameters::join(PN::parameters::number_of_pieces(2), smooth.parameters(2)))),
               std::invalid_argument);
}
