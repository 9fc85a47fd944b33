// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Any model of MutableFaceGraph, here a Polyhedron_3 with EPICK. Its control normals are in a map
// of their own, outside the polyhedron, and grow with it.
//
//   polyhedron [MESH [OUTPUT]]

#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  const std::string output = argc > 2 ? argv[2] : "polyhedron.off";
  Polyhedron polyhedron;
  if (!CGAL::IO::read_polygon_mesh(filename, polyhedron) || polyhedron.empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "Input: " << num_vertices(polyhedron) << " vertices, " << num_faces(polyhedron)
            << " faces" << std::endl;

  const auto normals = PN::estimate_control_normals(polyhedron);

  CGAL::Real_timer timer;
  timer.start();
  PN::CatmullClark_subdivision(polyhedron,
                               params::number_of_iterations(3).vertex_normal_map(normals));
  timer.stop();
  std::cout << "Output: " << num_vertices(polyhedron) << " vertices, " << num_faces(polyhedron)
            << " faces in " << timer.time() << " s" << std::endl;

  // now the map holds the normals of all vertices of the refined polyhedron
  for (Vertex v : vertices(polyhedron))
    if (normals[v] == CGAL::NULL_VECTOR) return EXIT_FAILURE;
  return CGAL::IO::write_polygon_mesh(output, polyhedron, params::stream_precision(17))
           ? EXIT_SUCCESS
           : EXIT_FAILURE;
}
