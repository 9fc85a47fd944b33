// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <algorithm>
#include <cmath>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main()
{
  Mesh mesh; // a cube, with control normals away from its center, ...
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1),
                        Point(-1, 1, 1), Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), mesh);
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for (Mesh::Vertex_index v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;

  CGAL::PN_subdivision_3::CatmullClark_subdivision(
    mesh, CGAL::parameters::number_of_iterations(5).vertex_normal_map(normals));

  double deviation = 0; // ... becomes the sphere through its vertices
  for (const Point& p : mesh.points())
    deviation = (std::max)(deviation, std::abs((p - CGAL::ORIGIN).squared_length() - 3));
  std::cout << mesh.number_of_faces() << " faces, squared radius 3 +- " << deviation << "\n";
  return deviation < 1e-13 ? 0 : 1;
}
