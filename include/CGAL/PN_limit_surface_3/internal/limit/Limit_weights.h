// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WEIGHTS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WEIGHTS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_eigenvectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/Weight_number.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The fraction of small terms that a weight is but for rounding, by its continued fraction.
inline std::optional<std::pair<int, int>> as_fraction(long double x)
{
  const bool negative = x < 0;
  long double rest = std::abs(x);
  std::int64_t p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  for (int k = 0; k < 12; ++k) {
    const long double whole = std::floor(rest);
    if (whole > 1e6L) break;
    const auto a = static_cast<std::int64_t>(whole);
    const std::int64_t p = a * p1 + p0, q = a * q1 + q0;
    if (q > 100000) break;
    p0 = p1;
    q0 = q1;
    p1 = p;
    q1 = q;
    const long double value = static_cast<long double>(p) / static_cast<long double>(q);
    if (std::abs(value - std::abs(x)) <= 1e-15L)
      return std::make_pair(static_cast<int>(negative ? -p : p), static_cast<int>(q));
    if (rest - whole <= 0) break;
    rest = 1 / (rest - whole);
  }
  return std::nullopt;
}

// The row l with l S = l and sum 1 as precisely as the number type is: that of double is corrected by what
// it leaves, each time by some 40 bits more. Of intervals it contains the rows of all matrices in S.
template <class FT>
class Limit_row
{
public:
  // the row of a matrix whose powers converge, so that there is exactly one such row
  explicit Limit_row(const Ring_matrix<FT>& matrix)
    : places_(places(matrix))
    , rows_(places_.size())
  {
    std::vector<std::size_t> number(matrix.size(), 0);
    for (std::size_t k = 0; k < places_.size(); ++k) number[places_[k]] = k;
    for (std::size_t k = 0; k < places_.size(); ++k)
      for (const auto& [j, weight] : matrix[places_[k]])
        if (!CGAL::certainly(weight == FT(0))) rows_[k].emplace_back(number[j], weight);
    if (places_.size() > 1) invert();
  }

  Ring_row<FT> operator()() const
  {
    const std::uint32_t first = places_.front();
    if (places_.size() == 1) return {{first, FT(1)}};
    Vector x;
    for (const Reals& r : inverse_) x.emplace_back(static_cast<double>(r[0]));
    improve(x);
    if constexpr (is_interval_v<FT>)
      widen(x);
    else
      round(x);
    Ring_row<FT> row;
    for (std::size_t k = 0; k < x.size(); ++k)
      if (!CGAL::certainly(x[k] == FT(0))) row.push_back({places_[k], x[k]});
    return row;
  }

private:
  using Real = long double;
  using Reals = std::vector<Real>;
  using Vector = std::vector<FT>;

  // the points of the ring that the first one comes to depend on, ascending: all others have the weight 0
  static std::vector<std::uint32_t> places(const Ring_matrix<FT>& matrix)
  {
    std::vector<char> is_reached(matrix.size(), 0);
    std::vector<std::uint32_t> result{0};
    is_reached[0] = 1;
    for (std::size_t k = 0; k < result.size(); ++k)
      for (const auto& [j, weight] : matrix[result[k]])
        if (is_reached[j] == 0 && !CGAL::certainly(weight == FT(0))) {
          is_reached[j] = 1;
          result.push_back(j);
        }
    std::sort(result.begin(), result.end());
    return result;
  }

  [[noreturn]] static void fail()
  {
    throw std::domain_error("PN_subdivision_3: the precision of the number type does not determine "
                            "the limit mask: use a higher precision");
  }

  // The equations: that the weights sum to 1, and of the columns of S - 1 all but the first, which depends on
  // the others as the rows of S sum to 1.
  void invert()
  {
    const std::size_t n = rows_.size();
    std::vector<Reals> a(n, Reals(2 * n, Real(0)));
    std::fill_n(a[0].begin(), n, Real(1));
    for (std::size_t j = 0; j < n; ++j)
      for (const auto& [k, weight] : rows_[j])
        if (k != 0) a[k][j] += CGAL::to_double(weight);
    for (std::size_t k = 0; k < n; ++k) {
      if (k != 0) a[k][k] -= 1;
      a[k][n + k] = 1;
    }
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k; i < n; ++i)
        if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
      if (!(std::abs(a[pivot][k]) > 0)) fail();
      std::swap(a[k], a[pivot]);
      const Real factor = 1 / a[k][k];
      for (Real& x : a[k]) x *= factor;
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k || a[i][k] == 0) continue;
        const Real of_k = a[i][k];
        for (std::size_t j = k; j < 2 * n; ++j) a[i][j] -= of_k * a[k][j];
      }
    }
    for (const Reals& row : a)
      inverse_.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(n), row.end());
  }

  FT inverse(std::size_t i, std::size_t j) const { return FT(static_cast<double>(inverse_[i][j])); }

  // the residual of the equations at x, times the inverse
  Vector correction(const Vector& x) const
  {
    Vector rest(x);
    FT sum(0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += x[i];
      for (const auto& [k, weight] : rows_[i]) rest[k] -= x[i] * weight;
    }
    rest[0] = FT(1) - sum;
    Vector result(x.size(), FT(0));
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t k = 0; k < x.size(); ++k) result[i] += inverse(i, k) * rest[k];
    return result;
  }

  // until the corrections are those of rounding; of intervals x has no width
  void improve(Vector& x) const
  {
    FT last(0);
    for (int step = 0; step < 10000; ++step) {
      const Vector d = correction(x);
      FT largest(0);
      for (std::size_t k = 0; k < x.size(); ++k) {
        FT change = d[k];
        if constexpr (is_interval_v<FT>) {
          const FT next = middle(FT(x[k] + d[k]));
          change = middle(FT(next - x[k]));
          x[k] = next;
        } else
          x[k] += change;
        change = CGAL::abs(change);
        if (CGAL::certainly(largest < change)) largest = change;
      }
      if (!CGAL::certainly(FT(0) < largest)) return;
      if (step != 0 && !CGAL::certainly(FT(4) * largest < last)) return;
      last = largest;
    }
  }

  // With R for the inverse, A for the matrix of the equations and e = R (b - A x) the solution differs from
  // x + e by no more than a |e| / (1 - a), where a = |1 - R A| < 1.
  void widen(Vector& x) const
  {
    using Bounds = Interval_bounds<FT>;
    const std::size_t n = x.size();
    const Vector e = correction(x);
    auto largest = Bounds::upper(FT(0)), norm = largest;
    for (std::size_t i = 0; i < n; ++i) {
      FT sum(0);
      for (std::size_t j = 0; j < n; ++j) {
        FT product = inverse(i, 0) - FT(i == j ? 1 : 0);
        if (j != 0) product -= inverse(i, j);
        for (const auto& [k, weight] : rows_[j])
          if (k != 0) product += inverse(i, k) * weight;
        sum += CGAL::abs(product);
      }
      norm = (std::max)(norm, Bounds::upper(sum));
      largest = (std::max)(largest, Bounds::upper(CGAL::abs(e[i])));
    }
    const FT a(norm);
    if (!CGAL::certainly(a < FT(1))) fail();
    const FT radius = a * FT(largest) / (FT(1) - a);
    for (std::size_t k = 0; k < n; ++k) x[k] += e[k] + symmetric_interval<FT>(1) * radius;
  }

  // takes fractions that are as near as rounding tells; the largest weight is what the others leave of 1
  void round(Vector& x) const
  {
    const FT tolerance = FT(64) * FT(static_cast<int>(x.size())) * machine_epsilon<FT>();
    std::size_t largest = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const auto approximate = static_cast<double>(CGAL::to_double(x[k]));
      const auto fraction = as_fraction(approximate);
      if (fraction) {
        const FT exact = FT(fraction->first) / FT(fraction->second);
        if (CGAL::abs(FT(exact - x[k])) <= tolerance) x[k] = exact;
      }
      if (std::abs(approximate) > std::abs(static_cast<double>(CGAL::to_double(x[largest]))))
        largest = k;
    }
    FT sum(0);
    for (std::size_t k = 0; k < x.size(); ++k)
      if (k != largest) sum += x[k];
    x[largest] = FT(1) - sum;
  }

  std::vector<std::uint32_t> places_;
  std::vector<std::vector<std::pair<std::size_t, FT>>> rows_; // of S, over places_
  std::vector<Reals> inverse_;
};

// whether a row times the matrix is the row, exactly
template <class FT>
bool is_left_eigenvector(const Ring_row<FT>& row, const Ring_matrix<FT>& matrix)
{
  std::vector<FT> difference(matrix.size(), FT(0));
  for (const auto& [i, x] : row) {
    difference[i] -= x;
    for (const auto& [j, weight] : matrix[i]) difference[j] += x * weight;
  }
  return std::all_of(difference.begin(), difference.end(), [](const FT& x) { return x == FT(0); });
}

// The limit mask in the number type FT. The weights sum to 1 as those of all rows do: the largest
// comes last and is what the others leave. In exact types they are the fractions that they are close
// to, if these make it the limit mask exactly; otherwise they are rounded, as those of the rows are. Other
// types than those of the processor get them from the matrix, with all the precision that they have.
template <class FT>
Ring_row<FT> limit_weights(const Ring_eigenvectors::Vector& limit,
                           [[maybe_unused]] const Ring_matrix<FT>& matrix)
{
  if constexpr (!is_exact_v<FT> && !std::is_floating_point_v<FT>) return Limit_row<FT>(matrix)();
  std::size_t largest = 0;
  for (std::size_t i = 0; i < limit.size(); ++i)
    if (std::abs(limit[i]) > std::abs(limit[largest])) largest = i;
  const auto row_of = [&](const auto& weight_of) {
    Ring_row<FT> row;
    FT sum(0);
    for (std::size_t i = 0; i < limit.size(); ++i) {
      if (i == largest || std::abs(limit[i]) <= 1e-17L) continue;
      row.push_back({static_cast<std::uint32_t>(i), weight_of(limit[i])});
      sum += row.back().weight;
    }
    row.push_back({static_cast<std::uint32_t>(largest), FT(FT(1) - sum)});
    return row;
  };
  if constexpr (is_exact_v<FT>) {
    auto row = row_of([](long double x) {
      const auto fraction = as_fraction(x);
      return fraction ? FT(FT(fraction->first) / FT(fraction->second)) : rounded_weight<FT>(x);
    });
    if (is_left_eigenvector<FT>(row, matrix)) return row;
  }
  return row_of([](long double x) { return rounded_weight<FT>(x); });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_WEIGHTS_H
