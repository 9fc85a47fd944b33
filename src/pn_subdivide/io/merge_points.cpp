// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/corner_normals.h"
#include "io/soup_repair.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pn_subdivide {
namespace {

using Index = Mesh_data::Index;

// For each vertex the first one with its point.
std::vector<Index> first_equal(const std::vector<Triple>& points)
{
  std::vector<Index> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(), [&points](Index a, Index b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] =
      i > 0 && points[order[i]] == points[order[i - 1]] ? first[order[i - 1]] : order[i];
  return first;
}

// The sum of unit normals, where there is more than one; a single one stays as it is.
std::vector<Triple> merged_normals(const Mesh_data& mesh, const std::vector<Index>& first)
{
  std::vector<Triple> sums(mesh.normals);
  std::vector<bool> is_sum(mesh.normals.size(), false);
  for (std::size_t v = 0; v < first.size(); ++v) {
    const Index to = first[v];
    if (to == v || mesh.normals[v] == mesh.normals[to]) continue;
    if (!is_sum[to]) sums[to] = normalized(sums[to]);
    const Triple n = normalized(mesh.normals[v]);
    for (std::size_t i = 0; i < 3; ++i) sums[to][i] += n[i];
    is_sum[to] = true;
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (is_sum[v]) sums[v] = normalized(sums[v]);
  return sums;
}

template <class T>
void keep_first(std::vector<T>& values, const std::vector<Index>& first)
{
  std::size_t kept = 0;
  for (std::size_t v = 0; v < values.size(); ++v)
    if (first[v] == v) values[kept++] = values[v];
  values.resize(kept);
}

} // namespace

std::size_t merge_equal_points(Mesh_data& mesh)
{
  const std::vector<Index> first = first_equal(mesh.points);
  if (mesh.has_normals()) {
    mesh.normals = merged_normals(mesh, first);
    keep_first(mesh.normals, first);
  }
  std::vector<Index> number(first.size());
  Index kept = 0;
  for (std::size_t v = 0; v < first.size(); ++v)
    number[v] = first[v] == v ? kept++ : number[first[v]];
  keep_first(mesh.points, first);

  const Mesh_data old = mesh;
  mesh.clear_faces();
  std::vector<Index> face;
  for (std::size_t f = 0; f < old.number_of_faces(); ++f) {
    face.clear();
    for (const Index v : old.face(f)) face.push_back(number[v]);
    mesh.add_face(face);
  }
  mesh.merged_into = std::move(number);
  return first.size() - kept;
}

} // namespace pn_subdivide
