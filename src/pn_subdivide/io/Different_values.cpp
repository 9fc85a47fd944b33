// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Different_values.h"

#include <algorithm>
#include <numeric>

namespace pn_subdivide {

Different_values::Different_values(const Mesh_data& mesh, const std::vector<Triple>& of_corners)
{
  std::vector<Mesh_data::Index> vertex_of;
  vertex_of.reserve(of_corners.size());
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    vertex_of.insert(vertex_of.end(), mesh.face(f).begin(), mesh.face(f).end());

  std::vector<std::size_t> order(of_corners.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (vertex_of[a] != vertex_of[b]) return vertex_of[a] < vertex_of[b];
    return are_equal(of_corners[a], of_corners[b]) ? a < b : is_less(of_corners[a], of_corners[b]);
  });
  std::vector<std::size_t> first(of_corners.size()); // corner with the same vertex and value
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t c = order[i];
    const bool is_new = i == 0 || vertex_of[order[i - 1]] != vertex_of[c] ||
                        !are_equal(of_corners[order[i - 1]], of_corners[c]);
    first[c] = is_new ? c : first[order[i - 1]];
  }
  of_corner.resize(of_corners.size());
  for (std::size_t c = 0; c < of_corners.size(); ++c) {
    of_corner[c] = first[c] == c ? values.size() : of_corner[first[c]];
    if (first[c] != c) continue;
    values.push_back(of_corners[c]);
    vertex.push_back(vertex_of[c]);
  }
}

} // namespace pn_subdivide
