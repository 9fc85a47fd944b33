// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A mesh, normals, two rounds: what a program with point-normal subdivision takes to compile, beside linear.cpp.

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0});
  const auto c = mesh.add_vertex({1, 1, 0}), d = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c, d);
  auto normals =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", {0, 0, 1}).first;
  CGAL::PN_subdivision_3::CatmullClark_subdivision(
    mesh, CGAL::parameters::vertex_normal_map(normals).number_of_iterations(2));
  return mesh.number_of_faces() == 16 ? 0 : 1;
}
