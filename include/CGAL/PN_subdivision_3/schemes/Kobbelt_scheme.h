// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_KOBBELT_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_KOBBELT_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>
#include <CGAL/Uncertain.h>

#include <stdexcept>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of Kobbelt's interpolatory scheme for quadrilaterals (Eurographics 1996) with tension w:
&alpha; = -w, &beta; = 1/2 + w. Old vertices are kept.

<ul>
<li> edge (a, b): &alpha; X(b, a) + &beta; a + &beta; b + &alpha; X(a, b), with the continuation X(u, v) of the line
     from u beyond v. Along a border edge it is the next border vertex, at a corner 2v - u, from inside to a border
     vertex 2v - u, at an interior vertex of valence 4 the opposite neighbor. At other interior vertices it is
     Kobbelt's virtual point. With the neighbors l<sub>j</sub> of v, the vertices p<sub>j</sub> opposite v between
     l<sub>j</sub> and l<sub>j+1</sub>, u = l<sub>i</sub> and &gamma; = -&alpha;/&beta; this is
     4/n &sum; l<sub>j</sub> - (l<sub>i-1</sub> + l<sub>i</sub> + l<sub>i+1</sub>) +
     &gamma; (p<sub>i-2</sub> + p<sub>i-1</sub> + p<sub>i</sub> + p<sub>i+1</sub>) - 4&gamma;/n &sum; p<sub>j</sub>.
<li> face: the four-point rule &alpha;, &beta;, &beta;, &alpha; over the points of four edges in a row, two of
     the face and those opposite to them in the next faces (beyond a border edge reflected). The direction whose edges meet fewer extraordinary vertices is
     taken, at equal count the mean of both.
</ul>

The virtual point makes both directions agree on the faces of an isolated extraordinary vertex.

\tparam FT a field
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Kobbelt_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long, with a tension.
  Kobbelt_mask(const Level_connectivity& level, const FT& tension)
    : level_(level)
    , irregular_valence_(internal::irregular_valences(level, 4))
    , alpha_(-tension)
    , beta_(FT(1) / FT(2) + tension)
    , gamma_(tension / beta_)
    , has_plain_rows_(!CGAL::certainly(alpha_ == FT(0)) &&
                      internal::magnitude(alpha_) <= internal::magnitude(beta_))
    , edge_rest_(FT(1) - (beta_ + alpha_ + alpha_))
    , face_rest_(rest_of_face_row())
  {}

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
    if (has_plain_rows_ && has_plain_ends(h)) {
      add_plain_edge(h, beta_, alpha_, s);
      return s.add(level_.source(h), edge_rest_);
    }
    Row row;
    add_edge(h, FT(1), row);
    row.emit_row(s);
  }

  /// the row of the new vertex of a face.
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    const Index h = level_.halfedge_of_face(f), across = level_.next(h);
    if (has_plain_rows_ && has_plain_strip(h) && has_plain_strip(across))
      return add_plain_strip(h, s);
    const int spokes = spokes_of_strip(h), spokes_across = spokes_of_strip(across);
    Row row;
    if (spokes < spokes_across)
      add_strip(h, FT(1), row);
    else if (spokes_across < spokes)
      add_strip(across, FT(1), row);
    else {
      add_strip(h, FT(1) / FT(2), row);
      add_strip(across, FT(1) / FT(2), row);
    }
    row.emit_row(s);
  }

private:
  using Row = internal::Merged_row<FT>;

  static Index opposite(Index h) { return Level_connectivity::opposite(h); }
  Index beyond_next(Index h) const { return level_.next(level_.next(h)); }
  bool is_border_edge(Index h) const { return level_.is_border_edge(Level_connectivity::edge(h)); }
  int is_spoke(Index h) const
  {
    return irregular_valence_[level_.target(h)] != 0 || irregular_valence_[level_.source(h)] != 0;
  }

  // the edges of the four-point rule across h and the edge opposite to it in its face
  int spokes_of_strip(Index h) const
  {
    int spokes = 0;
    for (Index g : {h, beyond_next(h)}) {
      spokes += is_spoke(g);
      if (!is_border_edge(g)) spokes += is_spoke(beyond_next(opposite(g)));
    }
    return spokes;
  }

  // \name Plain rows
  // Away from borders and irregular vertices the rows have 4 and 4 x 4 entries, whose weights are known;
  // both directions of a face give the same. Entries come in the order of the merged rows.
  // @{
  bool is_plain(Index v) const { return irregular_valence_[v] == 0 && !level_.is_border_vertex(v); }
  bool has_plain_ends(Index h) const
  {
    return is_plain(level_.target(h)) && is_plain(level_.source(h));
  }
  bool has_plain_strip(Index h) const
  {
    for (Index g : {h, beyond_next(h)})
      if (!has_plain_ends(g) || !has_plain_ends(beyond_next(opposite(g)))) return false;
    return true;
  }

  // adds the plain row of an edge, but for the source of h
  template <class Stencil>
  void add_plain_edge(Index h, const FT& beside, const FT& beyond, Stencil& s) const
  {
    s.add(level_.target(h), beside);
    s.add(plain_continuation(h), beyond);
    s.add(plain_continuation(opposite(h)), beyond);
  }
  Index plain_continuation(Index h) const
  {
    return level_.target(level_.next(level_.next_around_target(h)));
  }

  template <class Stencil>
  void add_plain_strip(Index h, Stencil& s) const
  {
    const FT inner = beta_ * beta_, mixed = alpha_ * beta_, outer = alpha_ * alpha_;
    const Index ends[2] = {h, beyond_next(h)};
    for (int i = 0; i < 2; ++i) {
      const Index next = beyond_next(opposite(ends[i]));
      if (i != 0) s.add(level_.source(ends[i]), inner);
      add_plain_edge(ends[i], inner, mixed, s);
      s.add(level_.source(next), mixed);
      add_plain_edge(next, mixed, outer, s);
    }
    s.add(level_.source(h), face_rest_);
  }

  // the weight that is left by the entries of add_plain_strip(), added in their order
  FT rest_of_face_row() const
  {
    const FT inner = beta_ * beta_, mixed = alpha_ * beta_, outer = alpha_ * alpha_;
    FT sum(0);
    for (int i = 0; i < 2; ++i) {
      if (i != 0) sum += inner;
      for (const FT& w : {inner, mixed, mixed, mixed, mixed, outer, outer}) sum += w;
    }
    return FT(1) - sum;
  }
  // @}

  void add_strip(Index h, const FT& factor, Row& row) const
  {
    const Index ends[2] = {h, beyond_next(h)};
    for (int i = 0; i < 2; ++i) {
      add_edge(ends[i], factor * beta_, row);
      if (is_border_edge(ends[i])) {
        add_edge(ends[i], FT(2) * factor * alpha_, row);
        add_edge(ends[1 - i], -factor * alpha_, row);
      } else
        add_edge(beyond_next(opposite(ends[i])), factor * alpha_, row);
    }
  }

  void add_edge(Index h, const FT& factor, Row& row) const
  {
    row.add(level_.source(h), factor * beta_);
    row.add(level_.target(h), factor * beta_);
    add_continuation(h, factor * alpha_, row);
    add_continuation(opposite(h), factor * alpha_, row);
  }

  // X(source of h, target of h)
  void add_continuation(Index h, const FT& factor, Row& row) const
  {
    const Index v = level_.target(h);
    const bool along_border = is_border_edge(h);
    if (along_border && level_.valence(v) > 2)
      row.add(next_on_border(h), factor);
    else if (level_.is_border_vertex(v)) {
      row.add(v, FT(2) * factor);
      row.add(level_.source(h), -factor);
    } else if (irregular_valence_[v] == 0)
      row.add(level_.target(level_.next(level_.next_around_target(h))), factor);
    else
      add_virtual_point(h, factor, row);
  }

  Index next_on_border(Index h) const
  {
    if (level_.is_border(h)) return level_.target(level_.next(h));
    return level_.source(level_.prev(opposite(h)));
  }

  void add_virtual_point(Index h, const FT& factor, Row& row) const
  {
    const Index n = irregular_valence_[level_.target(h)];
    const FT mean = FT(4) / FT(int(n));
    Index g = h;
    for (Index j = 0; j < n; ++j, g = level_.next_around_target(g)) {
      // how often the indices j = i-1, i, i+1 and i-2, ..., i+1 meet this one, modulo n
      const int close = (j == 0) + (j == 1) + (j == n - 1);
      const int around = (j == 0) + (j == 1) + (j == n - 1) + (j == n - 2);
      row.add(level_.source(g), factor * (mean - FT(close)));
      row.add(level_.target(beyond_next(g)), factor * gamma_ * (FT(around) - mean));
    }
  }

  const Level_connectivity& level_;
  std::vector<Index> irregular_valence_; // 0: regular
  FT alpha_, beta_, gamma_;
  bool has_plain_rows_;
  FT edge_rest_, face_rest_;
};

/*!
\ingroup PkgPNSubdivision3Schemes
Kobbelt's interpolatory scheme: `Kobbelt_mask` on `PQQ_host`. Accepts quadrilaterals only, and no
interior vertex of valence 2.
\cgalModels{PNSubdivisionScheme_3}
*/
class Kobbelt_scheme
{
public:
  /// the host of the scheme.
  using Host = PQQ_host;

  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "kobbelt"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 4;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood{2, false, false, true};
  /// the name of the parameter that the constructor takes, and its default value.
  static constexpr const char* parameter_name() { return "tension"; }
  /// the default tension.
  static constexpr double default_parameter() { return 1. / 16; }

  /// The tension is a `double` or, for exact number types, a fraction. \pre `-1/2 < tension < 1/2`
  /// \throws std::invalid_argument otherwise
  explicit Kobbelt_scheme(const Scheme_parameter& tension = default_parameter())
    : tension_(tension)
  {
    if (!(tension.to_double() > -0.5 && tension.to_double() < 0.5))
      throw std::invalid_argument(
        "PN_subdivision_3: the tension of Kobbelt's scheme must lie between -1/2 and 1/2");
  }

  /// the mask of a round; see `PNSubdivisionScheme_3`.
  template <class FT>
  Kobbelt_mask<FT> mask(const Level_connectivity& level, unsigned /*round*/) const
  {
    return Kobbelt_mask<FT>(level, tension_.value<FT>());
  }

  /// refuses a face that is not a quadrilateral, and an interior vertex of valence 2.
  template <class Element_names>
  static void check(const Level_connectivity& level, const Element_names& names)
  {
    internal::check_quadrilaterals(level, names);
    internal::check_interior_valences(level, names);
  }

  /// see `estimated_row_entries()`: at an irregular vertex of valence n, edges have 2n entries; faces have as many, merged from 16n.
  static double dense_row_entries(const Level_connectivity& level, unsigned /*round*/)
  {
    return 18 * internal::squared_irregular_valences(level, 4);
  }

private:
  Scheme_parameter tension_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_KOBBELT_SCHEME_H
