// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the primal schemes share: a new vertex per edge, and the faces of the two quadrisections.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_QUADRISECTION_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_QUADRISECTION_H

#include "Face_list.h"

#include <map>

namespace reference {

// Vertices by `vertex(v)`, then edges by `edge(a, b)`, each in the order of the mesh.
template <class Vertex_rule, class Edge_rule>
std::map<Edge, int> add_vertices_and_edges(const Face_list& mesh, Refined& result,
                                           const Vertex_rule& vertex, const Edge_rule& edge)
{
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    result.add(mesh.ring(v).empty() ? mesh.point(v) : vertex(v));
  std::map<Edge, int> on_edge;
  for (const auto& [a, b] : mesh.edges())
    on_edge[{a, b}] = on_edge[{b, a}] = result.add(edge(a, b));
  return on_edge;
}

inline void add_corner_quads(const Face_list& mesh, const std::map<Edge, int>& on_edge,
                             const std::vector<int>& on_face, Refined& result)
{
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    const Face& face = mesh.faces()[std::size_t(f)];
    const std::size_t m = face.size();
    for (std::size_t i = 0; i < m; ++i) {
      const int before = face[(i + m - 1) % m], at = face[i], after = face[(i + 1) % m];
      result.faces.push_back(
        {at, on_edge.at({at, after}), on_face[std::size_t(f)], on_edge.at({before, at})});
    }
  }
}

inline void add_four_triangles(const Face_list& mesh, const std::map<Edge, int>& on_edge,
                               Refined& result)
{
  for (const Face& t : mesh.faces()) {
    const int ab = on_edge.at({t[0], t[1]}), bc = on_edge.at({t[1], t[2]}),
              ca = on_edge.at({t[2], t[0]});
    for (const Face& child :
         {Face{t[0], ab, ca}, Face{t[1], bc, ab}, Face{t[2], ca, bc}, Face{ab, bc, ca}})
      result.faces.push_back(child);
  }
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_QUADRISECTION_H
