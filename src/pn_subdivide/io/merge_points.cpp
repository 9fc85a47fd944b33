// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/mesh_normals.h"
#include "io/soup_repair.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pn_subdivide {
namespace {

struct Pair
{
  double distance;
  Index a, b; // a < b
};

// Points in the cells of a grid, sorted by these.
class Point_grid
{
public:
  Point_grid(const Mesh_data& mesh, const std::vector<Index>& vertices, double distance)
    // so that rounding takes no two points within the distance beyond neighboring cells
    : width_((std::max)(2 * distance, std::numeric_limits<double>::min()))
  {
    points_.reserve(vertices.size());
    for (const Index v : vertices) {
      const Triple& p = mesh.points[v];
      points_.push_back({{cell_of(p[0]), cell_of(p[1]), cell_of(p[2])}, v});
    }
    std::sort(points_.begin(), points_.end(), [](const Placed& p, const Placed& q) {
      return p.cell != q.cell ? p.cell < q.cell : p.vertex < q.vertex;
    });
  }

  // f(a, b) once for all pairs within the distance, and for some others
  template <class Function>
  void for_each_pair(const Function& f) const
  {
    for (auto p = points_.begin(); p != points_.end(); ++p) {
      const auto [x, y, z] = p->cell;
      for (auto q = p + 1; q != points_.end() && is_in_row(q->cell, {x, y, z}); ++q)
        f(p->vertex, q->vertex);
      for (const auto& [dx, dy] : {std::pair(0, 1), {1, -1}, {1, 0}, {1, 1}}) {
        const Triple first = {x + dx, y + dy, z - 1};
        if ((dx != 0 && first[0] == x) || (dy != 0 && first[1] == y)) continue;
        auto q =
          std::lower_bound(points_.begin(), points_.end(), first,
                           [](const Placed& s, const Triple& cell) { return s.cell < cell; });
        for (; q != points_.end() && is_in_row(q->cell, {first[0], first[1], z}); ++q)
          f(p->vertex, q->vertex);
      }
    }
  }

private:
  struct Placed
  {
    Triple cell;
    Index vertex;
  };

  // where cells are narrower than the digits of x, only equal numbers are near
  double cell_of(double x) const
  {
    const double cell = std::floor(x / width_);
    return std::abs(cell) < 1 / std::numeric_limits<double>::epsilon() ? cell : x;
  }
  // \pre not before the cell below
  static bool is_in_row(const Triple& cell, const Triple& other)
  {
    return cell[0] == other[0] && cell[1] == other[1] && cell[2] <= other[2] + 1;
  }

  double width_;
  std::vector<Placed> points_;
};

std::vector<Pair> pairs_within(const Mesh_data& mesh, const std::vector<Index>& vertices,
                               double distance)
{
  const std::size_t too_many = 64 * vertices.size() + 1000;
  std::vector<Pair> pairs;
  Point_grid(mesh, vertices, distance).for_each_pair([&](Index a, Index b) {
    const Triple d = difference(mesh.points[a], mesh.points[b]);
    const double length = std::hypot(d[0], d[1], d[2]);
    if (!(length <= distance)) return;
    pairs.push_back({length, (std::min)(a, b), (std::max)(a, b)});
    if (pairs.size() > too_many)
      throw Error("--merge-distance is too large for this mesh: it would join most of its points");
  });
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
    return p.distance != q.distance ? p.distance < q.distance : p.a != q.a ? p.a < q.a : p.b < q.b;
  });
  return pairs;
}

// Sets of vertices, which know the faces at them.
class Clusters
{
public:
  Clusters(const Mesh_data& mesh, const std::vector<Index>& vertices)
    : mesh_(mesh)
    , sets_(mesh.points.size())
    , faces_(vertices.size())
    , place_(mesh.points.size(), none)
  {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) sets_.make_set(v);
    for (std::size_t i = 0; i < vertices.size(); ++i) place_[vertices[i]] = i;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (const Index v : mesh.face(f))
        if (place_[v] != none) faces_[place_[v]].push_back(f);
  }

  void join(Index a, Index b)
  {
    const std::size_t s = sets_.find_set(a), t = sets_.find_set(b);
    if (s == t) return;
    std::vector<std::size_t>*few = &faces_[place_[s]], *many = &faces_[place_[t]];
    if (few->size() > many->size()) std::swap(few, many);
    const auto has_both = [&](std::size_t f) {
      bool has_s = false, has_t = false;
      for (const Index v : mesh_.face(f)) {
        const std::size_t root = sets_.find_set(v);
        has_s = has_s || root == s;
        has_t = has_t || root == t;
      }
      return has_s && has_t;
    };
    if (std::any_of(few->begin(), few->end(), has_both)) return;
    many->insert(many->end(), few->begin(), few->end());
    std::vector<std::size_t> faces = std::move(*many);
    few->clear();
    many->clear();
    sets_.link(s, t);
    faces_[place_[sets_.find_set(s)]] = std::move(faces);
  }

  std::vector<Index> first()
  {
    std::vector<Index> result(mesh_.points.size()), of_root(result.size());
    std::vector<bool> is_known(result.size(), false);
    for (std::size_t v = 0; v < result.size(); ++v) {
      const std::size_t root = sets_.find_set(v);
      if (!is_known[root]) of_root[root] = Index(v);
      is_known[root] = true;
      result[v] = of_root[root];
    }
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const Mesh_data& mesh_;
  boost::disjoint_sets_with_storage<> sets_;
  std::vector<std::vector<std::size_t>> faces_; // of the candidates, at the roots of the sets
  std::vector<std::size_t> place_;              // of a vertex among the candidates
};

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
    for (const Index v : mesh.vertices_of_corners())
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
  for (const Index v : mesh.vertices_of_corners())
    attributes.texture.push_back({columns[0]->values[v], columns[1]->values[v], 0});
  attributes.texture_type = columns[0]->type;
  attributes.has_texture_type_of_file = columns[0]->has_type_of_file;
  remove_columns(attributes.of_vertices, {columns[0]->name, columns[1]->name});
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

std::vector<Index> first_near(const Mesh_data& mesh, double distance)
{
  const std::vector<Index> vertices = vertices_at_open_edges(mesh);
  const std::vector<Pair> pairs = pairs_within(mesh, vertices, distance);
  if (pairs.empty()) {
    std::vector<Index> first(mesh.points.size());
    std::iota(first.begin(), first.end(), Index(0));
    return first;
  }
  Clusters clusters(mesh, vertices);
  for (const Pair& pair : pairs) clusters.join(pair.a, pair.b);
  return clusters.first();
}

double rounding_of_floats(const std::vector<Triple>& points)
{
  double largest = 0;
  for (const Triple& p : points)
    for (const double x : p) largest = (std::max)(largest, std::abs(x));
  if (!(largest > 0)) return 0;
  const int lowest = std::numeric_limits<float>::min_exponent - 1;
  return std::ldexp(4., (std::max)(std::ilogb(largest), lowest) -
                          (std::numeric_limits<float>::digits - 1));
}

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
