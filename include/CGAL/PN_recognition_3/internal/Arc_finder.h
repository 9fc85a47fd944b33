// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_ARC_FINDER_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_ARC_FINDER_H

#include <CGAL/PN_recognition_3/internal/Arc_growth.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Cuts a polygon into the lines and arcs that it has been made of. As of surfaces, points are on them up to the rounding of
// the file: a run of three points is extended as long as they are on its line or circle up to the tolerance, and
// believed in if more points are on it than would be on any, and the next ones are clearly not.
class Arc_finder : Arc_growth
{
public:
  // points without repeated neighbors
  Arc_finder(std::vector<Point> points, bool closed, double tolerance, unsigned min_facets)
    : Arc_growth(std::move(points), closed, tolerance, min_facets)
    , owner_(points_.size(), -1)
  {}

  // from the first corner on; a closed polygon that is one piece begins at 0
  std::vector<Arc_run> operator()()
  {
    if (n_ < 3) return n_ < 2 ? std::vector<Arc_run>() : std::vector<Arc_run>{unknown(0, edges_)};
    find(Kind::line);
    find(Kind::circle);
    choose();
    drop_accidents();
    return pieces();
  }

private:
  void find(Kind kind)
  {
    std::vector<bool> is_known(points_.size(), false);
    for (Index i = closed_ ? 0 : 1; i < edges_; ++i) {
      if (is_known[edge_number(i - 1)] && is_known[edge_number(i)]) continue;
      Arc_run run = unknown(i - 1, i + 1);
      run.kind = kind;
      if (std::abs(turn(i)) > greatest_step() || !settle(run)) continue;
      new_flats_.clear();
      if (!take_flats_out(run) || !is_over_determined(run)) {
        for (const Index e : new_flats_) is_flat_[edge_number(e)] = false;
        i += run.edges() / 8; // its neighbors lead to the same
        continue;
      }
      for (Index e = run.first; e < run.last; ++e) is_known[edge_number(e)] = true;
      found_.push_back(run);
    }
  }

  // Few chords that are much longer than all others are lines: tessellators halve steps, they do not double them.
  bool take_flats_out(Arc_run& run)
  {
    if (run.kind == Kind::line) return true;
    double widest = 0, next = 0;
    for (Index e = run.first; e < run.last; ++e) widest = (std::max)(widest, step(run, e));
    std::vector<Index> flats;
    for (Index e = run.first; e < run.last; ++e)
      if (step(run, e) >= 0.9 * widest)
        flats.push_back(e);
      else
        next = (std::max)(next, step(run, e));
    const Index number = Index(flats.size());
    run.widest = widest;
    if (number == run.edges() || !(number <= 2 || 10 * number <= run.edges()) ||
        !(widest > 1.75 * next))
      return true;
    for (const Index e : flats) is_flat_[edge_number(e)] = true;
    new_flats_.insert(new_flats_.end(), flats.begin(), flats.end());
    return take_rest(run, flats);
  }
  bool take_rest(Arc_run& run, std::vector<Index> flats)
  {
    const bool is_full = run.edges() == n_;
    flats.push_back(is_full ? flats.front() + n_ : run.last);
    Index from = is_full ? flats.front() + 1 : run.first;
    Arc_run best = run;
    best.first = best.last = from;
    for (const Index e : flats) {
      if (e - from > best.edges()) {
        best.first = from;
        best.last = e;
      }
      from = e + 1;
    }
    run = best;
    return run.edges() >= 2 && settle(run) && take_flats_out(run);
  }

  // --- choice ---

  void choose()
  {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Arc_run& a, const Arc_run& b) { return a.edges() > b.edges(); });
    for (Arc_run& run : found_) {
      give_way(run);
      if (run.edges() < 2) continue;
      for (Index e = run.first; e < run.last; ++e) owner_[edge_number(e)] = Index(chosen_.size());
      chosen_.push_back(run);
    }
  }
  // Three points are on a line by accident now and then, five on a circle.
  void drop_accidents()
  {
    const auto goes_on = [&](Index i, Index e) {
      return is_edge(e) && owner_[edge_number(e)] < 0 && std::abs(turn(i)) <= greatest_step();
    };
    for (const Arc_run& run : chosen_) {
      const bool is_short = run.kind == Kind::line
                              ? run.edges() == 2
                              : run.edges() <= 5 && !is_tangent(run, run.first - 1, run.first) &&
                                  !is_tangent(run, run.last, run.last);
      if (!is_short || !goes_on(run.first, run.first - 1) || !goes_on(run.last, run.last)) continue;
      for (Index e = run.first; e < run.last; ++e) owner_[edge_number(e)] = -1;
    }
  }
  // At their ends two runs may share edges, whose points are on both: they meet where the sum of the distances is least.
  void give_way(Arc_run& run)
  {
    while (run.edges() > 0 && owner_[edge_number(run.first)] >= 0) ++run.first;
    while (run.edges() > 0 && owner_[edge_number(run.last - 1)] >= 0) --run.last;
    for (Index e = run.first; e < run.last; ++e)
      if (owner_[edge_number(e)] >= 0) run.last = e;
  }

  // --- the rest ---

  bool is_corner(Index i) const
  {
    if (!closed_ && (i == 0 || i == n_ - 1)) return true;
    return owner_[edge_number(i - 1)] != owner_[edge_number(i)] ||
           (owner_[edge_number(i)] < 0 && std::abs(turn(i)) > greatest_step());
  }

  std::vector<Arc_run> pieces()
  {
    std::vector<Index> corners;
    for (Index i = 0; i < n_; ++i)
      if (is_corner(i)) corners.push_back(i);
    if (corners.empty()) corners.push_back(0);
    if (closed_) corners.push_back(corners.front() + n_);
    std::vector<Arc_run> result;
    const bool has_owner =
      std::any_of(owner_.begin(), owner_.end(), [](Index owner) { return owner >= 0; });
    bool is_known = has_owner;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      result.push_back(piece(corners[k], corners[k + 1]));
      is_known = is_known || result.back().edges() > 1;
    }
    if (!is_known) return lines(0, edges_); // corners everywhere
    if (!has_owner) return {unknown(0, edges_)};
    std::vector<Arc_run> all;
    for (const Arc_run& run : result)
      if ((run.kind == Kind::circle && !is_round(run)) ||
          (run.kind == Kind::unknown && run.edges() <= 2)) {
        const std::vector<Arc_run> more = lines(run.first, run.last);
        all.insert(all.end(), more.begin(), more.end());
      } else
        all.push_back(run);
    return all;
  }
  Arc_run piece(Index first, Index last) const
  {
    const Index owner = owner_[edge_number(first)];
    Arc_run run = owner < 0 ? Arc_run() : chosen_[std::size_t(owner)];
    run.first = first;
    run.last = last;
    return run;
  }
  std::vector<Index> owner_, new_flats_;
  std::vector<Arc_run> found_, chosen_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_ARC_FINDER_H
