// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_BUTTERFLY_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_BUTTERFLY_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/internal/schemes/valences.h>
#include <CGAL/PN_subdivision_3/schemes/Cosine_weights.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of modified Butterfly subdivision (Zorin, Schr&ouml;der, Sweldens 1996), tension w = 0.
Old vertices are kept. An end of an edge is irregular if it is an interior vertex of valence other
than 6.

<ul>
<li> border edge: (-1, 9, 9, -1)/16 along the border.
<li> no irregular end: 1/2 for the ends, 1/8 for the two wings, -1/16 for the four vertices opposite
the wing edges; beyond a wing edge on the border, its reflection s + t - o of the vertex o inside.
<li> one irregular end of valence n: 3/4 for it and s<sub>j</sub> for its neighbors, counted from
the other end: n = 3: 5/12, -1/12, -1/12; n = 4: 3/8, 0, -1/8, 0; n &ge; 5: (1/4 + cos(2&pi;j/n) +
cos(4&pi;j/n)/2)/n. <li> two irregular ends: the mean of the two.
</ul>

The reflection at the border is the rule of OpenMesh's `ModifiedButterflyT`.

\tparam FT a field; the cosines are those of `cosine_weight()`
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Butterfly_mask
{
public:
  using Index = Level_connectivity::Index;

  explicit Butterfly_mask(const Level_connectivity& level)
    : level_(level)
    , irregular_valence_(internal::irregular_valences(level, 6))
  {}

  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    s.add(v, FT(1));
  }

  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    const Index h = Level_connectivity::halfedge_of_edge(e);
    const Index o = Level_connectivity::opposite(h);
    if (level_.is_border(h)) return border_edge(h, s);
    if (level_.is_border(o)) return border_edge(o, s);
    const Index to_source = irregular_valence_[level_.target(o)];
    const Index to_target = irregular_valence_[level_.target(h)];
    if (to_source == 0 && to_target == 0)
      regular_edge(h, o, s);
    else if (to_target == 0)
      s.add_rest(irregular_end(o, to_source, FT(1), s).vertex);
    else if (to_source == 0)
      s.add_rest(irregular_end(h, to_target, FT(1), s).vertex);
    else {
      const auto first = irregular_end(o, to_source, half_, s);
      s.add(first.vertex, first.weight);
      s.add_rest(irregular_end(h, to_target, half_, s).vertex);
    }
  }

private:
  template <class Stencil>
  void border_edge(Index border, Stencil& s) const
  {
    s.add(level_.source(level_.prev(border)), minus_16th_);
    s.add(level_.target(level_.next(border)), minus_16th_);
    s.add(level_.source(border), nine_16ths_);
    s.add(level_.target(border), nine_16ths_);
  }

  template <class Stencil>
  void regular_edge(Index h, Index o, Stencil& s) const
  {
    // what the four far points take or, reflected, give
    const Index wing_edges[4] = {level_.next(h), level_.next(level_.next(h)), level_.next(o),
                                 level_.next(level_.next(o))};
    bool inside[4];
    for (int i = 0; i < 4; ++i) {
      const Index beyond = Level_connectivity::opposite(wing_edges[i]);
      inside[i] = !level_.is_border(beyond);
      if (inside[i]) s.add(level_.target(level_.next(beyond)), minus_16th_);
    }
    // at the target of h: its wing edge in this face, and that in the other
    add_end(level_.target(h), !inside[0], !inside[3], !inside[1], !inside[2], s);
    add_end(level_.target(o), !inside[2], !inside[1], !inside[3], !inside[0], s);
    add_wing(level_.target(wing_edges[0]), !inside[0], !inside[1], s);
    add_wing(level_.target(wing_edges[2]), !inside[2], !inside[3], s);
  }

  // A far point beyond the wing edge (end, wing) is end + wing - other end: -1/16 of it.
  template <class Stencil>
  void add_end(Index end, bool own1, bool own2, bool others1, bool others2, Stencil& s) const
  {
    const int reflected = int(others1) + int(others2) - int(own1) - int(own2);
    s.add(end, reflected == 0 ? half_ : half_ + FT(reflected) / FT(16));
  }
  template <class Stencil>
  void add_wing(Index wing, bool edge1, bool edge2, Stencil& s) const
  {
    const int reflected = int(edge1) + int(edge2);
    if (reflected < 2) s.add(wing, reflected == 0 ? eighth_ : FT(1) / FT(16));
  }

  // Adds the neighbors of the target of h, an irregular vertex of valence n, with weights that sum
  // to 1/4 of the factor, and returns the target with what is missing to the factor.
  template <class Stencil>
  typename Stencil::Entry irregular_end(Index h, Index n, const FT& factor, Stencil& s) const
  {
    FT missing = factor;
    Index g = h;
    for (Index j = 0; j < n; ++j, g = level_.next_around_target(g)) {
      const FT weight = factor * irregular_weight(j, n);
      missing -= weight;
      if (weight != FT(0)) s.add(level_.source(g), weight);
    }
    return {level_.target(h), missing};
  }

  FT irregular_weight(Index j, Index n) const
  {
    if (n == 3) return j == 0 ? FT(5) / FT(12) : FT(-1) / FT(12);
    if (n == 4) return j == 0 ? FT(3) / FT(8) : (j == 2 ? FT(-1) / FT(8) : FT(0));
    const FT c1 = cosines_(j, n), c2 = cosines_(2 * std::int64_t(j), n);
    return (FT(1) / FT(4) + c1 + c2 / FT(2)) / FT(int(n));
  }

  const Level_connectivity& level_;
  std::vector<Index> irregular_valence_; // 0: regular
  Cosine_table<FT> cosines_;
  FT half_ = FT(1) / FT(2), eighth_ = FT(1) / FT(8);
  FT nine_16ths_ = FT(9) / FT(16), minus_16th_ = FT(-1) / FT(16);
};

/*!
\ingroup PkgPNSubdivision3Schemes
Modified Butterfly subdivision: `Butterfly_mask` on `PTQ_host`. Accepts triangles only, and no
interior vertex of valence 2.
\cgalModels{PNSubdivisionScheme_3}
*/
struct Butterfly_scheme
{
  using Host = PTQ_host;

  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "butterfly"; }

  template <class FT>
  Butterfly_mask<FT> mask(const Level_connectivity& level, unsigned /*round*/) const
  {
    return Butterfly_mask<FT>(level);
  }

  /// refuses an interior vertex of valence 2.
  template <class Element_names>
  static void check(const Level_connectivity& level, const Element_names& names)
  {
    internal::check_interior_valences(level, names);
  }
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_BUTTERFLY_SCHEME_H
