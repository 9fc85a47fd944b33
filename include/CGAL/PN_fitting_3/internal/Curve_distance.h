// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_CURVE_DISTANCE_H
#define CGAL_PN_FITTING_3_INTERNAL_CURVE_DISTANCE_H

#include <CGAL/PN_fitting_3/internal/Foot_of_point.h>
#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What Limit_distance is for surfaces, for cubic B-spline curves: about each point a few control points are refined.
template <int dimension>
class Curve_distance
{
public:
  using Value = Point_normal<double, dimension>;
  using Values = std::vector<Value>;

  explicit Curve_distance(bool is_closed)
    : is_closed_(is_closed)
  {}

  Farthest_point operator()(const Values& values, const Vectors<dimension>& points,
                            const std::vector<std::uint32_t>& vertices, double tolerance) const
  {
    constexpr unsigned most_rounds = 16;
    Farthest_point farthest;
    for (const auto v : vertices) {
      Foot_of_point foot;
      foot.vertex = v;
      std::copy_n(points[v].data(), dimension, foot.point.begin());
      Part part = part_about(values, v);
      for (unsigned rounds = 0;; ++rounds) {
        const auto [at, distance] = find(part, foot.point);
        foot.note(distance);
        if (rounds == most_rounds || foot.is_settled(tolerance)) {
          farthest.add(foot);
          break;
        }
        if (foot.distance + foot.error <= farthest.distance) break;
        part = refined(part, at);
      }
    }
    return farthest;
  }

private:
  static constexpr std::ptrdiff_t reach = 3; // on both sides of the center

  struct Part
  {
    Values net;
    std::ptrdiff_t center = 0;
    bool begins = false, ends = false; // at the first or last value of an open curve
  };

  Part part_about(const Values& values, std::size_t v) const
  {
    const auto n = static_cast<std::ptrdiff_t>(values.size()), at = static_cast<std::ptrdiff_t>(v);
    Part part;
    for (auto i = at - reach; i <= at + reach; ++i) {
      if (!is_closed_ && (i < 0 || i >= n)) continue;
      if (i == at) part.center = static_cast<std::ptrdiff_t>(part.net.size());
      part.net.push_back(values[static_cast<std::size_t>((i % n + n) % n)]);
    }
    part.begins = !is_closed_ && at <= reach;
    part.ends = !is_closed_ && at + reach >= n - 1;
    return part;
  }

  // in the two pieces about the center: twice the parameter of the foot, rounded, and the distance
  static std::pair<std::ptrdiff_t, double> find(const Part& part,
                                                const std::array<double, 3>& point)
  {
    const auto n = static_cast<std::ptrdiff_t>(part.net.size());
    const auto entry = [&](std::ptrdiff_t i, const Jet& weight) {
      Jet_entry e;
      const Value& value = part.net[static_cast<std::size_t>(i)];
      e.weight = weight;
      std::copy_n(value.point.begin(), dimension, e.point.begin());
      std::copy_n(value.normal.begin(), dimension, e.normal.begin());
      e.roundness = value.roundness;
      return e;
    };
    std::pair<std::ptrdiff_t, double> best{2 * part.center,
                                           std::numeric_limits<double>::infinity()};
    if (n == 1) best.second = quick_length(difference(entry(0, {}).point, point));
    for (auto i = (std::max)(std::ptrdiff_t(0), part.center - 1); i <= part.center && i + 1 < n;
         ++i) {
      const bool is_inner = i > 0 && i + 2 < n;
      const auto at = [&](double u, double) {
        const Jet x = Jet::of_u(u), y = x * -1 + 1;
        std::vector<Jet_entry> entries;
        if (is_inner) {
          const Jet left = y * y * y * (1. / 6), right = x * x * x * (1. / 6);
          const Jet first = x * x * x * 0.5 - x * x + 2. / 3;
          entries = {entry(i, first), entry(i + 1, (left + first + right) * -1 + 1),
                     entry(i - 1, left), entry(i + 2, right)};
        } else
          entries = {entry(i, y), entry(i + 1, x)};
        return Jet_average(std::move(entries), true);
      };
      const Foot_in_piece f = foot_in_piece(at, false, point, 0.5, 0);
      if (f.distance < best.second)
        best = {2 * i + static_cast<std::ptrdiff_t>(std::lround(2 * f.u)), f.distance};
    }
    return best;
  }

  // `center`: twice the number of the old value, one more for the middle to the next one
  Part refined(const Part& old, std::ptrdiff_t center) const
  {
    const auto n = static_cast<std::ptrdiff_t>(old.net.size());
    const auto average = [&](const Ring_averages::Row& row) {
      return average_(row.data(), row.data() + row.size(), old.net.data());
    };
    Part part;
    const std::ptrdiff_t first = (std::max)(center - reach, std::ptrdiff_t(old.begins ? 0 : 1)),
                         last = (std::min)(center + reach, 2 * n - (old.ends ? 2 : 3));
    for (auto i = first; i <= last; ++i) {
      const auto j = static_cast<std::uint32_t>(i / 2);
      if (i % 2 == 1)
        part.net.push_back(average({{j, 1. / 2}, {j + 1, 1. / 2}}));
      else if (i == 0 || i == 2 * n - 2)
        part.net.push_back(old.net[j]);
      else
        part.net.push_back(average({{j - 1, 1. / 8}, {j + 1, 1. / 8}, {j, 6. / 8}}));
    }
    part.center = center - first;
    part.begins = old.begins && first == 0;
    part.ends = old.ends && last == 2 * n - 2;
    return part;
  }

  bool is_closed_;
  PN_average<double, dimension> average_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_CURVE_DISTANCE_H
