// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_EXTRAORDINARY_LIMIT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_EXTRAORDINARY_LIMIT_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/curvature/Extraordinary_net.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Local_frame.h>
#include <CGAL/PN_subdivision_3/schemes/Cosine_weights.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// the double subdominant eigenvalue of Catmull-Clark (degree 4) and Loop subdivision
template <class FT>
FT subdominant_eigenvalue(Level_connectivity::Index degree, Level_connectivity::Index valence)
{
  const FT c = cosine_weight<FT>(1, valence);
  if (degree == 3) return FT(3) / 8 + c / 4;
  return (5 + c + std::sqrt((c + 1) * (c + 9))) / 16;
}

// Left eigenvectors of Catmull-Clark and Loop subdivision at a vertex of any valence, over its
// 1-ring: that of 1, the limit mask, and the complex one of the subdominant eigenvalue. Tuned rules
// with the same eigenvectors share them.
template <class FT>
class Extraordinary_limit
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<FT, 3>;

  explicit Extraordinary_limit(const Extraordinary_net& net)
  {
    if (net.degree() == 4)
      make_masks_of_quads(net);
    else
      make_masks_of_triangles(net);
  }

  // The limit point and the limit control normal, zero without control normals: the PN average.
  Value limit(const std::vector<Value>& values) const
  {
    const Entry* const first = entries_.data();
    return PN_average<FT, 3>()(first, first + entries_.size(), values.data());
  }

  // applies the tangent mask to f(value), a scalar
  template <class Function>
  Pair<FT> tangent(const std::vector<Value>& values, const Function& f) const
  {
    Pair<FT> t{};
    for (const Entry& e : entries_) {
      const FT x = f(values[e.vertex]);
      t[0] += e.tangent[0] * x;
      t[1] += e.tangent[1] * x;
    }
    return t;
  }

private:
  struct Entry
  {
    Index vertex;
    FT weight;        // of the limit mask
    Pair<FT> tangent; // real and imaginary part
  };

  void make_masks_of_quads(const Extraordinary_net& net)
  {
    const Index n = net.valence();
    const FT m = FT(n), lambda = subdominant_eigenvalue<FT>(4, n);
    const FT y = half_turn(1, n)[0] / (8 * (lambda - FT(1) / 4));
    entries_.push_back({0, m / (m + 5), {}});
    for (Index s = 0; s < n; ++s) {
      entries_.push_back({net.vertex(s, 1, 0), 4 / (m * (m + 5)), half_turn(2 * s, n)});
      const Pair<FT> t = half_turn(2 * s + 1, n);
      entries_.push_back({net.vertex(s, 1, 1), 1 / (m * (m + 5)), {y * t[0], y * t[1]}});
    }
  }

  void make_masks_of_triangles(const Extraordinary_net& net)
  {
    const Index n = net.valence();
    const FT lambda = subdominant_eigenvalue<FT>(3, n), a = 5 - 8 * lambda * lambda;
    entries_.push_back({0, 3 / (3 + a), {}});
    for (Index s = 0; s < n; ++s)
      entries_.push_back({net.vertex(s, 1, 0), a / (FT(n) * (3 + a)), half_turn(2 * s, n)});
  }

  // exp(-i k pi / n), by sin(x) = cos(x - pi / 2) in units of 2 pi / (4 n)
  static Pair<FT> half_turn(Index k, Index n)
  {
    return {cosine_weight<FT>(k, 2 * n), -cosine_weight<FT>(2 * std::int64_t(k) - n, 4 * n)};
  }

  std::vector<Entry> entries_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_EXTRAORDINARY_LIMIT_H
