// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_FOUND_REGIONS_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_FOUND_REGIONS_H

#include <CGAL/PN_recognition_3/internal/Evidence.h>
#include <CGAL/PN_recognition_3/internal/Region.h>
#include <CGAL/PN_recognition_3/internal/Shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// Tries guesses and keeps those that have evidence.
class Found_regions
{
public:
  using Seeds = std::vector<Index>;

  explicit Found_regions(const Context& context)
    : c_(context)
    , grower_(context)
    , measure_(context)
    , evidence_(context, grower_, measure_)
  {
    for (auto& of_kind : known_) of_kind.resize(context.patches.size());
    has_region_.assign(context.patches.size(), false);
    is_settled_.assign(context.patches.size(), false);
  }

  const std::vector<Region>& regions() const { return regions_; }
  bool has_region(Index p) const { return has_region_[p]; }
  Evidence& evidence() { return evidence_; }

  // in a sphere or torus that is beyond doubt
  bool is_settled(Index p) const { return is_settled_[p]; }

  // whether the facets are together in a region of this kind already
  bool is_known(Kind kind, const Seeds& seeds) const
  {
    if (std::all_of(seeds.begin(), seeds.end(), [&](Index p) { return is_settled_[p]; }))
      return true;
    const auto& of_kind = known_[int(kind)];
    const auto has_all = [&](Index number) {
      return std::all_of(seeds.begin(), seeds.end(), [&](Index p) {
        return std::find(of_kind[p].begin(), of_kind[p].end(), number) != of_kind[p].end();
      });
    };
    return std::any_of(of_kind[seeds[0]].begin(), of_kind[seeds[0]].end(), has_all);
  }

  enum class Guess { exact, may_be_fitted };
  bool try_shape(Shape s, const Seeds& seeds, Guess guess = Guess::exact)
  {
    if (is_known(s.kind, seeds)) return false;
    const double t = first_tolerance(seeds);
    if (!are_on(s, seeds, t) &&
        !(guess == Guess::may_be_fitted && fit_to(seeds, s) && are_on(s, seeds, t)))
      return false;
    return goes_on(s, seeds, t) && try_region(s, seeds, t);
  }
  // of facets that may be all there are
  bool try_whole(Shape s, const Seeds& seeds)
  {
    if (is_known(s.kind, seeds)) return false;
    const double t = first_tolerance(seeds);
    return (are_on(s, seeds, t) || (fit_to(seeds, s) && are_on(s, seeds, t))) &&
           try_region(s, seeds, t);
  }

private:
  bool try_region(const Shape& s, const Seeds& seeds, double t)
  {
    Region r;
    r.shape = s;
    if (!grower_.settle(r, seeds, t)) return false;
    const bool holds = evidence_(r);
    if (holds || r.patches.size() >= 12) remember(r, holds);
    return holds;
  }

  double first_tolerance(const Seeds& seeds) const
  {
    const double t = c_.tolerance();
    return (std::max)(2 * t, (std::min)(50 * t, 0.02 * least_width(seeds)));
  }
  double least_width(const Seeds& seeds) const
  {
    double width = c_.part.size;
    for (const Index p : seeds) width = (std::min)(width, c_.patches[p].width);
    return width;
  }

  bool are_on(const Shape& s, const Seeds& seeds, double t) const
  {
    const int side = grower_.side_of(s, seeds[0]);
    for (const Index p : seeds)
      if (!grower_.is_on(s, p, t, side)) return false;
    return true;
  }

  // a facet beside these is on the shape or tangent to it
  bool goes_on(const Shape& s, const Seeds& seeds, double t) const
  {
    const int side = grower_.side_of(s, seeds[0]);
    for (const Index p : seeds)
      for (const Index number : c_.patches[p].joints) {
        const Joint& j = c_.patches.joints[number];
        const Index q = j.other(p);
        if (!j.is_smooth || std::find(seeds.begin(), seeds.end(), q) != seeds.end()) continue;
        if (grower_.is_on(s, q, t, side) || is_tangent_along(c_, j, q, s, side, radians(2)))
          return true;
      }
    return false;
  }

  bool fit_to(const Seeds& seeds, Shape& s) const
  {
    const std::vector<Vec3> points = c_.points_of(c_.vertices_of(seeds));
    if (!(Shape_fit::residual(s, points) < 0.3 * least_width(seeds))) return false;
    return Shape_fit(points, 12)(s, 100 * c_.tolerance());
  }

  void remember(const Region& r, bool holds)
  {
    const bool is_doubt_excluded =
      (r.shape.kind == Kind::sphere || r.shape.kind == Kind::torus) && r.inner_vertices >= 30;
    for (const Index p : r.patches) {
      known_[int(r.shape.kind)][p].push_back(number_);
      if (holds) has_region_[p] = true;
      if (holds && is_doubt_excluded) is_settled_[p] = true;
    }
    ++number_;
    if (holds) regions_.push_back(r);
  }

  const Context& c_;
  Grower grower_;
  Measure_region measure_;
  Evidence evidence_;
  std::vector<Region> regions_;
  std::vector<std::vector<Index>> known_[6]; // of a kind and patch: numbers of what has been tried
  std::vector<bool> has_region_, is_settled_;
  Index number_ = 0;
};

inline int rank_of(Kind kind)
{
  return kind == Kind::cylinder ? 0 : kind == Kind::sphere ? 1 : kind == Kind::cone ? 2 : 3;
}

// Of regions that overlap those of most facets, so that a sphere wins over its rows, which are exact cones.
inline std::vector<Region> choose_regions(const Context& c, Found_regions& found)
{
  std::vector<Region> all = found.regions();
  std::stable_sort(all.begin(), all.end(), [&](const Region& a, const Region& b) {
    if (a.patches.size() != b.patches.size()) return a.patches.size() > b.patches.size();
    if (a.number_of_tangent_ends() != b.number_of_tangent_ends())
      return a.number_of_tangent_ends() > b.number_of_tangent_ends();
    if (a.shape.kind != b.shape.kind) return rank_of(a.shape.kind) < rank_of(b.shape.kind);
    return a.patches < b.patches; // patches are numbered in the order of their vertices
  });
  std::vector<bool> is_taken(c.patches.size(), false);
  std::vector<Region> result;
  for (Region& r : all) {
    std::vector<Index> rest;
    for (const Index p : r.patches)
      if (!is_taken[p]) rest.push_back(p);
    if (rest.size() < r.patches.size()) {
      if (5 * rest.size() < 3 * r.patches.size()) continue;
      r.patches = rest;
      if (!found.evidence().still_holds(r)) continue;
    }
    for (const Index p : r.patches) is_taken[p] = true;
    result.push_back(std::move(r));
  }
  return result;
}

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_FOUND_REGIONS_H
