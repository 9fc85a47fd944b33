// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_GEOMETRY_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_GEOMETRY_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Curvature_transfer.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A value with its first and second derivatives in the directions a and b.
template <class FT>
struct Jet_2
{
  FT value{}, a{}, b{}, aa{}, ab{}, bb{};

  void add(const FT& x, const Jet_2& weight)
  {
    value += x * weight.value;
    a += x * weight.a;
    b += x * weight.b;
    aa += x * weight.aa;
    ab += x * weight.ab;
    bb += x * weight.bb;
  }
  // the product rule
  void add_product(const FT& factor, const Jet_2& f, const Jet_2& g)
  {
    value += factor * f.value * g.value;
    a += factor * (f.a * g.value + f.value * g.a);
    b += factor * (f.b * g.value + f.value * g.b);
    aa += factor * (f.aa * g.value + 2 * f.a * g.a + f.value * g.aa);
    ab += factor * (f.ab * g.value + f.a * g.b + f.b * g.a + f.value * g.ab);
    bb += factor * (f.bb * g.value + 2 * f.b * g.b + f.value * g.bb);
  }
};

// the surface (u, z) in a frame
template <class FT>
struct Surface_jet
{
  Local_frame<FT> frame;
  std::array<Jet_2<FT>, 2> u;
  Jet_2<FT> z;
};

// Gaussian and mean curvature
template <class FT>
struct Curvatures
{
  FT gaussian, mean;
};

// the curvatures of the surface (u, z) with the normal on the side that z points to; mean curvature is positive where
// the surface bends away from it
template <class FT>
Curvatures<FT> curvatures(const Surface_jet<FT>& jet)
{
  const auto& [x, y] = jet.u;
  const Jet_2<FT>& z = jet.z;
  using Vector = Coordinates<FT, 3>;
  const Vector a{x.a, y.a, z.a}, b{x.b, y.b, z.b};
  Vector n = cross(a, b);
  if (n[2] < 0)
    for (FT& c : n) c = -c;
  const FT area = dot(n, n); // squared
  const FT length = std::sqrt(area);
  const FT e = dot(a, a), f = dot(a, b), g = dot(b, b);
  const FT l = dot<FT, 3>({x.aa, y.aa, z.aa}, n) / length;
  const FT m = dot<FT, 3>({x.ab, y.ab, z.ab}, n) / length;
  const FT k = dot<FT, 3>({x.bb, y.bb, z.bb}, n) / length;
  return {(l * k - m * m) / area, -(e * k - 2 * f * m + g * l) / (2 * area)};
}

// Value and derivatives of a regular spline surface at a vertex from the vertex and its 1-ring:
// bicubic B-splines on quads, the box spline of Loop's scheme on triangles. The PN surface of the roundness r
// at the vertex is that of z = w + r g.u/2, where u, g and w = z - r g.u/2 are refined linearly up to third order.
template <class FT>
class Regular_jet
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;
  using Value = Point_normal<FT, 3>;

  explicit Regular_jet(Index degree)
  {
    if (degree == 4)
      bicubic_weights();
    else
      box_spline_weights();
  }

  std::size_t size() const { return weights_.size(); }

  // `ring`: the vertex and its 1-ring, clockwise
  Curvatures<FT> operator()(const Index* ring, const Value* values,
                            const FT& roundness = FT(1)) const
  {
    return curvatures(surface_jet(ring, values, roundness));
  }

  Surface_jet<FT> surface_jet(const Index* ring, const Value* values,
                              const FT& roundness = FT(1)) const
  {
    const Local_frame<FT> frame(values[*ring].point, normal(ring, values));
    Jet_2<FT> u[2], g[2], z;
    for (std::size_t k = 0; k < size(); ++k) {
      const Value& v = values[ring[k]];
      const Pair<FT> uk = frame.u(v.point), gk = frame.slope(v.normal);
      for (std::size_t c = 0; c < 2; ++c) {
        u[c].add(uk[c], weights_[k]);
        g[c].add(gk[c], weights_[k]);
      }
      z.add(frame.z(v.point) - roundness * ((gk[0] * uk[0] + gk[1] * uk[1]) / 2), weights_[k]);
    }
    for (int c = 0; c < 2; ++c) z.add_product(roundness / 2, g[c], u[c]);
    return {frame, {u[0], u[1]}, z};
  }

private:
  // the normal of the limit; that of the points where there are no normals
  Vector normal(const Index* ring, const Value* values) const
  {
    Vector n{}, a{}, b{};
    for (std::size_t k = 0; k < size(); ++k) {
      const Value& v = values[ring[k]];
      add_multiple<FT, 3>(n, weights_[k].value, v.normal);
      add_multiple<FT, 3>(a, weights_[k].a, v.point);
      add_multiple<FT, 3>(b, weights_[k].b, v.point);
    }
    if (dot(n, n) == FT(0)) n = cross(b, a); // the ring is clockwise
    normalize(n);
    return n;
  }

  void bicubic_weights()
  {
    const FT value[] = {FT(1) / 6, FT(4) / 6, FT(1) / 6}, first[] = {FT(-1) / 2, 0, FT(1) / 2},
             second[] = {1, -2, 1};
    constexpr int places[][2] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}, {0, 2},
                                 {0, 1}, {0, 0}, {1, 0}, {2, 0}};
    for (const auto& [i, j] : places)
      weights_.push_back({value[i] * value[j], first[i] * value[j], value[i] * first[j],
                          second[i] * value[j], first[i] * first[j], value[i] * second[j]});
  }

  void box_spline_weights()
  {
    weights_.push_back({FT(1) / 2, 0, 0, -2, 0, -2});
    const FT sine = std::sqrt(FT(3)) / 2;
    const FT sines[] = {0, sine, sine, 0, -sine, -sine};
    for (int k = 0; k < 6; ++k) {
      const FT c = cosine_weight<FT>(k, 6), s = sines[k];
      const FT c2 = cosine_weight<FT>(2 * k, 6), s2 = sines[2 * k % 6];
      weights_.push_back(
        {FT(1) / 12, c / 3, s / 3, (1 + 2 * c2) / 3, 2 * s2 / 3, (1 - 2 * c2) / 3});
    }
  }

  std::vector<Jet_2<FT>> weights_;
};

// The jet of a regular spline surface, from a ring whose neighbors are in front of its diagonal vertices.
inline Surface_jet<double>
spline_jet(bool is_quads, const std::vector<Point_normal<double, 3>>& ring, double roundness)
{
  static constexpr Level_connectivity::Index quads[] = {0, 1, 6, 2, 7, 3, 8, 4, 5},
                                             triangles[] = {0, 1, 2, 3, 4, 5, 6};
  return Regular_jet<double>(is_quads ? 4 : 3)
    .surface_jet(is_quads ? quads : triangles, ring.data(), roundness);
}

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

  // the length of what the masks make of the ring, in the direction where it is the shortest
  double size() const
  {
    const auto [a, b] = size_;
    return std::abs(a[0] * b[1] - a[1] * b[0]) /
           std::sqrt(a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1]);
  }

  // the error of the normal as far as the ring alone tells it, as Ring_lanes::error
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
  // the second derivatives of the height in the frame: aa, ab, bb
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_GEOMETRY_H
