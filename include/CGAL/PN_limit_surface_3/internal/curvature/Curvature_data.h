// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_DATA_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_DATA_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Orders points by the cells of a grid over their box, along a curve that stays close to itself. In a refined mesh
// the vertices of old vertices, edges and faces have numbers far apart: what looks at one vertex after the other
// with those around it waits for memory most of the time.
class Cell_order
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;
  using Points = std::vector<Vector>;

  explicit Cell_order(const Points& points)
    : points_(points)
  {
    // about as many cells as points: a surface meets few of them
    while (points.size() >> (3 * (bits_ + 1)) != 0 && bits_ < 10) ++bits_;
  }

  // the numbers of the points in this order
  std::vector<Index> operator()() const
  {
    std::vector<std::uint32_t> cell(points_.size());
    std::vector<Index> end((std::size_t(1) << (3 * bits_)) + 1, 0);
    set_cells(cell);
    for (const std::uint32_t c : cell) ++end[c + 1];
    for (std::size_t c = 1; c < end.size(); ++c) end[c] += end[c - 1];
    std::vector<Index> result(points_.size());
    for (std::size_t v = 0; v < cell.size(); ++v) result[end[cell[v]]++] = static_cast<Index>(v);
    return result;
  }

  // the least corner and the size of the box
  static std::pair<Vector, Vector> span(const Points& points)
  {
    Vector least{0, 0, 0}, greatest{0, 0, 0};
    if (!points.empty()) least = greatest = points.front();
    for (const Vector& p : points)
      for (std::size_t c = 0; c < 3; ++c) {
        least[c] = (std::min)(least[c], p[c]);
        greatest[c] = (std::max)(greatest[c], p[c]);
      }
    return {least, {greatest[0] - least[0], greatest[1] - least[1], greatest[2] - least[2]}};
  }

private:
  void set_cells(std::vector<std::uint32_t>& cell) const
  {
    const auto [least, size] = span(points_);
    const double last = std::ldexp(1., bits_) - 1;
    for (std::size_t v = 0; v < points_.size(); ++v)
      for (std::size_t c = 0; c < 3; ++c) {
        if (!(size[c] > 0) || !std::isfinite(size[c])) continue;
        const double place = (points_[v][c] - least[c]) / size[c] * (last + 1);
        cell[v] |= spread(static_cast<std::uint32_t>((std::min)(place, last))) << c;
      }
  }

  // two zeros behind each of the last ten bits
  static std::uint32_t spread(std::uint32_t x)
  {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
  }

  const Points& points_;
  int bits_ = 0; // of a coordinate of a cell
};

// What is known of the vertices of a mesh, which are numbered anew, so that near ones have near numbers. A normal
// is a unit vector or zero; it takes part in the fit if `fits_normals`, and otherwise only tells the sides of the
// surface apart.
struct Curvature_data
{
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  struct Vertex
  {
    Vector point, normal;
  };

  // without normals
  Curvature_data(Level_connectivity&& a_level, const std::vector<Vector>& points)
    : level(std::move(a_level))
    , unit(unit_of(points))
    , old_number(Cell_order(points)())
  {
    vertices.reserve(points.size());
    for (const Index v : old_number) vertices.push_back({points[v], {0, 0, 0}});
    const Index n = level.number_of_vertices();
    std::vector<Index> number(n);
    for (Index v = 0; v < n; ++v) number[old_number[v]] = v;
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      level.set_target(h, number[level.target(h)]);
    for (Index v = 0; v < n; ++v) number[v] = level.halfedge_of_vertex(old_number[v]);
    for (Index v = 0; v < n; ++v) level.set_halfedge_of_vertex(v, number[v]);
  }

  // from one vertex to another, in the unit
  Vector offset(Index from, Index to) const
  {
    const Vector &a = vertices[from].point, &b = vertices[to].point;
    return {unit * (b[0] - a[0]), unit * (b[1] - a[1]), unit * (b[2] - a[2])};
  }

  // The order in which things are added up about a vertex must not depend on the new numbers.
  bool is_before(Index v, Index w) const { return old_number[v] < old_number[w]; }

  Level_connectivity level;
  // A power of two that makes the size of the mesh about 1.
  double unit;
  std::vector<Index> old_number;
  std::vector<Vertex> vertices;
  // Where a vertex has no normal of its own, the normal of its faces gives the plane of the fit. Only if
  // normals are fitted.
  std::vector<Vector> face_normals;
  bool fits_normals = false;

private:
  static double unit_of(const std::vector<Vector>& points)
  {
    const auto span = Cell_order::span(points).second;
    const double size = (std::max)({span[0], span[1], span[2]});
    constexpr int largest = 1000;
    if (!(size > 0) || !std::isfinite(size)) return 1;
    return std::ldexp(1., (std::min)((std::max)(-std::ilogb(size), -largest), largest));
  }
};

// The vertices that share faces with each vertex of the interior, clockwise; none at the border. They begin with
// the neighbor of the least number, whatever half-edge the vertex stores.
class Face_neighbors
{
public:
  using Index = Level_connectivity::Index;

  explicit Face_neighbors(const Curvature_data& data)
    : data_(data)
    , begin_(std::size_t(data.level.number_of_vertices()) + 1, 0)
  {
    count(data.level);
    vertices_.resize(begin_.back());
  }

  // to be called once for every vertex
  void set(Index v)
  {
    if (begin(v) != end(v)) fill(data_.level, v);
  }

  const Index* begin(Index v) const { return vertices_.data() + begin_[v]; }
  const Index* end(Index v) const { return vertices_.data() + begin_[std::size_t(v) + 1]; }

private:
  void count(const Level_connectivity& level)
  {
    const Index uniform = level.uniform_degree();
    for (Index f = 0; f < level.number_of_faces(); ++f) {
      const Index first = level.halfedge_of_face(f);
      const Index degree = uniform != 0 ? uniform : level.degree(first);
      Index h = first;
      do {
        begin_[std::size_t(level.target(h)) + 1] += degree - 2;
        h = level.next(h);
      } while (h != first);
    }
    if (level.has_border())
      for (Index v = 0; v < level.number_of_vertices(); ++v)
        if (!level.is_isolated(v) && level.is_border_vertex(v)) begin_[std::size_t(v) + 1] = 0;
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  }

  void fill(const Level_connectivity& level, Index v)
  {
    Index* to = vertices_.data() + begin_[v];
    const Index first = first_halfedge(level, v);
    Index h = first;
    do {
      *to++ = level.source(h);
      const Index next = level.next(h);
      for (Index g = level.next(next); level.next(g) != h; g = level.next(g))
        *to++ = level.target(g);
      h = Level_connectivity::opposite(next);
    } while (h != first);
  }

  Index first_halfedge(const Level_connectivity& level, Index v) const
  {
    const Index first = level.halfedge_of_vertex(v);
    Index best = first;
    for (Index h = level.next_around_target(first); h != first; h = level.next_around_target(h))
      if (data_.is_before(level.source(h), level.source(best))) best = h;
    return best;
  }

  const Curvature_data& data_;
  std::vector<std::size_t> begin_; // in vertices_
  std::vector<Index> vertices_;
};

// The normals of Angle_weighted_normals, vertex by vertex, but for angles that are good to 3e-8: where
// they only lay the planes of fits, the others take longer than all the rest.
class Corner_normals
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  explicit Corner_normals(const Curvature_data& data)
    : data_(data)
  {}

  // a unit vector; zero if the faces have no area, or their normals cancel
  Vector operator()(Index v) const
  {
    if (data_.level.is_isolated(v)) return {};
    Sum sum = sum_of_faces(v, 1);
    // squares of areas in range, whatever the size of the faces is beside that of the mesh
    if (!(sum.largest > 1e-60)) {
      if (!(sum.largest > 0)) return {};
      sum = sum_of_faces(v, std::ldexp(1., (std::min)(-std::ilogb(sum.largest), 1000)));
    }
    const double length = std::sqrt(dot<double, 3>(sum.normal, sum.normal));
    if (!(length > 4096 * epsilon * sum.angles)) return {};
    return quotient(sum.normal, length);
  }

  // Abramowitz and Stegun, 4.4.46. \pre |x| <= 1
  static double arc_cosine(double x)
  {
    constexpr double pi = 3.14159265358979324;
    const double c = std::abs(x);
    double sum = -0.0012624911;
    for (const double a : {0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874,
                           -0.2145988016, 1.5707963050})
      sum = sum * c + a;
    const double angle = std::sqrt(1 - c) * sum;
    return x < 0 ? pi - angle : angle;
  }

private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();

  struct Sum
  {
    Vector normal{0, 0, 0};
    double angles = 0;
    double largest = 0; // a squared length of an edge, in the unit
  };

  struct Edge
  {
    Vector offset;
    double square, inverse_length;
  };

  Vector offset(Index v, Index h, double scale) const
  {
    return multiple(scale, data_.offset(v, data_.level.target(h)));
  }

  static Edge edge(const Vector& offset)
  {
    const double square = dot<double, 3>(offset, offset);
    return {offset, square, square > 0 ? 1 / std::sqrt(square) : 0};
  }

  Sum sum_of_faces(Index v, double scale) const
  {
    const Level_connectivity& level = data_.level;
    Sum sum;
    const double coordinate = data_.unit * scale * largest_coordinate(v);
    const Index first = level.halfedge_of_vertex(v);
    Edge before = edge(offset(v, Level_connectivity::opposite(first), scale));
    Index h = first;
    do { // the edge of `before` is that of h
      const Index next = level.next(h);
      const Edge after = edge(offset(v, next, scale));
      sum.largest = (std::max)(sum.largest, after.square);
      if (!level.is_border(h))
        add(sum, before, after, area(v, h, before, after, scale), coordinate);
      before = after;
      h = Level_connectivity::opposite(next);
    } while (h != first);
    return sum;
  }

  // twice the area vector of the face of h
  Vector area(Index v, Index h, const Edge& before, const Edge& after, double scale) const
  {
    Vector sum{0, 0, 0}, last = after.offset;
    for (Index g = data_.level.next(data_.level.next(h)); data_.level.next(g) != h;
         g = data_.level.next(g)) {
      const Vector corner = offset(v, g, scale);
      add_multiple<double, 3>(sum, 1, cross(last, corner));
      last = corner;
    }
    add_multiple<double, 3>(sum, 1, cross(last, before.offset));
    return sum;
  }

  // What the rounding of the coordinates alone can make of a face without area counts as no area.
  static void add(Sum& sum, const Edge& before, const Edge& after, const Vector& area,
                  double coordinate)
  {
    const double square = dot<double, 3>(area, area);
    const double side = (std::max)(before.square, after.square);
    const double rounding = 16 * epsilon * (coordinate + std::sqrt(side));
    if (!(square > rounding * rounding * side)) return;
    const double cosine =
      dot<double, 3>(before.offset, after.offset) * before.inverse_length * after.inverse_length;
    if (before.inverse_length == 0 || after.inverse_length == 0) return;
    const double angle = arc_cosine((std::max)(-1., (std::min)(1., cosine)));
    add_multiple<double, 3>(sum.normal, angle / std::sqrt(square), area);
    sum.angles += angle;
  }

  double largest_coordinate(Index v) const
  {
    const Vector& p = data_.vertices[v].point;
    return (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  }

  const Curvature_data& data_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_DATA_H
