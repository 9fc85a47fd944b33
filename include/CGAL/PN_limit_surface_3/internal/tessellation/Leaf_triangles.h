// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_LEAF_TRIANGLES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_LEAF_TRIANGLES_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

struct Tessellation_triangle
{
  using Index = Level_connectivity::Index;

  Index origin;                   // the face of the control mesh
  std::array<Index, 3> slot_ids;  // of the corners
  std::array<Index, 3> halfedges; // of the result, each from a corner to the next
};

// Divides leaves into triangles that have all vertices on their sides, as finer neighbors have put them there.
template <class FT>
class Leaf_triangles
{
public:
  using Index = Level_connectivity::Index;

  // `tolerance` is that of the triangles; is_proven: whether the errors of leaves are bounds
  Leaf_triangles(const Split_edges<FT>& all, double tolerance, std::size_t dimension = 0,
                 bool is_proven = false)
    : all_(all)
    , tolerance_(tolerance)
    , dimension_(dimension)
    , is_proven_(is_proven)
    , edge_(all.number_of_edges(), Level_connectivity::null)
  {}

  void reserve(std::size_t triangles) { triangles_.reserve(triangles); }

  // corner_values: `dimension` numbers for each corner. Returns the estimated distance of the leaf, and of its triangles by the
  // normals at their corners.
  double add(const Tessellation_leaf& leaf, const double* corner_values = nullptr)
  {
    take(leaf, corner_values);
    for (Place& p : polygon_) p.halfedge = result_halfedge(p.halfedge);
    leaf_error_ = 0;
    note_error(leaf.origin, leaf.error + (is_proven_ ? way_back(leaf) : 0), 0, polygon_.size() / 2);
    add_triangles(leaf);
    return leaf_error_;
  }

  // The triangles of this leaf alone, for a trial: how far the surface is from them by the normals, infinite if it is more
  // than `most`.
  double try_alone(const Tessellation_leaf& leaf, double most)
  {
    triangles_.clear();
    take(leaf, nullptr);
    is_trial_ = true;
    most_ = most;
    trial_error_ = 0;
    for (const Place& p : polygon_)
      if (p.corner.normal == flatness::Vector{}) return infinity;
    forget_chords();
    return may_be_flat() && add_triangles(leaf) && trial_error_ <= most_ ? trial_error_ : infinity;
  }

  const std::vector<Tessellation_triangle>& triangles() const { return triangles_; }
  // `dimension` for each corner of each triangle
  const std::vector<double>& corner_values() const { return corner_values_; }
  Index number_of_edges() const { return edges_; }
  // the largest of the leaves
  double bound() const { return worst_.error; }
  // the face of the control mesh where it is, and about where
  Index worst_face() const { return worst_.origin; }
  const flatness::Vector& worst_place() const { return worst_.place; }

private:
  struct Chord
  {
    flatness::Height height;
    double length;
  };

  void take(const Tessellation_leaf& leaf, const double* corner_values)
  {
    polygon_.clear();
    corners_ = corner_values;
    degree_ = leaf.degree;
    for (Index i = 0; i < leaf.degree; ++i) {
      const auto side = side_bit(i), last_side = side_bit(i == 0 ? leaf.degree - 1 : i - 1);
      auto sides = static_cast<unsigned char>(side | last_side);
      all_.for_each_part(leaf.slot_ids[i], leaf.halfedges[i], [&](Index slot, Index h, double t) {
        polygon_.push_back({slot, h, sides, i + t, all_.corner(slot)});
        sides = side;
      });
    }
  }

  // The bound is for vertices that come one after the other along the sides: how far they go back at most.
  double way_back(const Tessellation_leaf& leaf) const
  {
    double way = 0, before = 0;
    for (const Place& p : polygon_) {
      const auto i = static_cast<std::size_t>(p.at);
      if (p.at == double(i)) before = 0;
      const flatness::Vector a = all_.corner(leaf.slot_ids[i]).point,
                             side =
                               difference(all_.corner(leaf.slot_ids[(i + 1) % degree_]).point, a);
      const double length = quick_length(side);
      const double along = length > 0 ? dot(difference(p.corner.point, a), side) / length : 0;
      way = (std::max)(way, before - along);
      before = (std::max)(before, along);
    }
    return way;
  }

  bool add_triangles(const Tessellation_leaf& leaf)
  {
    if (polygon_.size() != 4 || leaf.degree != 4) return clip(leaf.origin);
    add_quadrilateral(leaf);
    return true;
  }

  // Each division has a triangle about the middle of the polygon: none of its sides has more than half of the places
  // beyond it, and one side has a third.
  bool may_be_flat()
  {
    const std::size_t n = polygon_.size();
    if (n < 4) return true;
    const auto bulge = [&](std::size_t i, std::size_t k) {
      return n <= most_places ? chord((std::min)(i, k), (std::max)(i, k)).height.largest
                              : flatness::Section(polygon_[i].corner, polygon_[k].corner).bulge();
    };
    for (std::size_t step = n / 2; step >= (n + 2) / 3; --step)
      for (std::size_t i = 0; i < (2 * step == n ? step : n); ++i)
        if (bulge(i, (i + step) % n) <= most_) return true;
    return false;
  }

  // a vertex of a leaf, with the half-edge that comes from it, and the sides on which it is
  struct Place
  {
    Index slot, halfedge;
    unsigned char sides;
    double at; // the number of the corner, and the part of the side that it is behind that
    flatness::Corner corner;
  };

  static unsigned char side_bit(Index i) { return static_cast<unsigned char>(1u << i); }

  Index result_halfedge(Index h)
  {
    Index& e = edge_[h / 2];
    if (e == Level_connectivity::null) e = edges_++;
    return 2 * e + h % 2;
  }

  void add_triangle(Index origin, const Place& a, const Place& b, const Place& c)
  {
    triangles_.push_back({origin, {a.slot, b.slot, c.slot}, {a.halfedge, b.halfedge, c.halfedge}});
    add_corner_values(a, b, c);
  }

  void add_corner_values(const Place& a, const Place& b, const Place& c)
  {
    for (const Place* p : {&a, &b, &c}) {
      const auto i = static_cast<std::size_t>(p->at);
      const double t = p->at - double(i);
      const double *from = corners_ + i * dimension_,
                   *to = corners_ + (i + 1) % degree_ * dimension_;
      for (std::size_t k = 0; k < dimension_; ++k)
        corner_values_.push_back(t == 0 ? from[k] : from[k] + t * (to[k] - from[k]));
    }
  }

  // clips the corner i, so that its predecessor leads to its successor
  void clip_corner(Index origin, std::size_t i)
  {
    Place& before = polygon_[i == 0 ? polygon_.size() - 1 : i - 1];
    Place after = polygon_[i + 1 == polygon_.size() ? 0 : i + 1];
    after.halfedge = 2 * edges_++;
    add_triangle(origin, before, polygon_[i], after);
    before.halfedge = after.halfedge + 1;
    polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  // between the places i and k
  void note_error(Index origin, double error, std::size_t i, std::size_t k)
  {
    leaf_error_ = (std::max)(leaf_error_, error);
    if (error > worst_.error)
      worst_ = {origin, error,
                flatness::between(polygon_[i].corner.point, polygon_[k].corner.point, 0.5)};
  }

  static double turns(const Place& a, const Place& b, const Place& c)
  {
    return flatness::is_turned_or_thin(a.corner, b.corner, c.corner, 1e-7) ? 1 : 0;
  }

  void add_quadrilateral(const Tessellation_leaf& leaf)
  {
    const auto& p = polygon_;
    const auto turns_at = [&](std::size_t i) {
      const Place &a = p[i], &b = p[i + 1], &c = p[i + 2], &d = p[(i + 3) % 4];
      return turns(a, b, c) + turns(a, c, d);
    };
    std::size_t first = leaf.has_flatter_second ? 1 : 0;
    const double of_flatter = turns_at(first);
    if (of_flatter > 0 && turns_at(1 - first) < of_flatter) first = 1 - first;
    if (is_trial_)
      trial_error_ = (std::max)(over_triangle(first, first + 1, first + 2),
                                over_triangle(first, first + 2, (first + 3) % 4));
    clip_corner(leaf.origin, first + 1);
    add_triangle(leaf.origin, p[0], p[1], p[2]);
  }
  double over_triangle(std::size_t i, std::size_t j, std::size_t k) const
  {
    return flatness::over_triangle(polygon_[i].corner, polygon_[j].corner, polygon_[k].corner);
  }

  // A triangle has no three corners on one side, and what is left after it neither. Ears, the flattest and shortest
  // first, until there are few places; then the best of all divisions.
  bool clip(Index origin)
  {
    const bool has_chords = is_trial_ && polygon_.size() <= most_places;
    while (polygon_.size() > most_places) {
      std::size_t best = polygon_.size();
      auto best_key = std::make_pair(0., 0.);
      const auto off = places_off_sides();
      for (std::size_t i = 0; i < polygon_.size(); ++i) {
        if (!is_ear(i, off)) continue;
        const auto key = key_of_ear(i);
        if (best != polygon_.size() && !(key < best_key)) continue;
        best = i;
        best_key = key;
      }
      clip_corner(origin, best);
    }
    if (!has_chords) forget_chords();
    return divide(origin);
  }

  // forgets the chords of the places as they were; a chord is found when it is asked for
  void forget_chords()
  {
    const std::size_t n = (std::min)(polygon_.size(), most_places);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = i + 1; k < n; ++k) chords_[i][k].length = -1;
  }
  const Chord& chord(std::size_t i, std::size_t k)
  {
    Chord& c = chords_[i][k];
    if (c.length < 0)
      c = {flatness::height({polygon_[i].corner, polygon_[k].corner}),
           flatness::distance(polygon_[i].corner, polygon_[k].corner)};
    return c;
  }

  // for each side, the number of places that are not on it
  std::array<std::size_t, 4> places_off_sides() const
  {
    std::array<std::size_t, 4> off{};
    for (const Place& p : polygon_)
      for (unsigned s = 0; s < 4; ++s) off[s] += (p.sides >> s & 1u) == 0 ? 1 : 0;
    return off;
  }
  bool is_ear(std::size_t i, const std::array<std::size_t, 4>& off) const
  {
    const auto [before, after] = neighbors(i);
    if ((before->sides & polygon_[i].sides & after->sides) != 0) return false;
    for (unsigned s = 0; s < 4; ++s)
      if (off[s] == 1 && (polygon_[i].sides >> s & 1u) == 0) return false;
    return true;
  }
  std::pair<const Place*, const Place*> neighbors(std::size_t i) const
  {
    return {&polygon_[i == 0 ? polygon_.size() - 1 : i - 1],
            &polygon_[i + 1 == polygon_.size() ? 0 : i + 1]};
  }
  std::pair<double, double> key_of_ear(std::size_t i) const
  {
    const auto [before, after] = neighbors(i);
    const flatness::Section section(before->corner, after->corner);
    return {turns(*before, polygon_[i], *after),
            section.bulge() + weight_of_length * flatness::distance(before->corner, after->corner)};
  }

  // The division of least cost, part by part: of the places from i to k the best apex of the triangle at i, k. False if a
  // trial finds none.
  bool divide(Index origin)
  {
    const std::size_t n = polygon_.size();
    for (std::size_t step = 1; step < n; ++step)
      for (std::size_t i = 0, k = step; k < n; ++i, ++k) {
        Part& part = parts_[i][k];
        part = {step == 1 ? 0 : infinity, i};
        if (chord(i, k).height.largest > most_ && is_trial_) {
          if (step == 1) return false;
          continue;
        }
        for (std::size_t j = i + 1; j < k; ++j) {
          const double of_parts = parts_[i][j].cost + parts_[j][k].cost;
          if (!(of_parts < part.cost)) continue;
          const double cost = of_parts + cost_of(i, j, k, part.cost - of_parts);
          if (cost < part.cost) part = {cost, j};
        }
      }
    if (n > 2 && !(parts_[0][n - 1].cost < infinity)) {
      CGAL_assertion(is_trial_);
      return false;
    }
    add_part(origin, 0, n - 1, polygon_[n - 1].halfedge);
    return true;
  }

  // some number that is not less than `most` if the cost is not
  double cost_of(std::size_t i, std::size_t j, std::size_t k, double most) const
  {
    const Place &a = polygon_[i], &b = polygon_[j], &c = polygon_[k];
    if ((a.sides & b.sides & c.sides) != 0) return infinity;
    const Chord &ab = chords_[i][j], &bc = chords_[j][k], &ac = chords_[i][k];
    const double height = flatness::over_triangle(ab.height, bc.height, ac.height);
    if (is_trial_ && height > most_) return infinity;
    const double error = height / tolerance_;
    constexpr double cost_of_turn = 1024, cost_of_excess = 64, cost_of_length = 1. / 256;
    const double around = ab.length + bc.length + ac.length;
    const double longest = (std::max)({ab.length, bc.length, ac.length});
    const double shape = around > longest ? longest / (around - longest) : 1; // 1/2 to 1
    const double fourth = error * error * error * error;
    const double cost = fourth * (error > 1 ? cost_of_excess : 1) + cost_of_length * shape;
    return cost > 2 * most ? cost : cost + cost_of_turn * turns(a, b, c);
  }

  // adds the part between the places i to k and the half-edge that leads from k to i
  void add_part(Index origin, std::size_t i, std::size_t k, Index back)
  {
    if (k == i + 1) return;
    const std::size_t j = parts_[i][k].apex;
    const auto halfedge = [&](std::size_t from, std::size_t to) {
      return to == from + 1 ? polygon_[from].halfedge : 2 * edges_++;
    };
    const Index first = halfedge(i, j), second = halfedge(j, k);
    triangles_.push_back(
      {origin, {polygon_[i].slot, polygon_[j].slot, polygon_[k].slot}, {first, second, back}});
    add_corner_values(polygon_[i], polygon_[j], polygon_[k]);
    const double error =
      flatness::over_triangle(chords_[i][j].height, chords_[j][k].height, chords_[i][k].height);
    if (is_trial_)
      trial_error_ = (std::max)(trial_error_, error);
    else if (!is_proven_ && is_known(i) && is_known(j) && is_known(k))
      note_error(origin, tessellation_safety * error, i, k);
    add_part(origin, i, j, first + 1);
    add_part(origin, j, k, second + 1);
  }

  bool is_known(std::size_t i) const { return all_.slot(polygon_[i].slot).has_surface_normal; }

  struct Worst
  {
    Index origin = 0;
    double error = 0;
    flatness::Vector place{};
  };
  struct Part
  {
    double cost;
    std::size_t apex;
  };
  static constexpr std::size_t most_places = 16;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  template <class T>
  using Table = std::array<std::array<T, most_places>, most_places>;

  const Split_edges<FT>& all_;
  const double tolerance_;
  const std::size_t dimension_;
  const bool is_proven_;
  const double* corners_ = nullptr;
  std::size_t degree_ = 0;
  bool is_trial_ = false;
  double most_ = 0, trial_error_ = 0; // of a trial
  double leaf_error_ = 0;
  std::vector<double> corner_values_;
  Table<Chord> chords_;
  Table<Part> parts_;
  std::vector<Index> edge_; // of the result
  Index edges_ = 0;
  Worst worst_;
  std::vector<Place> polygon_;
  std::vector<Tessellation_triangle> triangles_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_LEAF_TRIANGLES_H
