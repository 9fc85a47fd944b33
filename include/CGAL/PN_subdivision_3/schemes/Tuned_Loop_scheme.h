// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_LOOP_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_LOOP_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/internal/numbers/Weight_number.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/Uncertain.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::PN_subdivision_3 {
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

  // the sums from d = 0 to n-1, plus a number
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

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of Loop subdivision, modified at extraordinary vertices after Prautzsch and Umlauf
(2000): the matrix that maps the 1-ring of such a vertex to the next one keeps its eigenvectors and
gets other eigenvalues.

An interior vertex of valence n other than 6 is *extraordinary*; it is *separated* if no vertex that
shares a face with it is extraordinary, too. This is decided anew in every round. A separated vertex
v, unless its valence is 2, and the edges at v have the rules below; all else is as in `Loop_mask`.

With the eigenvalues &mu;<sub>k</sub> = 3/8 + cos(2&pi;k/n)/4 of frequency k = 1, ..., n-1,
&lambda; = &mu;<sub>1</sub> and that of frequency 0, &lambda;<sup>2</sup>:
<ul>
<li> &mu;<sub>1</sub>' = &mu;<sub>n-1</sub>' = &lambda;', which is 1/2 if n is 3 or 4, and &lambda; otherwise,
<li> all others are bounded by C&lambda;'<sup>2</sup>; C is the cap. With C = 1
curvature is only bounded.
</ul>
With &alpha; = 5/8 - &lambda;<sup>2</sup> and &kappa; = (1 - (&lambda;<sup>2</sup>)')/(1 - &lambda;<sup>2</sup>),
<ul>
<li> vertex v: 1 - &alpha;&kappa; for v and &alpha;&kappa;/n for each neighbor.
<li> edge from v to its neighbor e<sub>0</sub>: 3&kappa;/8 for v, and for the neighbors
e<sub>d</sub> around v (1 - 3&kappa;/8 + &sum; &mu;<sub>k</sub>' cos(2&pi;kd/n))/n.
</ul>

\tparam FT a field. The weights of valences 3 and 4 are rational. Those of other valences are computed to the
  precision of `Gmpfr` and of number types with their own `cos()` and `acos()`, and enclosed in intervals. For other
  types they are computed with about 104 bits, and rounded to `double` for exact number types. All rows sum to 1.
<br><b>Cost:</b> of construction: linear in the size of the level. The n edges of a separated vertex of valence n have
  rows of n entries.
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Tuned_Loop_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long, with a bound of the eigenvalues.
  Tuned_Loop_mask(const Level_connectivity& level, const Scheme_parameter& cap)
    : Tuned_Loop_mask(level, 1, internal::Ring_tuning(cap, 1, Tuned_valences::all))
  {}
  /// in a round, counted from 1.
  Tuned_Loop_mask(const Level_connectivity& level, unsigned round,
                  const internal::Ring_tuning& tuning)
    : level_(level)
    , plain_(level)
  {
    const bool all = tuning.valences == Tuned_valences::all;
    if (tuning.holds_in(round))
      separated_ = {level, 6, 3, [&](Index n) { return weights(n, tuning); },
                    [all](Index n) { return all || (n != 4 && n != 5); }};
    rings_ = internal::Long_rings(level, separated_);
  }

  /// the row of the new vertex of an old vertex.
  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    const Weights* const w = separated_.at(v);
    if (w == nullptr) return plain_.vertex(v, s);
    level_.for_each_neighbor(level_.halfedge_of_vertex(v),
                             [&](Index u) { s.add(u, w->vertex_to_neighbor); });
    s.add_rest(v);
  }

  /// the row of the new vertex of an edge.
  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    const auto [h, w] = separated_.at_edge(level_, e);
    if (w == nullptr) return plain_.edge(e, s);
    const Index v = level_.target(h);
    auto weight = w->edge_to_neighbor.begin();
    rings_.for_each_neighbor(level_, h, [&](Index u) { s.add(u, *weight++); });
    s.add(v, w->edge_to_vertex);
  }

  /// the vertices with rules of their own, in ascending order.
  std::vector<Index> separated_vertices() const { return separated_.vertices(); }

private:
  struct Weights
  {
    FT vertex_to_neighbor;
    std::vector<FT> edge_to_neighbor; // from its own neighbor on
    FT edge_to_vertex; // the rest, as Stencil::add_rest() would find it for every row
  };

  // the cosines of valences 3 and 4 are rational
  static Weights weights(Index n, const internal::Ring_tuning& tuning)
  {
    using Number = internal::Weight_number<FT, internal::Has_trigonometry<FT>>;
    return n <= 4 ? tuned<FT>(n, tuning) : tuned<Number>(n, tuning);
  }

  template <class Number>
  static Weights tuned(Index n, const internal::Ring_tuning& tuning)
  {
    const internal::Tuned_Loop_frequencies<Number> frequencies(n, tuning);
    const Number size = Number(int(n)), three_8ths = Number(3) / Number(8);
    const Number lambda2 = frequencies.lambda * frequencies.lambda;
    const Number kappa =
      (Number(1) - tuning.other(lambda2, true, frequencies.new_lambda)) / (Number(1) - lambda2);

    Weights w;
    w.vertex_to_neighbor =
      internal::rounded_weight<FT>(Number((Number(5) / Number(8) - lambda2) * kappa / size));
    for (const Number& sum : frequencies.sums(Number(1) - three_8ths * kappa))
      w.edge_to_neighbor.push_back(internal::rounded_weight<FT>(Number(sum / size)));
    FT sum(0);
    for (const FT& weight : w.edge_to_neighbor) sum += weight;
    w.edge_to_vertex = FT(1) - sum;
    return w;
  }

  const Level_connectivity& level_;
  Loop_mask<FT> plain_;
  internal::Separated_vertices<Weights> separated_;
  internal::Long_rings rings_;
};

/*!
\ingroup PkgPNSubdivision3Schemes
Tuned Loop subdivision: `Tuned_Loop_mask` on `PTQ_host`. Accepts triangles only. On a mesh
without separated extraordinary vertices a round gives the same as one of `Loop_scheme`.

`Tuned(cap, first_round, valences)` takes the cap, above 0 and at most 1, by default 0.5. In a call, whose rounds are counted
from 1, the rules hold from `first_round` on, by default 1, and those of `Loop_scheme` before; they hold at `valences`, see
`Tuned_valences`, by default at all. Numbers out of their range are refused by `std::invalid_argument`. `of_the_paper(cap)` is the
policy of Yang's paper: a plain first round, and plain rules at valences 4 and 5.
\cgalModels{PNSubdivisionScheme_3}
*/
class Loop_scheme::Tuned : public internal::Tuned_scheme<Loop_scheme>
{
public:
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "modified-loop"; }

  using internal::Tuned_scheme<Loop_scheme>::Tuned_scheme;

  /// the mask of a round; see `PNSubdivisionScheme_3`.
  template <class FT>
  Tuned_Loop_mask<FT> mask(const Level_connectivity& level, unsigned round) const
  {
    return Tuned_Loop_mask<FT>(level, round, tuning_);
  }

  /// see `estimated_row_entries()`: the n edges of a separated vertex have n entries each.
  static double dense_row_entries(const Level_connectivity& level, unsigned round)
  {
    // from the second round on all are separated
    return round == 1 ? internal::squared_separated_valences(level, 6, 3)
                      : internal::squared_irregular_valences(level, 6);
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_LOOP_SCHEME_H
