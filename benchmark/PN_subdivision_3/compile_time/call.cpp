// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A mesh, maps and one call, which scripts/measure_budgets.sh names, with its headers in front: what a user's source takes to compile.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace CGAL::PN_subdivision_3 {} // namespace CGAL::PN_subdivision_3
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int main()
{
  Mesh mesh, result;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0});
  const auto c = mesh.add_vertex({1, 1, 0}), d = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c, d);
  [[maybe_unused]] auto normals =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", {0, 0, 1}).first;
  [[maybe_unused]] auto points =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:limit").first;
  [[maybe_unused]] auto colors = mesh.add_property_map<Mesh::Vertex_index, double>("v:color").first;
  [[maybe_unused]] auto sharp =
    mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  [[maybe_unused]] auto surfaces =
    mesh.add_property_map<Mesh::Face_index, std::size_t>("f:surface").first;
  PN_CALL;
  return mesh.number_of_faces() + result.number_of_faces() > 0 ? 0 : 1;
}
