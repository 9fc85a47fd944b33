// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Two rounds on a mesh of any type, and what a plain Surface_mesh gives.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_MESH_TYPE_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_MESH_TYPE_CASES_H

#include "Mesh_cases.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace mesh_type_cases {

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vector = Kernel::Vector_3;

struct Result
{
  std::vector<Triple> points, normals;
  std::vector<Polygon> faces;
  bool operator==(const Result& r) const
  {
    return points == r.points && normals == r.normals && faces == r.faces;
  }
};

struct Case
{
  const char* name;
  Soup soup;
  bool loop;
};

inline std::vector<Case> cases()
{
  return {{"cube", cube(), false},
          {"mixed with border", mixed_with_border(), false},
          {"tetrahedron", tetrahedron(), true},
          {"triangles with border", triangles_with_border(), true}};
}

template <class M, class NP>
void subdivide(const Case& c, M& mesh, const NP& np)
{
  if (c.loop)
    PN::subdivide(mesh, PN::Loop_scheme(), np);
  else
    PN::subdivide(mesh, PN::CatmullClark_scheme(), np);
}

// what two rounds on a plain Surface_mesh give
inline Result reference(const Case& c)
{
  Mesh mesh;
  build(c.soup, mesh);
  auto n = mesh.add_property_map<Mesh::Vertex_index, Vector>("n").first;
  put_normals(normals(c.soup), mesh, n);
  subdivide(c, mesh, params::number_of_iterations(2).vertex_normal_map(n));
  EXPECT_TRUE(is_linked(mesh));
  return {points(mesh), values(mesh, n), faces_of(mesh)};
}

// of a mesh with the faces of the case and its points in p
template <class M, class Point_map, class Normal_map>
Result with_maps(const Case& c, M& mesh, Point_map p, Normal_map n)
{
  put_normals(normals(c.soup), mesh, n);
  subdivide(c, mesh, params::number_of_iterations(2).vertex_point_map(p).vertex_normal_map(n));
  EXPECT_TRUE(is_linked(mesh)) << c.name;
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh)) << c.name;
  return {values(mesh, p), values(mesh, n), faces_of(mesh)};
}

template <class K, class M, class Point_map>
Result with_dynamic_normals(const Case& c, M& mesh, Point_map p)
{
  build(c.soup, mesh, p);
  return with_maps(c, mesh, p, get(CGAL::dynamic_vertex_property_t<typename K::Vector_3>(), mesh));
}

template <class K, class M>
void expect_same_as_surface_mesh()
{
  for (const Case& c : cases()) {
    M mesh;
    EXPECT_TRUE((with_dynamic_normals<K>(c, mesh, get(CGAL::vertex_point, mesh))) == reference(c))
      << c.name;
  }
}

} // namespace mesh_type_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_MESH_TYPE_CASES_H
