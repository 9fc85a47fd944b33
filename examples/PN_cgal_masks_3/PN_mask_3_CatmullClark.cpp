// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A sphere from the eight corners of a cube: CGAL's own Catmull-Clark mask in CGAL's own host, once
// as it is and once as a point-normal mask.

#include <CGAL/PN_cgal_masks_3/PN_mask_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

double largest_deviation_from_sphere(const Mesh& mesh, double radius)
{
  double deviation = 0;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const double r = std::sqrt((mesh.point(v) - CGAL::ORIGIN).squared_length());
    deviation = (std::max)(deviation, std::abs(r / radius - 1));
  }
  return deviation;
}

int main()
{
  const double radius = std::sqrt(3.);
  Mesh mesh;
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1),
                        Point(-1, 1, 1), Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), mesh);
  Mesh linear = mesh;

  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (Mesh::Vertex_index v : mesh.vertices()) normals[v] = (mesh.point(v) - CGAL::ORIGIN) / radius;

  const unsigned int rounds = 5;
  const auto point_normals = PN::Zipped_point_normal_map(mesh.points(), normals);
  CGAL::Subdivision_method_3::PQQ(
    mesh, PN::make_PN_mask_3<CGAL::CatmullClark_mask_3>(mesh, point_normals),
    params::vertex_point_map(point_normals).number_of_iterations(rounds));
  CGAL::Subdivision_method_3::CatmullClark_subdivision(linear,
                                                       params::number_of_iterations(rounds));

  std::cout << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces() << " faces\n"
            << "largest relative deviation from the sphere\n"
            << "  Catmull-Clark:    " << largest_deviation_from_sphere(linear, radius) << '\n'
            << "  PN-Catmull-Clark: " << largest_deviation_from_sphere(mesh, radius) << '\n';
  return EXIT_SUCCESS;
}
