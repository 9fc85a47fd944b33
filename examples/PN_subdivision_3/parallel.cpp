// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Several threads: the result is the same, bit for bit, as that of one.
//
//   parallel [MESH [ROUNDS]]

#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// A visitor is told of every round; an exception that it throws would cancel the work.
struct Progress
{
  void round_done(unsigned k, std::size_t number_of_faces) const
  {
    std::cout << "  round " << k << ": " << number_of_faces << " faces" << std::endl;
  }
};

template <class Concurrency_tag>
Mesh refined(Mesh mesh, unsigned rounds)
{
  auto normals = PN::estimate_control_normals(mesh);
  CGAL::Real_timer timer;
  timer.start();
  PN::CatmullClark_subdivision<Concurrency_tag>(
    mesh, params::number_of_iterations(rounds).vertex_normal_map(normals).visitor(Progress()));
  timer.stop();
  std::cout << "Output: " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces in "
            << timer.time() << " s" << std::endl;
  return mesh;
}

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  const unsigned rounds = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 5;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "Input: " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces"
            << std::endl;

  std::cout << "One thread\n";
  const Mesh sequential = refined<CGAL::Sequential_tag>(mesh, rounds);
  std::cout << "Several threads, where TBB is available\n";
  const Mesh parallel = refined<CGAL::Parallel_if_available_tag>(mesh, rounds);

  const bool same = std::equal(sequential.points().begin(), sequential.points().end(),
                               parallel.points().begin(), parallel.points().end());
  std::cout << (same ? "The points are the same." : "The points differ!") << std::endl;
  return same ? EXIT_SUCCESS : EXIT_FAILURE;
}
