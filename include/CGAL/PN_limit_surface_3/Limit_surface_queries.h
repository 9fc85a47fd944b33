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
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Ray_search.h>
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
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
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

How far the surface is from its triangles is estimated as in `tessellate()`. All triangles that may have the closest point, within twice this distance, are looked at, and all
that a ray passes within it. A triangle over which the ray may meet the surface twice, or at a place that Newton's
method does not find, is split, up to 16 times. A point that is returned for a ray is at most four times the
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
        sorted.emplace_back(std::sqrt(CGAL::squared_distance(q, t->triangle())), t);
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [d, t] : sorted) {
      if (d - distance_ > best.distance) break;
      if (Places::is_about(best, *t, 0)) continue;
      const Place other = descend(start(*t, closest(t->triangle(), q)), q);
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
    Kernel::Vector_3 d = Places::vector_in_double(direction);
    const double length = std::sqrt(d.squared_length());
    if (!(length > 0))
      throw std::invalid_argument("PN_subdivision_3: the direction of a ray is zero");
    d = d / length;
    const Kernel::Point_3 o = Places::in_double(source);
    Near_ray near_ray{distance_, {}};
    tree_.traversal(Kernel::Ray_3(o, d), near_ray);
    internal::Ray_search<Surface> search(places_, o, d);
    std::vector<std::pair<double, typename Primitive::Id>> sorted;
    for (const auto& t : near_ray.found) sorted.emplace_back(search.least_distance(*t), t);
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [least, t] : sorted) search.add(*t);
    if (!search.first()) return {};
    return hit(*search.first(), search.first()->distance, search.first()->gap);
  }

private:
  using Places = internal::Surface_places<Surface>;
  using Kernel = Simple_cartesian<double>;
  using Triangle = typename Places::Triangle;
  using Place = typename Places::Place;
  using Step = std::array<double, 2>; // of the parameters
  using Primitive = internal::Query_primitive<typename Surface::Face>;

  // Collects the triangles whose boxes, grown, a ray meets.
  struct Near_ray
  {
    double reach;
    std::vector<typename Primitive::Id> found;

    bool go_further() const { return true; }
    void intersection(const Kernel::Ray_3& ray, const Primitive& p)
    {
      if (is_met(ray, p.datum().bbox())) found.push_back(p.id());
    }
    template <class Node>
    bool do_intersect(const Kernel::Ray_3& ray, const Node& node) const
    {
      return is_met(ray, node.bbox());
    }
    bool is_met(const Kernel::Ray_3& ray, const Bbox_3& b) const
    {
      return CGAL::do_intersect(ray, Bbox_3(b.xmin() - reach, b.ymin() - reach, b.zmin() - reach,
                                            b.xmax() + reach, b.ymax() + reach, b.zmax() + reach));
    }
  };

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
    return places_.start(t, coordinates(t.triangle(), p));
  }

  // \name Closest points: the least distance in a piece, by Newton's method in its domain
  Place descend(Place place, const Kernel::Point_3& p) const
  {
    constexpr int most_steps = 30;
    place.at = places_.evaluate(place);
    place.distance = std::sqrt(CGAL::squared_distance(Places::in_double(place.at.point), p));
    place.gap = place.distance;
    for (int i = 0; i < most_steps; ++i) {
      Place next = place;
      if (!go(next, step(place, p), p)) break;
      const double moved = std::sqrt(CGAL::squared_distance(Places::in_double(next.at.point),
                                                            Places::in_double(place.at.point)));
      next.gap = place.distance - next.distance;
      place = next;
      if (moved <= places_.surface().tolerance()) break;
    }
    if (!(place.gap < place.distance)) place.gap = 0; // the first place was the best one
    return place;
  }

  // by a step or a part of it, if that is closer
  bool go(Place& place, const Step& step, const Kernel::Point_3& p) const
  {
    const Place from = place;
    for (double t = step[0] == 0 && step[1] == 0 ? 0 : 1; t > 1e-3; t /= 4) {
      place.u = from.u;
      place.v = from.v;
      places_.move(place, t * step[0], t * step[1]);
      place.at = places_.evaluate(place);
      place.distance = std::sqrt(CGAL::squared_distance(Places::in_double(place.at.point), p));
      if (place.distance < from.distance) return true;
    }
    place = from;
    return false;
  }

  // to the least value in the domain of what Newton's method takes for the half square of the distance
  Step step(const Place& place, const Kernel::Point_3& p) const
  {
    const auto& s = place.at;
    if (s.derivatives == 0) return {0, 0};
    const auto r = Places::in_double(s.point) - p, du = Places::vector_in_double(s.du),
               dv = Places::vector_in_double(s.dv);
    const double gu = r * du, gv = r * dv;
    double a = du * du, b = du * dv, c = dv * dv;
    if (s.derivatives == 2) {
      const double x = a + r * Places::vector_in_double(s.duu),
                   y = b + r * Places::vector_in_double(s.duv),
                   z = c + r * Places::vector_in_double(s.dvv);
      if (x > 0 && x * z - y * y > 1e-3 * a * c) a = x, b = y, c = z;
    }
    return step_to_least(place, gu, gv, a, b, c);
  }

  // of gu x + gv y + a x^2 / 2 + b x y + c y^2 / 2, which is nowhere concave: inside, or else on a side
  Step step_to_least(const Place& place, double gu, double gv, double a, double b, double c) const
  {
    const bool is_triangular = places_.surface().is_triangular();
    const double u = place.u, v = place.v, det = a * c - b * b;
    if (det > 0) {
      const Step s = {(b * gv - c * gu) / det, (b * gu - a * gv) / det};
      const double x = u + s[0], y = v + s[1];
      if (x >= 0 && y >= 0 && (is_triangular ? x + y <= 1 : x <= 1 && y <= 1)) return s;
    }
    const std::size_t n = is_triangular ? 3 : 4;
    const Step corners[] = {{0, 0}, {1, 0}, {is_triangular ? 0. : 1., 1}, {0, 1}};
    Step best{};
    double least = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Step &p = corners[k], &q = corners[(k + 1) % n];
      const double x = p[0] - u, y = p[1] - v, dx = q[0] - p[0], dy = q[1] - p[1];
      const double slope = (gu + a * x + b * y) * dx + (gv + b * x + c * y) * dy,
                   bend = a * dx * dx + 2 * b * dx * dy + c * dy * dy,
                   t = bend > 0 ? (std::min)(1., (std::max)(0., -slope / bend)) : slope < 0;
      const Step s = {x + t * dx, y + t * dy};
      const double value =
        gu * s[0] + gv * s[1] + (a * s[0] * s[0] + c * s[1] * s[1]) / 2 + b * s[0] * s[1];
      if (value < least) least = value, best = s;
    }
    return best;
  }

  Hit hit(const Place& p, double distance, double error) const
  {
    Hit h;
    h.location = places_.location(p);
    h.point = p.at.point;
    h.normal = p.at.normal;
    h.distance = distance;
    h.error = error;
    return h;
  }

  const Places places_;
  std::vector<Triangle> triangles_;
  AABB_tree<internal::Query_traits<Primitive>> tree_;
  double distance_ = 0;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_LIMIT_SURFACE_QUERIES_H
