// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_CURVE_WINDOWS_H
#define CGAL_PN_CURVES_INTERNAL_CURVE_WINDOWS_H

#include <CGAL/PN_curves/internal/Curve_subdivision.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_weights.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_eigenvectors.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The points of a window before and behind its center: that is a vertex if the mask is primal, and the first
// point of an edge if it is dual. Smaller numbers than the mask asks for mean that the polygon ends there.
using Window_size = std::pair<std::int64_t, std::int64_t>;

// The rows that make the points of a window in the next round.
template <class FT>
struct Curve_window
{
  std::vector<Entry_row<FT>> rows;
  Window_size next;

  // the rest is there if `next` is the window itself, so that the next rounds are all alike
  Entry_row<FT> limit_row;
  // of the points, in double; the first one is empty if there is none, the second one if it is zero for all data
  std::vector<double> first_derivative, second_derivative;
  // whether all other parts of the data shrink much faster than the part of the curvature
  bool has_curvature = false;
  // the modulus of the largest eigenvalue besides 1 and the eigenvalue of the first derivative, within some percent
  double largest_other = 0;
};

// A matrix of a few rows, or of the rows of differences of neighbors.
template <class FT>
using Window_matrix = std::vector<std::vector<FT>>;

// The row l with l S = l and sum 1, by elimination; empty if there is not exactly one. Rows of S sum to 1.
template <class FT>
std::vector<FT> window_limit_row(const Window_matrix<FT>& matrix)
{
  const std::size_t n = matrix.size();
  const FT tolerance = is_exact_v<FT> ? FT(0) : FT(1e-9);
  // Equations for l: a row for each column of S - 1. The first column depends on the others; the sum takes
  // its place. The right side is in column n.
  Window_matrix<FT> a(n, std::vector<FT>(n + 1, FT(0)));
  a[0].assign(n + 1, FT(1));
  for (std::size_t j = 1; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) a[j][i] = matrix[i][j] - FT(i == j ? 1 : 0);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (CGAL::abs(a[pivot][k]) < CGAL::abs(a[i][k])) pivot = i;
    if (!(tolerance < CGAL::abs(a[pivot][k]))) return {};
    std::swap(a[k], a[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || a[i][k] == FT(0)) continue;
      const FT factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j <= n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  std::vector<FT> row;
  for (std::size_t k = 0; k < n; ++k) row.push_back(a[k][n] / a[k][k]);
  return row;
}

// The windows of a mask, each made where it is met first.
template <class FT>
class Curve_windows
{
public:
  using Index = std::int64_t;
  using Window = Curve_window<FT>;

  // the points of a window behind its center, if the polygon does not end there
  template <class Mask>
  static Index half_of(const Mask& mask)
  {
    const auto width = static_cast<Index>(mask.template coefficients<double>().size());
    return (std::max)(1 - width % 2, (width - 2) / 2);
  }

  // half: half_of(mask) or more
  template <class Mask>
  Curve_windows(const Mask& mask, Index half)
    : rows_(mask)
    , half_(half)
  {
    const std::vector<double> a = mask.template coefficients<double>();
    outer_ = (std::max)(std::abs(a.front()), std::abs(a.back()));
  }

  bool is_primal() const { return rows_.is_primal(); }

  // the size of a window with both sides inside of the polygon
  Window_size full() const { return {is_primal() ? half_ : half_ - 1, half_}; }

  const Window& at(const Window_size& size)
  {
    const auto [window, is_new] = windows_.try_emplace(size);
    if (is_new) make(size, window->second);
    return window->second;
  }

private:
  using Real = Ring_eigenvectors::Real;
  using Matrix = Window_matrix<Real>;

  static constexpr Real tolerance = 1e-9L;
  // what does not shrink faster than this would spoil the curvature for many rounds
  static constexpr double settling = 0.65 / 4;
  // parts of data that shrink by more than this compared with others are hardly smaller than these
  static constexpr double converging = 0.95;

  // A side that ends with the polygon has twice as many points in the next round. The rows are made on a
  // polygon that is no longer than the window: none leaves it where it does not end there.
  void make(const Window_size& size, Window& window) const
  {
    const Index behind = is_primal() ? 2 * size.second : 2 * size.second - 1;
    window.next = {(std::min)(2 * size.first, full().first), (std::min)(behind, full().second)};
    const Index center = 2 * size.first + rows_.first_point();
    for (Index i = center - window.next.first; i <= center + window.next.second; ++i) {
      window.rows.emplace_back();
      rows_.emit_row(i, size.first + size.second + 1, Curve_end::reflect, window.rows.back());
    }
    if (window.next == size) set_functionals(window);
  }

  template <class Number>
  static Window_matrix<Number> matrix(const Window& window)
  {
    Window_matrix<Number> m;
    for (const Entry_row<FT>& row : window.rows) {
      m.emplace_back(window.rows.size(), Number(0));
      for (const auto& e : row)
        if constexpr (std::is_same_v<Number, FT> || std::is_floating_point_v<FT>)
          m.back()[e.vertex] = e.weight;
        else
          m.back()[e.vertex] = close_double(e.weight);
    }
    return m;
  }

  static Ring_row<FT> limit_row(const Window& window, [[maybe_unused]] const Matrix& reals)
  {
    Ring_row<FT> result;
    if constexpr (is_exact_v<FT>) {
      for (const FT& x : window_limit_row(matrix<FT>(window)))
        result.push_back({static_cast<std::uint32_t>(result.size()), x});
      return result;
    } else {
      Ring_matrix<FT> m;
      for (const Entry_row<FT>& row : window.rows) m.emplace_back(row.begin(), row.end());
      return limit_weights<FT>(window_limit_row(reals), m);
    }
  }

  // Left eigenvectors: the limit, and the derivatives with respect to the parameter of the points 0, 1, 2, ..., which
  // are limits of differences of points and of differences of these. These have matrices of their own, whose rows
  // sum to 1 where linear and quadratic data are reproduced.
  void set_functionals(Window& window) const
  {
    const Matrix points = matrix<Real>(window), first = of_differences(points),
                 second = of_differences(first);
    const double rest = radius(first) / 2, rest_of_first = radius(second) / 4;
    if (!(rest < converging))
      throw std::invalid_argument("PN_subdivision_3: the mask has no limit points: the powers of "
                                  "its matrix do not converge");
    for (const auto& [place, weight] : limit_row(window, points))
      if (!CGAL::certainly(weight == FT(0))) window.limit_row.add(place, weight);
    window.largest_other = (std::max)(outer_, rest);
    if (!sum_to_one(first) || (std::max)(outer_, rest_of_first) >= converging / 2) return;
    window.first_derivative = over_points(window_limit_row(first), 1);
    window.largest_other = (std::max)(outer_, rest_of_first);
    double others = window.largest_other;
    if (sum_to_one(second)) {
      others = (std::max)(outer_, radius(of_differences(second)) / 8);
      window.second_derivative = over_points(window_limit_row(second), 2);
    }
    window.has_curvature = others < settling;
  }

  // the matrix that maps differences of neighbors to twice the differences of the next round
  static Matrix of_differences(const Matrix& m)
  {
    Matrix d;
    for (std::size_t i = 1; i < m.size(); ++i) {
      d.emplace_back();
      Real sum = 0;
      for (std::size_t j = 1; j < m.size(); ++j) {
        sum += m[i - 1][j - 1] - m[i][j - 1];
        d.back().push_back(2 * sum);
      }
    }
    return d;
  }

  static bool sum_to_one(const Matrix& m)
  {
    return !m.empty() && std::all_of(m.begin(), m.end(), [](const std::vector<Real>& row) {
      Real rest = 1;
      for (const Real x : row) rest -= x;
      return std::abs(rest) <= tolerance;
    });
  }

  // a functional of differences, or of differences of these, as one of points
  static std::vector<double> over_points(std::vector<Real> f, int order)
  {
    for (; !f.empty() && order > 0; --order) {
      f.push_back(0);
      for (std::size_t j = f.size(); j-- > 0;) f[j] = (j == 0 ? 0 : f[j - 1]) - f[j];
    }
    return {f.begin(), f.end()};
  }

  static double radius(const Matrix& m)
  {
    return Ring_eigenvectors::largest_modulus(
      Ring_eigenvectors::noise(m.size(), 3), [&](std::vector<Real>& x) {
        const std::vector<Real> old = x;
        for (std::size_t i = 0; i < x.size(); ++i)
          x[i] = std::inner_product(old.begin(), old.end(), m[i].begin(), Real(0));
      });
  }

  Univariate_rows<FT> rows_;
  Index half_;
  double outer_; // the modulus of the largest eigenvalue that larger windows have besides
  std::map<Window_size, Window> windows_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CURVES_INTERNAL_CURVE_WINDOWS_H
