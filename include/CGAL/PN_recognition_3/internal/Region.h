// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_REGION_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_REGION_H

#include <CGAL/PN_recognition_3/internal/Part.h>
#include <CGAL/PN_recognition_3/internal/Patches.h>
#include <CGAL/PN_recognition_3/internal/Shape.h>
#include <CGAL/PN_recognition_3/internal/linear_algebra.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// How the facets of a region lie about an angle: that about its axis, or about the tube of a torus.
struct Turn
{
  std::vector<double> positions; // distinct angles of vertices, from where the region begins on
  std::vector<double> spans;     // of the facets; on a sphere their widths
  bool is_full = false;
  double widest = 0, least = 0; // of the spans
  double start = 0, end = 0;

  // the first or last position: 0, 1; -1: neither
  int end_at(double angle) const
  {
    if (is_full) return -1;
    const double margin = 0.2 * (least > 0 ? least : widest);
    if (std::abs(std::remainder(angle - start, 2 * std::acos(-1.))) < margin) return 0;
    if (std::abs(std::remainder(angle - end, 2 * std::acos(-1.))) < margin) return 1;
    return -1;
  }
};

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

// Facets of one shape, and what there is to tell about them.
struct Region
{
  Shape shape;
  std::vector<Index> patches; // sorted
  std::vector<Index> vertices;
  int side = 1; // of the faces' normals beside the shape's
  double residual = 0;
  double greatest_rho = 0;
  Turn turn, meridian;     // meridian: of a torus
  double widest_angle = 0; // of a sphere: between corners of a face
  std::size_t inner_vertices = 0;
  bool tangent_ends[2] = {false, false}; // of the turn
  bool has_tangent_end = false;          // any

  int number_of_tangent_ends() const { return int(tangent_ends[0]) + int(tangent_ends[1]); }
  // the widest step, n = 2 pi / step
  double step() const
  {
    return shape.kind == Kind::sphere ? widest_angle : (std::max)(turn.widest, meridian.widest);
  }
};

// What many functions need to know about the part.
struct Context
{
  const Part& part;
  const Patches& patches;
  double greatest_smooth_angle;
  unsigned min_facets;
  mutable std::vector<bool> is_listed; // vertices, none but in vertices_of()

  double tolerance() const { return part.tolerance; }
  const Vec3& point(Index v) const { return part.points[v]; }
  Vec3 direction(const Joint& j) const { return part.points[j.w] - part.points[j.v]; }
  // whether all of some patches have a vertex
  bool have_vertex(const std::vector<Index>& some_patches, Index v) const
  {
    return std::all_of(some_patches.begin(), some_patches.end(), [&](Index p) {
      return std::binary_search(patches[p].vertices.begin(), patches[p].vertices.end(), v);
    });
  }
  std::vector<Vec3> points_of(const std::vector<Index>& vertices) const
  {
    std::vector<Vec3> result;
    result.reserve(vertices.size());
    for (const Index v : vertices) result.push_back(part.points[v]);
    return result;
  }
  std::vector<Index> vertices_of(const std::vector<Index>& some_patches) const
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
};

// whether a patch outside is tangent to a shape along a joint
inline bool is_tangent_along(const Context& c, const Joint& j, Index outside, const Shape& s,
                             int side, double greatest_angle = radians(0.5))
{
  const double cosine = std::cos(greatest_angle);
  for (const Index v : {j.v, j.w})
    if (!(side * dot(s.normal(c.point(v)), c.patches[outside].normal) > cosine)) return false;
  return true;
}

// Fills in what follows from the shape and the patches.
class Measure_region
{
public:
  explicit Measure_region(const Context& context)
    : c_(context)
    , is_inside_(context.patches.size(), false)
  {}

  void operator()(Region& r)
  {
    std::sort(r.patches.begin(), r.patches.end());
    r.vertices = c_.vertices_of(r.patches);
    r.residual = Shape_fit::residual(r.shape, c_.points_of(r.vertices));
    r.greatest_rho = 0;
    if (r.shape.has_axis())
      for (const Index v : r.vertices)
        r.greatest_rho = (std::max)(r.greatest_rho, r.shape.local(c_.point(v)).rho);
    r.turn = r.meridian = Turn();
    r.widest_angle = 0;
    if (r.shape.kind == Kind::sphere)
      measure_angles(r);
    else
      measure_turns(r);
    for (const Index p : r.patches) is_inside_[p] = true;
    count_inner_vertices(r);
    find_tangent_ends(r);
    for (const Index p : r.patches) is_inside_[p] = false;
  }

private:
  void measure_angles(Region& r) const
  {
    for (const Index p : r.patches) {
      const Patches::Patch& patch = c_.patches[p];
      const double width = (patch.vertices.size() == 3 ? 2 : 1) * patch.width;
      r.turn.spans.push_back(width / r.shape.radius);
      r.turn.widest = (std::max)(r.turn.widest, r.turn.spans.back());
      for (const Index f : patch.faces) {
        const Lists::Range corners = c_.part.corners[f];
        for (std::size_t i = 0; i < corners.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            r.widest_angle =
              (std::max)(r.widest_angle, angle_between(c_.point(corners[i]) - r.shape.center,
                                                       c_.point(corners[j]) - r.shape.center));
      }
    }
  }

  void measure_turns(Region& r) const
  {
    const Shape& s = r.shape;
    const Cross_section across(s.axis);
    Make_turn turn, meridian;
    std::vector<std::pair<double, double>> about_axis, about_tube;
    for (const Index p : r.patches) {
      about_axis.clear();
      about_tube.clear();
      for (const Index v : c_.patches[p].vertices) {
        const Cylindrical q = s.local(c_.point(v));
        if (s.kind == Kind::torus)
          about_tube.emplace_back(s.meridian_angle(c_.point(v)), margin(s.tube));
        if (q.rho > 1e-3 * r.greatest_rho)
          about_axis.emplace_back(across.angle(q.outward), margin(q.rho));
      }
      turn.add_facet(about_axis);
      if (s.kind == Kind::torus) meridian.add_facet(about_tube);
    }
    r.turn = turn();
    r.meridian = meridian();
  }
  double margin(double radius) const { return 1e-9 + 4 * c_.tolerance() / radius; }

  void count_inner_vertices(Region& r) const
  {
    r.inner_vertices = 0;
    for (const Index v : r.vertices) {
      bool is_inner = !c_.part.on_border[v];
      for (const Index f : c_.part.faces_around[v]) {
        const Index p = c_.patches.patch_of_face[f];
        is_inner = is_inner && (p == null || is_inside_[p]);
      }
      r.inner_vertices += is_inner;
    }
  }

  void find_tangent_ends(Region& r) const
  {
    r.tangent_ends[0] = r.tangent_ends[1] = r.has_tangent_end = false;
    const Cross_section across(r.shape.axis);
    for (const Index p : r.patches)
      for (const Index number : c_.patches[p].joints) {
        const Joint& j = c_.patches.joints[number];
        const Index outside = j.other(p);
        if (is_inside_[outside] || !j.is_smooth ||
            !is_tangent_along(c_, j, outside, r.shape, r.side))
          continue;
        r.has_tangent_end = true;
        if (r.shape.kind == Kind::sphere) continue;
        const Vec3 e = r.shape.local(c_.point(j.v)).outward + r.shape.local(c_.point(j.w)).outward;
        const int end = r.turn.end_at(across.angle(e));
        if (end >= 0) r.tangent_ends[end] = true;
      }
  }

  const Context& c_;
  std::vector<bool> is_inside_;
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_REGION_H
