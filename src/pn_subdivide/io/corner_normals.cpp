// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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
  for (const Corner_normal& n : normals)
    all_same = all_same && (mesh.roundness.empty() || n.roundness == mesh.roundness[n.vertex]);
  if (!all_same) mesh.several_normals = std::move(normals);
}

void set_vertex_roundness(Mesh_data& mesh)
{
  if (mesh.corner_roundness.empty()) return;
  std::vector<double> least(mesh.points.size(), 2);
  const auto for_each_corner = [&](const auto& f) {
    std::size_t corner = 0;
    for (std::size_t face = 0; face < mesh.number_of_faces(); ++face)
      for (const Mesh_data::Index v : mesh.face(face)) f(mesh.corner_roundness[corner++], v);
  };
  for_each_corner([&](double w, Mesh_data::Index v) { least[v] = (std::min)(least[v], w); });
  bool all_same = true, all_round = mesh.roundness.empty();
  for_each_corner([&](double w, Mesh_data::Index v) {
    all_same = all_same && w == least[v];
    all_round = all_round && w == 1;
  });
  mesh.roundness.resize(all_round ? 0 : mesh.points.size(), 1);
  for (std::size_t v = 0; v < mesh.roundness.size(); ++v)
    if (least[v] < 2) mesh.roundness[v] = least[v];
  if (all_same) mesh.corner_roundness.clear();
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

Triple face_normal(const Mesh_data& mesh, std::size_t f)
{
  const Mesh_data::Face face = mesh.face(f);
  const Triple& origin = mesh.points[face.front()];
  double largest = 0; // so that no product overflows or vanishes
  for (const Mesh_data::Index v : face)
    for (const double x : difference(mesh.points[v], origin))
      largest = std::fmax(largest, std::abs(x));
  if (!(largest > 0)) return {0, 0, 0};

  const auto side = [&](const Mesh_data::Index& v) {
    Triple d = difference(mesh.points[v], origin);
    for (double& x : d) x /= largest;
    return d;
  };
  Triple before = side(face[1]), area = {0, 0, 0};
  for (std::ptrdiff_t i = 2; i < std::ptrdiff_t(face.size()); ++i) {
    const Triple now = side(face[i]), part = cross_product(before, now);
    if (i == 2)
      area = part; // with its signs of zero
    else
      for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
    before = now;
  }
  return normalized(area);
}

} // namespace pn_subdivide
