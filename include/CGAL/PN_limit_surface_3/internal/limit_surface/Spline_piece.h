// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SPLINE_PIECE_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SPLINE_PIECE_H

#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Jet.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What is known of a vertex of a level that is cut open.
enum class Piece_vertex : char { irregular, interior, border, corner };

// The control vertices of the polynomial piece of a face, and their weights as functions of the parameters: 16 of the
// bicubic spline, 12 of the quartic box spline of Loop subdivision. At the border, whose rule is the cubic spline, what is
// beyond is extrapolated: a vertex is a sum of vertices of the level.
class Spline_piece
{
public:
  using Index = Level_connectivity::Index;
  struct Entry
  {
    Index vertex;
    Jet weight;
  };
  using Entries = std::vector<Entry>;

  // kind(v): a vertex; checks_ring: whether all vertices have to be regular, not only the corners
  template <class Kind>
  Spline_piece(const Level_connectivity& level, Index base, Index degree, bool checks_ring,
               const Kind& kind)
    : level_(level)
    , degree_(degree)
  {
    Index h = base;
    for (Index i = 0; i < degree; ++i, h = level.next(h)) h_[i] = h;
    if (h != base) return;
    is_regular_ = degree == 4 ? collect_quads(kind) : collect_triangles(kind);
    if (is_regular_ && checks_ring)
      for (const Sum& s : controls_)
        for (const auto& [v, factor] : s)
          is_regular_ = is_regular_ && kind(v) != Piece_vertex::irregular;
  }

  bool is_regular() const { return is_regular_; }

  Entries entries(double u, double v) const
  {
    return degree_ == 4 ? added(quad_weights(u, v)) : added(triangle_weights(u, v));
  }

  // calls f(point, sides) with the Bezier points, whose convex hull contains the piece; bit i of `sides`: the point belongs to
  // the side from corner i on. point(v): of a vertex. \pre no vertex is extrapolated
  template <class Point_of, class Function>
  void for_each_bezier_point(const Point_of& point, const Function& f) const
  {
    const auto sum = [&](const auto& weight) {
      std::array<double, 3> p{};
      for (std::size_t i = 0; i < controls_.size(); ++i)
        if (const double w = weight(static_cast<int>(i)); w != 0) {
          const auto q = point(controls_[i].front().first);
          for (std::size_t c = 0; c < 3; ++c) p[c] += w * q[c];
        }
      return p;
    };
    if (degree_ == 4) {
      constexpr double part[4][4] = {{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}};
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
          f(sum([&](int i) { return part[x][i % 4] * part[y][i / 4] / 36; }),
            (y == 0 ? 1u : 0u) | (x == 3 ? 2u : 0u) | (y == 3 ? 4u : 0u) | (x == 0 ? 8u : 0u));
    } else
      for (int x = 0; x <= 4; ++x)
        for (int y = 0; x + y <= 4; ++y) {
          const std::array<int, 3> e{x, y, 4 - x - y};
          f(sum([&](int i) {
              return bezier_weight(i / 3, e[i % 3], e[(i + 1) % 3], e[(i + 2) % 3]) / 12;
            }),
            (e[2] == 0 ? 1u : 0u) | (e[0] == 0 ? 2u : 0u) | (e[1] == 0 ? 4u : 0u));
        }
  }

private:
  using Sum = std::vector<std::pair<Index, double>>;

  // 12 times the coefficient of the Bezier polynomial a^p b^q c^r in the weights below
  static double bezier_weight(int kind, int p, int q, int r)
  {
    const int least = (std::min)(q, r);
    if (kind == 0) return p >= 3 ? 6 : p == 2 ? 4 + least : p == 1 ? 2 + least : 1 + 0.5 * least;
    if (kind == 1) return r == 0 ? 1 + 0.5 * (std::min)(p, q) : r == 1 ? 0.5 : 0;
    return p == 4 ? 1 : p == 3 && (kind == 2 ? q : r) == 1 ? 0.5 : 0;
  }

  static Index opposite(Index h) { return Level_connectivity::opposite(h); }
  Index corner(Index i) const { return level_.target(h_[i % degree_]); }
  // the other side of the edge from corner i on
  Index outer(Index i) const { return opposite(h_[(i + 1) % degree_]); }
  bool has_face(Index i) const { return !level_.is_border(outer(i)); }

  // a + b - c
  static Sum beyond(const Sum& a, const Sum& b, const Sum& c)
  {
    Sum s = a;
    s.insert(s.end(), b.begin(), b.end());
    for (const auto& [v, factor] : c) s.emplace_back(v, -factor);
    return s;
  }
  static Sum one(Index v) { return {{v, 1.}}; }

  bool are_quads_around(Index h) const
  {
    for (const Index g : halfedges_around_target(level_, h))
      if (!level_.is_border(g) && !level_.has_degree(g, degree_)) return false;
    return true;
  }

  // \name Quadrilaterals: the control vertex in column c and row r of 4 is number 4 r + c
  template <class Kind>
  bool collect_quads(const Kind& kind)
  {
    for (Index i = 0; i < 4; ++i) {
      const Piece_vertex k = kind(corner(i));
      const int borders = (has_face(i) ? 0 : 1) + (has_face(i + 3) ? 0 : 1);
      constexpr Piece_vertex expected[] = {Piece_vertex::interior, Piece_vertex::border,
                                           Piece_vertex::corner};
      if (k != expected[borders] || !has_valence(level_, h_[i], Index(4 - borders)) ||
          !are_quads_around(h_[i]))
        return false;
    }
    controls_.assign(16, {});
    // corners, and steps outward over the edge from each on
    constexpr int place[] = {5, 6, 10, 9}, step[] = {-4, 1, 4, -1};
    for (Index i = 0; i < 4; ++i) controls_[place[i]] = one(corner(i));
    for (Index i = 0; i < 4; ++i) {
      if (!has_face(i)) continue;
      const Index a = level_.next(outer(i)), b = level_.next(a);
      controls_[place[i] + step[i]] = one(level_.target(a));
      controls_[place[(i + 1) % 4] + step[i]] = one(level_.target(b));
      const Index across = opposite(a);
      if (!level_.is_border(across))
        controls_[place[i] + step[i] + step[(i + 3) % 4]] =
          one(level_.target(level_.next(level_.next(across))));
    }
    for (Index i = 0; i < 4; ++i)
      if (!has_face(i)) extrapolate(place[i], step[i], step[(i + 1) % 4]);
    return true;
  }

  // the row beyond the edge at `first`, whose four places have steps `along`
  void extrapolate(int first, int outward, int along)
  {
    for (int j = -1; j < 3; ++j) {
      const int at = first + j * along;
      const Sum &a = controls_[at], &b = controls_[at - outward];
      if (!a.empty() && !b.empty()) controls_[at + outward] = beyond(a, a, b);
    }
  }

  static std::array<Jet, 4> cubic(const Jet& t)
  {
    const Jet s = t * -1 + 1, t2 = t * t, s2 = s * s;
    return {s2 * s * (1. / 6), (t2 * t * 3 + t2 * -6 + 4) * (1. / 6),
            (s2 * s * 3 + s2 * -6 + 4) * (1. / 6), t2 * t * (1. / 6)};
  }
  static std::array<Jet, 16> quad_weights(double u, double v)
  {
    const auto x = cubic(Jet::of_u(u)), y = cubic(Jet::of_v(v));
    std::array<Jet, 16> w;
    for (std::size_t i = 0; i < 16; ++i) w[i] = x[i % 4] * y[i / 4];
    return w;
  }

  // \name Triangles: corner i, the vertex across the edge from it on, and the two between that one and the one of the edge
  // before, are numbers i, 3 + i, 6 + i, 9 + i
  template <class Kind>
  bool collect_triangles(const Kind& kind)
  {
    int borders = 0;
    for (Index i = 0; i < 3; ++i) {
      const Piece_vertex k = kind(corner(i));
      borders += has_face(i) ? 0 : 1;
      if ((k != Piece_vertex::interior && k != Piece_vertex::border) ||
          !has_valence(level_, h_[i], k == Piece_vertex::interior ? 6 : 4) ||
          !are_quads_around(h_[i]))
        return false;
    }
    if (borders > 1) return false;
    controls_.assign(12, {});
    for (Index i = 0; i < 3; ++i) {
      controls_[i] = one(corner(i));
      if (has_face(i)) controls_[3 + i] = one(level_.target(level_.next(outer(i))));
    }
    for (Index i = 0; i < 3; ++i)
      if (controls_[3 + i].empty())
        controls_[3 + i] = beyond(controls_[i], controls_[(i + 1) % 3], controls_[(i + 2) % 3]);
    for (Index i = 0; i < 3; ++i) collect_outer(i);
    return true;
  }

  // Round corner i: from the edge from it on, over 3 + i, 6 + i, 9 + i and 3 + (i - 1), to the edge before.
  void collect_outer(Index i)
  {
    const Index before = 3 + (i + 2) % 3, after = 3 + i;
    Sum &x = controls_[6 + i], &y = controls_[9 + i];
    if (has_face(i)) { // along the half-edge from the corner to vertex 3 + i
      const Index across = opposite(level_.next(outer(i)));
      if (!level_.is_border(across)) x = one(level_.target(level_.next(across)));
    }
    if (has_face((i + 2) % 3)) {
      const Index across = opposite(level_.next(level_.next(outer((i + 2) % 3))));
      if (!level_.is_border(across)) y = one(level_.target(level_.next(across)));
    }
    const Sum& c = controls_[i];
    if (x.empty())
      x = has_face(i) ? beyond(c, controls_[after], controls_[(i + 1) % 3])
                      : beyond(c, y, controls_[before]);
    if (y.empty())
      y = has_face((i + 2) % 3) ? beyond(c, controls_[before], controls_[(i + 2) % 3])
                                : beyond(c, x, controls_[after]);
  }

  // the weights of the quartic box spline with the directions of the edges, twice each
  static std::array<Jet, 16> triangle_weights(double u, double v)
  {
    const Jet x = Jet::of_u(u), y = Jet::of_v(v);
    const std::array<Jet, 3> t = {(x + y) * -1 + 1, x, y};
    std::array<Jet, 16> w{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Jet &a = t[i], &b = t[(i + 1) % 3], &c = t[(i + 2) % 3];
      const Jet a2 = a * a, b2 = b * b, c2 = c * c, a3 = a2 * a, b3 = b2 * b, c3 = c2 * c;
      w[i] = (a2 * a2 * 6 + a3 * (b + c) * 24 + a2 * (b2 * 24 + b * c * 60 + c2 * 24) +
              a * (b3 * 8 + b2 * c * 36 + b * c2 * 36 + c3 * 8) + b2 * b2 + b3 * c * 6 +
              b2 * c2 * 12 + b * c3 * 6 + c2 * c2) *
             (1. / 12);
      w[3 + i] = (a2 * a2 + a3 * b * 6 + a2 * b2 * 12 + a * b3 * 6 + b2 * b2 +
                  c * (a3 * 2 + a2 * b * 6 + a * b2 * 6 + b3 * 2)) *
                 (1. / 12);
      w[6 + i] = a3 * (a + b * 2) * (1. / 12);
      w[9 + i] = a3 * (a + c * 2) * (1. / 12);
    }
    return w;
  }

  Entries added(const std::array<Jet, 16>& weights) const
  {
    Entries all;
    for (std::size_t i = 0; i < controls_.size(); ++i)
      for (const auto& [vertex, factor] : controls_[i]) {
        Entry* e = nullptr;
        for (Entry& other : all)
          if (other.vertex == vertex) e = &other;
        if (e == nullptr) e = &all.emplace_back(Entry{vertex, {}});
        e->weight += weights[i] * factor;
      }
    return all;
  }

  const Level_connectivity& level_;
  const Index degree_;
  std::array<Index, 4> h_{};
  std::vector<Sum> controls_;
  bool is_regular_ = false;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_SPLINE_PIECE_H
