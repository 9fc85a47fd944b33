// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

inline double midpoint_distance(const Context& c, const Shape& s, Lists::Range faces)
{
  double result = 0;
  for (const Index f : faces) {
    const Lists::Range v = c.part.corners[f];
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Vec3 m = 0.5 * (c.point(v[i]) + c.point(v[(i + 1) % v.size()]));
      result = (std::max)(result, std::abs(s.distance(m)));
    }
  }
  return result;
}

inline bool may_be_facet(const Context& c, const Region& r, Lists::Range vertices,
                         const Vec3& normal, double width, double t)
{
  if (facts_of(r.shape.kind).is_doubly_curved && vertices.size() > 4) return false;
  const double angle = 0.55 * r.step() + std::atan(6 * c.tolerance() / width);
  for (const Index v : vertices) {
    if (!(std::abs(r.shape.distance(c.point(v))) <= t)) return false;
    const Vec3 n = r.shape.normal(c.point(v));
    if (dot(n, n) > 0 && !(angle_between(r.side * n, normal) <= angle)) return false;
  }
  return true;
}

// The radius of the shape about the same center, axis or apex that a plane touches; -1: there is none.
inline double radius_of_touched(const Shape& s, const Vec3& normal, const Vec3& point)
{
  constexpr double most = 2e-3;
  const double along = dot(normal, s.axis);
  if (s.kind == Kind::cone) {
    const Vec3 d = point - s.apex();
    return std::abs(dot(normal, d)) <= most * norm(d)
             ? -along / std::sqrt(1 - along * along) * s.radius * s.cosine / s.sine
             : -1;
  }
  return s.kind == Kind::sphere || (s.kind == Kind::cylinder && std::abs(along) <= most)
           ? dot(normal, point - s.center)
           : -1;
}

inline bool is_cut_facet(const Context& c, const Patches::Patch& patch, const Region& r)
{
  const Shape& s = r.shape;
  const double t = 3 * c.tolerance(), step = r.step(),
               radius = radius_of_touched(s, r.side * patch.normal, patch.mean);
  return radius >= s.radius * std::cos(0.51 * step) - t &&
         radius <= s.radius * std::cos(step / (s.kind == Kind::sphere ? 6 : 4)) &&
         std::all_of(patch.vertices.begin(), patch.vertices.end(),
                     [&](Index v) { return s.distance(c.point(v)) <= t; });
}

// what growing leaves undone
class Region_borders
{
public:
  Region_borders(const Context& context, std::vector<Region>& regions,
                 const std::vector<double>& prism_step)
    : c_(context)
    , regions_(regions)
    , prism_step_(prism_step)
    , owner_(context.patches.size(), null)
  {}

  std::vector<Index> operator()()
  {
    join_cut_rows();
    for (Index i = 0; i < regions_.size(); ++i)
      for (const Index p : regions_[i].patches) owner_[p] = i;
    for (Region& r : regions_) r.greatest_midpoint_distance = greatest_midpoint_distance(r);
    absorb();
    set_patches();
    return owner_;
  }

private:
  // a row of the facets of a sphere, which has been cut, is a cone by itself
  void join_cut_rows()
  {
    const auto is_row_of = [&](const Region& cone, const Region& sphere) {
      return sphere.shape.kind == Kind::sphere &&
             std::all_of(cone.patches.begin(), cone.patches.end(),
                         [&](Index p) { return is_cut_facet(c_, c_.patches[p], sphere); });
    };
    for (std::size_t i = regions_.size(); i-- > 0;) {
      if (regions_[i].shape.kind != Kind::cone) continue;
      for (Region& sphere : regions_)
        if (is_row_of(regions_[i], sphere)) {
          sphere.patches.insert(sphere.patches.end(), regions_[i].patches.begin(),
                                regions_[i].patches.end());
          regions_.erase(regions_.begin() + std::ptrdiff_t(i));
          break;
        }
    }
  }

  double greatest_midpoint_distance(const Region& r) const
  {
    double own = 0;
    for (const Index p : r.patches)
      own = (std::max)(own, midpoint_distance(c_, r.shape, c_.patches[p].faces));
    return 1.5 * own + c_.tolerance();
  }

  void absorb()
  {
    for (int round = 0; round < 20; ++round) {
      std::vector<std::pair<Index, Index>> taken;
      for (Index p = 0; p < c_.patches.size(); ++p) {
        if (owner_[p] != null || prism_step_[p] > 0) continue;
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
  Index absorbing_neighbor(Index p) const
  {
    for (const Index number : c_.patches[p].joints) {
      const Joint& j = c_.patches.joints[number];
      const Index region = owner_[j.other(p)];
      if (region != null && j.is_smooth && is_absorbed(c_.patches[p], regions_[region]))
        return region;
    }
    return null;
  }
  bool is_absorbed(const Patches::Patch& patch, const Region& r) const
  {
    return is_cut_facet(c_, patch, r) ||
           (may_be_facet(c_, r, patch.vertices, patch.normal, patch.width, 3 * c_.tolerance()) &&
            midpoint_distance(c_, r.shape, patch.faces) <= r.greatest_midpoint_distance);
  }
  void set_patches()
  {
    for (Region& r : regions_) r.patches.clear();
    for (Index p = 0; p < c_.patches.size(); ++p)
      if (owner_[p] != null) regions_[owner_[p]].patches.push_back(p);
  }

  const Context& c_;
  std::vector<Region>& regions_;
  const std::vector<double>& prism_step_;
  std::vector<Index> owner_;
};

inline std::vector<Index> close_borders(const Context& c, std::vector<Region>& regions,
                                        const std::vector<double>& prism_step)
{
  return Region_borders(c, regions, prism_step)();
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
