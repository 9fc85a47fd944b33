// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_CURVATURE_TRANSFER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_CURVATURE_TRANSFER_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/Local_frame.h>
#include <CGAL/PN_subdivision_3/internal/average/checked_coordinates.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Ring_functionals.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class FT>
using Triple_of = std::array<FT, 3>;

template <class FT>
FT dot_of_triples(const Triple_of<FT>& a, const Triple_of<FT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The shortest x with A x = b, for the columns of a 3x3 matrix A. Singular values below 1e-8 of the
// largest count as 0. By rotations of pairs of columns until all are perpendicular (one-sided Jacobi
// method), always in the same order.
template <class FT>
Triple_of<FT> least_norm_solution(std::array<Triple_of<FT>, 3> columns, const Triple_of<FT>& b)
{
  std::array<Triple_of<FT>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr std::size_t pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int sweep = 0; sweep < 12; ++sweep)
    for (const auto& [i, j] : pairs) {
      const FT product = dot_of_triples(columns[i], columns[j]);
      if (product == FT(0)) continue;
      const FT difference =
        dot_of_triples(columns[j], columns[j]) - dot_of_triples(columns[i], columns[i]);
      // tan of the smaller angle that makes them perpendicular
      const FT zeta = difference / (2 * product);
      const FT t = sign_of(zeta) / (absolute_value(zeta) + square_root_of<FT>(1 + zeta * zeta));
      const FT c = 1 / square_root_of<FT>(1 + t * t), s = c * t;
      for (auto* m : {&columns, &axes})
        for (std::size_t r = 0; r < 3; ++r) {
          const FT x = (*m)[i][r], y = (*m)[j][r];
          (*m)[i][r] = c * x - s * y;
          (*m)[j][r] = s * x + c * y;
        }
    }
  FT largest(0);
  for (const auto& column : columns) {
    const FT square = dot_of_triples(column, column);
    if (square > largest) largest = square;
  }
  Triple_of<FT> x{};
  for (std::size_t k = 0; k < 3; ++k) {
    const FT square = dot_of_triples(columns[k], columns[k]);
    if (!(square > FT(1e-16) * largest)) continue;
    const FT share = dot_of_triples(columns[k], b) / square;
    for (std::size_t r = 0; r < 3; ++r) x[r] += share * axes[k][r];
  }
  return x;
}

// A quadratic form u^T Q v over the plane of a frame.
template <class Real>
struct Quadratic_part
{
  Local_frame<Real> frame;
  Real xx, xy, yy;

  // of vectors in space
  Real operator()(const Coordinates<Real, 3>& a, const Coordinates<Real, 3>& b) const
  {
    const Real a1 = dot<Real, 3>(a, frame.e1()), a2 = dot<Real, 3>(a, frame.e2());
    const Real b1 = dot<Real, 3>(b, frame.e1()), b2 = dot<Real, 3>(b, frame.e2());
    return xx * a1 * b1 + xy * (a1 * b2 + a2 * b1) + yy * a2 * b2;
  }

  // Q u, in the plane
  Pair<Real> gradient(const Pair<Real>& u) const
  {
    return {xx * u[0] + xy * u[1], xy * u[0] + yy * u[1]};
  }
};

// The transfer of curvature at an extraordinary vertex, after a round of tuned rules that keep the
// quadratic part of the heights w of a ring: half of it goes to the slopes of the control normals,
// which the PN rule keeps for ever.
template <class Real>
class Curvature_transfer
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<Real, 3>;
  using Ring = std::vector<Value>;

  Curvature_transfer(Index degree, Index valence)
    : functionals_(degree, valence)
  {}

  std::size_t size() const { return functionals_.size(); }

  // What is left in the heights of a ring, in the order of Ring_functionals. None where the normals
  // spread over more than 60 degrees or are not all there, where the ring has collapsed, and where
  // it is no more than `noise`.
  std::optional<Quadratic_part<Real>> operator()(const Ring& ring, const Real& noise) const
  {
    const auto* const mask = functionals_.limit().data();
    const Value limit = PN_average<Real, 3>{Real(1)}(mask, mask + size(), ring.data());
    for (const Value& v : ring)
      if (!(dot<Real, 3>(v.normal, limit.normal) >= Real(1) / 2)) return std::nullopt;
    const Local_frame<Real> frame(limit.point, limit.normal);
    std::vector<Pair<Real>> u(size());
    std::vector<Real> w(size());
    for (std::size_t j = 0; j < size(); ++j) {
      u[j] = frame.u(ring[j].point);
      const auto h = pn_height<Real, 3>(ring[j], frame.origin(), frame.normal());
      w[j] = h.numerator / (std::max)(h.denominator, Real(Real(1) / Real(1000)));
    }
    const Pair<Real> slope = slope_of(u, w);
    if (!is_finite_number(slope[0]) || !is_finite_number(slope[1])) return std::nullopt;
    for (std::size_t j = 0; j < size(); ++j) w[j] -= slope[0] * u[j][0] + slope[1] * u[j][1];

    Triple_of<Real> rest{};
    for (std::size_t k = 0; k < functionals_.quadratic().size(); ++k)
      rest[k] = applied(functionals_.quadratic()[k], [&](std::size_t j) { return w[j]; });
    const auto exceeds = [&](const Real& x) { return absolute_value(x) > noise; };
    if (std::none_of(rest.begin(), rest.end(), exceeds)) return std::nullopt;
    return with_rest(frame, u, rest);
  }

private:
  using Functional = typename Ring_functionals<Real>::Functional;

  template <class Function>
  static Real applied(const Functional& functional, const Function& f)
  {
    Real sum(0);
    for (std::size_t j = 0; j < functional.size(); ++j) sum += functional[j] * f(j);
    return sum;
  }

  Pair<Real> slope_of(const std::vector<Pair<Real>>& u, const std::vector<Real>& w) const
  {
    std::array<Pair<Real>, 2> size;
    Pair<Real> heights;
    for (std::size_t r = 0; r < 2; ++r) {
      for (std::size_t c = 0; c < 2; ++c)
        size[r][c] = applied(functionals_.tangent(r), [&](std::size_t j) { return u[j][c]; });
      heights[r] = applied(functionals_.tangent(r), [&](std::size_t j) { return w[j]; });
    }
    return solve(size, heights);
  }

  // The form that the functionals see as `rest`. Its least norm is that of the matrix, so that it does
  // not depend on the frame, if the unknown besides the diagonal is sqrt(2) Q_xy.
  std::optional<Quadratic_part<Real>> with_rest(const Local_frame<Real>& frame,
                                                const std::vector<Pair<Real>>& u,
                                                const Triple_of<Real>& rest) const
  {
    const Real root = square_root_of(Real(2));
    std::array<Triple_of<Real>, 3> columns{};
    for (std::size_t k = 0; k < functionals_.quadratic().size(); ++k) {
      const Functional& f = functionals_.quadratic()[k];
      columns[0][k] = applied(f, [&](std::size_t j) { return u[j][0] * u[j][0] / 2; });
      columns[1][k] = applied(f, [&](std::size_t j) { return u[j][1] * u[j][1] / 2; });
      columns[2][k] = applied(f, [&](std::size_t j) { return u[j][0] * u[j][1] / root; });
    }
    const Triple_of<Real> q = least_norm_solution(columns, rest);
    for (const Real& x : q)
      if (!is_finite_number(x)) return std::nullopt;
    return Quadratic_part<Real>{frame, q[0], q[2] / root, q[1]};
  }

  Ring_functionals<Real> functionals_;
};

// The same on rings of any number type: in double, or long double, about the middle of the ring.
template <class FT>
class Normal_transfer
{
public:
  using Real = Rooted_number<FT>;
  using Value = Point_normal<FT, 3>;
  using Part = Quadratic_part<Real>;

  Normal_transfer(Level_connectivity::Index degree, Level_connectivity::Index valence)
    : transfer_(degree, valence)
  {}

  std::size_t size() const { return transfer_.size(); }

  // The quadratic part of a ring. What rounding leaves of spheres and cylinders is none: it is that of the
  // coordinates that the points have about the origin of the mesh, if they are given about another one. The
  // frame of the part is that of the ring divided by a power of two if squares of its size would be out of range.
  std::optional<Part> operator()(const std::vector<Value>& ring,
                                 const Coordinates<FT, 3>& origin = {FT(0), FT(0), FT(0)})
  {
    Real largest(0);
    Size size = 0;
    ring_.resize(ring.size());
    for (std::size_t j = 0; j < ring.size(); ++j)
      for (std::size_t c = 0; c < 3; ++c) {
        largest = (std::max)(largest, absolute_value(real(FT(origin[c] + ring[j].point[c]))));
        ring_[j].point[c] = real(FT(ring[j].point[c] - ring[0].point[c]));
        ring_[j].normal[c] = real(ring[j].normal[c]);
        size = (std::max)(size, std::abs(size_of(ring_[j].point[c])));
      }
    constexpr int harmless = 64;
    exponent_ = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
    if (std::abs(exponent_) <= harmless) exponent_ = 0;
    if (exponent_ == 0) return transfer_(ring_, 64 * epsilon() * largest);
    for (Point_normal<Real, 3>& v : ring_)
      for (Real& x : v.point) x = scaled(x, -exponent_);
    auto part = transfer_(ring_, 64 * epsilon() * scaled(largest, -exponent_));
    if (part)
      for (Real* x : {&part->xx, &part->xy, &part->yy}) *x = scaled(*x, -exponent_);
    return part;
  }

  // Adds half of it to the slopes of the normals of the ring that it was found in last.
  template <class Normal_of>
  void add_half(const Part& part, const Normal_of& normal) const
  {
    for (std::size_t j = 0; j < ring_.size(); ++j) {
      Pair<Real> g = part.gradient(part.frame.u(ring_[j].point));
      if (exponent_ != 0)
        for (Real& x : g) x = scaled(x, exponent_);
      const Real half = dot<Real, 3>(ring_[j].normal, part.frame.normal()) / 2;
      Coordinates<FT, 3>& n = normal(j);
      for (std::size_t c = 0; c < 3; ++c)
        n[c] -= FT(half * (g[0] * part.frame.e1()[c] + g[1] * part.frame.e2()[c]));
      n = unit_or_zero<FT, 3>(n, FT(1));
    }
  }

private:
  static Real real(const FT& x)
  {
    if constexpr (std::is_floating_point_v<FT> || std::is_same_v<FT, Real>)
      return x;
    else
      return close_double(x);
  }
  // of which the exponent is asked
  using Size = std::conditional_t<std::is_floating_point_v<Real>, Real, double>;
  static Size size_of(const Real& x)
  {
    if constexpr (std::is_floating_point_v<Real>)
      return x;
    else
      return close_double(x);
  }
  static Real epsilon()
  {
    if constexpr (std::is_floating_point_v<FT>)
      return std::numeric_limits<FT>::epsilon();
    else
      return machine_epsilon<Real>();
  }
  static Real scaled(const Real& x, int exponent)
  {
    if constexpr (std::is_floating_point_v<Real>)
      return std::ldexp(x, exponent);
    else
      return times_power_of_two(x, exponent);
  }

  Curvature_transfer<Real> transfer_;
  std::vector<Point_normal<Real, 3>> ring_;
  int exponent_ = 0; // of the power of two by which `ring_` is divided
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_CURVATURE_TRANSFER_H
