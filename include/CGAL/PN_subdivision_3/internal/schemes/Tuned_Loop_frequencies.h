// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_TUNED_LOOP_FREQUENCIES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_TUNED_LOOP_FREQUENCIES_H

#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/scheme_parts/Cosine_weights.h>
#include <CGAL/Uncertain.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The new eigenvalues mu_k' of frequencies k = 1, ..., n-1 of Loop's ring matrix, and the sums over k of
// mu_k' cos(2 pi k d / n) for all d.
template <class Number>
class Tuned_Loop_frequencies
{
public:
  Tuned_Loop_frequencies(std::int64_t valence, const Ring_tuning& tuning)
    : lambda(Number(3) / Number(8) + cosine_weight<Number>(1, valence) / Number(4))
    , new_lambda(valence <= 4 ? Number(Number(1) / Number(2)) : lambda)
    , n_(valence)
    , tuning_(tuning)
  {}

  // lambda = mu_1, and mu_1'
  Number lambda, new_lambda;

  // from d = 0 to n-1, plus a number
  std::vector<Number> sums(const Number& constant) const
  {
    constexpr std::int64_t longest_added = 64;
    return n_ <= longest_added ? added_sums(constant) : closed_sums(constant);
  }
  // n^2 terms; at valences 3 and 4 rational
  std::vector<Number> added_sums(const Number& constant) const
  {
    std::vector<Number> cosine, eigenvalue, sums;
    for (std::int64_t k = 0; k < n_; ++k) {
      cosine.push_back(cosine_weight<Number>(k, n_));
      eigenvalue.push_back(new_eigenvalue(k, old_eigenvalue(cosine.back())));
    }
    const auto n = static_cast<std::size_t>(n_);
    for (std::size_t d = 0; d < n; ++d) {
      Number sum = constant;
      for (std::size_t k = 1, kd = d; k < n; ++k, kd = (kd + d) % n)
        sum += eigenvalue[k] * cosine[kd];
      sums.push_back(sum);
    }
    return sums;
  }
  // The eigenvalues are the bound but for frequencies +-1 and +-2, and for a window of low ones, those of
  // frequencies m to n-m, whose sum with W(j) = sum of cos(2 pi k j / n) over the window is
  // (3/8 - bound) W(d) + (W(d-1) + W(d+1))/8. \pre n > 4
  std::vector<Number> closed_sums(const Number& constant) const
  {
    const Number bound = tuning_.other(Number(1), false, new_lambda); // 1 is above it
    const Number first = Number(2) * (new_lambda - bound);
    const std::vector<Number> cosine = table([&](std::int64_t k) { return turn(k); });
    const Number second = Number(2) * (new_eigenvalue(2, old_eigenvalue(cosine[2])) - bound);
    const std::vector<Number> window = window_sums(bound);
    const Number share = Number(3) / Number(8) - bound;
    std::vector<Number> sums;
    for (std::int64_t d = 0; d < n_; ++d) {
      Number sum = constant - bound + first * at(cosine, d) + second * at(cosine, 2 * d);
      if (d == 0) sum += bound * Number(int(n_));
      sum += share * at(window, d) + (at(window, d - 1) + at(window, d + 1)) / Number(8);
      sums.push_back(sum);
    }
    return sums;
  }

private:
  static Number old_eigenvalue(const Number& cosine)
  {
    return Number(3) / Number(8) + cosine / Number(4);
  }
  Number turn(std::int64_t k) const { return cosine_weight<Number>(k, n_); }

  Number new_eigenvalue(std::int64_t k, const Number& old) const
  {
    if (k == 1 || k == n_ - 1) return new_lambda;
    return tuning_.other(old, k == 2 || k == n_ - 2, new_lambda);
  }

  // the first frequency from 3 on that is not certainly above the bound; they descend up to n/2
  std::int64_t window_begin(const Number& bound) const
  {
    std::int64_t begin = 3, end = n_ / 2 + 1;
    while (begin < end) {
      const std::int64_t middle = begin + (end - begin) / 2;
      if (CGAL::certainly(bound < old_eigenvalue(turn(middle))))
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  // W(j) = -sin((2m-1) pi j / n) / sin(pi j / n), since all frequencies together have the sum 0
  std::vector<Number> window_sums(const Number& bound) const
  {
    const std::int64_t m = window_begin(bound);
    const auto n = static_cast<std::size_t>(n_);
    std::vector<Number> window(n, Number(0));
    if (2 * m > n_) return window;
    const std::vector<Number> sine = // of multiples of pi / n
      table([&](std::int64_t j) { return cosine_weight<Number>(n_ - 2 * j, 4 * n_); });
    window[0] = Number(int(n_ - 2 * m + 1));
    for (std::size_t j = 1; j < n; ++j) {
      const std::size_t multiple = static_cast<std::size_t>(2 * m - 1) * j % (2 * n);
      const Number quotient = sine[multiple % n] / sine[j];
      window[j] = multiple < n ? Number(-quotient) : quotient;
    }
    return window;
  }
  // f(0), ..., f(n-1), where f(n-k) = f(k)
  template <class Function>
  std::vector<Number> table(const Function& f) const
  {
    std::vector<Number> values(static_cast<std::size_t>(n_));
    for (std::int64_t k = 0; 2 * k <= n_; ++k)
      values[static_cast<std::size_t>(k)] = values[static_cast<std::size_t>((n_ - k) % n_)] = f(k);
    return values;
  }
  const Number& at(const std::vector<Number>& values, std::int64_t j) const
  {
    return values[static_cast<std::size_t>((j + n_) % n_)];
  }

  std::int64_t n_;
  const Ring_tuning& tuning_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_TUNED_LOOP_FREQUENCIES_H
