// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_CATMULLCLARK_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_CATMULLCLARK_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of Catmull-Clark subdivision for polygons of any degree, as in
`CGAL::Subdivision_method_3::CatmullClark_mask_3`.

<ul>
<li> face of degree m: 1/m each.
<li> interior edge: (a + b + f<sub>1</sub> + f<sub>2</sub>) / 4 with the two face centroids.
<li> interior vertex of valence n: Q/n + 2R/n + (n-3)v/n with the mean Q of the face centroids and
     the mean R of the edge midpoints.
<li> border edge: its midpoint; border vertex: (1, 6, 1)/8 along the border, also at corners.
<li> vertex without edges: itself.
</ul>

\tparam FT a field
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class CatmullClark_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long.
  explicit CatmullClark_mask(const Level_connectivity& level)
    : level_(level)
  {}

  /// the row of the new vertex of an old vertex.
  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    if (level_.is_isolated(v)) return s.add(v, FT(1));
    const Index h = level_.halfedge_of_vertex(v);
    if (level_.is_border(h)) return add_along_border(level_, h, eighth_, s);
    const Index n = level_.valence(v);
    if (!is_among_quads(h)) return vertex_among_polygons(h, n, s);
    if (n == 4) {
      ring_of_quads(h, three_32nds_, one_64th_, s);
      s.add(v, nine_16ths_);
    } else {
      const FT n2 = FT(int(n)) * FT(int(n));
      ring_of_quads(h, FT(3) / (FT(2) * n2), FT(1) / (FT(4) * n2), s);
      s.add_rest(v);
    }
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
    } else if (is_quad(h) && is_quad(o)) {
      s.add(level_.target(o), three_8ths_);
      s.add(level_.target(h), three_8ths_);
      other_corners_of_quad(h, s);
      other_corners_of_quad(o, s);
    } else
      edge_among_polygons(h, o, s);
  }

  /// the row of the new vertex of a face.
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    const Index h = level_.halfedge_of_face(f);
    if (is_quad(h)) {
      Index g = h;
      for (int i = 0; i < 4; ++i, g = level_.next(g)) s.add(level_.target(g), quarter_);
      return;
    }
    const FT weight = FT(1) / FT(int(level_.degree(h)));
    for (Index g = level_.next(h); g != h; g = level_.next(g)) s.add(level_.target(g), weight);
    s.add_rest(level_.target(h));
  }

  /// \name Parts of faces
  /// What a corner of the face of `h` has as such of its weight, the other parts of which belong to
  /// the edges of the face. Needed where the two faces at an edge read different values of its ends.
  /// @{

  /// in the row of the target of `h`, an interior vertex of valence `n`.
  FT face_part_of_vertex(Index h, Index n) const
  {
    return FT(1) / (FT(int(n)) * FT(int(n)) * FT(int(level_.degree(h))));
  }
  /// in the row of the edge of `h`, an interior edge.
  FT face_part_of_edge(Index h) const { return quarter_ / FT(int(level_.degree(h))); }
  /// @}

private:
  bool is_quad(Index h) const { return level_.uniform_degree() == 4 || level_.has_degree(h, 4); }

  bool is_among_quads(Index h) const
  {
    if (level_.uniform_degree() == 4) return true;
    for (const Index g : internal::halfedges_around_target(level_, h))
      if (!level_.has_degree(g, 4)) return false;
    return true;
  }

  template <class Stencil>
  void ring_of_quads(Index h, const FT& edge_weight, const FT& face_weight, Stencil& s) const
  {
    Index g = h;
    do {
      const Index out = level_.next(g);
      s.add(level_.target(out), edge_weight);
      s.add(level_.target(level_.next(out)), face_weight);
      g = Level_connectivity::opposite(out);
    } while (g != h);
  }

  // Each of the n faces gives 1/(n^2 m) to its m corners, each edge 1/n^2 to its far end.
  template <class Stencil>
  void vertex_among_polygons(Index h, Index n, Stencil& s) const
  {
    const FT w = FT(1) / (FT(int(n)) * FT(int(n)));
    FT before = w / FT(int(level_.degree(Level_connectivity::opposite(h))));
    for (const Index g : internal::halfedges_around_target(level_, h)) {
      const FT corner = w / FT(int(level_.degree(g)));
      s.add(level_.source(g), w + before + corner);
      Index c = level_.next(level_.next(g));
      for (; level_.next(c) != g; c = level_.next(c)) s.add(level_.target(c), corner);
      before = corner;
    }
    s.add_rest(level_.target(h));
  }

  template <class Stencil>
  void edge_among_polygons(Index h, Index o, Stencil& s) const
  {
    const FT w1 = quarter_ / FT(int(level_.degree(h)));
    const FT w2 = quarter_ / FT(int(level_.degree(o)));
    other_corners(h, w1, s);
    other_corners(o, w2, s);
    s.add(level_.target(o), quarter_ + w1 + w2);
    s.add_rest(level_.target(h));
  }

  template <class Stencil>
  void other_corners_of_quad(Index h, Stencil& s) const
  {
    const Index g = level_.next(h);
    s.add(level_.target(g), one_16th_);
    s.add(level_.target(level_.next(g)), one_16th_);
  }

  // The corners of the face of `h` that are not ends of `h`.
  template <class Stencil>
  void other_corners(Index h, const FT& weight, Stencil& s) const
  {
    Index g = level_.next(h);
    for (Index after = level_.next(g); after != h; after = level_.next(g)) {
      s.add(level_.target(g), weight);
      g = after;
    }
  }

  const Level_connectivity& level_;
  FT half_ = FT(1) / FT(2), quarter_ = FT(1) / FT(4), eighth_ = FT(1) / FT(8);
  FT three_8ths_ = FT(3) / FT(8), three_32nds_ = FT(3) / FT(32);
  FT one_16th_ = FT(1) / FT(16), nine_16ths_ = FT(9) / FT(16), one_64th_ = FT(1) / FT(64);
};

/*!
\ingroup PkgPNSubdivision3Schemes
Catmull-Clark subdivision: `CatmullClark_mask` on `PQQ_host`. Accepts any polygons.
\cgalModels{PNSubdivisionScheme_3}
*/
struct CatmullClark_scheme : internal::Scheme_of_mask<PQQ_host, CatmullClark_mask>
{
  /// with other eigenvalues at separated extraordinary vertices, in `schemes/Tuned_CatmullClark_scheme.h`.
  class Tuned;
  /// with transfer of curvature at extraordinary vertices, in `schemes/Transfer_schemes.h`.
  class Transfer;
  /// by grid lines, in `schemes/Grid_CatmullClark_scheme.h`.
  struct Grid;

  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "catmull-clark"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 1;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood{0, true, true, false};

  /// along creases the rules are those of the border.
  static constexpr bool has_crease_rules = true;

  /// see `estimated_row_entries()`: the corners and edges of a face of m vertices have m entries for it in the first round.
  static double dense_row_entries(const Level_connectivity& level, unsigned round)
  {
    return round == 1 ? 2 * internal::squared_irregular_degrees(level) : 0;
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_CATMULLCLARK_SCHEME_H
