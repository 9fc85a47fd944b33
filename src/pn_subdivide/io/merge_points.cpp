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
#include <cmath>
#include <numeric>
#include <string>
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

bool differ(const Column& column, const std::vector<Index>& first)
{
  for (std::size_t v = 0; v < first.size(); ++v) {
    const double x = column.values[v], y = column.values[first[v]];
    if (x != y && !(std::isnan(x) && std::isnan(y))) return true;
  }
  return false;
}

// Texture coordinates of vertices that are merged and have different ones become those of corners:
// the copies of vertices were there for a seam.
void move_texture_to_corners(Mesh_data& mesh, const std::vector<Index>& first)
{
  Attributes& attributes = mesh.attributes;
  const Column_group columns = find_texture(attributes.of_vertices);
  const auto is_cut = [&first](const Column* column) { return differ(*column, first); };
  if (!attributes.texture.empty() || std::none_of(columns.begin(), columns.end(), is_cut)) return;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Index v : mesh.face(f))
      attributes.texture.push_back({columns[0]->values[v], columns[1]->values[v], 0});
  attributes.texture_type = columns[0]->type;
  const std::string names[] = {columns[0]->name, columns[1]->name};
  const auto is_moved = [&names](const Column& c) {
    return c.name == names[0] || c.name == names[1];
  };
  Columns& all = attributes.of_vertices;
  all.erase(std::remove_if(all.begin(), all.end(), is_moved), all.end());
}

} // namespace

Point_merge merge_equal_points(Mesh_data& mesh)
{
  const std::vector<Index> first = first_equal(mesh.points);
  Point_merge result;
  move_texture_to_corners(mesh, first);
  for (Column& column : mesh.attributes.of_vertices) {
    if (differ(column, first)) result.differing_attributes.push_back(column.name);
    keep_first(column.values, first);
  }
  if (mesh.has_normals()) {
    mesh.normals = merged_normals(mesh, first);
    keep_first(mesh.normals, first);
  }
  std::vector<Index> number(first.size());
  Index kept = 0;
  for (std::size_t v = 0; v < first.size(); ++v)
    number[v] = first[v] == v ? kept++ : number[first[v]];
  keep_first(mesh.points, first);

  mesh.renumber_vertices(number);
  mesh.merged_into = std::move(number);
  result.merged_vertices = first.size() - kept;
  return result;
}

} // namespace pn_subdivide
