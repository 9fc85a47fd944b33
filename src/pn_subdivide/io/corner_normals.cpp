// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/corner_normals.h"

#include <algorithm>
#include <numeric>

namespace pn_subdivide {

Different_normals::Different_normals(const Mesh_data& mesh)
{
  const std::vector<Triple>& given = mesh.corner_normals;
  std::vector<Mesh_data::Index> vertex_of;
  vertex_of.reserve(given.size());
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    vertex_of.insert(vertex_of.end(), mesh.face(f).begin(), mesh.face(f).end());

  std::vector<std::size_t> order(given.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (vertex_of[a] != vertex_of[b]) return vertex_of[a] < vertex_of[b];
    return given[a] != given[b] ? given[a] < given[b] : a < b;
  });
  std::vector<std::size_t> first(given.size()); // corner with the same vertex and normal
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t c = order[i];
    const bool is_new =
      i == 0 || vertex_of[order[i - 1]] != vertex_of[c] || given[order[i - 1]] != given[c];
    first[c] = is_new ? c : first[order[i - 1]];
  }
  of_corner.resize(given.size());
  for (std::size_t c = 0; c < given.size(); ++c) {
    of_corner[c] = first[c] == c ? normals.size() : of_corner[first[c]];
    if (first[c] != c) continue;
    normals.push_back(given[c]);
    vertex.push_back(vertex_of[c]);
  }
}

void set_vertex_normals(Mesh_data& mesh)
{
  const Different_normals different(mesh);
  mesh.normals.resize(mesh.points.size(), Triple{0, 0, 0});
  std::vector<int> number(mesh.points.size(), 0); // of different normals; 2: more than one
  bool all_same = true;
  for (std::size_t i = 0; i < different.normals.size(); ++i) {
    const Mesh_data::Index v = different.vertex[i];
    Triple& n = mesh.normals[v];
    if (number[v] == 0)
      n = different.normals[i];
    else
      for (std::size_t k = 0; k < 3; ++k) n[k] += different.normals[i][k];
    number[v] = (std::min)(number[v] + 1, 2);
    all_same = all_same && number[v] == 1;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (number[v] == 2) mesh.normals[v] = normalized(mesh.normals[v]);
  if (all_same) mesh.corner_normals.clear();
}

} // namespace pn_subdivide
