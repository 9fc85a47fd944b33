// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A refiner whose control points and normals change is compared with a new call of subdivide().

#include "Extent.h"
#include "Mesh_cases.h"
#include "Surface_refiner_cases.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/Polyhedron_3.h>

#include <set>
#include <utility>

using namespace surface_refiner_cases;

TEST(Surface_refiner, CatmullClark)
{
  expect_as_subdivide(quads_and_others(), PN::CatmullClark_scheme(), 3);
  expect_as_subdivide(triangles(), PN::CatmullClark_scheme(), 2);
}
TEST(Surface_refiner, Loop)
{
  expect_as_subdivide(triangles(), PN::Loop_scheme(), 3);
}
TEST(Surface_refiner, DooSabinWhichIsDual)
{
  expect_as_subdivide(quads_and_others(), PN::DooSabin_scheme(), 3);
}
TEST(Surface_refiner, Sqrt3WhoseRoundsAlternateOnTheBorder)
{
  expect_as_subdivide(triangles(), PN::Sqrt3_scheme(), 3);
}
TEST(Surface_refiner, NormalsByAnotherScheme)
{
  expect_as_subdivide(triangles(),
                      PN::with_normal_scheme(PN::Butterfly_scheme(), PN::Loop_scheme()), 2);
}
TEST(Surface_refiner, ModifiedScheme)
{
  expect_as_subdivide(triangles(), PN::Loop_scheme::Tuned(), 3);
}

TEST(Surface_refiner, LinearScheme)
{
  expect_as_subdivide(cube(), PN::linear(PN::Kobbelt_scheme()), 3);
}

TEST(Surface_refiner, ReachesTheTwoRingOfFacesAndNothingElse)
{
  // a control vertex of Catmull-Clark subdivision reaches the faces of its 2-neighborhood
  Mesh mesh = grid(12);
  auto normals = add_normals(mesh);
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                              params::number_of_iterations(3).vertex_normal_map(normals));
  const std::vector<Point> old_points = refiner.points();
  const Vertex center(6 * 13 + 6);       // at (6, 6)
  EXPECT_TRUE(refiner.update().empty()); // nothing has changed
  refiner.set_normal(center, Vector(0.5, 0.2, 1));
  const auto& reached = refiner.update();
  EXPECT_TRUE(std::is_sorted(reached.begin(), reached.end()));
  const std::set<std::size_t> reached_set(reached.begin(), reached.end());
  EXPECT_EQ(reached.size(), reached_set.size());
  // of the 4 x 4 faces about it those vertices inside, at most
  EXPECT_LE(reached.size(), 31u * 31u);
  EXPECT_GE(reached.size(), 29u * 29u);
  for (std::size_t v = 0; v < old_points.size(); ++v) {
    if (reached_set.count(v) != 0) continue;
    EXPECT_EQ(refiner.points()[v], old_points[v]) << v;
  }
}

// of so many vertices that those reached are few
TEST(Surface_refiner, TellsWhatIsReachedInIncreasingOrder)
{
  constexpr unsigned n = 70;
  Mesh mesh = grid(n);
  PN::Surface_refiner refiner(mesh, PN::linear(PN::CatmullClark_scheme()));
  refiner.set_point(Vertex(n / 2 * (n + 1) + n / 2), Point(n / 2., n / 2., 1));
  const auto& reached = refiner.update();
  EXPECT_EQ(reached.size(), 25u); // the vertices within two steps of the refined grid
  EXPECT_TRUE(std::is_sorted(reached.begin(), reached.end()));
}

TEST(Surface_refiner, EstimatesNormalsAgainWherePointsMove)
{
  Mesh mesh;
  build(mixed_with_border(), mesh, mesh.points());
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(2));
  mesh.point(Vertex(2)) = Point(1.2, 1, 0.7);
  refiner.set_point(Vertex(2), mesh.point(Vertex(2)));
  refiner.update();
  Mesh refined = mesh;
  PN::subdivide(refined, PN::CatmullClark_scheme(), params::number_of_iterations(2));
  EXPECT_EQ(refiner.points(), std::vector<Point>(refined.points().begin(), refined.points().end()));

  // a normal that is set stays, also when its neighbors' are estimated again; normals that are given have roundness 1
  PN::Surface_refiner round(mesh, PN::CatmullClark_scheme(),
                            PN::parameters::roundness(1).number_of_iterations(2));
  round.set_normal(Vertex(2), Vector(0, 0, 2));
  round.set_point(Vertex(1), Point(1, 0, 1));
  round.update();
  EXPECT_EQ(round.control_normal(Vertex(2)), Vector(0, 0, 1));
  auto normals = mesh.add_property_map<Vertex, Vector>("n").first;
  mesh.point(Vertex(1)) = Point(1, 0, 1);
  for (Vertex v : mesh.vertices()) normals[v] = round.control_normal(v);
  PN::subdivide(mesh, PN::CatmullClark_scheme(),
                params::number_of_iterations(2).vertex_normal_map(normals));
  EXPECT_EQ(round.points(), std::vector<Point>(mesh.points().begin(), mesh.points().end()));
}

TEST(Surface_refiner, NormalsOnTheBorderFollowTheOneThatIsSet)
{
  for (const auto estimate :
       {PN::Control_normal_estimate::coherent, PN::Control_normal_estimate::reciprocal}) {
    Mesh mesh = grid(2);
    for (Vertex v : mesh.vertices()) mesh.point(v) = Point(mesh.point(v).x(), mesh.point(v).y(), 0);
    PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                                PN::parameters::control_normal_estimate(estimate));
    const Vertex center(4), beside(5); // in the direction of x
    EXPECT_EQ(refiner.control_normal(beside), Vector(0, 0, 1));
    refiner.set_normal(center, Vector(0.3, 0, 1));
    refiner.update();
    // an arc joins two points if the sum of their normals is perpendicular to the chord
    const Vector n = refiner.control_normal(center), m = refiner.control_normal(beside);
    EXPECT_NEAR(m.x(), -n.x(), 1e-15);
    EXPECT_NEAR(m.y(), 0, 1e-15);
    EXPECT_NEAR(m.z(), n.z(), 1e-15);
  }
}

TEST(Surface_refiner, NoRoundsNoFacesNoVertices)
{
  Mesh mesh;
  build(tetrahedron(), mesh, mesh.points());
  auto normals = add_normals(mesh);
  PN::Surface_refiner control(mesh, PN::Loop_scheme(),
                              params::number_of_iterations(0).vertex_normal_map(normals));
  EXPECT_EQ(control.number_of_faces(), 4u);
  control.set_normal(Vertex(2), Vector(0, 3, 0));
  EXPECT_EQ(control.update(), std::vector<std::uint32_t>{2});
  EXPECT_EQ(control.normals()[2], Vector(0, 1, 0));
  EXPECT_EQ(control.points()[2], mesh.point(Vertex(2)));
  EXPECT_EQ(control.connectivity().number_of_faces(), 4u);

  Mesh lonely;
  lonely.add_vertex(Point(1, 2, 3));
  PN::Surface_refiner point(lonely, PN::CatmullClark_scheme(), params::number_of_iterations(9));
  EXPECT_EQ(point.points(), std::vector<Point>{Point(1, 2, 3)});
  point.set_point(Vertex(0), Point(4, 5, 6));
  point.update();
  EXPECT_EQ(point.points(), std::vector<Point>{Point(4, 5, 6)});

  PN::Surface_refiner nothing(Mesh(), PN::DooSabin_scheme(), params::number_of_iterations(2));
  EXPECT_TRUE(nothing.update().empty());
  Mesh built;
  nothing.build_mesh(built);
  EXPECT_TRUE(built.is_empty());
}

// that of a Surface_mesh is compared with that of subdivide() by test_matrix_of_features.cpp
TEST(Surface_refiner, BuildsAPolyhedronOnce)
{
  for (const Soup& soup : {quads_and_others(), mixed_with_border()}) {
    Mesh mesh = built<Mesh>(soup);
    const auto np = params::number_of_iterations(2).vertex_normal_map(add_normals(mesh));
    PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(), np);
    PN::subdivide(mesh, PN::CatmullClark_scheme(), np);
    CGAL::Polyhedron_3<Kernel> polyhedron;
    refiner.build_mesh(polyhedron);
    EXPECT_THROW(refiner.build_mesh(polyhedron), std::invalid_argument);
    EXPECT_TRUE(is_linked(polyhedron));
    EXPECT_EQ(faces_of(polyhedron), faces_of(mesh));
    EXPECT_EQ(points(polyhedron), points(mesh));
  }
}

TEST(Surface_refiner, NumbersVerticesAsTheMeshEnumeratesThem)
{
  // removed elements, and a mesh without indices
  Mesh mesh;
  build(cube(), mesh, mesh.points());
  const Vertex extra = mesh.add_vertex(Point(0, 0, 9));
  mesh.add_vertex(Point(0, 0, 10));
  mesh.remove_vertex(extra);
  ASSERT_TRUE(mesh.has_garbage());
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme());
  ASSERT_EQ(refiner.number_of_control_vertices(), 9u);
  EXPECT_EQ(refiner.control_point(Vertex(9)), Point(0, 0, 10));
  EXPECT_THROW(refiner.control_point(extra), std::out_of_range);

  CGAL::Polyhedron_3<Kernel> polyhedron;
  build(cube(), polyhedron, get(CGAL::vertex_point, polyhedron));
  PN::Surface_refiner of_polyhedron(polyhedron, PN::CatmullClark_scheme());
  for (auto v : vertices(polyhedron)) EXPECT_EQ(of_polyhedron.control_point(v), v->point());
}

TEST(Surface_refiner, TakesAMapOfIndices)
{
  Mesh mesh;
  build(cube(), mesh, mesh.points());
  auto indices = mesh.add_property_map<Vertex, int>("i").first;
  for (Vertex v : mesh.vertices()) indices[v] = 100 - 2 * int(v.idx());
  const PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                                    params::vertex_index_map(indices));
  for (Vertex v : mesh.vertices()) EXPECT_EQ(refiner.control_point(v), mesh.point(v));
  for (const int wrong : {98, -1}) {
    indices[Vertex(0)] = wrong;
    EXPECT_THROW(
      PN::Surface_refiner(mesh, PN::CatmullClark_scheme(), params::vertex_index_map(indices)),
      std::invalid_argument);
  }
}

TEST(Surface_refiner, IsMadeEmptyAndAssignedTo)
{
  PN::Surface_refiner<Mesh, PN::CatmullClark_scheme> refiner;
  EXPECT_EQ(refiner.number_of_control_vertices() + refiner.number_of_vertices() +
              refiner.number_of_faces() + refiner.memory() + refiner.update().size(),
            0u);
  EXPECT_THROW(refiner.control_point(Vertex(0)), std::out_of_range);
  EXPECT_THROW(refiner.set_point(Vertex(0), Point(0, 0, 0)), std::out_of_range);
  Mesh built;
  refiner.build_mesh(built);
  EXPECT_TRUE(built.is_empty());

  refiner = PN::Surface_refiner(grid(3), PN::CatmullClark_scheme());
  EXPECT_EQ(refiner.number_of_faces(), 36u);
}

// as a mesh that is built anew, for a mesh with tables and one without
template <class Built>
void expect_updated_as_built()
{
  Mesh mesh = grid(5);
  const auto normals = add_normals(mesh);
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                              params::number_of_iterations(2).vertex_normal_map(normals));
  Built updated, anew;
  refiner.build_mesh(updated);
  refiner.set_point(Vertex(7), Point(0.5, 0.25, 2));
  EXPECT_LT(refiner.update().size(), refiner.number_of_vertices());
  refiner.update_mesh(updated);
  refiner.build_mesh(anew);
  const auto points = [](Built& m) {
    std::vector<Point> result;
    for (auto v : vertices(m)) result.push_back(get(get(CGAL::vertex_point, m), v));
    return result;
  };
  EXPECT_EQ(points(updated), points(anew));
  EXPECT_EQ(points(anew), refiner.points());
  Built other;
  EXPECT_THROW(refiner.update_mesh(other), std::invalid_argument);
}

TEST(Surface_refiner, PutsWhatHasChangedIntoTheMesh)
{
  expect_updated_as_built<Mesh>();
  expect_updated_as_built<CGAL::Polyhedron_3<Kernel>>();

  Mesh mesh = grid(5);
  auto normals = add_normals(mesh);
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                              params::number_of_iterations(1).vertex_normal_map(normals));
  Mesh built;
  auto built_normals = built.add_property_map<Vertex, Vector>("n").first;
  refiner.build_mesh(built, params::vertex_normal_map(built_normals));
  refiner.set_normal(Vertex(9), Vector(1, 0, 0));
  refiner.update();
  refiner.update_mesh(built, params::vertex_normal_map(built_normals));
  for (Vertex v : built.vertices()) EXPECT_EQ(built_normals[v], refiner.normals()[v]);
}

TEST(Surface_refiner, RefusesAndGoesOn)
{
  Mesh mesh = grid(4);
  auto normals = add_normals(mesh);
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                              params::number_of_iterations(2).vertex_normal_map(normals));
  const auto before = refiner.points();
  EXPECT_THROW(refiner.set_point(Vertex(25), Point(0, 0, 0)), std::out_of_range);
  EXPECT_THROW(refiner.set_normal(Vertex(25), Vector(0, 0, 1)), std::out_of_range);
  EXPECT_THROW(refiner.control_point(Vertex(25)), std::out_of_range);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(refiner.set_point(Vertex(0), Point(nan, 0, 0)), std::invalid_argument);
  EXPECT_THROW(refiner.set_normal(Vertex(0), Vector(0, nan, 0)), std::invalid_argument);
  EXPECT_TRUE(refiner.update().empty());
  EXPECT_EQ(refiner.points(), before);

  const Point p = refiner.control_point(Vertex(12));
  const double large = std::numeric_limits<double>::max();
  refiner.set_point(Vertex(12), Point(large, large, large));
  refiner.set_point(Vertex(13), Point(-large, large, -large));
  EXPECT_THROW(refiner.update(), std::overflow_error);
  EXPECT_THROW(refiner.update(), std::overflow_error); // still
  refiner.set_point(Vertex(12), p);
  refiner.set_point(Vertex(13), mesh.point(Vertex(13)));
  refiner.update();
  EXPECT_EQ(refiner.points(), before);

  EXPECT_THROW(PN::Surface_refiner(mesh, PN::Loop_scheme()), std::invalid_argument);
  EXPECT_THROW(
    PN::Surface_refiner(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(40)),
    std::length_error);
}

TEST(Surface_refiner, MovesAndStatesItsMemory)
{
  Mesh mesh = grid(8);
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(3));
  const std::size_t at_first = refiner.memory();
  EXPECT_GE(at_first, refiner.number_of_vertices() * (sizeof(Point) + sizeof(Vector)));
  auto moved = std::move(refiner);
  mesh.clear();
  moved.set_normal(Vertex(40), Vector(0.3, 0, 1));
  EXPECT_FALSE(moved.update().empty());
  EXPECT_GT(moved.memory(), at_first);
}

TEST(Surface_refiner, IntervalsThatDoNotDecide)
{
  long_test([](auto) {
    using Interval = CGAL::Interval_nt<false>;
    const Interval::Protector protector;
    using Intervals = CGAL::Simple_cartesian<Interval>;
    CGAL::Surface_mesh<Intervals::Point_3> mesh;
    build(cube(), mesh, mesh.points());
    auto normals = mesh.add_property_map<Vertex, Intervals::Vector_3>("n").first;
    for (auto v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
    PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                                params::number_of_iterations(2).vertex_normal_map(normals));
    for (const auto& p : refiner.points()) // the sphere's
      EXPECT_TRUE((p - CGAL::ORIGIN).squared_length().do_overlap(Interval(3)));

    // whether the mean normal vanishes is not decided, and can be afterwards
    const Interval any(-1, 1);
    for (Vertex v : mesh.vertices()) refiner.set_normal(v, Intervals::Vector_3(any, any, 2));
    EXPECT_THROW(refiner.update(), std::domain_error);
    for (auto v : mesh.vertices()) refiner.set_normal(v, normals[v]);
    EXPECT_EQ(refiner.update().size(), refiner.number_of_vertices());
    for (const auto& p : refiner.points())
      EXPECT_TRUE((p - CGAL::ORIGIN).squared_length().do_overlap(Interval(3)));
  });
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Surface_refiner, SeveralThreadsGiveTheSameBits)
{
  Mesh mesh = grid(30);
  auto normals = add_normals(mesh);
  const auto np = params::number_of_iterations(3).vertex_normal_map(normals);
  PN::Surface_refiner one(mesh, PN::CatmullClark_scheme(), np);
  PN::Surface_refiner<Mesh, PN::CatmullClark_scheme, Kernel, CGAL::Parallel_tag> several(
    mesh, PN::CatmullClark_scheme(), np);
  EXPECT_EQ(one.points(), several.points());
  for (unsigned v = 100; v < 250; ++v) {
    one.set_normal(Vertex(v), Vector(0.1, std::sin(double(v)), 1));
    several.set_normal(Vertex(v), Vector(0.1, std::sin(double(v)), 1));
  }
  EXPECT_EQ(one.update(), several.update());
  EXPECT_LT(one.update().size(), one.number_of_vertices());
  EXPECT_EQ(one.points(), several.points());
  EXPECT_EQ(one.normals(), several.normals());
}
#endif
