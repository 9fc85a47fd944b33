// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Processor time of a surface in many pieces, divided by that in fewer ones, at equal output.
//
//   pieces_time [rounds] [few] [many] [limit]
//
// Without arguments a cube is refined eight times, in 1024 and in 4096 pieces. Fails where the quotient exceeds
// `limit`; prints a checksum of the points, which is the same for any number of pieces.

#include "Control_meshes.h"

#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;

Mesh cube()
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < 8; ++i)
    v.push_back(mesh.add_vertex(Kernel::Point_3(i & 1, i >> 1 & 1, i >> 2)));
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) mesh.add_face(v[f[0]], v[f[1]], v[f[2]], v[f[3]]);
  return mesh;
}

struct Job
{
  double seconds = 0;
  std::uint64_t sum = 0;
};

Job refine(const Mesh& mesh, unsigned rounds, std::size_t number)
{
  Job job;
  const std::clock_t begin = std::clock();
  const PN::Surface_pieces pieces(
    mesh, PN::CatmullClark_scheme(),
    PN::parameters::number_of_pieces(number).number_of_iterations(rounds));
  for (std::size_t i = 0; i < number; ++i) {
    const auto piece = pieces.piece(i);
    for (std::uint32_t v = 0; v < piece.number_of_vertices(); ++v) {
      if (!piece.owns_vertex(v)) continue;
      for (int c = 0; c < 3; ++c) {
        const double x = piece.points()[v][c];
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        job.sum += bits * (2 * piece.vertex_number(v) + 1);
      }
    }
  }
  job.seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  return job;
}

} // namespace

int main(int argc, char* argv[])
{
  const unsigned rounds = argc > 1 ? unsigned(std::atoi(argv[1])) : 8;
  const int few = argc > 2 ? std::atoi(argv[2]) : 1024;
  const int many = argc > 3 ? std::atoi(argv[3]) : 4096;
  const double limit = argc > 4 ? std::atof(argv[4]) : 0;
  if (few < 1 || many < 1) {
    std::cerr << "usage: pieces_time [rounds] [few] [many] [limit]\n";
    return EXIT_FAILURE;
  }
  const Mesh mesh = cube();
  const Job a = refine(mesh, rounds, std::size_t(few)), b = refine(mesh, rounds, std::size_t(many));
  std::cout << rounds << " rounds: " << few << " pieces " << a.seconds << " s, " << many
            << " pieces " << b.seconds << " s: " << b.seconds / a.seconds << " times, checksum "
            << std::hex << a.sum << "\n";
  if (a.sum != b.sum) {
    std::cerr << "the points differ\n";
    return EXIT_FAILURE;
  }
  if (limit > 0 && b.seconds > limit * a.seconds) {
    std::cerr << "more than " << limit << " times\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
