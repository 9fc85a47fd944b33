// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SURFACE_EVALUATION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SURFACE_EVALUATION_H

#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Cell_enclosure.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Jet.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Limit_cells.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Spline_piece.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
#  include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A point of a limit surface that is sought, and what has been found.
struct Surface_query
{
  double u, v;      // in the cell
  double scale = 1; // of derivatives of the cell
  std::size_t number = 0;

  Jet_vector point{};
  std::array<double, 3> normal{};
  double error = std::numeric_limits<double>::infinity(), normal_error = error;
  unsigned derivatives = 0; // up to which order they are known
  unsigned rounds = 0;

  bool has_last = false;
  double last_step = 0, last_turn = 0;
};

struct Surface_demand
{
  double tolerance, normal_tolerance;
  unsigned most_rounds;
};

// Points of a limit surface, of a scheme that its caller need not know.
class Surface_evaluation
{
public:
  using Index = Level_connectivity::Index;
  using Queries = std::vector<Surface_query>;

  Surface_evaluation() = default;
  Surface_evaluation(const Surface_evaluation&) = delete;
  Surface_evaluation& operator=(const Surface_evaluation&) = delete;
  virtual ~Surface_evaluation() = default;

  virtual const Level_connectivity& level() const = 0;
  virtual bool splits_triangles() const = 0;
  // evaluates queries that are all in one face; in a polygon that is split in quadrilaterals, in the piece at the corner
  virtual Queries evaluate(Index face, Index corner, Queries queries,
                           const Surface_demand& demand) const = 0;
  virtual Surface_box enclosure(Index face, unsigned rounds, bool is_proven,
                                unsigned more_rounds) const = 0;
};

template <class Scheme, class Level_creases>
class Scheme_evaluation : public Surface_evaluation
{
public:
  using Cells = Limit_cells<Scheme, Level_creases>;
  using Cell = typename Cells::Cell;

  Scheme_evaluation(const Scheme& scheme, typename Cells::Level&& level, Level_creases&& creases)
    : cells_(scheme, std::move(level), std::move(creases))
    , facts_(facts_of(cells_.scheme()))
  {}

  const Level_connectivity& level() const override { return cells_.control().level; }
  bool splits_triangles() const override { return degree == 3; }

  Queries evaluate(Index face, Index corner, Queries queries,
                   const Surface_demand& demand) const override
  {
    Evaluations e(*this, demand);
    Cell cell = cells_.of_face(face);
    if (level().has_degree(cells_.control().level.halfedge_of_face(face), degree))
      e(std::move(cell), std::move(queries));
    else {
      const typename Cells::Round round(cells_, std::move(cell));
      e(round.child(corner), std::move(queries));
    }
    return std::move(e.done);
  }

  Surface_box enclosure(Index face, unsigned rounds, bool is_proven,
                        unsigned more_rounds) const override
  {
    if (is_proven) {
      if (!has_proven_bound(cells_.scheme()))
        throw std::invalid_argument("PN_subdivision_3: no enclosure is proven for " +
                                    name_in_message(cells_.scheme()) +
                                    ", except for Catmull-Clark and Loop: use bbox()");
      require_proof(cells_, face);
    }
    Cell_enclosure<Cells> enclosure(cells_, is_proven, rounds, more_rounds);
    enclosure.add(cells_.of_face(face));
    return enclosure.result();
  }

private:
  using Value = typename Cells::Value;
  static constexpr Index degree = Scheme::Host::refined_degree;
  static constexpr bool is_pn = is_pn_v<Scheme>;

  // the work of one call
  class Evaluations
  {
  public:
    Evaluations(const Scheme_evaluation& of, const Surface_demand& demand)
      : of_(of)
      , demand_(demand)
      , limits_demand_{demand.tolerance / 4, demand.normal_tolerance,
                       (std::max)(1u, demand.most_rounds), true, true} // points and surface normals
      , limits_(of.cells_.scheme(), limits_demand_, For_chunks())
    {}

    void operator()(Cell&& cell, Queries queries)
    {
      queries = evaluate(cell, std::move(queries));
      if (queries.empty()) return;
      std::array<Queries, 4> parts;
      for (Surface_query& q : queries) {
        const Index part = degree == 4 ? into_quad(q) : into_triangle(q);
        parts[part].push_back(q);
      }
      const typename Cells::Round round(of_.cells_, std::move(cell));
      for (Index i = 0; i < 4; ++i)
        if (!parts[i].empty()) (*this)(round.child(i), std::move(parts[i]));
    }

    Queries done;

  private:
    // the child that a query is in, whose parameters the query gets
    static Index into_quad(Surface_query& q)
    {
      constexpr Index of_halves[] = {0, 1, 3, 2};
      const bool right = q.u >= 0.5, upper = q.v >= 0.5;
      q.u = 2 * q.u - (right ? 1 : 0);
      q.v = 2 * q.v - (upper ? 1 : 0);
      q.scale *= 2;
      return of_halves[(right ? 1 : 0) + (upper ? 2 : 0)];
    }
    static Index into_triangle(Surface_query& q)
    {
      const double u = 2 * q.u, v = 2 * q.v;
      if (u < 1 && v < 1 && u + v > 1) {
        q.u = 1 - u, q.v = 1 - v, q.scale *= -2;
        return 3;
      }
      q.scale *= 2;
      q.u = u >= 1 ? u - 1 : u;
      q.v = u < 1 && v >= 1 ? v - 1 : v;
      return u >= 1 ? 1 : v >= 1 ? 2 : 0;
    }

    // returns the queries that the cell is too coarse for
    Queries evaluate(Cell& cell, Queries queries)
    {
      Queries open;
      bool is_regular = false;
      if (of_.facts_.limit_neighborhood.is_spline && cell.rounds + 1 >= of_.facts_.first_round)
        of_.cells_.with_kinds(
          cell, [&](const Level_connectivity& level, Index base, const auto& kind) {
            const Spline_piece piece(level, base, degree,
                                     of_.facts_.limit_neighborhood.regular_rings > 0, kind);
            is_regular = piece.is_regular();
            if (!is_regular) return;
            for (Surface_query& q : queries)
              note(q, cell, Jet_average(entries(cell, piece.entries(q.u, q.v)), is_pn), 2, open);
          });
      if (!is_regular) evaluate_irregular(cell, queries, open);
      return open;
    }

    std::vector<Jet_entry> entries(const Cell& cell, const Spline_piece::Entries& weights) const
    {
      std::vector<Jet_entry> all;
      all.reserve(weights.size());
      for (const auto& [v, weight] : weights) {
        Jet_entry& e = all.emplace_back();
        e.weight = weight;
        const Value& value = cell.level.values[v];
        e.point = point_of(value);
        if constexpr (is_pn) {
          e.normal = value.normal;
          e.roundness = value.roundness;
        }
      }
      return all;
    }

    // Corners are limit points. Near the last round, and where the scheme has no polynomial pieces, the patch of the limits at
    // the corners stands for the surface.
    void evaluate_irregular(Cell& cell, Queries& queries, Queries& open)
    {
      const bool takes_patch =
        !of_.facts_.limit_neighborhood.is_spline || cell.rounds + 1 >= demand_.most_rounds;
      const auto is_corner = [](const Surface_query& q) {
        return (q.u == 0 || q.u == 1) && (q.v == 0 || q.v == 1);
      };
      std::vector<Corner> corners;
      for (Surface_query& q : queries) {
        if (!takes_patch && !is_corner(q)) {
          open.push_back(q);
          continue;
        }
        if (corners.empty()) corners = limits(cell);
        if (is_corner(q))
          put(q, cell, corners[q.u == 0 ? (q.v == 0 ? 0 : degree - 1) : (q.v == 0 ? 1 : 2)]);
        else
          note(q, cell, patch_average(entries(corners), q.u, q.v), 1, open);
      }
    }

    struct Corner : Jet_entry
    {
      double error, normal_error;
    };
    static std::vector<Jet_entry> entries(const std::vector<Corner>& corners)
    {
      return {corners.begin(), corners.end()};
    }

    std::vector<Corner> limits(Cell& cell)
    {
      const std::vector<Index> vertices = Cells::distinct(cell.corners());
      Level_creases creases = cell.creases; // gets the tangents of the limit
      const auto results = limits_(cell.level, creases, cell.rounds + 1, &vertices);
      const typename Cells::Cell_slots slot_of(cell.level.level, cell.creases);
      std::vector<Corner> corners;
      for (const Index h : cell.halfedges()) {
        const auto& r = results[slot_of(h)];
        Corner c{};
        c.point = point_of(r.value);
        if constexpr (is_pn) c.normal = r.value.normal;
        if (r.has_surface_normal) c.normal = r.surface_normal;
        c.error = r.error + rounding(c.point);
        c.normal_error =
          r.has_surface_normal ? r.normal_error : std::numeric_limits<double>::infinity();
        corners.push_back(c);
      }
      return corners;
    }

    void put(Surface_query& q, const Cell& cell, const Corner& corner)
    {
      for (std::size_t c = 0; c < 3; ++c) q.point[c] = {corner.point[c], 0, 0, 0, 0, 0};
      q.normal = corner.normal;
      q.error = corner.error;
      q.normal_error = corner.normal_error;
      q.derivatives = 0;
      q.rounds = cell.rounds;
      done.push_back(q);
    }

    static double rounding(const std::array<double, 3>& p)
    {
      return 16 * std::numeric_limits<double>::epsilon() * largest_coordinate(p);
    }

    // The next approximation; what the last one was off by tells of its error. It falls by 1/16 a round in regular pieces.
    void note(Surface_query q, const Cell& cell, const Jet_average& average, unsigned derivatives,
              Queries& open)
    {
      constexpr double ratio = 1. / 8;
      std::array<double, 3> p, last;
      const std::array<double, 3> n = average.unit_normal();
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] = average.point[c].value;
        last[c] = q.point[c].value;
      }
      const bool is_exact = derivatives == 2 && !is_pn;
      if (is_exact)
        q.error = q.normal_error = 0;
      else if (q.has_last) {
        const double step = quick_length(difference(p, last)),
                     turn = quick_length(difference(n, q.normal));
        q.error = (std::max)(step, ratio * q.last_step);
        q.normal_error = (std::max)(turn, ratio * q.last_turn);
        q.last_step = step;
        q.last_turn = turn;
      }
      const double least = rounding(p);
      q.error += least;
      q.has_last = true;
      q.normal = n;
      q.derivatives = derivatives;
      q.rounds = cell.rounds;
      const double s = q.scale, s2 = s * s;
      for (std::size_t c = 0; c < 3; ++c) {
        const Jet& j = average.point[c];
        q.point[c] = {j.value, s * j.u, s * j.v, s2 * j.uu, s2 * j.uv, s2 * j.vv};
      }
      const bool is_last = cell.rounds >= demand_.most_rounds;
      if (is_last || (q.error <= (std::max)(demand_.tolerance, 2 * least) &&
                      q.normal_error <= demand_.normal_tolerance))
        done.push_back(q);
      else
        open.push_back(q);
    }

    const Scheme_evaluation& of_;
    const Surface_demand demand_;
    const Limit_demand limits_demand_;
    Limits_of_level<Scheme, double, Level_creases> limits_;
  };

  const Cells cells_;
  const Scheme_facts facts_;
};

template <class Scheme, class Level_creases>
std::unique_ptr<Surface_evaluation>
make_surface_evaluation(const Scheme& scheme,
                        Valued_level<typename Average_of_scheme<Scheme, double>::Value>&& level,
                        Level_creases&& creases)
{
  return std::make_unique<Scheme_evaluation<Scheme, Level_creases>>(
    scheme, std::move(level), std::forward<Level_creases>(creases));
}

// for the library CGAL::PN_subdivision_3_limits, see limits_at_slots.h
#define CGAL_PN_SUBDIVISION_3_SURFACE_OF(EXTERN, SCHEME, CREASES)                                  \
  EXTERN template std::unique_ptr<Surface_evaluation> make_surface_evaluation(                     \
    const compiled_once::SCHEME&, Valued_level<compiled_once::Value<compiled_once::SCHEME>>&&,     \
    CREASES&&);
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
CGAL_PN_SUBDIVISION_3_OF_QUADS(CGAL_PN_SUBDIVISION_3_SURFACE_OF, extern)
CGAL_PN_SUBDIVISION_3_OF_TRIANGLES(CGAL_PN_SUBDIVISION_3_SURFACE_OF, extern)
#endif

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SURFACE_EVALUATION_H
