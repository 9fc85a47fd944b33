// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_LIMIT_DISTANCE_H
#define CGAL_PN_FITTING_3_INTERNAL_LIMIT_DISTANCE_H

#include <CGAL/PN_fitting_3/internal/Foot_of_point.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Has_final_rules.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Spline_piece.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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
    , neighborhood_(limit_neighborhood(scheme))
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
    const Index first = level.halfedge_of_vertex(foot.center);
    foot.in_face = {};
    Index h = first;
    do {
      if (!level.is_border(h)) {
        const Foot_in_piece f = in_face(level, values, rounds, h, foot.point);
        if (f.distance < foot.in_face.distance) {
          foot.in_face = f;
          foot.base = h;
        }
        if (f.u > 0 && f.v > 0 && (degree == 3 ? f.u + f.v < 1 : f.u < 1 && f.v < 1)) break;
      }
      h = level.next_around_target(h);
    } while (h != first);
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
    const Spline_piece piece(level, base, degree, neighborhood_.regular_rings > 0, [&](Index v) {
      if (level.is_border_vertex(v)) return Piece_vertex::border;
      const bool is_regular = level.valence(v) == Has_final_rules<Scheme>::regular_valence;
      return is_regular ? Piece_vertex::interior : Piece_vertex::irregular;
    });
    const bool is_spline =
      neighborhood_.is_spline && piece.is_regular() && rounds + 1 >= first_tuned_round(scheme_);
    const auto at = [&](double u, double v) {
      std::vector<Jet_entry> entries;
      if (is_spline) {
        for (const auto& [vertex, weight] : piece.entries(u, v)) {
          entries.push_back(entry(vertex));
          entries.back().weight = weight;
        }
        return Jet_average(std::move(entries), true);
      }
      Index h = base;
      do {
        entries.push_back(entry(level.target(h)));
        h = level.next(h);
      } while (h != base);
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
  const Limit_neighborhood neighborhood_;
  For_chunks for_chunks_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_LIMIT_DISTANCE_H
