// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_TURN_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_TURN_H

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
  std::vector<double> spans;     // of the facets
  bool is_full = false;
  double widest = 0, least = 0; // of the spans
  double start = 0, end = 0;

  double facets_per_turn() const { return widest > 0 ? 2 * std::acos(-1.) / widest : 0; }
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

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_TURN_H
