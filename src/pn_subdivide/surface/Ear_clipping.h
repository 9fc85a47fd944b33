// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_EAR_CLIPPING_H
#define PN_SUBDIVIDE_EAR_CLIPPING_H

#include "surface/Polygon_in_plane.h"
#include "surface/split_polygon.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>
#include <vector>

namespace pn_subdivide {

// Cuts off corners, of those that can be cut off the one with the shortest diagonal first. In a polygon that
// touches or crosses itself there may be none: then the one that does least harm. Corners that turn right, the only
// ones that can lie in an ear, are found by their x: near-linear where ears are small, never more than quadratic.
class Ear_clipping
{
public:
  using Index = std::uint32_t;

  Ear_clipping(const Polygon_in_plane& polygon, const Is_edge& is_edge)
    : polygon_(polygon)
    , is_edge_(is_edge)
    , size_(Index(polygon.size()))
    , before_(size_)
    , after_(size_)
    , by_x_(size_)
    , turns_right_(size_)
    , version_(size_, 0)
  {
    for (Index i = 0; i < size_; ++i) {
      before_[i] = i == 0 ? size_ - 1 : i - 1;
      after_[i] = i + 1 == size_ ? 0 : i + 1;
    }
    std::iota(by_x_.begin(), by_x_.end(), Index(0));
    std::sort(by_x_.begin(), by_x_.end(),
              [&](Index i, Index j) { return polygon_.x(i) < polygon_.x(j); });
    for (Index i = 0; i < size_; ++i) set_turn(i);
    for (Index i = 0; i < size_; ++i) enter(i);
  }

  std::vector<Corner_triangle> triangles()
  {
    std::vector<Corner_triangle> result;
    while (result.size() + 2 < size_) {
      const Candidate c = queue_.top();
      queue_.pop();
      if (c.version != version_[c.corner]) continue;
      Corner_triangle t = {before_[c.corner], c.corner, after_[c.corner]};
      cut_off(c.corner);
      std::sort(t.begin(), t.end());
      result.push_back(t);
    }
    return result;
  }

private:
  enum Harm { none, is_blocked, has_no_area, is_reversed, doubles_an_edge };

  struct Candidate
  {
    int harm;
    double length;
    Index corner, version;

    bool operator>(const Candidate& c) const
    {
      return std::tie(harm, length, corner) > std::tie(c.harm, c.length, c.corner);
    }
  };

  int turn(Index i) const { return polygon_.turn(before_[i], i, after_[i]); }
  void set_turn(Index i) { turns_right_[i] = turn(i) < 0; }

  void enter(Index i)
  {
    const Index a = before_[i], c = after_[i];
    queue_.push({harm(i), polygon_.squared_distance(a, c), i, ++version_[i]});
  }

  void cut_off(Index i)
  {
    const Index a = before_[i], c = after_[i];
    ++version_[i];
    turns_right_[i] = false;
    after_[a] = c;
    before_[c] = a;
    set_turn(a);
    set_turn(c);
    enter(a);
    enter(c);
  }

  int harm(Index i) const
  {
    const Index a = before_[i], c = after_[i];
    if (after_[c] != a && is_edge_(a, c)) return doubles_an_edge;
    const int t = turn(i);
    if (t < 0) return is_reversed;
    if (t == 0) return has_no_area;
    return is_empty(a, i, c) ? none : is_blocked;
  }

  bool is_empty(Index a, Index b, Index c) const
  {
    const auto [left, right] = std::minmax({polygon_.x(a), polygon_.x(b), polygon_.x(c)});
    const auto [low, high] = std::minmax({polygon_.y(a), polygon_.y(b), polygon_.y(c)});
    auto i = std::lower_bound(by_x_.begin(), by_x_.end(), left,
                              [&](Index j, double x) { return polygon_.x(j) < x; });
    for (; i != by_x_.end() && polygon_.x(*i) <= right; ++i) {
      if (!turns_right_[*i] || *i == a || *i == b || *i == c) continue;
      if (polygon_.y(*i) >= low && polygon_.y(*i) <= high && blocks(*i, {a, b, c})) return false;
    }
    return true;
  }

  // A corner at the same point as one of the ear, as of a bridge to a hole, does so if one of its sides goes in.
  bool blocks(Index i, const std::array<Index, 3>& ear) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (polygon_.turn(ear[k], ear[(k + 1) % 3], i) < 0) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (is_at(i, ear[k])) return goes_in(before_[i], ear, k) || goes_in(after_[i], ear, k);
    return true;
  }
  bool is_at(Index i, Index j) const
  {
    return polygon_.x(i) == polygon_.x(j) && polygon_.y(i) == polygon_.y(j);
  }
  bool goes_in(Index i, const std::array<Index, 3>& ear, std::size_t k) const
  {
    return polygon_.turn(ear[k], ear[(k + 1) % 3], i) > 0 &&
           polygon_.turn(ear[k], ear[(k + 2) % 3], i) < 0;
  }

  const Polygon_in_plane& polygon_;
  const Is_edge& is_edge_;
  Index size_;
  std::vector<Index> before_, after_, by_x_;
  std::vector<char> turns_right_;
  std::vector<Index> version_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_EAR_CLIPPING_H
