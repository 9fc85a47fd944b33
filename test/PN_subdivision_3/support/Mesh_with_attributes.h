// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_CARRYING_MESH_H
#define PN_SUBDIVISION_3_TEST_CARRYING_MESH_H

#include "Mesh_cases.h"
#include "Options.h"

#include <CGAL/boost/graph/iterator.h>

namespace carrying_mesh {

namespace PN = CGAL::PN_subdivision_3;

// a mesh with values of all kinds of elements; those of the corners of every other face are a chart
template <class Mesh, class Number = double>
struct Mesh_with_attributes
{
  template <class Tag>
  using Map = typename boost::property_map<Mesh, Tag>::type;

  Mesh_with_attributes()
  {
    of_vertices = get(CGAL::dynamic_vertex_property_t<Number>(), mesh);
    of_corners = get(CGAL::dynamic_halfedge_property_t<Number>(), mesh);
    of_edges = get(CGAL::dynamic_edge_property_t<int>(), mesh);
    of_faces = get(CGAL::dynamic_face_property_t<int>(), mesh);
  }
  explicit Mesh_with_attributes(const mesh_cases::Soup& soup)
    : Mesh_with_attributes()
  {
    mesh_cases::build(soup, mesh);
    int i = 0, j = 0, k = 0;
    for (auto v : vertices(mesh)) put(of_vertices, v, Number(7 * ++i % 13) / Number(10));
    for (auto h : halfedges(mesh)) put(of_corners, h, Number(0));
    for (auto f : faces(mesh)) {
      for (auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
        put(of_corners, h, Number(get(of_vertices, target(h, mesh)) + Number(++j % 2)));
      put(of_faces, f, ++k);
    }
    for (auto e : edges(mesh)) put(of_edges, e, ++k);
  }
  auto attributes() const
  {
    return test_options::attributes(
      PN::parameters::vertex_attribute(of_vertices),
      PN::parameters::corner_attribute(of_corners, PN::Corner_rule::all),
      PN::parameters::edge_attribute(of_edges), PN::parameters::face_attribute(of_faces));
  }
  std::vector<Number> carried() const
  {
    std::vector<Number> result;
    for (auto v : vertices(mesh)) result.push_back(get(of_vertices, v));
    for (auto h : halfedges(mesh))
      if (!CGAL::is_border(h, mesh)) result.push_back(get(of_corners, h));
    for (auto e : edges(mesh)) result.push_back(Number(get(of_edges, e)));
    for (auto f : faces(mesh)) result.push_back(Number(get(of_faces, f)));
    return result;
  }

  Mesh mesh;
  Map<CGAL::dynamic_vertex_property_t<Number>> of_vertices;
  Map<CGAL::dynamic_halfedge_property_t<Number>> of_corners;
  Map<CGAL::dynamic_edge_property_t<int>> of_edges;
  Map<CGAL::dynamic_face_property_t<int>> of_faces;
};

} // namespace carrying_mesh

#endif // PN_SUBDIVISION_3_TEST_CARRYING_MESH_H
