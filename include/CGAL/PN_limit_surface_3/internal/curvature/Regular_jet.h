// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_REGULAR_JET_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_REGULAR_JET_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>

#include <array>
#include <cmath>
#include <cstddef>
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

// of the surface (u, z) with the normal on the side that z points to; mean curvature is positive where
// the surface bends away from it
template <class FT>
Curvatures<FT> curvatures(const Jet_2<FT>& x, const Jet_2<FT>& y, const Jet_2<FT>& z)
{
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
    const Surface_jet<FT> jet = surface_jet(ring, values, roundness);
    return curvatures(jet.u[0], jet.u[1], jet.z);
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_REGULAR_JET_H
