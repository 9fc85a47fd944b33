// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

// --- what is known of the part ---

inline bool Context::have_vertex(const std::vector<Index>& some_patches, Index v) const
{
  return std::all_of(some_patches.begin(), some_patches.end(), [&](Index p) {
    return std::binary_search(patches[p].vertices.begin(), patches[p].vertices.end(), v);
  });
}

inline std::vector<Vec3> Context::points_of(const std::vector<Index>& vertices) const
{
  std::vector<Vec3> result;
  result.reserve(vertices.size());
  for (const Index v : vertices) result.push_back(part.points[v]);
  return result;
}

inline std::vector<Index> Context::vertices_of(const std::vector<Index>& some_patches) const
{
  std::vector<Index> result;
  for (const Index p : some_patches)
    for (const Index v : patches[p].vertices)
      if (!is_listed[v]) {
        is_listed[v] = true;
        result.push_back(v);
      }
  for (const Index v : result) is_listed[v] = false;
  std::sort(result.begin(), result.end());
  return result;
}

inline bool is_tangent_along(const Context& c, const Joint& j, Index outside, const Shape& s,
                             int side, double greatest_angle)
{
  const double cosine = std::cos(greatest_angle);
  for (const Index v : {j.v, j.w})
    if (!(side * dot(s.normal(c.point(v)), c.patches[outside].normal) > cosine)) return false;
  return true;
}

// --- what is measured of a region ---

inline int Turn::end_at(double angle) const
{
  if (is_full) return -1;
  const double margin = 0.2 * (least > 0 ? least : widest);
  if (std::abs(std::remainder(angle - start, 2 * std::acos(-1.))) < margin) return 0;
  if (std::abs(std::remainder(angle - end, 2 * std::acos(-1.))) < margin) return 1;
  return -1;
}

class Make_turn
{
public:
  static constexpr double whole = 6.283185307179586;

  // of a vertex its angle and how precise that is; a facet is a list of such
  void add_facet(const std::vector<std::pair<double, double>>& angles)
  {
    if (angles.empty()) return result_.spans.push_back(0);
    double low = 0, high = 0;
    for (const auto& a : angles) {
      const double d = std::remainder(a.first - angles[0].first, whole);
      low = (std::min)(low, d);
      high = (std::max)(high, d);
      all_.push_back(a);
    }
    result_.spans.push_back(high - low);
    intervals_.emplace_back(angles[0].first + low, high - low);
  }

  Turn operator()()
  {
    if (all_.empty()) return result_;
    for (const double s : result_.spans) {
      result_.widest = (std::max)(result_.widest, s);
      if (s > 1e-9 && (result_.least == 0 || s < result_.least)) result_.least = s;
    }
    std::sort(all_.begin(), all_.end());
    const std::size_t n = all_.size();
    std::size_t last = n - 1; // before the widest gap
    double gap = all_[0].first + whole - all_[n - 1].first;
    for (std::size_t i = 0; i + 1 < n; ++i)
      if (all_[i + 1].first - all_[i].first > gap) {
        gap = all_[i + 1].first - all_[i].first;
        last = i;
      }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = (last + 1 + i) % n;
      const double x = all_[k].first + (k <= last && last + 1 < n ? whole : 0);
      if (result_.positions.empty() || x - result_.positions.back() > all_[k].second)
        result_.positions.push_back(x);
    }
    result_.start = result_.positions.front();
    result_.end = result_.positions.back();
    result_.is_full = is_covered(result_.start - gap / 2);
    return result_;
  }

private:
  bool is_covered(double angle) const
  {
    for (const auto& i : intervals_) {
      const double d = angle - i.first;
      if (d - whole * std::floor(d / whole) < i.second) return true;
    }
    return false;
  }

  Turn result_;
  std::vector<std::pair<double, double>> all_, intervals_;
};

inline void measure_angles(const Context& c, Region& r)
{
  for (const Index p : r.patches) {
    const Patches::Patch& patch = c.patches[p];
    const double width = (patch.vertices.size() == 3 ? 2 : 1) * patch.width;
    r.turn.spans.push_back(width / r.shape.radius);
    r.turn.widest = (std::max)(r.turn.widest, r.turn.spans.back());
    for (const Index f : patch.faces) {
      const Lists::Range corners = c.part.corners[f];
      for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          r.widest_angle =
            (std::max)(r.widest_angle, angle_between(c.point(corners[i]) - r.shape.center,
                                                     c.point(corners[j]) - r.shape.center));
    }
  }
}

inline void measure_turns(const Context& c, Region& r)
{
  const Shape& s = r.shape;
  const bool has_tube = facts_of(s.kind).has_tube;
  const Cross_section across(s.axis);
  const auto margin = [&](double radius) { return 1e-9 + 4 * c.tolerance() / radius; };
  Make_turn turn, meridian;
  std::vector<std::pair<double, double>> about_axis, about_tube;
  for (const Index p : r.patches) {
    about_axis.clear();
    about_tube.clear();
    for (const Index v : c.patches[p].vertices) {
      const Cylindrical q = s.local(c.point(v));
      if (has_tube) about_tube.emplace_back(s.meridian_angle(c.point(v)), margin(s.tube));
      if (q.rho > 1e-3 * r.greatest_rho)
        about_axis.emplace_back(across.angle(q.outward), margin(q.rho));
    }
    turn.add_facet(about_axis);
    if (has_tube) meridian.add_facet(about_tube);
  }
  r.turn = turn();
  r.meridian = meridian();
}

inline void count_inner_vertices(const Context& c, Region& r)
{
  r.inner_vertices = 0;
  for (const Index v : r.vertices) {
    bool is_inner = !c.part.on_border[v];
    for (const Index f : c.part.faces_around[v]) {
      const Index p = c.patches.patch_of_face[f];
      is_inner = is_inner && (p == null || c.is_inside[p]);
    }
    r.inner_vertices += is_inner;
  }
}

inline void find_tangent_ends(const Context& c, Region& r)
{
  r.tangent_ends[0] = r.tangent_ends[1] = r.has_tangent_end = false;
  const Cross_section across(r.shape.axis);
  for (const Index p : r.patches)
    for (const Index number : c.patches[p].joints) {
      const Joint& j = c.patches.joints[number];
      const Index outside = j.other(p);
      if (c.is_inside[outside] || !j.is_smooth || !is_tangent_along(c, j, outside, r.shape, r.side))
        continue;
      r.has_tangent_end = true;
      if (!facts_of(r.shape.kind).turns_about_axis) continue;
      const Vec3 e = r.shape.local(c.point(j.v)).outward + r.shape.local(c.point(j.w)).outward;
      const int end = r.turn.end_at(across.angle(e));
      if (end >= 0) r.tangent_ends[end] = true;
    }
}

inline void measure(const Context& c, Region& r)
{
  std::sort(r.patches.begin(), r.patches.end());
  r.vertices = c.vertices_of(r.patches);
  r.residual = greatest_distance(r.shape, c.points_of(r.vertices));
  r.greatest_rho = 0;
  const Kind_facts facts = facts_of(r.shape.kind);
  if (facts.turns_about_axis)
    for (const Index v : r.vertices)
      r.greatest_rho = (std::max)(r.greatest_rho, r.shape.local(c.point(v)).rho);
  r.turn = r.meridian = Turn();
  r.widest_angle = 0;
  if (facts.turns_about_axis)
    measure_turns(c, r);
  else
    measure_angles(c, r);
  for (const Index p : r.patches) c.is_inside[p] = true;
  count_inner_vertices(c, r);
  find_tangent_ends(c, r);
  for (const Index p : r.patches) c.is_inside[p] = false;
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
