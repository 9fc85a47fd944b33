// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_POLYGON_TRIANGLES_H
#define PN_TEST_POLYGON_TRIANGLES_H

// Triangles of a plane polygon with holes: bridges, then ears, as long and thin as they come.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace synthetic_parts {

struct Rim_corner
{
  std::size_t vertex;
  double x, y;
};
using Rim = std::vector<Rim_corner>;

inline double area_of(const Rim_corner& a, const Rim_corner& b, const Rim_corner& c)
{
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

inline double area_of(const Rim& rim)
{
  double area = 0;
  for (std::size_t i = 2; i < rim.size(); ++i) area += area_of(rim[0], rim[i - 1], rim[i]);
  return area;
}

class Polygon_triangles
{
public:
  using Triangle = std::array<std::size_t, 3>;

  // `rims`: one counterclockwise, the others clockwise; ears are looked for from corner `start` on
  Polygon_triangles(std::vector<Rim> rims, std::size_t start)
  {
    const auto outer =
      std::find_if(rims.begin(), rims.end(), [](const Rim& r) { return area_of(r) > 0; });
    if (outer == rims.end()) throw std::logic_error("polygon without an outer rim");
    std::iter_swap(rims.begin(), outer);
    double area = 0;
    for (const Rim& r : rims) area += area_of(r);
    smallest_ = 1e-10 * area;
    polygon_ = rims[0];
    std::vector<Rim> holes(rims.begin() + 1, rims.end());
    while (!holes.empty()) join(holes);
    cut_ears(start);
  }

  const std::vector<Triangle>& triangles() const { return triangles_; }

private:
  static bool are_same(const Rim_corner& a, const Rim_corner& b) { return a.vertex == b.vertex; }

  bool crosses(const Rim_corner& p, const Rim_corner& q, const Rim& rim) const
  {
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Rim_corner &a = rim[i], &b = rim[(i + 1) % rim.size()];
      if (!are_same(a, p) && !are_same(a, q) && std::abs(area_of(p, q, a)) < smallest_ &&
          is_between(p, q, a))
        return true;
      if (are_same(a, p) || are_same(a, q) || are_same(b, p) || are_same(b, q)) continue;
      if (area_of(p, q, a) * area_of(p, q, b) < 0 && area_of(a, b, p) * area_of(a, b, q) < 0)
        return true;
    }
    return false;
  }
  static bool is_between(const Rim_corner& p, const Rim_corner& q, const Rim_corner& a)
  {
    return (a.x - p.x) * (a.x - q.x) + (a.y - p.y) * (a.y - q.y) <= 0;
  }

  // Does the bridge to q leave corner i into the polygon?
  bool is_inside(std::size_t i, const Rim_corner& q) const
  {
    const std::size_t n = polygon_.size();
    const Rim_corner &a = polygon_[(i + n - 1) % n], &b = polygon_[i], &c = polygon_[(i + 1) % n];
    const bool left_of_first = area_of(a, b, q) > 0, left_of_second = area_of(b, c, q) > 0;
    return area_of(a, b, c) > 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
  }

  void join(std::vector<Rim>& holes)
  {
    double least = -1;
    std::size_t hole = 0, at = 0, from = 0;
    for (std::size_t h = 0; h < holes.size(); ++h)
      for (std::size_t j = 0; j < holes[h].size(); ++j)
        for (std::size_t i = 0; i < polygon_.size(); ++i) {
          const Rim_corner &p = polygon_[i], &q = holes[h][j];
          const double d = std::hypot(p.x - q.x, p.y - q.y);
          if ((least >= 0 && d >= least) || !is_inside(i, q) || crosses(p, q, polygon_) ||
              std::any_of(holes.begin(), holes.end(),
                          [&](const Rim& r) { return crosses(p, q, r); }))
            continue;
          least = d, hole = h, at = j, from = i;
        }
    if (least < 0) throw std::logic_error("no bridge to a hole");
    Rim rim = holes[hole];
    std::rotate(rim.begin(), rim.begin() + static_cast<std::ptrdiff_t>(at), rim.end());
    rim.push_back(rim[0]);
    rim.push_back(polygon_[from]);
    polygon_.insert(polygon_.begin() + static_cast<std::ptrdiff_t>(from) + 1, rim.begin(),
                    rim.end());
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(hole));
  }

  bool is_ear(std::size_t i, double smallest) const
  {
    const std::size_t n = polygon_.size();
    const Rim_corner &a = polygon_[(i + n - 1) % n], &b = polygon_[i], &c = polygon_[(i + 1) % n];
    if (!(area_of(a, b, c) > smallest)) return false;
    for (const Rim_corner& p : polygon_) {
      if (are_same(p, a) || are_same(p, b) || are_same(p, c)) continue;
      const double e = -smallest_;
      if (area_of(a, b, p) > e && area_of(b, c, p) > e && area_of(c, a, p) > e) return false;
    }
    return true;
  }

  void cut_ears(std::size_t start)
  {
    std::size_t i = start;
    while (polygon_.size() > 3) {
      const std::size_t n = polygon_.size();
      std::size_t k = 0;
      while (k < n && !is_ear((i + k) % n, smallest_)) ++k;
      if (k == n) throw std::logic_error("no ear");
      i = (i + k) % n;
      add((i + n - 1) % n, i, (i + 1) % n);
      polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if (!(area_of(polygon_) > smallest_)) throw std::logic_error("last ear is flat");
    add(0, 1, 2);
  }

  void add(std::size_t a, std::size_t b, std::size_t c)
  {
    triangles_.push_back({polygon_[a].vertex, polygon_[b].vertex, polygon_[c].vertex});
  }

  Rim polygon_;
  std::vector<Triangle> triangles_;
  double smallest_ = 0;
};

} // namespace synthetic_parts

#endif // PN_TEST_POLYGON_TRIANGLES_H
