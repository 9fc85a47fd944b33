// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/corner_normals.h"
#include "io/near_points.h"
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

bool is_zero(const Triple& n)
{
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

// Different normals of vertices that are merged become those of corners: the copies of vertices were there for a
// hard edge. Where only one of them has a normal it is that of all.
void merge_normals(Mesh_data& mesh, const std::vector<Index>& first)
{
  if (!mesh.has_normals() || mesh.has_corner_normals()) return;
  bool differ = false;
  std::vector<bool> has_several(first.size(), false);
  std::vector<Triple> of_first(mesh.normals);
  for (std::size_t v = 0; v < first.size(); ++v) {
    const Triple &n = mesh.normals[v], &m = of_first[first[v]];
    if (is_zero(n) || n == m) continue;
    if (is_zero(m))
      of_first[first[v]] = n;
    else
      has_several[first[v]] = differ = true;
  }
  if (differ)
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (const Index v : mesh.face(f))
        mesh.corner_normals.push_back(has_several[first[v]] ? normalized(mesh.normals[v])
                                                            : of_first[first[v]]);
  mesh.normals = std::move(of_first);
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
  attributes.has_texture_type_of_file = columns[0]->has_type_of_file;
  const std::string names[] = {columns[0]->name, columns[1]->name};
  const auto is_moved = [&names](const Column& c) {
    return c.name == names[0] || c.name == names[1];
  };
  Columns& all = attributes.of_vertices;
  all.erase(std::remove_if(all.begin(), all.end(), is_moved), all.end());
}

// Vertex v goes into first[v], the first of those with which it is merged.
std::size_t merge(Mesh_data& mesh, const std::vector<Index>& first, Point_merge& result)
{
  move_texture_to_corners(mesh, first);
  for (Column& column : mesh.attributes.of_vertices) {
    auto& names = result.differing_attributes;
    if (differ(column, first) && std::find(names.begin(), names.end(), column.name) == names.end())
      names.push_back(column.name);
    keep_first(column.values, first);
  }
  merge_normals(mesh, first);
  keep_first(mesh.normals, first);
  keep_first(mesh.roundness, first);
  std::vector<Index> number(first.size());
  Index kept = 0;
  for (std::size_t v = 0; v < first.size(); ++v)
    number[v] = first[v] == v ? kept++ : number[first[v]];
  keep_first(mesh.points, first);

  mesh.renumber_vertices(number);
  if (mesh.has_corner_normals()) {
    mesh.vertices_with_several_normals = vertices_with_several_normals(mesh);
    set_vertex_normals(mesh);
  }
  if (mesh.merged_into.empty())
    mesh.merged_into = std::move(number);
  else
    for (Index& v : mesh.merged_into) v = number[v];
  return first.size() - kept;
}

} // namespace

Point_merge merge_equal_points(Mesh_data& mesh)
{
  Point_merge result;
  result.merged_vertices = merge(mesh, first_equal(mesh.points), result);
  return result;
}

Point_merge merge_near_points(Mesh_data& mesh, double distance)
{
  Point_merge result = merge_equal_points(mesh);
  if (!(distance > 0)) return result;
  const std::vector<Index> first = first_near(mesh, distance);
  result.joined_vertices = merge(mesh, first, result);
  return result;
}

} // namespace pn_subdivide
