// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Points by one scheme, normals by another: Kobbelt's scheme keeps the old points, Catmull-Clark
// smooths the normals. Both refine by the same host.
//
//   normals_by_another_scheme [MESH [OUTPUT]]

#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  const std::string output = argc > 2 ? argv[2] : "normals_by_another_scheme.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  if (!CGAL::is_quad_mesh(mesh)) {
    std::cerr << "Kobbelt's scheme takes quadrilaterals only: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "Input: " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces"
            << std::endl;
  auto normals = PN::estimate_control_normals(mesh);
  const Mesh control = mesh;

  const auto scheme = PN::with_normal_scheme(PN::Kobbelt_scheme(), PN::CatmullClark_scheme());
  CGAL::Real_timer timer;
  timer.start();
  PN::subdivide(mesh, scheme, params::number_of_iterations(3).vertex_normal_map(normals));
  timer.stop();
  std::cout << "Output: " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces in "
            << timer.time() << " s" << std::endl;

  Mesh one_scheme = control;
  auto own = PN::estimate_control_normals(one_scheme);
  PN::Kobbelt_subdivision(one_scheme, params::number_of_iterations(3).vertex_normal_map(own));
  double squared = 0;
  for (Mesh::Vertex_index v : mesh.vertices())
    squared = (std::max)(squared, CGAL::squared_distance(mesh.point(v), one_scheme.point(v)));
  std::cout << "Largest distance to the surface with the normals by Kobbelt's scheme: "
            << std::sqrt(squared) << std::endl;

  for (Mesh::Vertex_index v : control.vertices())
    if (mesh.point(v) != control.point(v)) return EXIT_FAILURE;
  return CGAL::IO::write_polygon_mesh(output, mesh, params::stream_precision(17)) ? EXIT_SUCCESS
                                                                                  : EXIT_FAILURE;
}
