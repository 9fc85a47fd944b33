// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_SQRT3_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_SQRT3_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of \f$ \sqrt{3} \f$ subdivision (Kobbelt 2000), as in
`CGAL::Subdivision_method_3::Sqrt3_mask_3`.

<ul>
<li> face: its centroid.
<li> interior vertex of valence n: 1 - &alpha; for the vertex and &alpha;/n for each neighbor,
     &alpha; = (4 - 2cos(2&pi;/n))/9.
<li> border, even rounds: vertex (4, 19, 4)/27 along the border. New vertices on the edge (s, t) with the border
neighbors r before s and u after t: (1, 16, 10)/27 on r, s, t and (10, 16, 1)/27 on s, t, u. <li> border, odd rounds,
and vertex without edges: the vertex itself.
</ul>

\tparam FT a field; the cosine is that of `cosine_weight()`
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Sqrt3_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long.
  explicit Sqrt3_mask(const Level_connectivity& level)
    : level_(level)
    , neighbor_weight_(&neighbor_weight)
    , vertex_weight_(&vertex_weight)
  {}

  /// the row of the new vertex of an old vertex.
  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    if (level_.is_isolated(v) || level_.is_border_vertex(v)) return s.add(v, FT(1));
    const Index n = level_.valence(v);
    const FT weight = neighbor_weight_(n);
    level_.for_each_neighbor(level_.halfedge_of_vertex(v), [&](Index w) { s.add(w, weight); });
    s.add(v, vertex_weight_(n));
  }

  /// the row of the new vertex of a face.
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    const Index h = level_.halfedge_of_face(f), n = level_.next(h);
    s.add(level_.target(h), third_);
    s.add(level_.target(n), third_);
    s.add(level_.target(level_.next(n)), last_third_);
  }

  /// the old vertex that the border half-edge `border` leads to, in a round that refines the border.
  template <class Stencil>
  void border_vertex(Index border, Stencil& s) const
  {
    add_along_border(level_, border, FT(FT(4) / FT(27)), s);
  }

  /// new vertex `i` of the border edge with the face half-edge `h`, 0 at its source, 1 at its
  /// target.
  template <class Stencil>
  void border_edge(Index h, Index i, Stencil& s) const
  {
    const Index border = Level_connectivity::opposite(h);
    // along the border, which runs against h
    const Index beyond =
      i == 0 ? level_.target(level_.next(border)) : level_.source(level_.prev(border));
    const Index closer = i == 0 ? level_.source(h) : level_.target(h);
    const Index farther = i == 0 ? level_.target(h) : level_.source(h);
    s.add(beyond, FT(1) / FT(27));
    s.add(farther, FT(10) / FT(27));
    s.add_rest(closer);
  }

private:
  static FT neighbor_weight(Index n)
  {
    return (FT(4) - FT(2) * cosine_weight<FT>(1, n)) / (FT(9) * FT(int(n)));
  }

  // 1 minus the weights of the n neighbors, which are added one by one as in the row
  static FT vertex_weight(Index n)
  {
    const FT weight = neighbor_weight(n);
    FT sum(0);
    for (Index i = 0; i < n; ++i) sum += weight;
    return FT(1) - sum;
  }

  const Level_connectivity& level_;
  Weight_per_valence<FT> neighbor_weight_, vertex_weight_;
  FT third_ = FT(1) / FT(3), last_third_ = FT(1) - (third_ + third_);
};

/*!
\ingroup PkgPNSubdivision3Schemes
\f$ \sqrt{3} \f$ subdivision: `Sqrt3_mask` on `Sqrt3_host`. Accepts triangles only. The border is
refined in the even rounds of a call only.
\cgalModels{PNSubdivisionScheme_3}
*/
struct Sqrt3_scheme : internal::Scheme_of_mask<Sqrt3_host, Sqrt3_mask>
{
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "sqrt3"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 2;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood{0, true, false, false};
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_SQRT3_SCHEME_H
