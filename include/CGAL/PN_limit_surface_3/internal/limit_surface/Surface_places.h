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
#include <optional>
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
  // estimates: how far the surface is from the triangle, sides of the piece beside its sides, and its corners off the surface
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

  // the place where the corners of a triangle have these weights, but a little inside
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
  // adds the triangles of a piece whose sides are divided
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
    constexpr double safety = 1.5 * tessellation_safety; // folds are farther than a triangle tells
    const double bulge = flatness::over_triangle(corner(0), corner(1), corner(2));
    return {face, piece, corners, (std::max)({error, beside, safety * bulge}), beside, error};
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

// Where a ray meets a surface first. Seen along the ray, the surface has two coordinates, which both vanish there:
// Newton's method finds the place. It may fail, or find one of two; then the triangle is split, and parts that the ray does
// not come near drop out.
template <class Surface>
class Ray_search
{
public:
  using Places = Surface_places<Surface>;
  using Place = typename Places::Place;
  using Triangle = typename Places::Triangle;
  using Kernel = Simple_cartesian<double>;
  using Vector = Kernel::Vector_3;

  // direction: a unit vector
  Ray_search(const Places& places, const Kernel::Point_3& source, const Vector& direction)
    : places_(places)
    , source_(source)
    , along_(direction)
    , right_(perpendicular(direction))
    , up_(CGAL::cross_product(direction, right_))
  {}

  // no point of the surface over the triangle is nearer to the source along the ray
  double least_distance(const Triangle& t) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Query_corner& c : t.corners) least = (std::min)(least, seen(c.point - source_)[2]);
    return least - t.distance;
  }

  void add(const Triangle& t, unsigned splits = 0)
  {
    constexpr unsigned most_splits = 16, enough = 6;
    if (first_ && least_distance(t) > first_->distance) return;
    const Passing passing = this->passing(t);
    if (!(passing.gap <= t.distance)) return;
    const bool crosses_once = is_seen_from_one_side(t);
    if (crosses_once && first_ && Places::is_about(*first_, t, 0.5)) return;
    const Place place = approach(places_.start(t, passing.weights));
    if (is_hit(place)) {
      if (place.distance >= 0 && (!first_ || place.distance < first_->distance)) first_ = place;
      if (crosses_once && Places::is_about(place, t, 0.5)) return;
    }
    const bool is_known = t.distance <= (std::max)(4 * places_.surface().tolerance(), 2 * t.error);
    if (splits == most_splits || (is_known && splits >= enough)) return;
    for (const Triangle& part : places_.parts(t)) add(part, splits + 1);
  }

  const std::optional<Place>& first() const { return first_; }

private:
  using Seen = std::array<double, 3>; // to the right, up, and along the ray

  // how far the line of the ray passes a triangle, and the weights of its corners there
  struct Passing
  {
    double gap;
    std::array<double, 3> weights;
  };

  static Vector perpendicular(const Vector& d)
  {
    const Vector n = Kernel::Plane_3(CGAL::ORIGIN, d).base1();
    return n / std::sqrt(n.squared_length());
  }

  Seen seen(const Vector& v) const { return {v * right_, v * up_, v * along_}; }

  Passing passing(const Triangle& t) const
  {
    std::array<Seen, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = seen(t.corners[k].point - source_);
    std::array<double, 3> area;
    for (std::size_t k = 0; k < 3; ++k) {
      const Seen &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
      area[k] = a[0] * b[1] - a[1] * b[0];
    }
    const double sum = area[0] + area[1] + area[2];
    const auto [least, greatest] = std::minmax({area[0], area[1], area[2]});
    if (sum != 0 && (least >= 0 || greatest <= 0))
      return {0, {area[0] / sum, area[1] / sum, area[2] / sum}};
    Passing nearest{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double x = c[next][0] - c[k][0], y = c[next][1] - c[k][1], square = x * x + y * y;
      const double s =
        square > 0 ? (std::min)(1., (std::max)(0., -(c[k][0] * x + c[k][1] * y) / square)) : 0.;
      const double gap = std::hypot(c[k][0] + s * x, c[k][1] + s * y);
      if (!(gap < nearest.gap)) continue;
      nearest = {gap, {}};
      nearest.weights[k] = 1 - s;
      nearest.weights[next] = s;
    }
    return nearest;
  }

  // by more than half of what normals differ in
  bool is_seen_from_one_side(const Triangle& t) const
  {
    const auto side = [&](std::size_t k) { return t.corners[k].normal * along_; };
    const auto [a, b] = std::minmax({side(0), side(1), side(2)});
    return (std::max)(a, -b) > (b - a) / 2;
  }

  double tolerance(const Place& p) const
  {
    return (std::max)(4 * places_.surface().tolerance(), 1e-14 * std::abs(p.distance));
  }
  bool is_hit(const Place& p) const { return p.gap <= (std::max)(tolerance(p), 2 * p.at.error); }

  Seen look(Place& place) const
  {
    place.at = places_.evaluate(place);
    const Seen s = seen(Places::in_double(place.at.point) - source_);
    place.gap = std::hypot(s[0], s[1]);
    place.distance = s[2];
    return s;
  }

  Place approach(Place place) const
  {
    constexpr int most_steps = 30;
    Seen at = look(place);
    for (int i = 0; i < most_steps && place.gap > tolerance(place) && place.at.derivatives > 0;
         ++i) {
      const Seen u = seen(Places::vector_in_double(place.at.du)),
                 v = seen(Places::vector_in_double(place.at.dv));
      const double det = u[0] * v[1] - u[1] * v[0];
      if (det == 0) break;
      Place next = place;
      places_.move(next, (v[0] * at[1] - v[1] * at[0]) / det, (u[1] * at[0] - u[0] * at[1]) / det);
      at = look(next);
      if (!(next.gap < place.gap / 2)) break;
      place = next;
    }
    return place;
  }

  const Places& places_;
  const Kernel::Point_3 source_;
  const Vector along_, right_, up_;
  std::optional<Place> first_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SURFACE_PLACES_H
