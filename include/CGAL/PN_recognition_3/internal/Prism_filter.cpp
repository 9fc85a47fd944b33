// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

// Which of the regions are meant to be round, and which are prisms and pyramids, whose facets are planes; and those that
// are cut out of something unknown, which are none.
class Prism_filter
{
public:
  Prism_filter(const Context& context, std::vector<Region>& regions)
    : c_(context)
    , regions_(regions)
  {}

  std::vector<double> operator()()
  {
    drop_cuts();
    const std::size_t n = regions_.size();
    is_sure_.resize(n);
    is_contradicted_.resize(n);
    for (std::size_t i = 0; i < n; ++i) is_sure_[i] = is_sure_by_itself(regions_[i]);
    for (std::size_t i = 0; i < n; ++i) is_contradicted_[i] = !is_sure_[i] && has_contradiction(i);
    for (std::size_t i = 0; i < n; ++i)
      if (!is_contradicted_[i] && is_tangent_enough(regions_[i])) is_sure_[i] = true;
    spread();
    std::vector<double> step_of_prism(c_.patches.size(), 0);
    std::vector<Region> rounds;
    for (std::size_t i = 0; i < n; ++i) {
      Region& r = regions_[i];
      if (is_sure_[i] || is_round_by_default(i))
        rounds.push_back(std::move(r));
      else
        for (const Index p : r.patches) step_of_prism[p] = r.step();
    }
    regions_ = std::move(rounds);
    return step_of_prism;
  }

private:
  void set_owners()
  {
    owner_.assign(c_.patches.size(), null);
    for (std::size_t i = 0; i < regions_.size(); ++i)
      for (const Index p : regions_[i].patches) owner_[p] = Index(i);
  }

  void drop_cuts()
  {
    for (bool has_changed = true; has_changed;) {
      set_owners();
      std::vector<Region> rest;
      for (std::size_t i = 0; i < regions_.size(); ++i)
        if (!is_cut_of_unknown(Index(i))) rest.push_back(std::move(regions_[i]));
      has_changed = rest.size() < regions_.size();
      regions_ = std::move(rest);
    }
  }

  bool is_cut_of_unknown(Index i) const
  {
    const Region& r = regions_[i];
    // narrower ones, between facets that look like cut ones, are in any free form
    const bool has_third_of_turn = r.turn.end - r.turn.start > radians(119);
    double loose = 0, all = 0;
    for (const Index p : r.patches)
      for (const Index number : c_.patches[p].joints) {
        const Joint& j = c_.patches.joints[number];
        const Index q = j.other(p);
        if (owner_[q] == i) continue;
        all += j.length;
        if (owner_[q] == null && j.angle <= radians(30) &&
            !is_tangent_along(c_, j, q, r.shape, r.side) && goes_on(q) && !is_continued_by(r, q) &&
            !(has_third_of_turn && is_cut_facet(c_, c_.patches[q], r)))
          loose += j.length;
      }
    const double share = all > 0 ? loose / all : 0;
    if (r.inner_vertices >= 12) return share > 0.9;
    return share > 0.25 && r.turn.positions.size() <= 12 && !r.turn.is_full;
  }
  // whether a face of a small patch is on the shape, the others perhaps on the next one
  bool is_continued_by(const Region& r, Index q) const
  {
    const double t = 2 * c_.tolerance();
    if (c_.patches[q].faces.size() > 8) return false;
    for (const Index f : c_.patches[q].faces) {
      bool is_on = true;
      for (const Index v : c_.part.corners[f]) {
        const Vec3 n = r.side * r.shape.normal(c_.point(v));
        is_on = is_on && std::abs(r.shape.distance(c_.point(v))) <= t &&
                dot(n, c_.part.normal[f]) >=
                  std::cos(0.55 * r.step() + std::atan(6 * c_.tolerance() / c_.part.altitude[f]));
      }
      if (is_on) return true;
    }
    return false;
  }
  // to what is not so much larger that it is a plane
  bool goes_on(Index q) const
  {
    for (const Index number : c_.patches[q].joints) {
      const Joint& j = c_.patches.joints[number];
      const Index next = j.other(q);
      if (j.angle <= radians(30) && owner_[next] == null &&
          c_.patches[next].area < 20 * c_.patches[q].area)
        return true;
    }
    return false;
  }

  static double per_turn(double step)
  {
    // a hair more, since steps are rounded
    return step > 0 ? (1 + 1e-4) * 2 * std::acos(-1.) / step : 0;
  }

  bool is_sure_by_itself(const Region& r) const
  {
    if (r.shape.kind == Kind::sphere && r.patches.size() >= 24) return true;
    const double n = per_turn(r.step());
    if (n >= 12) return true;
    return facts_of(r.shape.kind).has_tube && n >= c_.min_facets && r.inner_vertices >= 4 &&
           r.meridian.positions.size() >= 4;
  }

  // A tessellator with a tolerance of chords or angles does not make the larger of two rounds the coarser one.
  bool has_contradiction(std::size_t i) const
  {
    const double radius = largest_radius(regions_[i]), step = regions_[i].step();
    for (std::size_t k = 0; k < regions_.size(); ++k) {
      const Region& r = regions_[k];
      if (k != i && is_sure_[k] && facts_of(r.shape.kind).turns_about_axis &&
          per_turn(r.step()) >= 12 && r.greatest_rho <= 1.05 * radius &&
          r.turn.widest < 2 * step / 3)
        return true;
    }
    return false;
  }
  static double largest_radius(const Region& r)
  {
    return facts_of(r.shape.kind).turns_about_axis ? r.greatest_rho : r.shape.radius;
  }

  static bool is_tangent_enough(const Region& r)
  {
    return r.number_of_tangent_ends() == 2 && r.step() <= radians(61);
  }

  // to what is coaxial with something sure, or tangent to it
  void spread()
  {
    set_owners();
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (std::size_t i = 0; i < regions_.size(); ++i) {
        if (is_sure_[i] || is_contradicted_[i]) continue;
        if (!is_coaxial_with_sure(i) && !is_tangent_to_sure(i)) continue;
        is_sure_[i] = true;
        has_changed = true;
      }
    }
  }
  bool is_coaxial_with_sure(std::size_t i) const
  {
    const Region& r = regions_[i];
    for (std::size_t k = 0; k < regions_.size(); ++k)
      if (k != i && is_sure_[k] && is_coaxial(r, regions_[k]) &&
          regions_[k].turn.widest >= 0.9 * r.turn.widest)
        return true;
    return false;
  }
  bool is_coaxial(const Region& a, const Region& b) const
  {
    if (!facts_of(a.shape.kind).turns_about_axis || !facts_of(b.shape.kind).turns_about_axis)
      return false;
    const double margin = 1e-6 + 20 * c_.tolerance() / (std::min)(a.greatest_rho, b.greatest_rho);
    return norm(cross(a.shape.axis, b.shape.axis)) <= margin &&
           norm(cross(b.shape.center - a.shape.center, a.shape.axis)) <= 1e-4 * c_.part.size;
  }
  bool is_tangent_to_sure(std::size_t i) const
  {
    const Region& r = regions_[i];
    for (const Index p : r.patches)
      for (const Index number : c_.patches[p].joints) {
        const Joint& j = c_.patches.joints[number];
        const Index k = owner_[j.other(p)];
        if (k == null || k == i || !is_sure_[k]) continue;
        const Region& s = regions_[k];
        const auto is_tangent_at = [&](Index v) {
          const Vec3 n = r.shape.normal(c_.point(v)), m = s.shape.normal(c_.point(v));
          return r.side * s.side * dot(n, m) > std::cos(radians(0.5));
        };
        if (j.is_smooth && is_tangent_at(j.v) && is_tangent_at(j.w)) return true;
      }
    return false;
  }

  bool is_round_by_default(std::size_t i) const
  {
    const Region& r = regions_[i];
    if (is_contradicted_[i] || per_turn(r.step()) < c_.min_facets) return false;
    return r.turn.is_full || r.turn.positions.size() >= 5 ||
           !facts_of(r.shape.kind).turns_about_axis;
  }

  const Context& c_;
  std::vector<Region>& regions_;
  std::vector<bool> is_sure_, is_contradicted_;
  std::vector<Index> owner_;
};

inline std::vector<double> take_prisms_out(const Context& c, std::vector<Region>& regions)
{
  return Prism_filter(c, regions)();
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
