// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control normals for a mesh without any: estimated from the points, with the roundness at each vertex, and left out where the
// surface is to be that of the linear scheme.
//
//   estimate_normals [MESH [OUTPUT]]

#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::string filename =
    argc > 1 ? argv[1] : CGAL::data_file_path("meshes/mixed_borders.off");
  const std::string output = argc > 2 ? argv[2] : "estimate_normals.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "Input: " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces"
            << std::endl;

  auto normals = PN::estimate_control_normals(mesh);

  // At the border an estimated normal sees one side only. The zero vector means "no control
  // normal". Elsewhere the normals keep the roundness of the estimate.
  std::size_t without = 0, round = 0;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    if (mesh.is_border(v)) put(normals, v, CGAL::NULL_VECTOR);
    if (normals[v] == CGAL::NULL_VECTOR)
      ++without;
    else if (get(normals.roundness_map(), v) > 0.5)
      ++round;
  }
  std::cout << without << " vertices without a control normal, " << round << " that are round"
            << std::endl;

  CGAL::Real_timer timer;
  timer.start();
  PN::CatmullClark_subdivision(mesh, params::number_of_iterations(3).vertex_normal_map(normals));
  timer.stop();
  std::cout << "Output: " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces in "
            << timer.time() << " s" << std::endl;

  return CGAL::IO::write_polygon_mesh(output, mesh, params::stream_precision(17)) ? EXIT_SUCCESS
                                                                                  : EXIT_FAILURE;
}
