// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_PROVEN_BOUND_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_PROVEN_BOUND_H

#include <cmath>
#include <limits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A bound of the distance of a point-normal limit from that of the linear scheme on the same net, whose edges have ends no
// farther apart than D, with unit normals that differ by delta at most. With non-negative weights the height H of a
// point-normal average is bounded by its covariances, and both differences contract:
//   eta = ((1 - (1 - sigma2 delta^2)^(1/2)) / (2 - d0^2 delta^2 / 2))^(1/2) sigma D >= |H|,
//   delta' = gamma delta / (1 - sigma2 delta^2)^(1/2),  D' = gamma D + 2 eta;
// the bound is the sum of all eta, infinite where the normals differ too much. The constants are those of
// scripts/enclosure_constants.py, rounded up.
class Proven_bound
{
public:
  static constexpr unsigned least_valence = 3, most_valence = 12;

  // degree: of the faces; valence: the one at a corner with the largest gamma is decisive, see include()
  explicit Proven_bound(unsigned degree)
    : is_quads_(degree == 4)
    , gamma_(0.5)
    , sigma2_(is_quads_ ? 0.75 : 0.4258)
    , d0_(is_quads_ ? 4 : 2)
  {}

  // \pre least_valence <= valence <= most_valence
  void include(unsigned valence)
  {
    constexpr double of_quads[] = {0.5,    0.5,    0.67,   0.75,   0.7909,
                                   0.8125, 0.8241, 0.8300, 0.8327, 0.8334};
    constexpr double of_triangles[] = {0.5,   0.5,    0.5,    0.5,    0.5760,
                                       0.625, 0.6588, 0.6834, 0.7021, 0.7168};
    const double gamma = (is_quads_ ? of_quads : of_triangles)[valence - least_valence];
    if (gamma > gamma_) gamma_ = gamma;
    if (is_quads_ && valence == 3) sigma2_ = 0.8426;
  }

  double operator()(double delta, double d) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double sum = 0;
    for (int i = 0; i < 1000 && delta * d > 0; ++i) {
      const double remaining = 1 - sigma2_ * delta * delta;
      const double cosine = 2 - d0_ * d0_ * delta * delta / 2;
      if (!(remaining > 0) || !(cosine >= 1)) return infinite;
      const double root = std::sqrt(remaining);
      // 1 - root without cancellation
      const double eta =
        std::sqrt(sigma2_ * delta * delta / (1 + root) / cosine) * std::sqrt(sigma2_) * d;
      sum += eta;
      delta = gamma_ * delta / root;
      d = gamma_ * d + 2 * eta;
      if (delta < 1e-40) break;
    }
    return sum * (1 + 1e-12);
  }

private:
  bool is_quads_;
  double gamma_, sigma2_, d0_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_PROVEN_BOUND_H
