// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Tessellations whose distance from the surface is proved: against limit points of far more rounds, and what is refused.

#include "Extent.h"
#include "Messages.h"
#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "Tessellation_cases.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using test_meshes::Control_mesh;
using namespace tessellation_cases;

// a closed surface whose points are flat, while its normals are those of something round
Control_mesh pillow(const Control_mesh& shape)
{
  Control_mesh mesh = named_shapes::on_unit_sphere(shape);
  for (auto& p : mesh.points) p[2] *= 0.02;
  return mesh;
}
Control_mesh disturbed(Control_mesh mesh)
{
  test_meshes::set_uneven_normals(mesh, 4);
  return mesh;
}

template <class Scheme>
void expect_bound(const Control_mesh& shape, const Scheme& scheme, double eps, double roundness = 1)
{
  SCOPED_TRACE(shape.name);
  Surface_mesh control = to_surface_mesh(shape), out;
  const auto result = PN::tessellate(
    control, scheme, eps, out,
    PN::parameters::proven_bound(true).roundness(roundness).vertex_normal_map(normal_map(control)));
  EXPECT_TRUE(result.reached);
  EXPECT_LE(result.bound, eps);
  expect_conforming(out, control);
  PN::subdivide_to_limit(
    control, scheme,
    PN::parameters::roundness(roundness)
      .number_of_iterations((std::min)(result.depth + 4, tests_are_full ? 6u : 4u))
      .vertex_normal_map(normal_map(control)));
  const std::vector<Triangle> all = triangles(out);
  double largest = 0;
  for (auto v : control.vertices()) largest = (std::max)(largest, distance(control.point(v), all));
  EXPECT_LE(largest, result.bound);
  EXPECT_GE(largest, 0.15 * result.bound);
}

TEST(ProvenTessellation, BoundsWhatIsThereFourLevelsDeeper)
{
  const auto cc = PN::CatmullClark_scheme();
  expect_bound(named_shapes::on_unit_sphere(named_shapes::cube()), cc,
               0.08); // the linear limit is nearer than this one
  expect_bound(pillow(named_shapes::cube()), cc, 0.1);
  expect_bound(pillow(named_shapes::prism(5)), cc, 0.1, 0.7);
  expect_bound(disturbed(named_shapes::cube()), cc, 0.1);
  const auto loop = PN::Loop_scheme();
  expect_bound(pillow(test_meshes::bipyramid(7)), loop, 0.1);
  expect_bound(disturbed(test_meshes::bipyramid(4)), loop, 0.1);
}
TEST(ProvenTessellation, OfLinearSchemes)
{
  for (const double eps : {0.1, 0.03}) {
    Control_mesh cube = named_shapes::cube();
    cube.normals.assign(cube.points.size(), {0, 0, 0});
    Surface_mesh control = to_surface_mesh(cube), out;
    const auto scheme = PN::linear(PN::CatmullClark_scheme());
    const auto result =
      PN::tessellate(control, scheme, eps, out, PN::parameters::proven_bound(true));
    EXPECT_TRUE(result.reached);
    PN::subdivide_to_limit(control, scheme, params::number_of_iterations(6));
    const std::vector<Triangle> all = triangles(out);
    double largest = 0;
    for (auto v : control.vertices())
      largest = (std::max)(largest, distance(control.point(v), all));
    EXPECT_LE(largest, result.bound);
    EXPECT_GE(largest, 0.15 * result.bound);
  }
}

template <class Scheme>
PN::Tessellation_result proven(const Control_mesh& shape, const Scheme& scheme, double eps,
                               Surface_mesh& out)
{
  Surface_mesh control = to_surface_mesh(shape);
  return PN::tessellate(
    control, scheme, eps, out,
    PN::parameters::proven_bound(true).number_of_iterations(4).vertex_normal_map(
      normal_map(control)));
}

// Squares of the small one's lengths are 0.
TEST(ProvenTessellation, OfPartsOfVeryDifferentSize)
{
  const Control_mesh cube = disturbed(named_shapes::cube());
  Surface_mesh alone, out;
  Control_mesh both = cube;
  for (std::size_t i = 0; i < cube.points.size(); ++i) {
    both.points.push_back(cube.points[i]);
    for (double& x : both.points.back()) x *= 1e-170;
    both.normals.push_back(cube.normals[i]);
  }
  for (reference::Face f : cube.faces) {
    for (int& v : f) v += int(cube.points.size());
    both.faces.push_back(f);
  }
  const auto scheme = PN::CatmullClark_scheme();
  const auto expected = proven(cube, scheme, 0.1, alone);
  const auto result = proven(both, scheme, 0.1, out);
  EXPECT_TRUE(result.reached);
  EXPECT_EQ(result.bound, expected.bound);
  // no bound is known of normals like those of its control faces
  EXPECT_LE(result.number_of_triangles, expected.number_of_triangles + 48);
}

// Linear averages, whose bound is not that of normals which differ from none.
TEST(ProvenTessellation, WithoutNormals)
{
  Control_mesh cube = named_shapes::cube();
  cube.normals.assign(cube.points.size(), {0, 0, 0});
  Surface_mesh out;
  const auto result = proven(cube, PN::CatmullClark_scheme(), 0.1, out);
  EXPECT_TRUE(result.reached);
  EXPECT_LE(result.bound, 0.1);
}

// \name Out of reach

TEST(Tessellation, ToleranceOutOfReachGivesWhatIsInReach)
{
  Control_mesh flat = named_shapes::cube();
  flat.normals.assign(flat.points.size(), {0, 0, 0});
  for (const double eps : {1e-32, 1e-300}) {
    Surface_mesh control = to_surface_mesh(flat), out;
    for (auto v : control.vertices()) // all in one plane, up to rounding
      control.point(v) = Point(control.point(v).x() / 3, control.point(v).y() / 3,
                               0.7 + 1e-18 * control.point(v).z());
    const auto result = PN::tessellate(control, PN::linear(PN::CatmullClark_scheme()), eps, out);
    EXPECT_FALSE(result.reached); // its outline is bent
    EXPECT_EQ(result.obstacle, PN::Tessellation_result::Obstacle::digits);
    EXPECT_GT(result.number_of_triangles, 10000U);
    EXPECT_LE(result.number_of_triangles, 600000U);
  }
}

// \name What is not proved

template <class Scheme, class NamedParameters>
void expect_refused(const Surface_mesh& control, const Scheme& scheme, const std::string& part,
                    const NamedParameters& np)
{
  Surface_mesh out;
  messages::expect_refused(
    [&] { PN::tessellate(control, scheme, 0.1, out, np.proven_bound(true)); }, {part});
  EXPECT_EQ(out.number_of_vertices(), 0U);
}

TEST(ProvenTessellation, NamesTheFirstVertexThatIsNotCovered)
{
  Surface_mesh cube = to_surface_mesh(disturbed(named_shapes::cube()));
  const auto normals = PN::parameters::border(PN::Border::curve);
  expect_refused(cube, PN::CatmullClark_scheme::Tuned(), "modified", normals);
  auto sharp = cube.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  Surface_mesh::Halfedge_index last;
  for (auto h : cube.halfedges())
    if (cube.target(h) == Surface_mesh::Vertex_index(7) &&
        cube.source(h) != Surface_mesh::Vertex_index(0))
      last = h;
  sharp[cube.edge(last)] = true;
  expect_refused(cube, PN::CatmullClark_scheme(),
                 "vertex number " + std::to_string(cube.source(last).idx()) + ", which is sharp",
                 normals.edge_is_constrained_map(sharp));
  Surface_mesh poles = to_surface_mesh(disturbed(test_meshes::bipyramid(13)));
  unsigned pole = 99;
  for (auto v : poles.vertices())
    if (poles.degree(v) == 13) pole = (std::min)(pole, unsigned(v.idx()));
  expect_refused(poles, PN::Loop_scheme(),
                 "vertex number " + std::to_string(pole) + ", whose valence is 13", normals);
  Control_mesh half = disturbed(test_meshes::grid(6, 8, true, true, test_meshes::Cells::quads));
  for (const std::size_t v : {0, 1, 2, 6, 7, 8, 12, 13, 14}) half.normals[v] = {0, 0, 0};
  Surface_mesh torus = to_surface_mesh(half);
  expect_refused(torus, PN::CatmullClark_scheme(),
                 "vertex number 7, which has no normals about it, while a neighbor has",
                 PN::parameters::border(PN::Border::curve).vertex_normal_map(normal_map(torus)));
  Surface_mesh open =
    to_surface_mesh(disturbed(test_meshes::grid(3, 3, false, false, test_meshes::Cells::quads)));
  expect_refused(open, PN::CatmullClark_scheme(), "vertex number 0, which is on the border",
                 normals);
}

// Numbers of 1e13 are 2^-9 apart, and 64 times half of that may count twice and grow twofold.
TEST(ProvenTessellation, SaysWhatIsLeftToRounding)
{
  Control_mesh cube = disturbed(named_shapes::cube());
  for (auto& p : cube.points) p[0] += 1e13;
  Surface_mesh out;
  EXPECT_TRUE(proven(cube, PN::CatmullClark_scheme(), 0.6, out).reached);
  out.clear();
  messages::expect_refused([&] { proven(cube, PN::CatmullClark_scheme(), 0.3, out); },
                           {"vertex number 0, whose coordinates leave 0.568 to"});
  EXPECT_EQ(out.number_of_vertices(), 0U);
}

TEST(ProvenTessellation, TellsWhatIsNotReached)
{
  Surface_mesh control = to_surface_mesh(pillow(named_shapes::cube())), out;
  const auto result =
    PN::tessellate(control, PN::CatmullClark_scheme(), 1e-3, out,
                   PN::parameters::proven_bound(true).number_of_iterations(2).vertex_normal_map(
                     normal_map(control)));
  EXPECT_FALSE(result.reached);
  EXPECT_GT(result.bound, 1e-3);
  EXPECT_LT(result.bound, 1);
}

} // namespace
