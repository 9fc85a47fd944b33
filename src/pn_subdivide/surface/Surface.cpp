// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Surface.h"

#include "io/Error.h"

#include <CGAL/boost/graph/iterator.h>

#include <string>

namespace pn_subdivide {
namespace {

void add_faces(Surface& surface, const Mesh_data& mesh)
{
  std::size_t refused = 0, first_refused = 0;
  std::vector<Surface::Vertex_index> vertices;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    vertices.clear();
    for (const Mesh_data::Index v : mesh.face(f)) vertices.emplace_back(v);
    if (surface.add_face(vertices) != Surface::null_face()) continue;
    if (refused++ == 0) first_refused = f;
  }
  if (refused > 0)
    throw Error(std::to_string(refused) + " faces do not fit into a 2-manifold (first: face " +
                std::to_string(first_refused) + ")");
}

} // namespace

Surface make_surface(const Mesh_data& mesh)
{
  Surface surface;
  surface.reserve(static_cast<Surface::size_type>(mesh.points.size()),
                  static_cast<Surface::size_type>(mesh.number_of_corners()),
                  static_cast<Surface::size_type>(mesh.number_of_faces()));
  for (const Point_3& p : mesh.points) surface.add_vertex(p);
  add_faces(surface, mesh);
  return surface;
}

Mesh_data to_mesh_data(const Surface& surface)
{
  Mesh_data mesh;
  mesh.points.reserve(surface.number_of_vertices());
  for (const Surface::Vertex_index v : surface.vertices()) mesh.points.push_back(surface.point(v));

  mesh.reserve_faces(surface.number_of_faces(), surface.number_of_halfedges());
  std::vector<std::size_t> face;
  for (const Surface::Face_index f : surface.faces()) {
    face.clear();
    for (const Surface::Vertex_index v : vertices_around_face(surface.halfedge(f), surface))
      face.push_back(v);
    mesh.add_face(face);
  }
  return mesh;
}

} // namespace pn_subdivide
