// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_LIMIT_SURFACE_QUERIES_H
#define CGAL_PN_SUBDIVISION_3_LIMIT_SURFACE_QUERIES_H

#include <CGAL/PN_subdivision_3/Limit_surface.h>
#include <CGAL/PN_subdivision_3/internal/tessellation/Flatness.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

namespace internal {

// A flat triangle between limit points.
template <class Face>
struct Query_triangle
{
  using Kernel = Simple_cartesian<double>;

  Kernel::Triangle_3 triangle;
  Face face;
  std::size_t piece;
  std::array<std::array<double, 2>, 3> parameters; // of the corners, in the piece
};

template <class Face>
struct Query_primitive
{
  using Id = typename std::vector<Query_triangle<Face>>::const_iterator;
  using Point = Simple_cartesian<double>::Point_3;
  using Datum = Simple_cartesian<double>::Triangle_3;

  Query_primitive() = default;
  Query_primitive(Id i)
    : id_(i)
  {}
  Id id() const { return id_; }
  const Datum& datum() const { return id_->triangle; }
  Point reference_point() const { return id_->triangle.vertex(0); }

private:
  Id id_;
};

#if CGAL_VERSION_NR >= 1060000000
template <class Primitive>
using Query_traits = AABB_traits_3<Simple_cartesian<double>, Primitive>;
#else
template <class Primitive>
using Query_traits = AABB_traits<Simple_cartesian<double>, Primitive>;
#endif

} // namespace internal

/*!
\ingroup PkgPNSubdivision3LimitSurface

finds closest points and intersections with rays on a limit surface. An `AABB_tree` of flat triangles between limit points finds candidates; from
there Newton's method goes to the point on the surface itself, which is evaluated where the query needs it, see `Limit_surface`.

How far the surface is from its triangles is estimated as in `tessellate()`. All triangles that may have the closest point, within twice this distance, are looked at. A ray
that passes the surface closer than this without a crossing, or crosses it twice between, may be counted wrong.

The squares of distances have to be in the range of `double`, here and in `AABB_tree`: coordinates up to 10<sup>150</sup>.

`AABB_tree` is under the GPL: so is whatever includes this header; no other header of the package includes it.

\tparam FaceGraph a model of `FaceListGraph`
\tparam GeomTraits a kernel, as that of `Limit_surface`
*/
template <class FaceGraph, class GeomTraits = typename internal::Surface_parameters<
                             FaceGraph, parameters::Default_named_parameters>::Geom_traits>
class Limit_surface_queries
{
public:
  /// the surface.
  using Surface = Limit_surface<FaceGraph, GeomTraits>;
  /// a point.
  using Point_3 = typename GeomTraits::Point_3;
  /// a vector.
  using Vector_3 = typename GeomTraits::Vector_3;

  /// A point of a limit surface that was found.
  struct Hit
  {
    /// where it is.
    typename Surface::Location location;
    /// the point.
    Point_3 point;
    /// the unit normal of the surface there.
    Vector_3 normal;
    /// the distance from the point that was asked for, or from the source of the ray.
    double distance = 0;
    /// of a closest point: by how much the surface may still be closer, by estimate; of a ray: how far the point is from the ray.
    double error = 0;
  };

  /*!
  makes the triangles.
  \param surface the surface, which has to live as long
  \param divisions of each edge of the control mesh, an even number
  \throws std::invalid_argument if `divisions` is not even and positive, or if the mesh has no faces
  */
  explicit Limit_surface_queries(const Surface& surface, unsigned divisions = 4)
    : surface_(surface)
  {
    if (divisions == 0 || divisions % 2 != 0)
      throw std::invalid_argument("PN_subdivision_3: edges are divided in an even number of parts, "
                                  "not in " +
                                  std::to_string(divisions));
    if (surface.faces().empty())
      throw std::invalid_argument("PN_subdivision_3: a limit surface without faces has no points");
    for (const auto face : surface.faces()) {
      const std::size_t pieces = surface.number_of_pieces(face);
      for (std::size_t piece = 0; piece < pieces; ++piece)
        add_piece(face, piece, pieces == 1 ? divisions : divisions / 2);
    }
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
  }
  Limit_surface_queries(const Limit_surface_queries&) = delete;
  Limit_surface_queries& operator=(const Limit_surface_queries&) = delete;

  /// the estimated distance of the surface from its triangles.
  double distance_from_triangles() const { return distance_; }

  /// the point of the surface closest to a point.
  Hit closest_point(const Point_3& p) const
  {
    const Kernel::Point_3 q = in_double(p);
    const auto nearest = tree_.closest_point_and_primitive(q);
    const double flat = std::sqrt(CGAL::squared_distance(q, nearest.first));
    Place best = descend(start(*nearest.second, nearest.first), q);
    const double reach = (std::min)(flat + 2 * distance_, best.distance + distance_);
    std::vector<typename Primitive::Id> around;
    tree_.all_intersected_primitives(Kernel::Sphere_3(q, reach * reach),
                                     std::back_inserter(around));
    std::vector<std::pair<double, typename Primitive::Id>> sorted;
    for (const auto& t : around)
      if (t != nearest.second)
        sorted.emplace_back(std::sqrt(CGAL::squared_distance(q, t->triangle)), t);
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [d, t] : sorted) {
      if (d - distance_ > best.distance) break;
      if (is_reached(*t, best)) continue;
      const Place other = descend(start(*t, closest(t->triangle, q)), q);
      if (other.distance < best.distance) best = other;
    }
    const double least = (std::max)(0., flat - distance_);
    return hit(best, best.distance,
               (std::min)((std::max)(0., best.distance - least), best.gap + best.at.error));
  }

  /*!
  the first intersection with a ray, if there is any.
  \param source where the ray begins
  \param direction its direction, of any length
  \throws std::invalid_argument if the direction is zero
  */
  std::optional<Hit> first_intersection(const Point_3& source, const Vector_3& direction) const
  {
    const Kernel::Point_3 o = in_double(source);
    Kernel::Vector_3 d = vector_in_double(direction);
    const double length = std::sqrt(d.squared_length());
    if (!(length > 0))
      throw std::invalid_argument("PN_subdivision_3: the direction of a ray is zero");
    d = d / length;
    std::vector<typename Primitive::Id> crossed;
    tree_.all_intersected_primitives(Kernel::Ray_3(o, d), std::back_inserter(crossed));
    std::optional<Hit> first;
    for (const auto& t : crossed) {
      const double along = crossing(t->triangle, o, d);
      const Kernel::Point_3 flat = o + along * d;
      if (first && along - 4 * distance_ > first->distance) continue;
      Place best = intersect(start(*t, closest(t->triangle, flat)), o, d, along);
      if (!is_hit(best)) best = intersect_neighbors(*t, flat, o, d, along, best);
      if (!is_hit(best)) { // the triangle is what is known
        best = start(*t, closest(t->triangle, flat));
        best.at = evaluate(best);
        best.distance = along;
        best.gap = gap(best.at, o, d, along);
      }
      if (best.distance >= 0 && (!first || best.distance < first->distance))
        first = hit(best, best.distance, best.gap);
    }
    return first;
  }

private:
  using Kernel = Simple_cartesian<double>;
  using Face = typename Surface::Face;
  using Triangle = internal::Query_triangle<Face>;
  using Primitive = internal::Query_primitive<Face>;
  using Surface_point = typename Surface::Surface_point;

  // parameters in a piece, and what is there
  struct Place
  {
    Face face;
    std::size_t piece;
    double u, v;
    Surface_point at;
    double distance = std::numeric_limits<double>::infinity(), gap = distance;
  };

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

  // \name Triangles
  void add_piece(Face face, std::size_t piece, unsigned n)
  {
    const bool is_triangle = surface_.is_triangular();
    std::vector<typename Surface::Location> places;
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= (is_triangle ? n - j : n); ++i)
        places.push_back({face, 2. * double(piece) + double(i) / n, double(j) / n});
    const auto points = surface_.evaluate(places);
    std::size_t row = 0;
    for (unsigned j = 0; j < n; ++j) {
      const std::size_t width = (is_triangle ? n - j : n) + 1, next = row + width;
      for (unsigned i = 0; i + 1 < width; ++i) {
        add(face, piece, places, points, {row + i, row + i + 1, next + i});
        if (!is_triangle || i + 2 < width)
          add(face, piece, places, points, {row + i + 1, next + i + 1, next + i});
      }
      row = next;
    }
  }

  void add(Face face, std::size_t piece, const std::vector<typename Surface::Location>& places,
           const std::vector<Surface_point>& points, const std::array<std::size_t, 3>& at)
  {
    Triangle t;
    t.face = face;
    t.piece = piece;
    std::array<internal::flatness::Corner, 3> corners;
    std::array<Kernel::Point_3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& s = points[at[k]];
      p[k] = in_double(s.point);
      const auto n = vector_in_double(s.normal);
      corners[k] = {{p[k].x(), p[k].y(), p[k].z()}, {n.x(), n.y(), n.z()}};
      t.parameters[k] = {places[at[k]].u - 2. * double(piece), places[at[k]].v};
      distance_ = (std::max)(distance_, s.error);
    }
    t.triangle = Kernel::Triangle_3(p[0], p[1], p[2]);
    const double estimate = internal::tessellation_safety *
                            internal::flatness::over_triangle(corners[0], corners[1], corners[2]);
    distance_ = (std::max)(distance_, estimate);
    triangles_.push_back(t);
  }

  static Kernel::Point_3 closest(const Kernel::Triangle_3& t, const Kernel::Point_3& p)
  {
    return Kernel().construct_projected_point_3_object()(t, p);
  }

  // barycentric coordinates of a point of the triangle
  static std::array<double, 3> coordinates(const Kernel::Triangle_3& t, const Kernel::Point_3& p)
  {
    const auto a = t[1] - t[0], b = t[2] - t[0], r = p - t[0];
    const double aa = a * a, ab = a * b, bb = b * b, ra = r * a, rb = r * b;
    const double det = aa * bb - ab * ab;
    if (!(det > 0)) return {1. / 3, 1. / 3, 1. / 3};
    const auto in_range = [](double x) { return (std::min)(1., (std::max)(0., x)); };
    const double x = in_range((ra * bb - rb * ab) / det), y = in_range((rb * aa - ra * ab) / det);
    return {(std::max)(0., 1 - x - y), x, y};
  }

  Place start(const Triangle& t, const Kernel::Point_3& p) const
  {
    const auto c = coordinates(t.triangle, p);
    Place place{t.face, t.piece, 0, 0, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      // vertices may have no derivatives
      const double part = 0.98 * c[k] + 0.02 / 3;
      place.u += part * t.parameters[k][0];
      place.v += part * t.parameters[k][1];
    }
    put_inside(place.u, place.v);
    return place;
  }

  Surface_point evaluate(const Place& p) const
  {
    return surface_.evaluate(p.face, 2. * double(p.piece) + p.u, p.v);
  }

  // whether the best place lies in the triangle
  static bool is_reached(const Triangle& t, const Place& best)
  {
    if (t.face != best.face || t.piece != best.piece) return false;
    const auto& q = t.parameters;
    double least_u = 1, least_v = 1, greatest_u = 0, greatest_v = 0;
    for (const auto& c : q) {
      least_u = (std::min)(least_u, c[0]), greatest_u = (std::max)(greatest_u, c[0]);
      least_v = (std::min)(least_v, c[1]), greatest_v = (std::max)(greatest_v, c[1]);
    }
    return best.u >= least_u && best.u <= greatest_u && best.v >= least_v && best.v <= greatest_v;
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

  // \name Closest points: the least distance in a piece, by Newton's method in its domain
  Place descend(Place place, const Kernel::Point_3& p) const
  {
    constexpr int most_steps = 30;
    place.at = evaluate(place);
    place.distance = std::sqrt(CGAL::squared_distance(in_double(place.at.point), p));
    place.gap = place.distance;
    for (int i = 0; i < most_steps; ++i) {
      const auto step = this->step(place, p);
      if (step[0] == 0 && step[1] == 0) break;
      Place next = place;
      double t = 1;
      for (; t > 1e-3; t /= 4) {
        next.u = place.u + t * step[0];
        next.v = place.v + t * step[1];
        put_inside(next.u, next.v);
        next.at = evaluate(next);
        next.distance = std::sqrt(CGAL::squared_distance(in_double(next.at.point), p));
        if (next.distance < place.distance) break;
      }
      if (!(t > 1e-3)) break;
      const double moved =
        std::sqrt(CGAL::squared_distance(in_double(next.at.point), in_double(place.at.point)));
      next.gap = place.distance - next.distance;
      place = next;
      if (moved <= surface_.tolerance()) break;
    }
    if (!(place.gap < place.distance)) place.gap = 0; // the first place was the best one
    return place;
  }

  // of Newton's method for the half square of the distance; what leads out of the domain is left out
  std::array<double, 2> step(const Place& place, const Kernel::Point_3& p) const
  {
    const Surface_point& s = place.at;
    if (s.derivatives == 0) return {0, 0};
    const auto r = in_double(s.point) - p, du = vector_in_double(s.du), dv = vector_in_double(s.dv);
    const double gu = r * du, gv = r * dv;
    double a = du * du, b = du * dv, c = dv * dv;
    if (s.derivatives == 2) {
      const double x = a + r * vector_in_double(s.duu), y = b + r * vector_in_double(s.duv),
                   z = c + r * vector_in_double(s.dvv);
      if (x > 0 && x * z - y * y > 1e-3 * a * c) a = x, b = y, c = z;
    }
    return bounded(place, gu, gv, a, b, c);
  }

  std::array<double, 2> bounded(const Place& place, double gu, double gv, double a, double b,
                                double c) const
  {
    const double det = a * c - b * b;
    if (!(a > 0) || !(c > 0) || !(det > 0)) return {0, 0};
    std::array<double, 2> step = {(b * gv - c * gu) / det, (b * gu - a * gv) / det};
    const auto leaves = [](double x, double dx) {
      return (x <= 0 && dx < 0) || (x >= 1 && dx > 0);
    };
    if (surface_.is_triangular() && place.u + place.v >= 1 - 1e-15 && step[0] + step[1] > 0) {
      const double along = -(gu - gv) / (a - 2 * b + c);
      step = {along, -along};
    }
    if (leaves(place.u, step[0])) step = {0, -gv / c};
    if (leaves(place.v, step[1])) step = {leaves(place.u, -gu / a) ? 0 : -gu / a, 0};
    return step;
  }

  // \name Rays
  static double crossing(const Kernel::Triangle_3& t, const Kernel::Point_3& o,
                         const Kernel::Vector_3& d)
  {
    const auto n = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
    const double nd = n * d;
    return nd == 0 ? (t[0] - o) * d : (n * (t[0] - o)) / nd;
  }
  static double gap(const Surface_point& s, const Kernel::Point_3& o, const Kernel::Vector_3& d,
                    double along)
  {
    return std::sqrt(CGAL::squared_distance(in_double(s.point), o + along * d));
  }
  bool is_hit(const Place& p) const
  {
    return p.gap <= (std::max)(4 * surface_.tolerance(), 1e-14 * p.distance);
  }

  // of Newton's method for S(u, v) = o + t d
  Place intersect(Place place, const Kernel::Point_3& o, const Kernel::Vector_3& d,
                  double along) const
  {
    constexpr int most_steps = 20;
    for (int i = 0;; ++i) {
      place.at = evaluate(place);
      place.distance = along;
      place.gap = gap(place.at, o, d, along);
      if (i == most_steps || is_hit(place) || place.at.derivatives == 0) return place;
      const auto du = vector_in_double(place.at.du), dv = vector_in_double(place.at.dv);
      const auto r = o + along * d - in_double(place.at.point);
      const auto n = CGAL::cross_product(du, dv);
      const double det = n * d;
      if (det == 0) return place;
      // r = du x + dv y - d z
      const double z = -(n * r) / det;
      const auto in_plane = r + z * d;
      const double a = du * du, b = du * dv, c = dv * dv, ru = in_plane * du, rv = in_plane * dv;
      const double gram = a * c - b * b;
      if (!(gram > 0)) return place;
      place.u += (c * ru - b * rv) / gram;
      place.v += (a * rv - b * ru) / gram;
      put_inside(place.u, place.v);
      along += z;
    }
  }

  // the surface may be crossed in another piece than its triangles are
  Place intersect_neighbors(const Triangle& t, const Kernel::Point_3& flat,
                            const Kernel::Point_3& o, const Kernel::Vector_3& d, double along,
                            Place best) const
  {
    const double reach = 4 * distance_;
    std::vector<typename Primitive::Id> around;
    tree_.all_intersected_primitives(Kernel::Sphere_3(flat, reach * reach),
                                     std::back_inserter(around));
    for (const auto& other : around) {
      if (other->face == t.face && other->piece == t.piece) continue;
      const Place p = intersect(start(*other, closest(other->triangle, flat)), o, d, along);
      if (p.gap < best.gap) best = p;
      if (is_hit(best)) break;
    }
    return best;
  }

  static Hit hit(const Place& p, double distance, double error)
  {
    Hit h;
    h.location = {p.face, 2. * double(p.piece) + p.u, p.v};
    h.point = p.at.point;
    h.normal = p.at.normal;
    h.distance = distance;
    h.error = error;
    return h;
  }

  const Surface& surface_;
  std::vector<Triangle> triangles_;
  AABB_tree<internal::Query_traits<Primitive>> tree_;
  double distance_ = 0;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_LIMIT_SURFACE_QUERIES_H
