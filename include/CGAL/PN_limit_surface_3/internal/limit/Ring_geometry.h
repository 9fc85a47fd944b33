// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_GEOMETRY_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_GEOMETRY_H

#include <CGAL/PN_limit_surface_3/internal/curvature/Regular_jet.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/face_normals.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Curvature_transfer.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// First and second order of a surface at the limit of a ring, from the values of the ring. They are
// computed in double.
class Ring_geometry
{
public:
  using Vector = Coordinates<double, 3>;
  using Value = Point_normal<double, 3>;
  using Masks = std::array<std::vector<double>, 2>;

  // The ring, its limit point and limit control normal N (zero without control normals), and the
  // tangent masks T. In the frame of N the surface has the slope a that T finds in the PN heights w
  // of the ring, T u a = T w; they are zero on spheres and cylinders with exact normals. With
  // another roundness r than 1 w is z + r (h - z), of the height z in the frame and the PN height h: this is what is refined
  // linearly.
  Ring_geometry(const std::vector<Value>& ring, const Value& limit, const Masks& tangents,
                double roundness = 1)
    : ring_(ring)
    , tangents_(tangents)
    , roundness_(roundness)
    , frame_(limit.point, has_normal(limit) ? limit.normal : cross_product(ring, tangents))
    , has_control_normal_(has_normal(limit))
  {
    if (!(dot(frame_.normal(), frame_.normal()) > 0.5)) return; // collapsed
    const auto height = [&](const Value& v) {
      const double of_arc = arc_height(v);
      return roundness_ == 1 ? of_arc : of_arc - (1 - roundness_) * (of_arc - frame_.z(v.point));
    };
    for (std::size_t c = 0; c < 2; ++c) {
      const Pair<double> u = masked([&](const Value& v) { return frame_.u(v.point)[c]; });
      for (std::size_t r = 0; r < 2; ++r) size_[r][c] = u[r];
    }
    slope_ = solve(size_, masked(height));
    is_regular_ = std::isfinite(slope_[0]) && std::isfinite(slope_[1]);
  }

  // whether the ring has a tangent plane: it has not collapsed to a line or a point
  bool is_regular() const { return is_regular_; }

  // of what the masks make of the ring, in the direction in which that is shortest
  double size() const
  {
    const auto [a, b] = size_;
    return std::abs(a[0] * b[1] - a[1] * b[0]) /
           std::sqrt(a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1]);
  }

  // what the ring alone tells of the error of the normal, as Ring_lanes::error
  // \pre is_regular()
  double error() const
  {
    if (!has_control_normal_) return std::numeric_limits<double>::infinity();
    double turn = 0;
    for (const Value& v : ring_)
      turn = (std::max)(
        turn, 4 - 2 * pn_height<double, 3>(v, frame_.origin(), frame_.normal()).denominator);
    const auto of_arc = [&](const Value& v) { return arc_height(v) - frame_.z(v.point); };
    const auto [a, b] = solve(size_, masked(of_arc));
    return (std::max)(turn / 2, 4 * std::sqrt(a * a + b * b));
  }

  // \pre is_regular()
  Vector normal() const
  {
    Vector n = frame_.normal();
    add_multiple<double, 3>(n, -slope_[0], frame_.e1());
    add_multiple<double, 3>(n, -slope_[1], frame_.e2());
    normalize(n);
    return n;
  }

  // The curvatures of the limit, where the parts of second order that the ring matrix carries on by
  // itself die out: what remains is the derivative of the slopes of the control normals, times the roundness.
  // Where they are transferred instead, all will be in the slopes, which still get `part`.
  // \pre is_regular()
  Curvatures<double> extraordinary_curvatures(bool are_transferred,
                                              const Quadratic_part<double>* part) const
  {
    auto [xx, xy, yy] = second_derivatives(are_transferred ? 1 : roundness_);
    const double a = slope_[0], b = slope_[1], s = 1 + a * a + b * b;
    if (part != nullptr) {
      xx += (*part)(frame_.e1(), frame_.e1());
      xy += (*part)(frame_.e1(), frame_.e2());
      yy += (*part)(frame_.e2(), frame_.e2());
    }
    const double trace = ((1 + b * b) * xx - 2 * a * b * xy + (1 + a * a) * yy) / s;
    return {(xx * yy - xy * xy) / (s * s), -trace / (2 * std::sqrt(s))};
  }

  // the same as the jet of the surface
  // \pre is_regular()
  Surface_jet<double> extraordinary_jet() const
  {
    const auto [xx, xy, yy] = second_derivatives(roundness_);
    Surface_jet<double> jet{frame_, {}, {}};
    jet.u[0].a = jet.u[1].b = 1;
    jet.z.a = slope_[0];
    jet.z.b = slope_[1];
    jet.z.aa = xx;
    jet.z.ab = xy;
    jet.z.bb = yy;
    return jet;
  }

private:
  // of the height in the frame: aa, ab, bb
  std::array<double, 3> second_derivatives(double share) const
  {
    std::array<Pair<double>, 2> h;
    for (std::size_t c = 0; c < 2; ++c)
      h[c] = solve(size_, masked([&](const Value& v) { return frame_.slope(v.normal)[c]; }));
    return {share * h[0][0], share * (h[0][1] + h[1][0]) / 2, share * h[1][1]};
  }

  double arc_height(const Value& v) const
  {
    const auto h = pn_height<double, 3>(v, frame_.origin(), frame_.normal());
    return h.numerator / (std::max)(h.denominator, 1. / 1024);
  }

  static bool has_normal(const Value& v) { return !PN_average<double, 3>::is_zero(v.normal); }

  template <class Function>
  Pair<double> masked(const Function& f) const
  {
    Pair<double> sum{};
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (tangents_[0][i] == 0 && tangents_[1][i] == 0) continue;
      const double x = f(ring_[i]);
      sum[0] += tangents_[0][i] * x;
      sum[1] += tangents_[1][i] * x;
    }
    return sum;
  }

  static Vector cross_product(const std::vector<Value>& ring, const Masks& tangents)
  {
    Vector t[2] = {};
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (std::size_t r = 0; r < 2; ++r)
        add_multiple<double, 3>(t[r], tangents[r][i], ring[i].point);
    for (Vector& x : t) normalize(x); // their product might underflow
    Vector n = cross(t[0], t[1]);
    if (!(dot(n, n) > 1e-24)) return Vector{};
    normalize(n);
    return n;
  }

  const std::vector<Value>& ring_;
  const Masks& tangents_;
  const double roundness_;
  Local_frame<double> frame_;
  std::array<Pair<double>, 2> size_{}; // T u
  Pair<double> slope_{};
  bool has_control_normal_, is_regular_ = false;
};

// A vertex and the vertices of some rings of faces around it, in an order that depends on the
// connectivity alone: the vertex; its neighbors, clockwise, on the border from one border neighbor
// to the other; the other vertices of its faces in the same sense; then ring by ring.
class Vertex_ring
{
public:
  using Index = Level_connectivity::Index;

  // Appends the rings behind what is there. Vertices of the first ring that coincide, as they may on the coarsest
  // meshes, occur as often as they are met.
  static void append(const Level_connectivity& level, Index v, unsigned rings,
                     std::vector<Index>& ring)
  {
    const Index h = level.halfedge_of_vertex(v);
    const auto begin = static_cast<std::ptrdiff_t>(ring.size());
    ring.push_back(v);
    level.for_each_neighbor(h, [&](Index w) { ring.push_back(w); });
    Index g = h;
    do {
      if (!level.is_border(g))
        for (Index c = level.next(level.next(g)); level.next(c) != g; c = level.next(c))
          ring.push_back(level.target(c));
      g = level.next_around_target(g);
    } while (g != h);
    if (rings > 1) append_outer_rings(level, h, rings, {ring.begin() + begin, ring.end()}, ring);
  }

  // The first ring that the vertex will have in the next round of a host that splits edges, in the
  // same order.
  template <class Host>
  static void append_next(const Level_connectivity& level, const Host& host, Index v,
                          std::vector<Index>& ring)
  {
    const Index first = level.halfedge_of_vertex(v);
    ring.push_back(v);
    Index h = first;
    do {
      h = level.next(h);
      ring.push_back(host.vertex_of_edge(Level_connectivity::edge(h)));
      h = Level_connectivity::opposite(h);
    } while (h != first);
    if constexpr (Host::refined_degree == 4) do {
        if (!level.is_border(h)) ring.push_back(host.vertex_of_face(level.face(h)));
        h = level.next_around_target(h);
      } while (h != first);
  }

private:
  static void append_outer_rings(const Level_connectivity& level, Index h, unsigned rings,
                                 std::unordered_set<Index>&& known, std::vector<Index>& ring)
  {
    std::vector<Index> in; // a half-edge into each vertex of the last ring, found from the center
    Index g = h;
    do {
      in.push_back(level.next(g));
      if (!level.is_border(g))
        for (Index c = level.next(level.next(g)); level.next(c) != g; c = level.next(c))
          in.push_back(c);
      g = level.next_around_target(g);
    } while (g != h);
    std::vector<Index> next_in;
    for (unsigned r = 1; r < rings; ++r) {
      next_in.clear();
      for (const Index first : in) {
        g = first;
        do {
          if (!level.is_border(g))
            for (Index c = level.next(g); c != g; c = level.next(c))
              if (known.insert(level.target(c)).second) {
                ring.push_back(level.target(c));
                next_in.push_back(c);
              }
          g = level.next_around_target(g);
        } while (g != first);
      }
      in.swap(next_in);
    }
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_GEOMETRY_H
