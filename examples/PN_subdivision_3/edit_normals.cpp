// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Modeling with normals: one control normal is turned again and again, and the refined surface follows.
// Prints how many vertices follow and how many pictures a second that would be, and writes the last
// surface.
//
//   edit_normals [MESH [OUTPUT [ROUNDS]]]

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  const std::string output = argc > 2 ? argv[2] : "edit_normals.ply";
  const auto rounds = static_cast<unsigned>(argc > 3 ? std::atoi(argv[3]) : 4);
  Mesh control;
  if (!CGAL::IO::read_polygon_mesh(filename, control) || control.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  PN::Surface_refiner refiner(control, PN::CatmullClark_scheme(),
                              params::number_of_iterations(rounds));
  Mesh refined;
  refiner.build_mesh(refined);
  std::cout << control.number_of_faces() << " control faces, " << refiner.number_of_faces()
            << " refined ones, " << refiner.memory() / 1000000 << " MB kept" << std::endl;

  // The normal of a vertex in the middle is turned in a circle.
  const Mesh::Vertex_index edited(control.number_of_vertices() / 2);
  const Vector normal = refiner.control_normal(edited);
  std::size_t reached = 0;
  const int frames = 200;
  auto start = std::chrono::steady_clock::now();
  for (int i = 0; i <= frames; ++i) {
    const double angle = 0.1 * i;
    refiner.set_normal(edited, normal + Vector(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0));
    // Only what the normal reaches is computed, and only that is put.
    reached = refiner.update().size();
    refiner.update_mesh(refined);
    if (i == 0) start = std::chrono::steady_clock::now(); // the first call has more to find out
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::cout << reached << " of " << refiner.number_of_vertices() << " vertices follow one normal, "
            << frames / time.count() << " frames a second" << std::endl;
  return CGAL::IO::write_polygon_mesh(output, refined, params::stream_precision(17)) ? EXIT_SUCCESS
                                                                                     : EXIT_FAILURE;
}
