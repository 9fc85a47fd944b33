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

class Give_slivers_away
{
public:
  Give_slivers_away(const Context& context, const Lists& edges_of_face, std::vector<Index>& label,
                    std::vector<Segments::Segment>& labels)
    : c_(context)
    , edges_of_face_(edges_of_face)
    , label_(label)
    , labels_(labels)
  {}

  // labels slivers, from the edge of what has labels on, by the longest common border among the best
  void operator()()
  {
    std::vector<Index> slivers;
    for (Index f = 0; f < label_.size(); ++f)
      if (label_[f] == null) slivers.push_back(f);
    for (int quality = 0; quality < 3 && !slivers.empty();) {
      std::vector<std::pair<Index, Index>> given;
      std::vector<Index> rest;
      for (const Index f : slivers) {
        const Index label = label_for_sliver(f, quality);
        if (label == null)
          rest.push_back(f);
        else
          given.emplace_back(f, label);
      }
      for (const auto& g : given) label_[g.first] = g.second;
      quality = given.empty() ? quality + 1 : 0;
      slivers = rest;
    }
    if (slivers.empty()) return;
    labels_.emplace_back(); // components of nothing but slivers
    const Index label = Index(labels_.size()) - 1;
    for (const Index f : slivers) label_[f] = label;
  }

private:
  Index label_for_sliver(Index f, int quality) const
  {
    std::vector<std::pair<Index, double>> borders;
    for (const Index e : edges_of_face_[f]) {
      const Part::Edge& edge = c_.part.edges[e];
      const Index label = label_[c_.part.across(f, e)];
      if (label == null || !is_good_for(f, labels_[label].shape, quality)) continue;
      auto it = borders.begin();
      while (it != borders.end() && it->first != label) ++it;
      if (it == borders.end()) it = borders.emplace(it, label, 0.);
      it->second += c_.part.length(edge);
    }
    const auto best =
      std::max_element(borders.begin(), borders.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return best == borders.end() ? null : best->first;
  }
  bool is_good_for(Index f, const Shape& s, int quality) const
  {
    if (quality == 2) return true;
    if (quality == 1 || s.kind == Kind::unknown) return quality == 1 && s.kind == Kind::unknown;
    for (const Index v : c_.part.corners[f])
      if (!(std::abs(s.distance(c_.point(v))) <= 8 * c_.tolerance())) return false;
    return true;
  }

  const Context& c_;
  const Lists& edges_of_face_;
  std::vector<Index>& label_;
  std::vector<Segments::Segment>& labels_;
};

inline void give_slivers_away(const Context& c, const Lists& edges_of_face,
                              std::vector<Index>& label, std::vector<Segments::Segment>& labels)
{
  Give_slivers_away(c, edges_of_face, label, labels)();
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
