// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_LIMIT_SURFACE_QUERIES_H
#define CGAL_PN_LIMIT_SURFACE_3_LIMIT_SURFACE_QUERIES_H

#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Jet.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Surface_places.h>

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
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::PN_subdivision_3 {

namespace internal {

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
  Datum datum() const { return id_->triangle(); }
  Point reference_point() const { return id_->corners[0].point; }

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

How far the surface is from its triangles is estimated as in `tessellate()`, and half more. All triangles that may have the closest point are looked at, and all
that a ray passes within this distance. A triangle over which several places may be closest is split (up to 100 are), and one over which the ray may meet the surface twice, or at a place that Newton's
method does not find, up to 16 times. A point that is returned for a ray is at most four times the
`tolerance()` of the surface off it, or twice the `error` that the surface has there if that is more.

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
    : places_(surface)
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
        places_.add_triangles(face, piece, pieces == 1 ? divisions : divisions / 2, triangles_);
    }
    for (const Triangle& t : triangles_) distance_ = (std::max)(distance_, t.distance);
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
    const Kernel::Point_3 q = Places::in_double(p);
    const Triangle& nearest = *tree_.closest_point_and_primitive(q).second;
    Place best = descend(start(nearest, q), q);
    Within_reach near_point{best.distance + distance_, {}};
    tree_.traversal(q, near_point);
    Parts parts;
    for (const auto& t : near_point.found) add(parts, *t, q);
    const double rest = (std::max)(0., search(best, parts, q));
    return hit(
      best, (std::max)((std::min)(best.gap + best.at.error, best.distance), best.distance - rest));
  }

  /*!
  the first intersection with a ray, if there is any.
  \param source where the ray begins
  \param direction its direction, of any length
  \throws std::invalid_argument if the direction is zero
  */
  std::optional<Hit> first_intersection(const Point_3& source, const Vector_3& direction) const
  {
    Kernel::Vector_3 d = Places::vector_in_double(direction);
    const double length = std::sqrt(d.squared_length());
    if (!(length > 0))
      throw std::invalid_argument("PN_subdivision_3: the direction of a ray is zero");
    d = d / length;
    const Kernel::Point_3 o = Places::in_double(source);
    Within_reach near_ray{distance_, {}};
    tree_.traversal(Kernel::Ray_3(o, d), near_ray);
    internal::Ray_search<Surface> search(places_, o, d);
    std::multimap<double, typename Primitive::Id> sorted;
    for (const auto& t : near_ray.found) sorted.emplace(search.least_distance(*t), t);
    for (const auto& [least, t] : sorted) search.add(*t);
    if (!search.first()) return {};
    return hit(*search.first(), search.first()->gap);
  }

private:
  using Places = internal::Surface_places<Surface>;
  using Kernel = Simple_cartesian<double>;
  using Triangle = typename Places::Triangle;
  using Place = typename Places::Place;
  using Primitive = internal::Query_primitive<typename Surface::Face>;

  // Collects the triangles whose boxes are within reach of a ray (grown boxes meet it) or of a point.
  struct Within_reach
  {
    double reach;
    std::vector<typename Primitive::Id> found;

    bool go_further() const { return true; }
    template <class Query>
    void intersection(const Query& query, const Primitive& p)
    {
      if (reaches(query, p.datum().bbox())) found.push_back(p.id());
    }
    template <class Query, class Node>
    bool do_intersect(const Query& query, const Node& node) const
    {
      return reaches(query, node.bbox());
    }
    bool reaches(const Kernel::Ray_3& ray, const Bbox_3& b) const
    {
      return CGAL::do_intersect(ray, Bbox_3(b.xmin() - reach, b.ymin() - reach, b.zmin() - reach,
                                            b.xmax() + reach, b.ymax() + reach, b.zmax() + reach));
    }
    // no Sphere_3, which for CGAL has nothing inside
    bool reaches(const Kernel::Point_3& p, const Bbox_3& b) const
    {
      double sum = 0;
      for (int k = 0; k < 3; ++k) {
        const double off = (std::max)({(b.min)(k)-p[k], p[k] - (b.max)(k), 0.});
        sum += off * off;
      }
      return sum <= reach * reach;
    }
  };

  // the place where the triangle is closest to a point
  Place start(const Triangle& t, const Kernel::Point_3& p) const
  {
    const Kernel::Triangle_3 flat = t.triangle();
    const auto a = flat[1] - flat[0], b = flat[2] - flat[0],
               r = Kernel().construct_projected_point_3_object()(flat, p) - flat[0];
    const double aa = a * a, ab = a * b, bb = b * b, ra = r * a, rb = r * b;
    const double det = aa * bb - ab * ab;
    if (!(det > 0)) return places_.start(t, {1. / 3, 1. / 3, 1. / 3});
    const double x = (ra * bb - rb * ab) / det, y = (rb * aa - ra * ab) / det;
    return places_.start(t, {1 - x - y, x, y});
  }

  // \name Closest points: the least distance in a piece, by Newton's method in its domain; triangles that may have several are split
  using Parts = std::multimap<double, Triangle>; // by the least distance that they may have
  static void add(Parts& parts, const Triangle& t, const Kernel::Point_3& p)
  {
    parts.emplace(std::sqrt(CGAL::squared_distance(p, t.triangle())) - t.distance, t);
  }

  // returns what no part that is left is nearer than
  double search(Place& best, Parts& parts, const Kernel::Point_3& p) const
  {
    constexpr unsigned most_splits = 100;
    for (unsigned splits = 0; !parts.empty();) {
      const auto [least, t] = *parts.begin();
      const double tolerance = (std::max)(places_.surface().tolerance(), best.at.error);
      if (least >= best.distance - tolerance) return least;
      const bool has_one = Places::has_one_foot(t, p);
      improve(best, t, has_one, p);
      if (!has_one && splits++ == most_splits) return least;
      parts.erase(parts.begin());
      if (!has_one)
        for (const Triangle& part : places_.parts(t)) add(parts, part, p);
    }
    return best.distance;
  }

  // replaces a place by a better one found from where a triangle is nearest, or by a corner, where Newton's method may not go
  void improve(Place& best, const Triangle& t, bool has_one, const Kernel::Point_3& p) const
  {
    const auto is_nearer = [&](const auto& x) {
      return std::sqrt(CGAL::squared_distance(p, x)) < best.distance;
    };
    const auto take = [&](const Place& from) {
      const Place other = descend(from, p);
      if (other.distance < best.distance) best = other;
    };
    const bool is_known = best.at.derivatives > 0 && Places::is_about(best, t, 0);
    if (!is_known && (has_one || is_nearer(t.triangle()))) take(start(t, p));
    for (const auto& c : t.corners)
      if (is_nearer(c.point)) take({t.face, t.piece, c.parameters[0], c.parameters[1], {}});
  }

  Place descend(Place place, const Kernel::Point_3& p) const
  {
    constexpr int most_steps = 30;
    look(place, p);
    place.gap = place.distance;
    for (int i = 0; i < most_steps; ++i) {
      const Place last = place;
      if (!go(place, p)) break;
      place.gap = last.distance - place.distance;
      const auto moved = Places::in_double(place.at.point) - Places::in_double(last.at.point);
      if (std::sqrt(moved.squared_length()) <= places_.surface().tolerance()) break;
    }
    if (!(place.gap < place.distance)) place.gap = 0; // the first place was the best one
    return place;
  }

  void look(Place& place, const Kernel::Point_3& p) const
  {
    place.at = places_.evaluate(place);
    place.distance = std::sqrt(CGAL::squared_distance(Places::in_double(place.at.point), p));
  }

  // moves the place by the step, or a part of the step, if that is closer
  bool go(Place& place, const Kernel::Point_3& p) const
  {
    internal::Jet_vector r;
    for (int k = 0; k < 3; ++k) {
      const auto x = [k](const auto& v) { return CGAL::to_double(v[k]); };
      const auto& s = place.at;
      r[k] = {x(s.point) - p[k], x(s.du), x(s.dv), x(s.duu), x(s.duv), x(s.dvv)};
    }
    const auto [u, v] = internal::next_foot(r, places_.surface().is_triangular(), place.u, place.v);
    for (double t = u == place.u && v == place.v ? 0 : 1; t > 1e-3; t /= 4) {
      Place next = place;
      places_.move(next, t * (u - place.u), t * (v - place.v));
      look(next, p);
      if (!(next.distance < place.distance)) continue;
      place = next;
      return true;
    }
    return false;
  }

  Hit hit(const Place& p, double error) const
  {
    return {places_.location(p), p.at.point, p.at.normal, p.distance, error};
  }

  const Places places_;
  std::vector<Triangle> triangles_;
  AABB_tree<internal::Query_traits<Primitive>> tree_;
  double distance_ = 0;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_LIMIT_SURFACE_QUERIES_H
