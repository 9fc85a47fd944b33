// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Growth of the peak resident set over one call, divided by the number of output faces.
//
//   peak_memory [catmull-clark|loop] [rings] [segments] [rounds] [limit]
//
// One measurement a process, since a peak is never forgotten: without arguments 64 x 61 quads are
// refined four times to a million. Fails where the growth exceeds `limit` bytes a face.

#include "Control_meshes.h"

#include <CGAL/PN_subdivision_3.h>

#include <sys/resource.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace {

double peak_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<double>(usage.ru_maxrss);
#else
  return 1024. * static_cast<double>(usage.ru_maxrss);
#endif
}

} // namespace

int main(int argc, char* argv[])
{
  namespace PN = CGAL::PN_subdivision_3;
  const bool loop = argc > 1 && std::string(argv[1]) == "loop";
  const int rings = argc > 2 ? std::atoi(argv[2]) : 64;
  const int segments = argc > 3 ? std::atoi(argv[3]) : 61;
  const int rounds = argc > 4 ? std::atoi(argv[4]) : 4;
  const double limit = argc > 5 ? std::atof(argv[5]) : 0;
  if (rings < 3 || segments < 3 || rounds < 1) {
    std::cerr << "usage: peak_memory [catmull-clark|loop] [rings] [segments] [rounds] [limit]\n";
    return EXIT_FAILURE;
  }

  Mesh mesh =
    loop ? Control_meshes::triangles(rings, segments) : Control_meshes::quads(rings, segments);
  const auto normals = Control_meshes::add_normals(mesh);
  const auto old_faces = mesh.number_of_faces();
  const auto np = CGAL::parameters::number_of_iterations(static_cast<unsigned>(rounds))
                    .vertex_normal_map(normals);

  const double before = peak_bytes();
  if (loop)
    PN::Loop_subdivision(mesh, np);
  else
    PN::CatmullClark_subdivision(mesh, np);
  const double bytes_per_face =
    (peak_bytes() - before) / static_cast<double>(mesh.number_of_faces());

  std::cout << (loop ? "Loop" : "Catmull-Clark") << ": " << old_faces << " -> "
            << mesh.number_of_faces() << " faces in " << rounds << " round(s), " << bytes_per_face
            << " bytes a face\n";
  if (limit > 0 && bytes_per_face > limit) {
    std::cerr << "more than " << limit << " bytes a face\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
