// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Linear_check.h"

#include "surface/Recognized_part.h"

#include <CGAL/PN_recognition_3/internal/recognition.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <cmath>

namespace pn_subdivide {
namespace {

namespace Recognition = PN::internal::recognition;

using Recognition::Shape;
using Recognition::Vec3;
using Kind = Recognized_surface::Kind;
using Triangle = Kernel::Triangle_3;
using Iterator = std::vector<Triangle>::const_iterator;
#if CGAL_VERSION_NR >= 1060000000
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Iterator>;
using Tree_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
using Tree_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

Point_3 as_point(const Vec3& p)
{
  return {p[0], p[1], p[2]};
}

double six_volumes(const Vec3& p, const Vec3& q, const Vec3& r)
{
  return dot(p, cross(q, r));
}

// The point of one surface or of two that is near to one of their tessellation; that itself if they are far apart.
Vec3 projected(Vec3 p, const Shape& a, const Shape& b, double farthest)
{
  constexpr int most = 20;
  constexpr double near = 1e-12;
  const Vec3 old = p;
  double distance = 1;
  for (int i = 0; i < most && distance > near; ++i) {
    distance = 0;
    for (const Shape* const s : {&a, &b}) {
      if (s->kind == Kind::unknown) continue;
      const double d = s->distance(p);
      distance = (std::max)(distance, std::abs(d));
      p = p - d * s->normal(p);
    }
  }
  return norm(p - old) <= farthest ? p : old;
}

} // namespace

struct Reference_surface::Tree
{
  std::vector<Triangle> triangles;
  std::vector<std::size_t> shape_of_triangle;
  std::vector<Shape> shapes;
  CGAL::AABB_tree<Tree_traits> tree;
};

// Triangles in the place of the faces.
class Reference_surface::Pieces
{
public:
  Pieces(const Surface& control, const std::vector<Triple>& points, const Frame& frame,
         const Recognized_part* part, Tree& tree)
    : control_(control)
    , points_(points)
    , tree_(tree)
    , segments_(control.number_of_faces(), 0)
  {
    if (part != nullptr) {
      segments_ = part->segments;
      for (const Recognized_surface& s : part->surfaces)
        tree_.shapes.push_back(
          Recognition::as_shape(s, frame.scale, {frame.shift[0], frame.shift[1], frame.shift[2]}));
    } else
      tree_.shapes.resize(1);
    std::size_t split_sides = 0;
    for (const Halfedge h : control.halfedges())
      split_sides += !control.is_border(h) && is_split(h);
    has_round_surfaces_ = split_sides > 0;
    constexpr double most_triangles = 100000, most_steps = 4;
    if (split_sides > 0)
      steps_ = std::size_t(
        (std::max)(1., (std::min)(most_steps, std::sqrt(most_triangles / double(split_sides)))));
  }

  bool has_round_surfaces() const { return has_round_surfaces_; }

  // Returns the gain of volume.
  double add_all()
  {
    for (const Face f : control_.faces()) add(f);
    return gain_ / 6;
  }

private:
  const Shape& shape(Halfedge h) const
  {
    static const Shape unknown;
    return control_.is_border(h) ? unknown : tree_.shapes[segments_[control_.face(h)]];
  }
  // Is the triangle over this side of a face to be split? It is round, or its rim is.
  bool is_split(Halfedge h) const
  {
    return is_round(shape(h).kind) || is_round(shape(control_.opposite(h)).kind);
  }
  Vec3 point(Vertex v) const
  {
    const Triple& p = points_[v];
    return {p[0], p[1], p[2]};
  }

  void add(Face f)
  {
    const auto sides = halfedges_around_face(control_.halfedge(f), control_);
    segment_ = segments_[f];
    Vec3 mean;
    double n = 0;
    bool has_split = false;
    for (const auto h : sides) {
      mean += point(control_.target(h));
      ++n;
      has_split = has_split || is_split(h);
    }
    mean = (1 / n) * mean;
    if (n == 3 && !has_split) {
      const auto h = control_.halfedge(f);
      return put(point(control_.source(h)), point(control_.target(h)),
                 point(control_.target(control_.next(h))));
    }
    for (const auto h : sides) {
      const Vec3 p = point(control_.source(h)), q = point(control_.target(h));
      if (!has_split)
        put(p, q, mean);
      else
        split(h, p, q, mean);
    }
  }

  // In rows from the side to the mean, which is moved as all that is inside the face.
  void split(Halfedge h, const Vec3& p, const Vec3& q, const Vec3& mean)
  {
    const Shape &own = shape(h), &other = shape(control_.opposite(h));
    const double size = (std::max)({norm(q - p), norm(mean - p), norm(mean - q)});
    const std::size_t n = steps_;
    std::vector<Vec3> row;
    for (std::size_t j = 0; j <= n; ++j) {
      std::vector<Vec3> next;
      for (std::size_t i = 0; i + j <= n; ++i) {
        const double b = double(i) / double(n), c = double(j) / double(n);
        const Vec3 x = (1 - b - c) * p + b * q + c * mean;
        const bool is_corner = j == 0 && (i == 0 || i == n);
        next.push_back(is_corner ? x : projected(x, own, j == 0 ? other : own, size));
      }
      for (std::size_t i = 0; i + 1 < row.size(); ++i) {
        put_gain(row[i], row[i + 1], next[i]);
        if (i + 1 < next.size()) put_gain(row[i + 1], next[i + 1], next[i]);
      }
      row = std::move(next);
    }
    gain_ -= six_volumes(p, q, mean);
  }

  void put_gain(const Vec3& p, const Vec3& q, const Vec3& r)
  {
    gain_ += six_volumes(p, q, r);
    put(p, q, r);
  }
  void put(const Vec3& p, const Vec3& q, const Vec3& r)
  {
    if (!(norm(Vec3(cross(q - p, r - p))) > 0)) return;
    tree_.triangles.emplace_back(as_point(p), as_point(q), as_point(r));
    tree_.shape_of_triangle.push_back(segment_);
  }

  const Surface& control_;
  const std::vector<Triple>& points_;
  Tree& tree_;
  std::vector<std::size_t> segments_;
  std::size_t segment_ = 0; // of the face
  std::size_t steps_ = 1;
  bool has_round_surfaces_ = false;
  double gain_ = 0;
};

Reference_surface::Reference_surface(const Surface& control, const std::vector<Triple>& points,
                                     const Frame& frame, const Recognized_part* part)
  : tree_(std::make_unique<Tree>())
{
  Pieces pieces(control, points, frame, part, *tree_);
  has_round_surfaces_ = pieces.has_round_surfaces();
  gained_volume_ = pieces.add_all();
  tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
}

Reference_surface::~Reference_surface() = default;

// That of the surface itself, where its pieces are nearest.
double Reference_surface::distance(const Triple& t) const
{
  if (tree_->triangles.empty()) return 0;
  const Point_3 p(t[0], t[1], t[2]);
  const auto [nearest, piece] = tree_->tree.closest_point_and_primitive(p);
  const double distance = std::sqrt(CGAL::squared_distance(p, nearest));
  const Shape& shape =
    tree_->shapes[tree_->shape_of_triangle[std::size_t(piece - tree_->triangles.cbegin())]];
  if (!is_round(shape.kind)) return distance;
  return (std::min)(distance, std::abs(shape.distance(Vec3{t[0], t[1], t[2]})));
}

} // namespace pn_subdivide
