// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SURFACE_PLACES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SURFACE_PLACES_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A point of a surface where triangles meet; parameters are those in a piece of a face.
struct Query_corner
{
  std::array<double, 2> parameters;
  Simple_cartesian<double>::Point_3 point;
  Simple_cartesian<double>::Vector_3 normal;
};

// A flat triangle between points of a surface.
template <class Face>
struct Query_triangle
{
  Face face;
  std::size_t piece;
  std::array<Query_corner, 3> corners;
  // by estimate: of the surface from it, of sides of the piece from its sides, and of its corners from the surface
  double distance, beside, error;

  Simple_cartesian<double>::Triangle_3 triangle() const
  {
    return {corners[0].point, corners[1].point, corners[2].point};
  }
};

// Places on a `Limit_surface`, and triangles between them.
template <class Surface>
class Surface_places
{
public:
  using Kernel = Simple_cartesian<double>;
  using Face = typename Surface::Face;
  using Surface_point = typename Surface::Surface_point;
  using Triangle = Query_triangle<Face>;

  // parameters in a piece, and what is there
  struct Place
  {
    Face face;
    std::size_t piece;
    double u, v;
    Surface_point at;
    double distance = std::numeric_limits<double>::infinity(), gap = distance;
  };

  explicit Surface_places(const Surface& surface)
    : surface_(surface)
  {}

  const Surface& surface() const { return surface_; }

  template <class Point>
  static Kernel::Point_3 in_double(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
  template <class Vector>
  static Kernel::Vector_3 vector_in_double(const Vector& v)
  {
    return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
  }

  typename Surface::Location location(const Place& p) const
  {
    return {p.face, 2. * double(p.piece) + p.u, p.v};
  }
  Surface_point evaluate(const Place& p) const
  {
    return surface_.evaluate(p.face, 2. * double(p.piece) + p.u, p.v);
  }

  // where the corners of a triangle have these weights, but a little inside
  Place start(const Triangle& t, const std::array<double, 3>& weights) const
  {
    Place place{t.face, t.piece, 0, 0, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = 0.98 * weights[k] + 0.02 / 3;
      place.u += part * t.corners[k].parameters[0];
      place.v += part * t.corners[k].parameters[1];
    }
    put_inside(place.u, place.v);
    return place;
  }

  // Stays in the piece. Corners may have no derivatives, so they are only approached.
  void move(Place& place, double du, double dv) const
  {
    constexpr double most = 15. / 16;
    double u = place.u + du, v = place.v + dv;
    put_inside(u, v);
    const bool is_corner = (u == 0 || u == 1) && (v == 0 || v == 1);
    place.u += (is_corner ? most : 1) * (u - place.u);
    place.v += (is_corner ? most : 1) * (v - place.v);
    put_inside(place.u, place.v);
  }

  // whether a place is within the box of the parameters of a triangle, grown by a part of its sides
  static bool is_about(const Place& place, const Triangle& t, double part)
  {
    if (t.face != place.face || t.piece != place.piece) return false;
    const auto is_between = [&](double x, std::size_t k) {
      const auto [least, greatest] = std::minmax(
        {t.corners[0].parameters[k], t.corners[1].parameters[k], t.corners[2].parameters[k]});
      const double growth = part * (greatest - least);
      return x >= least - growth && x <= greatest + growth;
    };
    return is_between(place.u, 0) && is_between(place.v, 1);
  }

  // Whether half the square of the distance from a point bends up over a triangle, as far as cubics over its sides tell, by a part of
  // what it does near the point: then there is no place but one where it is least.
  static bool has_one_foot(const Triangle& t, const Kernel::Point_3& p)
  {
    constexpr double part = 0.125;
    std::array<double, 3> bend;
    for (std::size_t k = 0; k < 3; ++k) {
      const Query_corner &a = t.corners[k], &b = t.corners[(k + 1) % 3];
      const Kernel::Vector_3 side = b.point - a.point, r = a.point - p, s = b.point - p;
      const double at_a = r * side - (r * a.normal) * (a.normal * side),
                   at_b = s * side - (s * b.normal) * (b.normal * side);
      bend[k] = at_b - at_a - part * side.squared_length();
      if (!(bend[k] >= 3 * std::abs((r + s) * side - at_a - at_b))) return false;
    }
    const auto [x, y, z] = bend;
    return 2 * (x * y + y * z + z * x) >= x * x + y * y + z * z;
  }

  // \name Triangles
  // those of a piece, whose sides are divided
  void add_triangles(Face face, std::size_t piece, unsigned divisions,
                     std::vector<Triangle>& all) const
  {
    const unsigned n = divisions;
    std::vector<std::array<double, 2>> parameters;
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= (surface_.is_triangular() ? n - j : n); ++i)
        parameters.push_back({double(i) / n, double(j) / n});
    const Corners corners = this->corners(face, piece, parameters);
    const std::size_t first = all.size();
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      all.push_back(
        triangle(face, piece, {corners.at[a], corners.at[b], corners.at[c]}, 0, corners.error));
    };
    std::size_t row = 0;
    for (unsigned j = 0; j < n; ++j) {
      const std::size_t width = (surface_.is_triangular() ? n - j : n) + 1, next = row + width;
      for (unsigned i = 0; i + 1 < width; ++i) {
        add(row + i, row + i + 1, next + i);
        if (!surface_.is_triangular() || i + 2 < width) add(row + i + 1, next + i + 1, next + i);
      }
      row = next;
    }
    measure_sides(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
  }

  // four, between the middles of the sides in the parameters; where estimates fail, distances decrease all the same
  std::array<Triangle, 4> parts(const Triangle& t) const
  {
    std::vector<std::array<double, 2>> parameters;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = t.corners[k].parameters, &b = t.corners[(k + 1) % 3].parameters;
      parameters.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2});
    }
    const Corners middles = corners(t.face, t.piece, parameters);
    const auto& c = t.corners;
    const auto& m = middles.at;
    const auto part = [&](const std::array<Query_corner, 3>& of) {
      double beside = 0;
      for (std::size_t k = 0; k < 3; ++k)
        if (are_on_side(of[k], of[(k + 1) % 3])) beside = t.beside / 4;
      Triangle result = triangle(t.face, t.piece, of, beside, middles.error);
      result.distance = (std::max)(result.distance, t.distance / 8);
      return result;
    };
    return {part({c[0], m[0], m[2]}), part({c[1], m[1], m[0]}), part({c[2], m[2], m[1]}),
            part({m[0], m[1], m[2]})};
  }

private:
  struct Corners
  {
    std::vector<Query_corner> at;
    double error = 0; // the largest one
  };

  Corners corners(Face face, std::size_t piece,
                  const std::vector<std::array<double, 2>>& parameters) const
  {
    std::vector<typename Surface::Location> places;
    for (const auto& p : parameters) places.push_back({face, 2. * double(piece) + p[0], p[1]});
    Corners result;
    for (const Surface_point& s : surface_.evaluate(places)) {
      result.at.push_back(
        {parameters[result.at.size()], in_double(s.point), vector_in_double(s.normal)});
      result.error = (std::max)(result.error, s.error);
    }
    return result;
  }

  bool are_on_side(const Query_corner& a, const Query_corner& b) const
  {
    constexpr double rounding = 1e-12;
    const auto &p = a.parameters, &q = b.parameters;
    const auto are = [&](std::size_t k, double x) { return p[k] == x && q[k] == x; };
    if (are(0, 0) || are(1, 0)) return true;
    if (!surface_.is_triangular()) return are(0, 1) || are(1, 1);
    return p[0] + p[1] > 1 - rounding && q[0] + q[1] > 1 - rounding;
  }

  // Between a curved side of the piece and the sides of its triangles there are none, nor beyond where the surface ends or the
  // piece beside it is no nearer to them. A curve of third degree is at most 2.1 times as far as there.
  template <class Iterator>
  void measure_sides(Iterator begin, Iterator end) const
  {
    constexpr double part = 0.4, safety = 2.5;
    std::vector<std::array<double, 2>> parameters;
    std::vector<std::pair<Triangle*, std::size_t>> sides;
    for (Iterator t = begin; t != end; ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Query_corner &a = t->corners[k], &b = t->corners[(k + 1) % 3];
        if (!are_on_side(a, b)) continue;
        sides.emplace_back(&*t, k);
        parameters.push_back({a.parameters[0] + part * (b.parameters[0] - a.parameters[0]),
                              a.parameters[1] + part * (b.parameters[1] - a.parameters[1])});
      }
    const Corners on_sides = corners(begin->face, begin->piece, parameters);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto [t, k] = sides[i];
      const auto at = [](const Query_corner& c) {
        return flatness::Vector{c.point.x(), c.point.y(), c.point.z()};
      };
      t->beside = (std::max)(
        t->beside, safety * flatness::distance_from_line(at(on_sides.at[i]), at(t->corners[k]),
                                                         at(t->corners[(k + 1) % 3])));
      t->distance = (std::max)(t->distance, t->beside);
    }
  }

  static Triangle triangle(Face face, std::size_t piece, const std::array<Query_corner, 3>& corners,
                           double beside, double error)
  {
    const auto corner = [&](std::size_t k) {
      const auto& [parameters, p, n] = corners[k];
      return flatness::Corner{{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}};
    };
    const double bulge = flatness::over_triangle(corner(0), corner(1), corner(2));
    return {face,   piece, corners, (std::max)({error, beside, tessellation_safety * bulge}),
            beside, error};
  }

  void put_inside(double& u, double& v) const
  {
    u = (std::min)(1., (std::max)(0., u));
    v = (std::min)(1., (std::max)(0., v));
    if (surface_.is_triangular() && u + v > 1) {
      const double excess = (u + v - 1) / 2;
      u = (std::max)(0., u - excess);
      v = (std::min)((std::max)(0., v - excess), 1 - u);
    }
  }

  const Surface& surface_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SURFACE_PLACES_H
