// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Both schemes reproduce the sphere through the vertices of a Platonic solid.

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3> radial_normals(Mesh& mesh)
{
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for (Mesh::Vertex_index v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
  return normals;
}

bool is_sphere(const Mesh& mesh, double squared_radius, std::size_t number_of_faces)
{
  bool good = mesh.is_valid() && mesh.number_of_faces() == number_of_faces;
  for (const Point& p : mesh.points())
    good &= std::abs((p - CGAL::ORIGIN).squared_length() - squared_radius) < 1e-14 * squared_radius;
  if (!good) std::cerr << "not a sphere with " << number_of_faces << " faces\n";
  return good;
}

} // namespace

int main()
{
  namespace PN = CGAL::PN_subdivision_3;
  using CGAL::parameters::number_of_iterations;

  Mesh cube;
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1),
                        Point(-1, 1, 1), Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), cube);
  PN::CatmullClark_subdivision(cube,
                               number_of_iterations(3).vertex_normal_map(radial_normals(cube)));

  Mesh tetrahedron;
  CGAL::make_tetrahedron(Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1),
                         tetrahedron);
  PN::Loop_subdivision(tetrahedron,
                       number_of_iterations(3).vertex_normal_map(radial_normals(tetrahedron)));

  return is_sphere(cube, 3, 6 * 64) && is_sphere(tetrahedron, 3, 4 * 64) ? EXIT_SUCCESS
                                                                         : EXIT_FAILURE;
}
