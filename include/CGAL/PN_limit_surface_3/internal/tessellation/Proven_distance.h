// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_PROVEN_DISTANCE_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_PROVEN_DISTANCE_H

#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Cell_enclosure.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Limit_cells.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Spline_piece.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Adaptive_level.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
#  include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

// A bound, which is proved, of the distance of the limit of a face from triangles between its corners and further points of
// the limit on its sides, wherever these are. Let Q be the quadrilateral of the corners, two triangles with either diagonal, or the
// triangle. The limit is within the bound of Theorem A of the linear one, and this in the hull of Bezier points or, at an
// extraordinary vertex, of control points. The distance from the hull of Q is convex, so that it is largest at these; no
// point of that hull is farther from Q than its diagonals are apart, the twist. Points of the limit on a side are no farther from
// the side of Q than the hull of its Bezier points; the triangles are the image of a triangulation of Q that has
// vertices at the feet of these points, and no farther from it than these points, and the twist again.
template <class Cells>
class Proven_distance
{
public:
  using Index = Level_connectivity::Index;
  using Cell = typename Cells::Cell;
  using Vector = flatness::Vector;

  // Lengths are divided by 2^exponent. Beyond the tolerance the result is infinite.
  Proven_distance(const Cells& cells, int exponent, double tolerance)
    : cells_(cells)
    , exponent_(exponent)
    , tolerance_(tolerance)
  {}

  double operator()(Index face, const std::array<Vector, 4>& corners) const
  {
    Search search{corners, 0, 0, 0};
    if (degree == 4)
      search.twist = distance_of_segments(corners[0], corners[2], corners[1], corners[3]);
    add(cells_.of_face(face), (1u << degree) - 1, search);
    return search.total();
  }

private:
  static constexpr Index degree = Cells::degree;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // rounds of look-ahead: in regular faces, whose bound falls by a fourth a round, and where hulls shrink to a vertex
  static constexpr unsigned most_rounds = 2, most_rounds_at_vertices = 16;

  struct Search
  {
    std::array<Vector, 4> corners;
    double twist, surface, sides; // the largest distances so far
    double total() const { return surface + sides + 2 * twist; }
  };

  Vector place(const Vector& p) const
  {
    return {std::ldexp(p[0], -exponent_), std::ldexp(p[1], -exponent_),
            std::ldexp(p[2], -exponent_)};
  }

  // sides: the sides of the face on which sides of the cell lie
  void add(Cell&& cell, unsigned sides, Search& search) const
  {
    Search here = search;
    const bool is_regular = measure(cell, sides, here);
    const bool is_last = cell.rounds >= (is_regular ? most_rounds : most_rounds_at_vertices);
    if (is_last && !(here.total() <= tolerance_)) here.surface = infinity;
    if (is_last || (here.total() <= tolerance_ && here.total() < infinity)) {
      search = here;
      return;
    }
    const typename Cells::Round round(cells_, std::move(cell));
    for (Index i = 0; i < 4 && search.surface < infinity; ++i)
      add(round.child(i), i < degree ? sides & (1u << i | 1u << (i + degree - 1) % degree) : 0,
          search);
  }

  // adds what the hull of a cell tells; whether it is one of Bezier points
  bool measure(Cell& cell, unsigned sides, Search& search) const
  {
    const Cell_net<Cells> net(cell);
    if (!net.has_uniform_faces()) {
      search.surface = infinity;
      return false;
    }
    double largest = 0, of_surface = 0, of_sides = 0;
    const auto note = [&](const Vector& p, unsigned of) {
      raise(of_surface, distance(p, search));
      for (Index i = 0; i < degree; ++i)
        if ((of & sides & 1u << i) != 0) raise(of_sides, distance_from_side(p, i, search));
    };
    bool is_regular = false;
    cells_.with_kinds(cell, [&](const Level_connectivity& level, Index base, const auto& kind) {
      const Spline_piece piece(level, base, degree, false, kind);
      is_regular = piece.is_regular();
      if (is_regular)
        piece.for_each_bezier_point([&](Index v) { return place(point_of(cell.level.values[v])); },
                                    note);
    });
    const auto [delta, d] = net.differences([&](const Vector& p) {
      for (const double x : place(p)) largest = (std::max)(largest, std::abs(x));
      if (!is_regular) note(place(p), ~0u);
    });
    const double rest =
      rounding_of_bound * largest +
      (is_pn_v<typename Cells::Scheme_type> ? net.proven_distance(delta, std::ldexp(d, -exponent_))
                                            : 0);
    raise(search.surface, of_surface + rest);
    if (sides != 0) raise(search.sides, of_sides + rest);
    return is_regular;
  }

  // raises `largest` to x; a NaN counts as infinite
  static void raise(double& largest, double x)
  {
    if (!(x <= largest)) largest = x < infinity ? x : infinity;
  }

  // \name Distances of points that are there, hence bounds, also where a square or a quotient is beyond the range of double
  static double distance(const Vector& p, const Search& search)
  {
    const auto& c = search.corners;
    const double first = flatness::distance_from_triangle(p, c[0], c[1], c[2]);
    return degree == 3 ? first
                       : (std::min)(first, flatness::distance_from_triangle(p, c[2], c[3], c[0]));
  }
  static double distance_from_side(const Vector& p, Index i, const Search& search)
  {
    return flatness::distance_from_segment(p, search.corners[i], search.corners[(i + 1) % degree]);
  }

  // the segments are from a to b, and from c to d
  static double distance_of_segments(const Vector& a, const Vector& b, const Vector& c,
                                     const Vector& d)
  {
    const flatness::Combination inside(difference(c, a), difference(b, a), difference(c, d));
    if (inside.s >= 0 && inside.s <= 1 && inside.t >= 0 && inside.t <= 1) return inside.distance;
    return (std::min)(
      {flatness::distance_from_segment(a, c, d), flatness::distance_from_segment(b, c, d),
       flatness::distance_from_segment(c, a, b), flatness::distance_from_segment(d, a, b)});
  }

  const Cells& cells_;
  const int exponent_;
  const double tolerance_;
};

// The same for the levels of a tessellation.
template <class Scheme, class Level_creases>
class Proven_bounds final
  : public Face_bounds<typename Limit_cells<Scheme, Level_creases>::Value, Level_creases>
{
  using Cells = Limit_cells<Scheme, Level_creases>;
  using Level = typename Cells::Level;

public:
  Proven_bounds(const Scheme& scheme, int exponent)
    : scheme_(scheme)
    , exponent_(exponent)
  {}

  void begin(const Adaptive_level<typename Cells::Value, Level_creases>& level) override
  {
    cells_.emplace(scheme_, Level(level.level), Level_creases(level.creases));
  }
  double operator()(Level_connectivity::Index face, const std::array<flatness::Vector, 4>& corners,
                    double tolerance) const override
  {
    return Proven_distance<Cells>(*cells_, exponent_, tolerance)(face, corners);
  }

private:
  const Scheme scheme_;
  const int exponent_;
  std::optional<Cells> cells_;
};

// The bounds of the levels that come of a control mesh, which is refused if it has a face for which there are none.
template <class Scheme, class Value, class Level_creases>
std::unique_ptr<Face_bounds<Value, Level_creases>>
proven_bounds(const Scheme& scheme, int exponent, const Valued_level<Value>& control,
              const Level_creases& creases, double tolerance)
{
  require_proof_of_all(Limit_cells<Scheme, Level_creases>(scheme, Valued_level<Value>(control),
                                                          Level_creases(creases)),
                       tolerance);
  return std::make_unique<Proven_bounds<Scheme, Level_creases>>(scheme, exponent);
}

// for the library CGAL::PN_subdivision_3_limits, see limits_at_slots.h
#define CGAL_PN_SUBDIVISION_3_BOUNDS_OF(EXTERN, SCHEME, CREASES)                                   \
  EXTERN template std::unique_ptr<                                                                 \
    Face_bounds<compiled_once::Value<compiled_once::SCHEME>, CREASES>>                             \
  proven_bounds(const compiled_once::SCHEME&, int,                                                 \
                const Valued_level<compiled_once::Value<compiled_once::SCHEME>>&, const CREASES&,  \
                double);
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
CGAL_PN_SUBDIVISION_3_OF_QUADS(CGAL_PN_SUBDIVISION_3_BOUNDS_OF, extern)
CGAL_PN_SUBDIVISION_3_OF_TRIANGLES(CGAL_PN_SUBDIVISION_3_BOUNDS_OF, extern)
#endif

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_PROVEN_DISTANCE_H
