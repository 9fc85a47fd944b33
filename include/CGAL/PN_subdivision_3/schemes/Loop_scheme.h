// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_LOOP_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_LOOP_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of Loop subdivision with Loop's original weight at extraordinary vertices, as in
`CGAL::Subdivision_method_3::Loop_mask_3`.

<ul>
<li> interior edge: 3/8 for its ends, 1/8 for the two opposite vertices.
<li> interior vertex of valence n: 1 - &alpha; for the vertex and &alpha;/n for each neighbor,
     &alpha; = 5/8 - (3 + 2cos(2&pi;/n))<sup>2</sup>/64.
<li> border edge: its midpoint; border vertex: (1, 6, 1)/8 along the border.
<li> vertex without edges: itself.
</ul>

\tparam FT a field; the cosine is that of `Cosine_weights`
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Loop_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long.
  explicit Loop_mask(const Level_connectivity& level)
    : level_(level)
    , neighbor_weight_(&neighbor_weight)
  {}

  /// the row of the new vertex of an old vertex.
  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    if (level_.is_isolated(v)) return s.add(v, FT(1));
    const Index h = level_.halfedge_of_vertex(v);
    if (level_.is_border(h)) return add_along_border(level_, h, eighth_, s);
    const Index n = level_.valence(v);
    const FT weight = n == 6 ? one_16th_ : neighbor_weight_(n);
    level_.for_each_neighbor(h, [&](Index w) { s.add(w, weight); });
    if (n == 6)
      s.add(v, five_8ths_);
    else
      s.add_rest(v);
  }

  /// the row of the new vertex of an edge.
  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    const Index h = Level_connectivity::halfedge_of_edge(e);
    const Index o = Level_connectivity::opposite(h);
    if (level_.is_border(h) || level_.is_border(o)) {
      s.add(level_.target(o), half_);
      s.add(level_.target(h), half_);
      return;
    }
    s.add(level_.target(o), three_8ths_);
    s.add(level_.target(h), three_8ths_);
    s.add(level_.target(level_.next(h)), eighth_);
    s.add(level_.target(level_.next(o)), eighth_);
  }

private:
  static FT neighbor_weight(Index n)
  {
    const FT a = FT(3) + FT(2) * cosine_weight<FT>(1, n);
    return (FT(5) / FT(8) - a * a / FT(64)) / FT(int(n));
  }

  const Level_connectivity& level_;
  Weight_per_valence<FT> neighbor_weight_;
  FT half_ = FT(1) / FT(2), eighth_ = FT(1) / FT(8), one_16th_ = FT(1) / FT(16);
  FT three_8ths_ = FT(3) / FT(8), five_8ths_ = FT(5) / FT(8);
};

/*!
\ingroup PkgPNSubdivision3Schemes
Loop subdivision: `Loop_mask` on `PTQ_host`. Accepts triangles only.
\cgalModels{PNSubdivisionScheme_3}
*/
struct Loop_scheme : internal::Scheme_of_mask<PTQ_host, Loop_mask>
{
  /// with other eigenvalues at separated extraordinary vertices, in `schemes/Tuned_Loop_scheme.h`.
  class Tuned;
  /// with transfer of curvature at extraordinary vertices, in `schemes/Transfer_schemes.h`.
  class Transfer;

  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "loop"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 1;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood{0, true, true, false};

  /// along creases the rules are those of the border.
  static constexpr bool has_crease_rules = true;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_LOOP_SCHEME_H
