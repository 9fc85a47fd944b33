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
#include <CGAL/PN_subdivision_3/internal/schemes/Merged_row.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Tuned_Loop_frequencies.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/Cosine_weights.h>
#include <CGAL/PN_subdivision_3/scheme_parts/Scheme_parameter.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

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
\cgalModels{PNSubdivisionScheme_3}
*/
class Loop_scheme::Tuned
{
public:
  /// the host of the scheme.
  using Host = PTQ_host;

  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "modified-loop"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 3;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood{1, true, true, false};
  /// the name of the parameter that the constructor takes, and its default value.
  static constexpr const char* parameter_name() { return "cap"; }
  /// the default cap.
  static constexpr double default_parameter() { return 0.5; }

  /// along creases the rules are those of the border.
  static constexpr bool has_crease_rules = true;

  /*!
  The rules of the tuned scheme hold from round `first_round` of a call on, those of `Loop_scheme`
  before; the rounds of every call are counted from 1. They hold at `valences`.
  \pre `0 < cap <= 1`, `first_round >= 1`
  \throws std::invalid_argument otherwise
  */
  explicit Tuned(const Scheme_parameter& cap = default_parameter(), unsigned first_round = 1,
                 Tuned_valences valences = Tuned_valences::all)
    : tuning_(cap, first_round, valences)
  {}

  /// the policy of Yang's paper: a plain first round, and plain rules at valences 4 and 5.
  static Loop_scheme::Tuned of_the_paper(const Scheme_parameter& cap = default_parameter())
  {
    return Loop_scheme::Tuned(cap, 2, Tuned_valences::diverging);
  }

  /// the first round with tuned weights.
  unsigned first_round() const { return tuning_.first_round; }
  /// the valences with tuned weights.
  Tuned_valences valences() const { return tuning_.valences; }

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

private:
  internal::Ring_tuning tuning_;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_LOOP_SCHEME_H
