// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_EIGENVALUES_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_EIGENVALUES_H

#include "analysis/Extraordinary_limit.h"

#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
Moduli of eigenvalues of the matrix that maps the 1-ring of a vertex to that of its successor.
*/
template <class FT>
struct Extraordinary_eigenvalues
{
  /// the largest one of frequency 1, &lambda;: it occurs twice, and nets shrink by it.
  FT subdominant;
  /// the largest one, &mu;, besides 1 and &lambda;.
  FT largest_other;

  /// returns the factor per ring by which the oscillation of curvature is expected to change, the
  /// largest of &mu;/&lambda;<sup>2</sup>, of &lambda;, which the third order of the PN rule
  /// contributes, and of 1/(8&lambda;<sup>2</sup>), where 1/8 is the largest eigenvalue that the
  /// control points outside of the 1-ring contribute.
  FT rate() const
  {
    const FT square = subdominant * subdominant;
    return (std::max)({largest_other / square, subdominant, 1 / (8 * square)});
  }
};

namespace internal {

// The blocks of a rotationally symmetric matrix on the 1-ring, by its discrete Fourier transform;
// the diagonal vertices of quads lie half a turn of the sector after the neighbors.
template <class Scheme, class FT>
class Ring_blocks
{
public:
  using Index = Level_connectivity::Index;
  static constexpr Index kinds = Scheme::Host::refined_degree - 1; // vertex, neighbor, diagonal

  Ring_blocks(const Scheme& scheme, Index valence)
    : valence_(valence)
    , level_(scheme, valence, 2)
  {
    const unsigned round = facts_of(scheme).first_round;
    const typename Scheme::Host host(level_.level(), round);
    const auto mask = scheme.template mask<FT>(level_.level(), round);
    const auto child = level_.children(level_.net());
    for (Index a = 0; a < kinds; ++a) {
      rows_[a].clear();
      host.stencil(mask, child[level_.net().vertex(0, a > 0, a > 1)], rows_[a].row());
      rows_[a].close_row();
      check_row(rows_[a]);
    }
  }

  // how strongly the frequency in vertices of kind b acts on that in those of kind a
  FT operator()(Index frequency, Index a, Index b) const
  {
    FT sum(0);
    for (auto e = rows_[a].begin(0); e != rows_[a].end(0); ++e) {
      const auto& [s, i, j] = level_.net().place(e->vertex);
      if (i + j != b) continue;
      const std::int64_t half_steps = 2 * std::int64_t(s) + (b == 2) - (a == 2);
      sum += e->weight * cosine_weight<FT>(half_steps * frequency, 2 * std::int64_t(valence_));
    }
    return sum;
  }

private:
  void check_row(const Stencil_block<FT>& row) const
  {
    for (auto e = row.begin(0); e != row.end(0); ++e)
      if (level_.net().norm(e->vertex) > 1)
        throw std::invalid_argument(
          "PN_subdivision_3: the stencils of the scheme leave the 1-ring, so "
          "that its eigenvalues are not those of a matrix on the 1-ring");
  }

  Index valence_;
  Zoom_level<Scheme, FT> level_;
  std::array<Stencil_block<FT>, kinds> rows_;
};

// the moduli of the eigenvalues with a sum and product, the larger one first
template <class FT>
std::array<FT, 2> moduli(const FT& sum, const FT& product)
{
  const FT half = sum / 2, square = half * half - product;
  if (square < FT(0)) return {std::sqrt(product), std::sqrt(product)};
  const FT root = std::sqrt(square), larger = std::abs(half) + root;
  return {larger, std::abs(std::abs(half) - root)};
}

} // namespace internal

/*!
returns the eigenvalues of a scheme at a vertex whose 1-ring is surrounded by regular vertices.

\tparam FT `float`, `double` or `long double`
\tparam Scheme a model of `PNSubdivisionScheme_3` on `PQQ_host` or `PTQ_host`, whose stencils in the
  1-ring do not leave the 1-ring and are symmetric, as those of Catmull-Clark and Loop subdivision
\throws std::invalid_argument if the valence is less than 3, or if a stencil leaves the 1-ring
<br><b>Cost:</b> the square of the valence
*/
template <class FT = double, class Scheme>
Extraordinary_eigenvalues<FT> extraordinary_eigenvalues(const Scheme& scheme,
                                                        Level_connectivity::Index valence)
{
  if constexpr (internal::Is_any<Scheme>::value)
    return internal::on_host<Extraordinary_eigenvalues<FT>, internal::Number_call<FT>,
                             internal::Hosts::all>(
      scheme, [&](const auto& s) -> Extraordinary_eigenvalues<FT> {
        if constexpr (internal::halves_edges_v<std::decay_t<decltype(s)>>)
          return extraordinary_eigenvalues<FT>(s, valence);
        else
          throw std::invalid_argument("PN_subdivision_3: this is not known for " +
                                      internal::name_in_message(s) +
                                      ": take a scheme that splits faces as Catmull-Clark or Loop");
      });
  else {
    using Blocks = internal::Ring_blocks<Scheme, FT>;
    using Index = Level_connectivity::Index;
    const Blocks block(scheme, valence);
    Extraordinary_eigenvalues<FT> result{FT(0), FT(0)};
    const auto note_other = [&](const FT& x) {
      result.largest_other = (std::max)(result.largest_other, std::abs(x));
    };
    // frequency 0: 1 and one or two others
    FT trace(0);
    for (Index a = 0; a < Blocks::kinds; ++a) trace += block(0, a, a);
    if constexpr (Blocks::kinds == 2) {
      note_other(trace - 1);
    } else {
      const auto minor = [&](Index a, Index b) {
        return block(0, a, a) * block(0, b, b) - block(0, a, b) * block(0, b, a);
      };
      // the sum of the products of two is that of the others and their product
      const FT sum = trace - 1, product = minor(0, 1) + minor(0, 2) + minor(1, 2) - sum;
      note_other(internal::moduli(sum, product)[0]);
    }
    for (Index k = 1; 2 * k <= valence; ++k) {
      std::array<FT, 2> m{std::abs(block(k, 1, 1)), FT(0)};
      if constexpr (Blocks::kinds == 3)
        m = internal::moduli(block(k, 1, 1) + block(k, 2, 2),
                             block(k, 1, 1) * block(k, 2, 2) - block(k, 1, 2) * block(k, 2, 1));
      if (k == 1)
        result.subdominant = m[0];
      else
        note_other(m[0]);
      note_other(m[1]);
    }
    return result;
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_EIGENVALUES_H
