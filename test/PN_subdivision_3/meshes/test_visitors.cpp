// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// What visitors are called for, and what is kept alive while it is referred to.

#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

Mesh tetrahedron()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  return mesh;
}

template <class Visitor>
void visit(Visitor& visitor)
{
  Mesh mesh = tetrahedron();
  PN::subdivide(mesh, PN::linear(PN::Loop_scheme()),
                CGAL::parameters::number_of_iterations(2).visitor(std::ref(visitor)));
}

template <class Visitor>
constexpr PN::internal::Level_origins::Kinds visited =
  PN::internal::Call_attributes<Mesh, Visitor, PN::internal::Not_given>::visited;

struct Faces : PN::Default_visitor
{
  void face_created(Mesh::Face_index, const PN::Control_element&) { ++number; }
  int number = 0;
};

struct Anything
{
  template <class... T>
  void round_done(const T&...)
  {
    ++rounds;
  }
  void vertex_created(Mesh::Vertex_index v, PN::Control_element) { vertices += v.is_valid(); }
  auto edge_created(Mesh::Edge_index, const PN::Control_element&) { return ++edges; }
  int rounds = 0, vertices = 0, edges = 0;
};

} // namespace

TEST(Visitors, MembersThatHideThoseOfTheDefaultAreCalled)
{
  Faces faces;
  visit(faces);
  EXPECT_EQ(faces.number, 64);
  static_assert(visited<Faces>.faces && !visited<Faces>.vertices && !visited<Faces>.edges,
                "what is not hidden costs nothing");
  PN::Default_visitor nothing;
  visit(nothing);
  static_assert(PN::internal::Call_attributes<Mesh, PN::Default_visitor,
                                              const PN::internal::Not_given>::is_empty,
                "nor does the default");
}

TEST(Visitors, MembersMayTakeWhatTheirArgumentsConvertTo)
{
  Anything all;
  visit(all);
  EXPECT_EQ(all.rounds, 2);
  EXPECT_EQ(all.vertices, 34);
  EXPECT_EQ(all.edges, 96);
}

// --- lifetimes ---

TEST(Lifetimes, APieceThatIsGoneGivesNoReferences)
{
  using Piece = PN::Surface_piece<Kernel>;
  const auto expect = [](auto get) {
    EXPECT_TRUE((std::is_invocable_v<decltype(get), Piece&>));
    EXPECT_TRUE((std::is_invocable_v<decltype(get), const Piece&>));
    EXPECT_FALSE((std::is_invocable_v<decltype(get), Piece>));
    EXPECT_FALSE((std::is_invocable_v<decltype(get), const Piece>));
  };
  expect([](auto&& p) -> decltype(std::forward<decltype(p)>(p).points()) { return p.points(); });
  expect([](auto&& p) -> decltype(std::forward<decltype(p)>(p).normals()) { return p.normals(); });
  expect([](auto&& p) -> decltype(std::forward<decltype(p)>(p).connectivity()) {
    return p.connectivity();
  });
}

TEST(Lifetimes, NoCallKeepsAReferenceToATemporaryFunction)
{
  const auto round_done = [](unsigned, std::size_t) {};
  using Subdivision = PN::internal::Mesh_subdivision<CGAL::Sequential_tag, PN::Loop_scheme, double>;
  using Function = decltype(round_done);
  EXPECT_TRUE((std::is_constructible_v<Subdivision, const PN::Loop_scheme&, unsigned, Function&>));
  EXPECT_FALSE((std::is_constructible_v<Subdivision, const PN::Loop_scheme&, unsigned, Function>));
}
