// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Normals of wedges in a list say what a map of all corners says.

#include "Random_creases.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/Surface_mesh.h>

using namespace tagged_meshes;

namespace {

using Mesh = CGAL::Surface_mesh<Point_3>;
using H = Mesh::Halfedge_index;
using V = Mesh::Vertex_index;
using Normals_of_vertices = Mesh::Property_map<V, Vector_3>;
using Corners = Dynamic_map<CGAL::dynamic_halfedge_property_t<Vector_3>, Mesh>;
using Wedge_normals = PN::internal::Wedge_normals<Corners, Normals_of_vertices>;

// of all corners, by what the list says of its half-edges
std::map<H, Vector_3> spread(const Mesh& mesh, const Normals_of_vertices& of_vertices,
                             const Wedge_normals::List& list)
{
  std::map<H, Vector_3> result;
  for (const H h : mesh.halfedges())
    if (!mesh.is_border(h)) result[h] = of_vertices[mesh.target(h)];
  const std::map<H, Vector_3> begins(list.begin(), list.end());
  for (const auto& [first, n] : list) {
    H h = first;
    do {
      result[h] = n;
      h = mesh.opposite(mesh.next(h));
    } while (!mesh.is_border(h) && begins.count(h) == 0);
  }
  return result;
}

template <class Scheme>
void expect_same(const Control& control, const Scheme& scheme, unsigned rounds)
{
  const auto with_border = PN::internal::with_border(scheme, control.border);
  Tagged<Mesh> dense(control), sparse(control);
  dense.subdivide(with_border, rounds);

  auto of_vertices = sparse.mesh.add_property_map<V, Vector_3>("v:n", CGAL::NULL_VECTOR).first;
  Wedge_normals::List list;
  PN::subdivide(sparse.mesh, with_border,
                np::number_of_iterations(rounds)
                  .edge_is_constrained_map(sparse.sharp)
                  .vertex_is_constrained_map(sparse.corners)
                  .vertex_normal_map(Wedge_normals{sparse.normals, of_vertices, &list}));
  const std::map<H, Vector_3> found = spread(sparse.mesh, of_vertices, list);
  ASSERT_EQ(dense.mesh.number_of_halfedges(), sparse.mesh.number_of_halfedges());
  for (const V v : sparse.mesh.vertices())
    EXPECT_EQ(sparse.mesh.point(v), dense.mesh.point(v)) << v;
  for (const auto& [h, n] : found) EXPECT_EQ(n, get(dense.normals, h)) << h;
  EXPECT_LT(list.size(), found.size() / 2);
}

template <class Shape>
void expect_same(const Shape& shape, Border border, const std::vector<double>& sharpness)
{
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 random(seed);
    random_creases::Control c = shape();
    c.border = border;
    random_creases::perturb(c, random);
    random_creases::tag(c, random, 0.2, sharpness);
    random_creases::give_normals(c, random);
    SCOPED_TRACE(seed);
    expect_same(c, PN::CatmullClark_scheme(), 2);
    expect_same(triangulated(c), PN::Loop_scheme(), 2);
  }
}

} // namespace

TEST(Wedge_normals, SayWhatAMapOfCornersSays)
{
  for (const Border border : {Border::surface, Border::curve, Border::corners, Border::fixed}) {
    SCOPED_TRACE(int(border));
    expect_same(random_creases::patch, border, {random_creases::infinity});
    expect_same(random_creases::patch, border, {0.5, 1, 1.7, random_creases::infinity});
  }
  expect_same(random_creases::box, Border::surface, {0.5, 1, 2, random_creases::infinity});
}

// what the user may make of a list that says nothing
TEST(Wedge_normals, AreNoneWhereNoVertexHasTwoWedges)
{
  std::mt19937 random(1);
  random_creases::Control c = random_creases::patch();
  c.border = Border::curve;
  random_creases::give_normals(c, random);
  Tagged<Mesh> tagged(c);
  auto of_vertices = tagged.mesh.add_property_map<V, Vector_3>("v:n", CGAL::NULL_VECTOR).first;
  Wedge_normals::List list;
  PN::subdivide(tagged.mesh, PN::internal::with_border(PN::CatmullClark_scheme(), c.border),
                np::number_of_iterations(2).vertex_normal_map(
                  Wedge_normals{tagged.normals, of_vertices, &list}));
  EXPECT_TRUE(list.empty());
  for (const V v : tagged.mesh.vertices())
    EXPECT_NEAR(of_vertices[v].squared_length(), 1, 1e-14) << v;
}
