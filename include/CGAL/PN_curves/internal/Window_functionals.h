// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_WINDOW_FUNCTIONALS_H
#define CGAL_PN_CURVES_INTERNAL_WINDOW_FUNCTIONALS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_masks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Functionals on a window of a control polygon, a run of points that one matrix maps to the run of the next
// round: left eigenvectors. Those of the eigenvalues 1, 1/2 and 1/4 are limit, first and second derivative
// with respect to the parameter of the window's points 0, 1, 2, ... They are found one after the other by
// iteration on both sides, each among the vectors that those before it annihilate.
class Window_functionals
{
public:
  using Real = long double;
  using Vector = std::vector<Real>;

  // outer: the modulus of the largest eigenvalue that larger windows have besides
  Window_functionals(const Ring_matrix<Real>& matrix, Real outer)
    : matrix_(matrix)
    , largest_other_(outer)
  {
    if (!find(1)) return;
    limit_ = pairs_[0].left;
    if (!find(Real(1) / 2)) {
      note_rest();
      return;
    }
    if (outer < Real(1) / 2 - tolerance && take_first()) {
      if (find(Real(1) / 4)) {
        largest_other_ = (std::max)(largest_other_, Real(1) / 4);
        if (take_second()) has_curvature_ = outer < settling && rest() < settling;
        note_rest();
        return;
      }
      note_rest();
      has_curvature_ = largest_other_ < settling;
      return;
    }
    largest_other_ = Real(1) / 2;
  }

  // sums to 1 but for rounding; empty if the powers of the matrix do not converge
  const Vector& limit() const { return limit_; }
  // empty if there is none
  const Vector& first_derivative() const { return first_; }
  // empty if it is zero for all data
  const Vector& second_derivative() const { return second_; }
  // whether all other parts of the data shrink much faster than those of the curvature
  bool has_curvature() const { return has_curvature_; }
  // the modulus of the largest eigenvalue besides 1 and that of the first derivative, within some percent
  Real largest_other() const { return largest_other_; }

private:
  static constexpr int most_steps = 600;
  static constexpr Real tolerance = 1e-9L;
  // what does not shrink faster than this would spoil the curvature for many rounds
  static constexpr Real settling = 0.65L / 4;
  static constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();

  struct Pair
  {
    Vector left, right; // their product is 1
  };

  static Real dot(const Vector& a, const Vector& b)
  {
    Real sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  static void scale(Vector& a, Real factor)
  {
    for (Real& x : a) x *= factor;
  }
  Vector start() const
  {
    Vector x(matrix_.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = 1 + std::sin(Real(2) + static_cast<Real>(i) * static_cast<Real>(i + 3)) / 2;
    return x;
  }

  // x times the matrix, or the matrix times x, without the parts of the known pairs
  Vector product(const Vector& x, bool from_left) const
  {
    Vector y(x.size(), Real(0));
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const auto& [j, weight] : matrix_[i]) {
        if (from_left)
          y[j] += x[i] * weight;
        else
          y[i] += weight * x[j];
      }
    for (const Pair& p : pairs_) {
      const Real part = dot(y, from_left ? p.right : p.left);
      for (std::size_t i = 0; i < y.size(); ++i) y[i] -= part * (from_left ? p.left : p.right)[i];
    }
    return y;
  }

  // the eigenvector of the largest eigenvalue that is left, if that is `value`
  std::optional<Vector> eigenvector(Vector x, Real value, bool from_left) const
  {
    for (int k = 0; k < most_steps; ++k) {
      Vector y = product(x, from_left);
      const Real length = std::sqrt(dot(y, y));
      if (!(length > 1e-15L)) return std::nullopt;
      const Real factor = dot(x, y) / dot(x, x);
      scale(y, 1 / length);
      Real change = 0;
      for (std::size_t i = 0; i < x.size(); ++i) change = (std::max)(change, std::abs(y[i] - x[i]));
      x.swap(y);
      if (change > rounding) continue;
      if (std::abs(factor - value) > tolerance) return std::nullopt;
      return x;
    }
    return std::nullopt;
  }

  bool find(Real value)
  {
    const auto left = eigenvector(start(), value, true), right = eigenvector(start(), value, false);
    if (!left || !right) return false;
    Pair pair{*left, *right};
    if (value == 1) std::fill(pair.right.begin(), pair.right.end(), Real(1)); // without rounding
    const Real product = dot(pair.left, pair.right);
    if (!(std::abs(product) > tolerance)) return false; // the eigenvalue has no other right vector
    scale(pair.left, 1 / product);
    pairs_.push_back(std::move(pair));
    return true;
  }

  // by data that are 0, 1, 2, ... but for a constant
  bool take_first()
  {
    Pair& p = pairs_[1];
    const std::size_t n = p.right.size();
    const Real step = (p.right[n - 1] - p.right[0]) / static_cast<Real>(n - 1);
    for (std::size_t i = 1; i < n; ++i)
      if (!(std::abs(p.right[i] - p.right[i - 1] - step) <= tolerance * std::abs(step)))
        return false;
    first_ = p.left;
    scale(first_, step);
    return true;
  }

  // by data whose second differences are 1
  bool take_second()
  {
    const Vector& r = pairs_[2].right;
    if (r.size() < 3) return false;
    const Real step = r[0] - 2 * r[1] + r[2];
    for (std::size_t i = 2; i < r.size(); ++i)
      if (!(std::abs(r[i] - 2 * r[i - 1] + r[i - 2] - step) <= tolerance * std::abs(step)))
        return false;
    second_ = pairs_[2].left;
    scale(second_, step);
    return true;
  }

  // the modulus of the largest eigenvalue that is left, within some percent
  Real rest() const
  {
    Vector x = start();
    constexpr int skipped = 30, measured = 60;
    Real logarithm = 0;
    for (int k = 0; k < skipped + measured; ++k) {
      x = product(x, false);
      const Real length = std::sqrt(dot(x, x));
      if (!(length > 1e-15L)) return 0;
      scale(x, 1 / length);
      if (k >= skipped) logarithm += std::log(length);
    }
    return std::exp(logarithm / measured);
  }
  void note_rest() { largest_other_ = (std::max)(largest_other_, rest()); }

  const Ring_matrix<Real>& matrix_;
  std::vector<Pair> pairs_;
  Vector limit_, first_, second_;
  bool has_curvature_ = false;
  Real largest_other_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CURVES_INTERNAL_WINDOW_FUNCTIONALS_H
