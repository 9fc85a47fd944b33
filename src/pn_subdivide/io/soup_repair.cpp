// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/soup_repair.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

namespace pn_subdivide {
namespace {

struct Visitor : CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  void polygon_orientation_reversed(std::size_t) { ++repair->reversed_faces; }

  void duplicated_vertex(std::size_t old_vertex, std::size_t)
  {
    ++repair->added_vertices;
    if (mesh->has_normals()) mesh->normals.push_back(mesh->normals[old_vertex]);
  }

  Mesh_data* mesh;
  Soup_repair* repair;
};

} // namespace

Soup_repair repair_soup(Mesh_data& mesh)
{
  std::vector<std::vector<std::size_t>> faces(mesh.number_of_faces());
  for (std::size_t f = 0; f < faces.size(); ++f)
    faces[f].assign(mesh.face(f).begin(), mesh.face(f).end());

  Soup_repair repair;
  const Visitor visitor{{}, &mesh, &repair};
  CGAL::Polygon_mesh_processing::orient_polygon_soup(mesh.points, faces,
                                                     CGAL::parameters::visitor(visitor));

  mesh.clear_faces();
  for (const auto& face : faces) mesh.add_face(face);
  return repair;
}

std::string Soup_repair::description() const
{
  return "repaired: " + std::to_string(reversed_faces) +
         (reversed_faces == 1 ? " face" : " faces") + " reversed, " +
         std::to_string(added_vertices) + (added_vertices == 1 ? " vertex" : " vertices") +
         " added as copies";
}

} // namespace pn_subdivide
