// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The same subdivision for meshes of OpenMesh, through CGAL's adaptor.

#include "Mesh_type_cases.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_subdivision_3/subdivision_methods_3.h>

#ifdef PN_TEST_WITH_OPENMESH

// OpenMesh's vectors have uninitialized default values, which its containers copy.
#  if defined(__GNUC__) && !defined(__clang__)
#    pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#  endif

#  include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#  include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// first OpenMesh's own headers
#  include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#  include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#  include <stdexcept>

using namespace mesh_type_cases;

struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Poly_mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;
using Tri_mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

// CGAL's adaptor rounds the points it puts to float, even if those of the mesh are double. Points
// in a map of the user's are not.
template <class M>
void expect_same_as_surface_mesh_by_dynamic_points(const Case& c)
{
  M mesh;
  const auto p = get(CGAL::dynamic_vertex_property_t<Kernel::Point_3>(), mesh);
  EXPECT_TRUE((with_dynamic_normals<Kernel>(c, mesh, p)) == reference(c)) << c.name;
}

template <class M>
void expect_same_as_surface_mesh_in_float(const Case& c)
{
  M mesh;
  const Result r = with_dynamic_normals<Kernel>(c, mesh, get(CGAL::vertex_point, mesh));
  const Result expected = reference(c);
  EXPECT_EQ(r.faces, expected.faces) << c.name;
  EXPECT_EQ(r.normals, expected.normals) << c.name;
  ASSERT_EQ(r.points.size(), expected.points.size());
  // coordinates less than 8 are rounded twice, on reading the soup and on writing
  for (std::size_t i = 0; i < r.points.size(); ++i)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(r.points[i][k], expected.points[i][k], 5e-7);
}

TEST(OpenMesh_types, Polygons)
{
  for (const Case& c : cases()) {
    expect_same_as_surface_mesh_by_dynamic_points<Poly_mesh>(c);
    expect_same_as_surface_mesh_in_float<Poly_mesh>(c);
  }
}

TEST(OpenMesh_types, Triangles)
{
  for (const Case& c : cases()) {
    if (!c.loop) continue;
    expect_same_as_surface_mesh_by_dynamic_points<Tri_mesh>(c);
    expect_same_as_surface_mesh_in_float<Tri_mesh>(c);
  }
}

// OpenMesh asks a vertex for its outgoing half-edge only.
TEST(OpenMesh_types, FindsTheBorderAtItsVertices)
{
  for (const Case& c : cases()) {
    Poly_mesh mesh;
    build(c.soup, mesh);
    subdivide(c, mesh, params::number_of_iterations(2));
    for (auto v : mesh.vertices()) {
      bool border = false;
      for (auto h : CGAL::halfedges_around_target(v, mesh)) border = border || mesh.is_boundary(h);
      EXPECT_EQ(mesh.is_boundary(v), border) << c.name << " vertex " << v.idx();
    }
  }
}

TEST(OpenMesh_types, Creases)
{
  using namespace tagged_meshes;
  Control polygons = tagged_washer();
  // what less than one round is left of in the first round is another matter for meshes
  for (auto& edge : polygons.sharp_edges)
    if (edge.second > 0 && edge.second < 1) edge.second += 1;
  for (auto& vertex : polygons.sharp_vertices)
    if (vertex.second > 0 && vertex.second < 1) vertex.second += 1;
  Tagged<Poly_mesh, Dynamic_points<Poly_mesh>> p(polygons);
  p.subdivide(PN::CatmullClark_scheme(), 2);
  EXPECT_TRUE(state(p) == state(polygons, PN::CatmullClark_scheme(), 2));
  const Control triangles = triangulated(polygons);
  Tagged<Tri_mesh, Dynamic_points<Tri_mesh>> t(triangles);
  t.subdivide(PN::Loop_scheme(), 2);
  EXPECT_TRUE(state(t) == state(triangles, PN::Loop_scheme(), 2));
}

// A failure leaves neither elements nor status attributes behind.
TEST(OpenMesh_types, NothingIsLeftOfACancelledSubdivision)
{
  struct Cancelling_visitor
  {
    void round_done(unsigned, std::size_t) const { throw std::runtime_error("cancelled"); }
  };
  Poly_mesh mesh;
  build(mixed_with_border(), mesh);
  const auto p = points(mesh);
  const auto f = faces_of(mesh);
  const auto edges = mesh.n_edges();
  EXPECT_THROW(PN::CatmullClark_subdivision(mesh, params::visitor(Cancelling_visitor())),
               std::runtime_error);
  EXPECT_EQ(mesh.n_vertices(), p.size());
  EXPECT_EQ(mesh.n_edges(), edges);
  EXPECT_EQ(mesh.n_faces(), f.size());
  EXPECT_FALSE(mesh.has_vertex_status());
  EXPECT_EQ(points(mesh), p);
  EXPECT_EQ(faces_of(mesh), f);
  EXPECT_TRUE(is_linked(mesh));
}

TEST(OpenMesh_types, DooSabinLeavesACompactMesh)
{
  Poly_mesh mesh;
  Mesh expected;
  build(mixed_with_border(), mesh);
  build(mixed_with_border(), expected);
  PN::DooSabin_subdivision(mesh, params::number_of_iterations(2));
  PN::DooSabin_subdivision(expected, params::number_of_iterations(2));
  EXPECT_EQ(faces_of(mesh), faces_of(expected));
  EXPECT_EQ(mesh.n_vertices(), expected.number_of_vertices());
  EXPECT_EQ(mesh.n_edges(), expected.number_of_edges());
  EXPECT_FALSE(mesh.has_vertex_status());
  EXPECT_TRUE(is_linked(mesh));
}

// Without status attributes, and with the float points of OpenMesh's default traits.
TEST(OpenMesh_types, WithFloatPoints)
{
  OpenMesh::PolyMesh_ArrayKernelT<> mesh;
  build(cube(), mesh);
  PN::CatmullClark_subdivision(mesh, params::number_of_iterations(2));
  Mesh exact;
  build(cube(), exact);
  PN::CatmullClark_subdivision(exact, params::number_of_iterations(2));
  const auto p = points(mesh), q = points(exact);
  ASSERT_EQ(p.size(), q.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(p[i][k], q[i][k], 2e-7);
}

#else

TEST(OpenMesh_types, OpenMeshIsNotInstalled)
{
  GTEST_SKIP() << "left out: OpenMesh not found (Debian package libopenmesh-dev)";
}

#endif // PN_TEST_WITH_OPENMESH
