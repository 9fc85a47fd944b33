// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_LIMIT_DISTANCE_H
#define CGAL_PN_FITTING_3_INTERNAL_LIMIT_DISTANCE_H

#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Jet.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Spline_piece.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Where a piece of a surface or curve is nearest to a point.
struct Foot_in_piece
{
  double u = 0, v = 0, distance = std::numeric_limits<double>::infinity();
};

// A point whose distance from a surface or curve is sought, in better and better approximations of these. Their errors fall
// by 1/4 a round at least.
struct Foot_of_point
{
  std::array<double, 3> point{};
  std::uint32_t vertex = 0; // to which it belongs
  double distance = std::numeric_limits<double>::infinity(), error = distance, step = 0;

  void note(double next)
  {
    const double last_step = step;
    step = std::abs(next - distance);
    error = (std::max)(step, last_step / 8);
    distance = next;
  }
  bool is_settled(double tolerance) const { return error <= (std::max)(tolerance, distance / 64); }
};

// The largest of some distances, with its estimated error.
struct Farthest_point
{
  double distance = 0, error = 0;
  std::uint32_t vertex = 0;

  void add(const Foot_of_point& foot)
  {
    if (foot.distance > distance) *this = {foot.distance, foot.error, foot.vertex};
  }
};

// at(u, v): the Jet_average of the piece, over the unit square or the triangle u + v <= 1; of a curve v does not matter
template <class At>
Foot_in_piece foot_in_piece(const At& at, bool is_triangle, const std::array<double, 3>& point,
                            double u, double v)
{
  constexpr int most_steps = 16;
  Foot_in_piece best;
  for (int i = 0; i < most_steps; ++i) {
    Jet_vector r = at(u, v).point;
    for (std::size_t k = 0; k < 3; ++k) r[k].value -= point[k];
    if (const double distance = std::sqrt(jet_product(r, r).value); distance < best.distance)
      best = {u, v, distance};
    const auto [next_u, next_v] = next_foot(r, is_triangle, u, v);
    if (!(std::abs(next_u - u) + std::abs(next_v - v) > 1e-15)) break;
    u = next_u;
    v = next_v;
  }
  return best;
}

// The largest distance of points from a limit surface, each sought about a vertex. As in Surface_evaluation the averages of
// the spline pieces of a level stand for the surface, and the patch of a face where it has no such piece. Each point has its foot in
// the faces about a center; the level is refined about the centers of the points that may be the farthest, until these distances
// no longer change.
template <class Scheme>
class Limit_distance
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<double, 3>;
  using Values = std::vector<Value>;

  struct Foot : Foot_of_point
  {
    Foot(const std::array<double, 3>& p, Index v, Index of_center)
      : center(of_center)
    {
      point = p;
      vertex = v;
    }

    Index center, base = 0; // base: the half-edge to the center in its face
    Foot_in_piece in_face{};
  };

  Limit_distance(const Scheme& scheme, const For_chunks& for_chunks)
    : scheme_(scheme)
    , facts_(facts_of(scheme))
    , for_chunks_(for_chunks)
  {}

  // `feet` have their points, and as centers vertices with faces; what is nearer than `farthest` does not matter
  Farthest_point operator()(Level_connectivity level, Values values, std::vector<Foot> feet,
                            double tolerance, Farthest_point farthest = {}) const
  {
    for (unsigned rounds = 0;; ++rounds) {
      for_chunks_(static_cast<Index>(feet.size()), [&](Index begin, Index end) {
        for (Index i = begin; i < end; ++i) find(level, values, rounds, feet[i]);
      });
      double least = farthest.distance;
      for (const Foot& f : feet) least = (std::max)(least, f.distance - f.error);
      const auto is_done = [&](const Foot& f) {
        const bool is_settled = rounds == most_rounds || f.is_settled(tolerance);
        if (is_settled) farthest.add(f);
        return is_settled || f.distance + f.error <= least;
      };
      feet.erase(std::remove_if(feet.begin(), feet.end(), is_done), feet.end());
      if (feet.empty()) return farthest;
      refine(level, values, rounds, feet);
    }
  }

private:
  using Refiner = Level_refiner<Scheme, PN_average<double, 3>>;
  static constexpr Index degree = Scheme::Host::refined_degree;
  static constexpr unsigned most_rounds = 12;

  void find(const Level_connectivity& level, const Values& values, unsigned rounds,
            Foot& foot) const
  {
    foot.in_face = {};
    for (const Index h : halfedges_around_target(level, level.halfedge_of_vertex(foot.center))) {
      if (level.is_border(h)) continue;
      const Foot_in_piece f = in_face(level, values, rounds, h, foot.point);
      if (f.distance < foot.in_face.distance) {
        foot.in_face = f;
        foot.base = h;
      }
      if (f.u > 0 && f.v > 0 && (degree == 3 ? f.u + f.v < 1 : f.u < 1 && f.v < 1)) break;
    }
    foot.note(foot.in_face.distance);
  }

  Foot_in_piece in_face(const Level_connectivity& level, const Values& values, unsigned rounds,
                        Index base, const std::array<double, 3>& point) const
  {
    const auto entry = [&](Index v) {
      return Jet_entry{{}, values[v].point, values[v].normal, values[v].roundness};
    };
    // of a polygon the corner, until it becomes several faces
    if (!level.has_degree(base, degree))
      return {0, 0, quick_length(difference(values[level.target(base)].point, point))};
    const Spline_piece piece(
      level, base, degree, facts_.limit_neighborhood.regular_rings > 0, [&](Index v) {
        if (level.is_border_vertex(v)) return Piece_vertex::border;
        const bool is_regular = level.valence(v) == Has_final_rules<Scheme>::regular_valence;
        return is_regular ? Piece_vertex::interior : Piece_vertex::irregular;
      });
    const bool is_spline =
      facts_.limit_neighborhood.is_spline && piece.is_regular() && rounds + 1 >= facts_.first_round;
    const auto at = [&](double u, double v) {
      std::vector<Jet_entry> entries;
      if (is_spline) {
        for (const auto& [vertex, weight] : piece.entries(u, v)) {
          entries.push_back(entry(vertex));
          entries.back().weight = weight;
        }
        return Jet_average(std::move(entries), true);
      }
      for (const Index h : halfedges_around_face(level, base))
        entries.push_back(entry(level.target(h)));
      return patch_average(std::move(entries), u, v);
    };
    return foot_in_piece(at, degree == 3, point, 0.25, 0.25);
  }

  void refine(Level_connectivity& level, Values& values, unsigned rounds,
              std::vector<Foot>& feet) const
  {
    std::vector<Index> centers;
    for (const Foot& f : feet) centers.push_back(f.center);
    std::sort(centers.begin(), centers.end());
    centers.erase(std::unique(centers.begin(), centers.end()), centers.end());
    const Sub_level cut(level, centers, cut_rings(scheme_));
    std::vector<Index> edge(level.number_of_edges());
    for (Index e = 0; e < cut.edges.size(); ++e) edge[cut.edges[e]] = e;
    typename Refiner::Values old;
    for (const Index v : cut.vertices) old.emplace_back(values[v]);
    Refiner refiner(scheme_, Level_connectivity(cut.level), std::move(old), for_chunks_, rounds);
    refiner.refine();
    for (Foot& f : feet)
      f.center =
        nearest_child(cut.level, refiner.level(), 2 * edge[f.base / 2] + f.base % 2, f.in_face);
    values.assign(refiner.values().begin(), refiner.values().end());
    level = refiner.take_level();
  }

  // the vertex of the next level that is next to parameters of a face
  static Index nearest_child(const Level_connectivity& level, const Level_connectivity& child,
                             Index base, const Foot_in_piece& f)
  {
    const auto i = static_cast<std::size_t>(std::lround(2 * f.u)),
               j = static_cast<std::size_t>(std::lround(2 * f.v));
    if (i == 0 && j == 0) return level.target(base);
    const Edge_split split(level);
    const Index h1 = level.next(base), h2 = level.next(h1);
    const auto corner = [&](Index h) { return level.target(h); };
    const auto middle = [&](Index h) { return split.edge_vertex(h); };
    if constexpr (degree == 3) {
      const Index at[3][3] = {{corner(base), middle(h1), corner(h1)},
                              {middle(base), middle(h2), middle(h2)},
                              {corner(h2), middle(h2), middle(h2)}};
      return at[j][i];
    } else {
      const Index h3 = level.next(h2);
      const Index of_face = child.target(child.next(child.next(split.second_half(base))));
      const Index at[3][3] = {{corner(base), middle(h1), corner(h1)},
                              {middle(base), of_face, middle(h2)},
                              {corner(h3), middle(h3), corner(h2)}};
      return at[j][i];
    }
  }

  const Scheme& scheme_;
  const Scheme_facts facts_;
  For_chunks for_chunks_;
};

// What Limit_distance is for surfaces, for cubic B-spline curves: about each point a few control points are refined.
template <int dimension>
class Curve_distance
{
public:
  using Value = Point_normal<double, dimension>;
  using Values = std::vector<Value>;

  explicit Curve_distance(bool is_closed)
    : is_closed_(is_closed)
  {}

  Farthest_point operator()(const Values& values, const Vectors<dimension>& points,
                            const std::vector<std::uint32_t>& vertices, double tolerance) const
  {
    constexpr unsigned most_rounds = 16;
    Farthest_point farthest;
    for (const auto v : vertices) {
      Foot_of_point foot;
      foot.vertex = v;
      std::copy_n(points[v].data(), dimension, foot.point.begin());
      Part part = part_about(values, v);
      for (unsigned rounds = 0;; ++rounds) {
        const auto [at, distance] = find(part, foot.point);
        foot.note(distance);
        if (rounds == most_rounds || foot.is_settled(tolerance)) {
          farthest.add(foot);
          break;
        }
        if (foot.distance + foot.error <= farthest.distance) break;
        part = refined(part, at);
      }
    }
    return farthest;
  }

private:
  static constexpr std::ptrdiff_t reach = 3; // on both sides of the center

  struct Part
  {
    Values net;
    std::ptrdiff_t center = 0;
    bool begins = false, ends = false; // at the first or last value of an open curve
  };

  Part part_about(const Values& values, std::size_t v) const
  {
    const auto n = static_cast<std::ptrdiff_t>(values.size()), at = static_cast<std::ptrdiff_t>(v);
    Part part;
    for (auto i = at - reach; i <= at + reach; ++i) {
      if (!is_closed_ && (i < 0 || i >= n)) continue;
      if (i == at) part.center = static_cast<std::ptrdiff_t>(part.net.size());
      part.net.push_back(values[static_cast<std::size_t>((i % n + n) % n)]);
    }
    part.begins = !is_closed_ && at <= reach;
    part.ends = !is_closed_ && at + reach >= n - 1;
    return part;
  }

  // in the two pieces about the center: twice the parameter of the foot, rounded, and the distance
  static std::pair<std::ptrdiff_t, double> find(const Part& part,
                                                const std::array<double, 3>& point)
  {
    const auto n = static_cast<std::ptrdiff_t>(part.net.size());
    const auto entry = [&](std::ptrdiff_t i, const Jet& weight) {
      Jet_entry e;
      const Value& value = part.net[static_cast<std::size_t>(i)];
      e.weight = weight;
      std::copy_n(value.point.begin(), dimension, e.point.begin());
      std::copy_n(value.normal.begin(), dimension, e.normal.begin());
      e.roundness = value.roundness;
      return e;
    };
    std::pair<std::ptrdiff_t, double> best{2 * part.center,
                                           std::numeric_limits<double>::infinity()};
    if (n == 1) best.second = quick_length(difference(entry(0, {}).point, point));
    for (auto i = (std::max)(std::ptrdiff_t(0), part.center - 1); i <= part.center && i + 1 < n;
         ++i) {
      const bool is_inner = i > 0 && i + 2 < n;
      const auto at = [&](double u, double) {
        const Jet x = Jet::of_u(u), y = x * -1 + 1;
        std::vector<Jet_entry> entries;
        if (is_inner) {
          const Jet left = y * y * y * (1. / 6), right = x * x * x * (1. / 6);
          const Jet first = x * x * x * 0.5 - x * x + 2. / 3;
          entries = {entry(i, first), entry(i + 1, (left + first + right) * -1 + 1),
                     entry(i - 1, left), entry(i + 2, right)};
        } else
          entries = {entry(i, y), entry(i + 1, x)};
        return Jet_average(std::move(entries), true);
      };
      const Foot_in_piece f = foot_in_piece(at, false, point, 0.5, 0);
      if (f.distance < best.second)
        best = {2 * i + static_cast<std::ptrdiff_t>(std::lround(2 * f.u)), f.distance};
    }
    return best;
  }

  // `center`: twice the number of the old value, one more for the middle to the next one
  Part refined(const Part& old, std::ptrdiff_t center) const
  {
    const auto n = static_cast<std::ptrdiff_t>(old.net.size());
    const auto average = [&](const Ring_averages::Row& row) {
      return average_(row.data(), row.data() + row.size(), old.net.data());
    };
    Part part;
    const std::ptrdiff_t first = (std::max)(center - reach, std::ptrdiff_t(old.begins ? 0 : 1)),
                         last = (std::min)(center + reach, 2 * n - (old.ends ? 2 : 3));
    for (auto i = first; i <= last; ++i) {
      const auto j = static_cast<std::uint32_t>(i / 2);
      if (i % 2 == 1)
        part.net.push_back(average({{j, 1. / 2}, {j + 1, 1. / 2}}));
      else if (i == 0 || i == 2 * n - 2)
        part.net.push_back(old.net[j]);
      else
        part.net.push_back(average({{j - 1, 1. / 8}, {j + 1, 1. / 8}, {j, 6. / 8}}));
    }
    part.center = center - first;
    part.begins = old.begins && first == 0;
    part.ends = old.ends && last == 2 * n - 2;
    return part;
  }

  bool is_closed_;
  PN_average<double, dimension> average_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_LIMIT_DISTANCE_H
