// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_BUTTERFLY_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_BUTTERFLY_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of modified Butterfly subdivision (Zorin, Schr&ouml;der, Sweldens 1996), tension w = 0.
Old vertices are kept. An end of an edge is irregular if it is an interior vertex of valence other
than 6.

<ul>
<li> border edge: (-1, 9, 9, -1)/16 along the border.
<li> no irregular end: 1/2 for the ends, 1/8 for the two wings, -1/16 for the four vertices opposite the wing edges.
Beyond a wing edge (s, t) on the border this is the reflection s + t - o of the vertex o inside.
<li> one irregular end of valence n: 3/4 for it and s<sub>j</sub> for its neighbors, counted from the other end.
Valence 3 has 5/12, -1/12, -1/12, valence 4 has 3/8, 0, -1/8, 0, n &ge; 5 has (1/4 + cos(2&pi;j/n) +
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
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long.
  explicit Butterfly_mask(const Level_connectivity& level)
    : level_(level)
    , irregular_valence_(internal::irregular_valences(level, 6))
  {
    for (const Index n : irregular_valence_)
      if (n != 0 && weights_.find(n) == weights_.end()) weights_.emplace(n, irregular_weights(n));
  }

  /// the row of the new vertex of an old vertex.
  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    s.add(v, FT(1));
  }

  /// the row of the new vertex of an edge.
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
    else if (to_target == 0) {
      add_neighbors(o, to_source, FT(1), s);
      s.add_rest(level_.target(o));
    } else if (to_source == 0) {
      add_neighbors(h, to_target, FT(1), s);
      s.add_rest(level_.target(h));
    } else {
      const FT rest = add_neighbors(o, to_source, half_, s);
      s.add(level_.target(o), rest);
      add_neighbors(h, to_target, half_, s);
      s.add_rest(level_.target(h));
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
    // the four points opposite the wing edges; where there is none its reflection, by the weights below
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

  // The reflection beyond the wing edge (end, wing) is end + wing - other end. It has the weight -1/16.
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

  // Adds the neighbors of the target of h, an irregular vertex of valence n, with their weights times the
  // factor. Returns the weight of the target itself: the factor minus their sum.
  template <class Stencil>
  FT add_neighbors(Index h, Index n, const FT& factor, Stencil& s) const
  {
    FT rest = factor;
    Index g = h;
    for (const FT& w : weights_.find(n)->second) {
      const FT weight = factor * w;
      rest -= weight;
      if (weight != FT(0)) s.add(level_.source(g), weight);
      g = level_.next_around_target(g);
    }
    return rest;
  }

  // the s_j
  static std::vector<FT> irregular_weights(Index n)
  {
    if (n == 3) return {FT(5) / FT(12), FT(-1) / FT(12), FT(-1) / FT(12)};
    if (n == 4) return {FT(3) / FT(8), FT(0), FT(-1) / FT(8), FT(0)};
    std::vector<FT> cosine, weights;
    for (Index j = 0; j < n; ++j) cosine.push_back(cosine_weight<FT>(j, n));
    for (std::size_t j = 0; j < n; ++j)
      weights.push_back((FT(1) / FT(4) + cosine[j] + cosine[2 * j % n] / FT(2)) / FT(int(n)));
    return weights;
  }

  const Level_connectivity& level_;
  std::vector<Index> irregular_valence_;     // 0: regular
  std::map<Index, std::vector<FT>> weights_; // for every irregular valence
  FT half_ = FT(1) / FT(2), eighth_ = FT(1) / FT(8);
  FT nine_16ths_ = FT(9) / FT(16), minus_16th_ = FT(-1) / FT(16);
};

/*!
\ingroup PkgPNSubdivision3Schemes
Modified Butterfly subdivision: `Butterfly_mask` on `PTQ_host`. Accepts triangles only, and no
interior vertex of valence 2.
\cgalModels{PNSubdivisionScheme_3}
*/
struct Butterfly_scheme : internal::Scheme_of_mask<PTQ_host, Butterfly_mask>
{
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "butterfly"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 2;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood{2, false, false, true};

  /// refuses an interior vertex of valence 2.
  template <class Element_names>
  static void check(const Level_connectivity& level, const Element_names& names)
  {
    internal::check_interior_valences(level, names);
  }

  /// see `estimated_row_entries()`: the n edges of an irregular vertex have n entries each.
  static double dense_row_entries(const Level_connectivity& level, unsigned /*round*/)
  {
    return internal::squared_irregular_valences(level, 6);
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_BUTTERFLY_SCHEME_H
