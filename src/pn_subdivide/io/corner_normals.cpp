// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/corner_normals.h"

#include "io/Different_values.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace pn_subdivide {

void set_vertex_normals(Mesh_data& mesh)
{
  const Different_values different(mesh, mesh.corner_normals);
  mesh.normals.resize(mesh.points.size(), Triple{0, 0, 0});
  std::vector<int> number(mesh.points.size(), 0); // of different normals; 2: more than one
  bool all_same = true;
  for (std::size_t i = 0; i < different.values.size(); ++i) {
    const Mesh_data::Index v = different.vertex[i];
    Triple& n = mesh.normals[v];
    if (number[v] == 0)
      n = different.values[i];
    else
      for (std::size_t k = 0; k < 3; ++k) n[k] += different.values[i][k];
    number[v] = (std::min)(number[v] + 1, 2);
    all_same = all_same && number[v] == 1;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (number[v] == 2) mesh.normals[v] = normalized(mesh.normals[v]);
  if (all_same) mesh.corner_normals.clear();
}

void set_several_normals(Mesh_data& mesh, std::vector<Corner_normal>&& normals)
{
  std::unordered_map<Mesh_data::Index, std::vector<Triple>> different;
  for (const Corner_normal& n : normals) {
    std::vector<Triple>& of_vertex = different[n.vertex];
    const auto is_same = [&](const Triple& other) { return are_equal(other, n.normal); };
    if (std::none_of(of_vertex.begin(), of_vertex.end(), is_same)) of_vertex.push_back(n.normal);
  }
  bool all_same = true;
  for (const auto& [v, values] : different) {
    Triple sum = values[0];
    for (std::size_t i = 1; i < values.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += values[i][k];
    mesh.normals[v] = values.size() == 1 ? sum : normalized(sum);
    all_same = all_same && values.size() == 1;
  }
  if (!all_same) mesh.several_normals = std::move(normals);
}

std::size_t vertices_with_several_normals(const Mesh_data& mesh)
{
  std::vector<Triple> first(mesh.points.size(), Triple{0, 0, 0});
  std::vector<bool> has_several(mesh.points.size(), false);
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) {
      const Triple& n = mesh.corner_normals[corner++];
      if (normalized(n) == Triple{0, 0, 0}) continue;
      if (first[v] == Triple{0, 0, 0}) first[v] = n;
      if (directions_differ(first[v], n)) has_several[v] = true;
    }
  return static_cast<std::size_t>(std::count(has_several.begin(), has_several.end(), true));
}

} // namespace pn_subdivide
