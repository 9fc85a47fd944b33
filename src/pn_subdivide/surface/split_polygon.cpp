// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/split_polygon.h"

#include "surface/Ear_clipping.h"
#include "surface/Polygon_in_plane.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace pn_subdivide {
namespace {

using Index = std::uint32_t;

// More corners are not worth cubic time.
constexpr std::size_t corners_for_the_best_split = 200;

// What is bad in a set of triangles, the worst first.
struct Harm
{
  Index double_edges = 0, folds = 0, flat = 0;
  double size = 0;

  bool operator<(const Harm& h) const
  {
    return std::tie(double_edges, folds, flat, size) <
           std::tie(h.double_edges, h.folds, h.flat, h.size);
  }
  Harm& operator+=(const Harm& h)
  {
    double_edges += h.double_edges;
    folds += h.folds;
    flat += h.flat;
    size += h.size;
    return *this;
  }
};

// The split of least harm, from those of all parts of the polygon that a diagonal cuts off.
class Best_split
{
public:
  Best_split(const Polygon_in_plane& polygon, const Is_edge& is_edge)
    : polygon_(polygon)
    , is_edge_(is_edge)
    , size_(Index(polygon.size()))
    , parts_(std::size_t(size_) * size_)
  {
    for (Index span = 2; span < size_; ++span)
      for (Index i = 0; i + span < size_; ++i) split(i, i + span);
  }

  std::vector<Corner_triangle> triangles() const
  {
    std::vector<Corner_triangle> result;
    std::vector<std::pair<Index, Index>> open = {{0, size_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j - i < 2) continue;
      const Index k = part(i, j).apex;
      result.push_back({i, k, j});
      open.push_back({i, k});
      open.push_back({k, j});
    }
    return result;
  }

private:
  struct Part
  {
    Harm harm;
    Index apex = 0;
  };

  Part& part(Index i, Index j) { return parts_[std::size_t(i) * size_ + j]; }
  const Part& part(Index i, Index j) const { return parts_[std::size_t(i) * size_ + j]; }

  void split(Index i, Index j)
  {
    Part& best = part(i, j);
    for (Index k = i + 1; k < j; ++k) {
      Harm harm = harm_of(i, k, j);
      harm += part(i, k).harm;
      harm += part(k, j).harm;
      if (k > i + 1 && !(harm < best.harm)) continue;
      best.harm = harm;
      best.apex = k;
    }
    if (j - i + 1 == size_) return;
    best.harm.double_edges += is_edge_(i, j);
    best.harm.size += polygon_.squared_distance(i, j) / 1024; // of equal areas the short ones
  }

  Harm harm_of(Index i, Index k, Index j) const
  {
    const int turn = polygon_.turn(i, k, j);
    return {0, Index(turn < 0), Index(turn == 0), polygon_.area(i, k, j)};
  }

  const Polygon_in_plane& polygon_;
  const Is_edge& is_edge_;
  Index size_;
  std::vector<Part> parts_;
};

bool has_no_fold(const Polygon_in_plane& polygon, const std::vector<Corner_triangle>& triangles)
{
  return std::all_of(triangles.begin(), triangles.end(),
                     [&](const Corner_triangle& t) { return polygon.turn(t[0], t[1], t[2]) > 0; });
}

bool has_double_edge(const std::vector<Corner_triangle>& triangles, const Is_edge& is_edge,
                     std::size_t size)
{
  // each diagonal is the longest side of one triangle, but for the last one's
  return std::any_of(triangles.begin(), triangles.end(), [&](const Corner_triangle& t) {
    return t[2] - t[0] + 1 != size && is_edge(t[0], t[2]);
  });
}

} // namespace

std::vector<Corner_triangle> split_polygon(const std::vector<Point_3>& points,
                                           const Is_edge& is_edge)
{
  const Polygon_in_plane polygon(points);
  std::vector<Corner_triangle> triangles = Ear_clipping(polygon, is_edge).triangles();
  bool is_good = has_no_fold(polygon, triangles);
  if (points.size() <= corners_for_the_best_split &&
      (!is_good || has_double_edge(triangles, is_edge, points.size()))) {
    triangles = Best_split(polygon, is_edge).triangles();
    is_good = has_no_fold(polygon, triangles);
  }
  if (is_good) triangles = Polygon_flips(polygon, is_edge, triangles).triangles();
  std::sort(triangles.begin(), triangles.end(),
            [](const Corner_triangle& a, const Corner_triangle& b) {
              return std::make_tuple(a[2] - a[0], a[0]) < std::make_tuple(b[2] - b[0], b[0]);
            });
  return triangles;
}

} // namespace pn_subdivide
