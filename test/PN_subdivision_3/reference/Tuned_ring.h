// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The matrix that maps the 1-ring of an extraordinary vertex to the next one, with other
// eigenvalues: by a discrete Fourier transform and numerical eigenvectors of its blocks. Compiled once,
// in Tuned_ring.cpp, since that takes seconds.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_TUNED_RING_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_TUNED_RING_H

#include "Quadrisection.h"

namespace reference {

// `plain` acts on the vertex and `groups` rings of `valence` vertices each; the pair of eigenvalues
// lambda becomes `new_lambda`, or stays if this is 0. With a cap of 0, which stands for 1/2, the
// quadratic ones (of frequency 0 the second, of 2 the first; of groups of 3 instead the second of
// frequency 1) become the square of lambda.
Matrix tuned_ring(const Matrix& plain, int valence, int groups, Real cap, Real new_lambda);

// Whether v is extraordinary, its faces have the degree, and they have no other extraordinary
// corner.
inline bool is_separated(const Face_list& mesh, int v, int regular_valence, std::size_t degree)
{
  const auto is_extraordinary = [&](int u) {
    return mesh.is_interior_of_valence_other_than(regular_valence, u);
  };
  const std::vector<int> ring = mesh.ring(v);
  if (ring.size() < 3 || !is_extraordinary(v)) return false;
  for (int u : ring) {
    const Face& face = mesh.faces()[std::size_t(mesh.face(v, u))];
    if (face.size() != degree) return false;
    for (int corner : face)
      if (corner != v && is_extraordinary(corner)) return false;
  }
  return true;
}

// The row `weights` over the vertices `ring`.
inline Row spread(const Face_list& mesh, const std::vector<int>& ring, const Row& weights)
{
  Row row = mesh.zero();
  for (std::size_t i = 0; i < ring.size(); ++i) row[ring[i]] += weights[Eigen::Index(i)];
  return row;
}

// The index of the new vertex of the edge ab.
inline std::size_t edge_point(const Face_list& mesh, int a, int b)
{
  for (std::size_t e = 0; e < mesh.edges().size(); ++e)
    if (mesh.edges()[e] == Edge(a, b) || mesh.edges()[e] == Edge(b, a))
      return std::size_t(mesh.number_of_vertices()) + e;
  throw std::logic_error("reference: no such edge");
}
inline std::size_t face_point(const Face_list& mesh, int f)
{
  return std::size_t(mesh.number_of_vertices()) + mesh.edges().size() + std::size_t(f);
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_TUNED_RING_H
