// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/split_polygon.h"

namespace pn_subdivide {
namespace {

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

// New half-edges are behind the old ones. Those that end at a corner of an old face lie between the
// two old ones there.
std::vector<Halfedge> old_corners(const Surface& surface, Surface::size_type old_halfedges)
{
  std::vector<Halfedge> result(surface.number_of_halfedges());
  for (Surface::size_type i = 0; i < old_halfedges; ++i) {
    const Halfedge h(i);
    result[i] = h;
    if (surface.is_border(h)) continue;
    for (Halfedge g = surface.opposite(surface.next(h)); g >= Halfedge(old_halfedges);
         g = surface.opposite(surface.next(g)))
      result[g] = h;
  }
  return result;
}

// As long as the shorter of the two walks round the vertices.
bool are_joined(const Surface& surface, Halfedge to_a, Halfedge to_b)
{
  const Vertex a = surface.target(to_a), b = surface.target(to_b);
  Halfedge i = to_a, j = to_b;
  do {
    if (surface.source(i) == b || surface.source(j) == a) return true;
    i = surface.opposite(surface.next(i));
    j = surface.opposite(surface.next(j));
  } while (i != to_a && j != to_b);
  return false;
}

// Cuts the corner after `before` off its face. What is left keeps the face and `before`; the half-edge of the
// diagonal takes the place of the one to the corner behind.
Halfedge cut_corner_off(Surface& surface, Halfedge before)
{
  const Halfedge corner = surface.next(before), behind = surface.next(corner);
  const Face rest = surface.face(before), triangle = surface.add_face();
  const Halfedge diagonal = surface.add_edge(surface.target(before), surface.target(behind));
  const Halfedge inside = surface.opposite(diagonal);
  surface.set_next(diagonal, surface.next(behind));
  surface.set_next(before, diagonal);
  surface.set_next(behind, inside);
  surface.set_next(inside, corner);
  for (const Halfedge h : {inside, corner, behind}) surface.set_face(h, triangle);
  surface.set_face(diagonal, rest);
  surface.set_halfedge(triangle, inside);
  surface.set_halfedge(rest, diagonal);
  return diagonal;
}

class Split_faces
{
public:
  explicit Split_faces(Surface& surface)
    : surface_(surface)
    , is_edge_([this](std::uint32_t i, std::uint32_t j) {
      return are_joined(surface_, corners_[i], corners_[j]);
    })
  {}

  void operator()(Face f)
  {
    corners_.clear();
    points_.clear();
    for (const Halfedge h : halfedges_around_face(surface_.halfedge(f), surface_)) {
      corners_.push_back(h);
      points_.push_back(surface_.point(surface_.target(h)));
    }
    if (corners_.size() == 4) {
      cut_corner_off(surface_, corners_[split_quad()]);
      return;
    }
    std::vector<Corner_triangle> triangles = split_polygon(points_, is_edge_);
    triangles.pop_back(); // is what is left
    for (const Corner_triangle& t : triangles)
      corners_[t[2]] = cut_corner_off(surface_, corners_[t[0]]);
  }

private:
  // The greater product of the triangles' area vectors: no fold, no slivers. The corner after the one that is
  // returned is cut off.
  std::size_t split_quad() const
  {
    std::vector<Vector_3> p;
    for (const Point_3& point : points_) p.push_back(point - CGAL::ORIGIN);
    scale_to_one(p);
    const auto product = [&](std::size_t i) { // of the diagonal from i to i + 2
      const Vector_3 &a = p[i], &b = p[i + 1], &c = p[i + 2], &d = p[(i + 3) % 4];
      return CGAL::cross_product(b - a, b - c) * CGAL::cross_product(d - c, d - a);
    };
    std::size_t i = product(0) > product(1) ? 0 : 1;
    if (is_edge_(std::uint32_t(i), std::uint32_t(i + 2)) &&
        !is_edge_(std::uint32_t(1 - i), std::uint32_t(3 - i)))
      i = 1 - i;
    return i;
  }

  Surface& surface_;
  std::vector<Halfedge> corners_;
  std::vector<Point_3> points_;
  Is_edge is_edge_;
};

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

Triangulation triangulate(Surface& surface)
{
  Triangulation result;
  for (const Face f : surface.faces())
    if (surface.degree(f) > 3) ++result.split_faces;
  if (result.split_faces == 0) return result;

  const Surface::size_type old_halfedges = surface.number_of_halfedges();
  const Surface::size_type old_faces = surface.number_of_faces();
  Split_faces split(surface);
  for (Surface::size_type f = 0; f < old_faces; ++f)
    if (surface.degree(Face(f)) > 3) split(Face(f));
  result.old_corner = old_corners(surface, old_halfedges);
  if (const std::optional<Corner_normal_map> normals = corner_normals_of(surface))
    for (const Halfedge h : surface.halfedges())
      normals->put_whole(h, normals->whole(result.old_corner[h]));
  return result;
}

} // namespace pn_subdivide
