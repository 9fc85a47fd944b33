// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_REGION_BORDERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_REGION_BORDERS_H

#include <CGAL/PN_subdivision_3/internal/recognition/Region.h>
#include <CGAL/PN_subdivision_3/internal/recognition/fit_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// The rounds, and to which of them each patch belongs; what growing leaves undone at their borders.
class Region_borders
{
public:
  Region_borders(const Context& context, std::vector<Region>& regions,
                 const std::vector<std::pair<Index, double>>& prisms)
    : c_(context)
    , regions_(regions)
    , owner_(context.patches.size(), null)
    , prism_step_(context.patches.size(), 0)
  {
    for (Index i = 0; i < regions_.size(); ++i)
      for (const Index p : regions_[i].patches) owner_[p] = i;
    for (const auto& p : prisms) prism_step_[p.first] = owner_[p.first] == null ? p.second : 0;
  }

  void operator()()
  {
    merge();
    for (Index i = 0; i < regions_.size(); ++i) own_midpoints_.push_back(midpoint_distance_of(i));
    absorb();
    set_patches();
  }

  const std::vector<Index>& owners() const { return owner_; }
  // of the prism whose side a patch is; 0: of none
  double prism_step(Index p) const { return prism_step_[p]; }
  bool is_prism(Index p) const { return prism_step_[p] > 0; }

  // of some faces: edges' midpoints from a region's shape
  template <class Faces>
  double midpoint_distance(const Shape& s, const Faces& faces) const
  {
    double result = 0;
    for (const Index f : faces) {
      const Lists::Range v = c_.part.corners[f];
      for (std::size_t i = 0; i < v.size(); ++i) {
        const Vec3 m = 0.5 * (c_.point(v[i]) + c_.point(v[(i + 1) % v.size()]));
        result = (std::max)(result, std::abs(s.distance(m)));
      }
    }
    return result;
  }
  double greatest_midpoint_distance(Index region) const
  {
    return 1.5 * own_midpoints_[region] + c_.tolerance();
  }

  // whether vertices and normal of some face or patch are as a facet's of the region would be
  template <class Vertices>
  bool may_be_facet(Index region, const Vertices& vertices, const Vec3& normal, double width,
                    double t) const
  {
    const Region& r = regions_[region];
    const bool is_doubly_curved = r.shape.kind == Kind::sphere || r.shape.kind == Kind::torus;
    if (is_doubly_curved && vertices.size() > 4) return false;
    const double angle = 0.55 * r.step() + std::atan(6 * c_.tolerance() / width);
    for (const Index v : vertices) {
      if (!(std::abs(r.shape.distance(c_.point(v))) <= t)) return false;
      const Vec3 n = r.shape.normal(c_.point(v));
      if (dot(n, n) > 0 && !(angle_between(r.side * n, normal) <= angle)) return false;
    }
    return true;
  }

private:
  double midpoint_distance_of(Index i) const
  {
    double result = 0;
    for (const Index p : regions_[i].patches)
      result = (std::max)(result, midpoint_distance(regions_[i].shape, c_.patches[p].faces));
    return result;
  }

  bool is_part_of(const Region& smaller, const Region& larger) const
  {
    if (smaller.shape.kind != larger.shape.kind) return false;
    for (const Index v : smaller.vertices) {
      const Vec3& x = c_.point(v);
      if (!(std::abs(larger.shape.distance(x)) <= 2 * c_.tolerance())) return false;
      const Vec3 m = smaller.shape.normal(x), n = larger.shape.normal(x);
      if (dot(m, m) > 0 && dot(n, n) > 0 &&
          angle_between(smaller.side * m, larger.side * n) > radians(8))
        return false;
    }
    return true;
  }

  void merge()
  {
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (const Joint& j : c_.patches.joints) {
        Index a = owner_[j.p], b = owner_[j.q];
        if (a == null || b == null || a == b) continue;
        if (std::make_pair(regions_[a].patches.size(), b) <
            std::make_pair(regions_[b].patches.size(), a))
          std::swap(a, b);
        if (!is_part_of(regions_[b], regions_[a])) continue;
        join(a, b);
        has_changed = true;
      }
    }
  }
  void join(Index a, Index b)
  {
    for (const Index p : regions_[b].patches) owner_[p] = a;
    Region& r = regions_[a];
    r.patches.insert(r.patches.end(), regions_[b].patches.begin(), regions_[b].patches.end());
    regions_[b].patches.clear();
    Measure_region measure(c_);
    measure(r);
    Region next = r;
    if (Shape_fit(c_.points_of(r.vertices), 3)(next.shape)) {
      measure(next);
      r = next;
    }
  }

  void absorb()
  {
    for (int round = 0; round < 20; ++round) {
      std::vector<std::pair<Index, Index>> taken;
      for (Index p = 0; p < c_.patches.size(); ++p) {
        if (owner_[p] != null || is_prism(p)) continue;
        const Index region = absorbing_neighbor(p);
        if (region != null) taken.emplace_back(p, region);
      }
      for (const auto& t : taken) {
        owner_[t.first] = t.second;
        regions_[t.second].patches.push_back(t.first);
      }
      if (taken.empty()) return;
    }
  }
  // the one that it fits best
  Index absorbing_neighbor(Index p) const
  {
    Index best = null;
    double least = 0;
    for (const Index number : c_.patches[p].joints) {
      const Joint& j = c_.patches.joints[number];
      const Index region = owner_[j.other(p)];
      if (region == null || region == best || !j.is_smooth) continue;
      const double angle = misfit(c_.patches[p], regions_[region]);
      if ((best != null && !(angle < least)) || !is_absorbed(p, region)) continue;
      best = region;
      least = angle;
    }
    return best;
  }
  bool is_absorbed(Index p, Index region) const
  {
    const Patches::Patch& patch = c_.patches[p];
    if (is_cut_facet(patch, regions_[region])) return true;
    return may_be_facet(region, patch.vertices, patch.normal, patch.width, 3 * c_.tolerance()) &&
           midpoint_distance(regions_[region].shape, patch.faces) <=
             greatest_midpoint_distance(region);
  }
  // polyhedral Booleans leave vertices on chords
  bool is_cut_facet(const Patches::Patch& patch, const Region& r) const
  {
    const Shape& s = r.shape;
    const double t = 3 * c_.tolerance(), step = r.turn.widest;
    if (s.kind != Kind::cylinder || std::abs(dot(patch.normal, s.axis)) > 2e-3) return false;
    const double h = r.side * dot(patch.normal, patch.mean - s.center);
    if (!(h >= s.radius * std::cos(0.51 * step) - t && h <= s.radius * std::cos(step / 4)))
      return false;
    for (const Index v : patch.vertices)
      if (s.distance(c_.point(v)) > t) return false;
    return true;
  }

  void set_patches()
  {
    for (Region& r : regions_) r.patches.clear();
    for (Index p = 0; p < c_.patches.size(); ++p)
      if (owner_[p] != null) regions_[owner_[p]].patches.push_back(p);
  }
  // with what rounding does to the normal of a small patch
  double misfit(const Patches::Patch& patch, const Region& r) const
  {
    return angle_between(r.side * r.shape.normal(patch.mean), patch.normal) + radians(0.1) +
           std::atan(c_.tolerance() / patch.width);
  }
  const Context& c_;
  std::vector<Region>& regions_;
  std::vector<Index> owner_;
  std::vector<double> prism_step_;
  std::vector<double> own_midpoints_;
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_REGION_BORDERS_H
