// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/soup_repair.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

namespace pn_subdivide {
namespace {

struct Visitor : CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  void polygon_orientation_reversed(std::size_t f) { (*is_reversed)[f] = !(*is_reversed)[f]; }

  void duplicated_vertex(std::size_t old_vertex, std::size_t)
  {
    add_values_of_copy(*mesh, static_cast<Index>(old_vertex));
  }

  Mesh_data* mesh;
  std::vector<bool>* is_reversed;
};

} // namespace

std::size_t orient_soup(Mesh_data& mesh, std::vector<bool>& is_reversed)
{
  std::vector<std::vector<std::size_t>> faces(mesh.number_of_faces());
  for (std::size_t f = 0; f < faces.size(); ++f)
    faces[f].assign(mesh.face(f).begin(), mesh.face(f).end());
  const std::size_t old_size = mesh.points.size();
  const Visitor visitor{{}, &mesh, &is_reversed};
  CGAL::Polygon_mesh_processing::orient_polygon_soup(mesh.points, faces,
                                                     CGAL::parameters::visitor(visitor));
  mesh.clear_faces();
  for (const auto& face : faces) mesh.add_face(face);
  return mesh.points.size() - old_size;
}

} // namespace pn_subdivide
