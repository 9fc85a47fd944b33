// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_GRID_CATMULLCLARK_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_GRID_CATMULLCLARK_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_average.h>

#include <array>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of `CatmullClark_mask` for quads, with the grid around a new vertex if there is one. Its rows then hold
the vertices of up to 5 rows and columns in the order that `Grid_average` reads. Vertices that only tell curve normals
have the weight 0.

An interior vertex is irregular if its valence is not 4, a border vertex if it is neither 3 nor 2. The row of an irregular
vertex, of an edge with an irregular end and of a face with an irregular corner is that of `CatmullClark_mask`. Grid lines end at
the border, and at irregular vertices, where the lines beside them end, too. Border vertices with a single face are corners of a grid, and stay.

\tparam FT a field
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Grid_CatmullClark_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level of quads, which has to live as long.
  explicit Grid_CatmullClark_mask(const Level_connectivity& level)
    : level_(level)
    , plain_(level)
  {}

  /// the row of the new vertex of an old vertex.
  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    if (level_.is_isolated(v)) return plain_.vertex(v, s);
    const Index h = level_.halfedge_of_vertex(v);
    const bool is_border = level_.is_border(h);
    if (is_border && has_valence(h, 2)) return s.add(v, FT(1));
    if (!has_valence(h, is_border ? 3 : 4)) return plain_.vertex(v, s);
    // from v on; at the border along it
    add_grid(is_border ? level_.next(h) : Level_connectivity::opposite(h), 5, is_border ? 1 : 5, s);
  }

  /// the row of the new vertex of an edge.
  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    const Index h = Level_connectivity::halfedge_of_edge(e);
    if (is_irregular(level_.source(h)) || is_irregular(level_.target(h))) return plain_.edge(e, s);
    add_grid(h, 4, level_.is_border_edge(e) ? 1 : 5, s);
  }

  /// the row of the new vertex of a face.
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    const Index h = level_.halfedge_of_face(f);
    for (const Index g : internal::halfedges_around_face(level_, h))
      if (is_irregular(level_.target(g))) return plain_.face(f, s);
    add_grid(h, 4, 4, s);
  }

private:
  static constexpr Index null = Level_connectivity::null;
  using Vertices = std::array<Index, 25>;

  bool has_valence(Index h, int n) const
  {
    Index g = h;
    for (int i = 1; i < n; ++i) {
      g = level_.next_around_target(g);
      if (g == h) return false;
    }
    return level_.next_around_target(g) == h;
  }

  bool is_irregular(Index v) const
  {
    const Index h = level_.halfedge_of_vertex(v);
    return level_.is_border(h) ? !has_valence(h, 3) && !has_valence(h, 2) : !has_valence(h, 4);
  }

  // the half-edge that goes on from the target of h in the grid line, null if it ends there
  Index beyond(Index h) const
  {
    const Index g = level_.halfedge_of_vertex(level_.target(h)),
                o = Level_connectivity::opposite(h);
    if (!level_.is_border(g))
      return has_valence(g, 4) ? level_.next(Level_connectivity::opposite(level_.next(h))) : null;
    if (!has_valence(g, 3)) return null;
    if (level_.is_border(h)) return level_.next(h);
    if (level_.is_border(o)) return Level_connectivity::opposite(level_.prev(o));
    return null;
  }

  // the half-edge of the next row to the left of h, null on the border
  Index left(Index h) const
  {
    if (h == null || level_.is_border(h)) return null;
    return Level_connectivity::opposite(level_.next(level_.next(h)));
  }
  Index right(Index h) const { return reversed(left(reversed(h))); }

  void put(Index h, Index* cell) const
  {
    if (h == null) return;
    cell[0] = level_.source(h);
    cell[1] = level_.target(h);
  }

  // h leads from the middle vertex to the next one in its row; the rows go on to its left
  template <class Stencil>
  void add_grid(Index h, int columns, int rows, Stencil& s) const
  {
    const auto shape = internal::Grid_shape::of(columns, rows);
    const int row = shape.center / columns, column = shape.center % columns;
    std::array<Index, 4> strip;
    strip.fill(null);
    strip[column] = h;
    for (int k = column + 1; k < columns - 1 && strip[k - 1] != null; ++k)
      strip[k] = beyond(strip[k - 1]);
    for (int k = column - 1; k >= 0 && strip[k + 1] != null; --k)
      strip[k] = reversed(beyond(Level_connectivity::opposite(strip[k + 1])));
    Vertices vertices;
    vertices.fill(null);
    for (int k = 0; k < columns - 1; ++k) {
      Index g = strip[k];
      for (int r = row; r < rows; ++r, g = left(g)) put(g, &vertices[r * columns + k]);
      g = right(strip[k]);
      for (int r = row - 1; r >= 0; --r, g = right(g)) put(g, &vertices[r * columns + k]);
    }
    emit_row(shape, vertices, s);
  }
  static Index reversed(Index h) { return h == null ? null : Level_connectivity::opposite(h); }

  // Where one of the vertices with weights is irregular the lines end at these: strips of quads do not agree beyond.
  template <class Stencil>
  void emit_row(const internal::Grid_shape& shape, const Vertices& vertices, Stencil& s) const
  {
    std::array<FT, 25> weights;
    bool goes_on = true;
    for (int i = 0; i < shape.columns * shape.rows; ++i) {
      const int r = i / shape.columns, c = i % shape.columns;
      weights[i] = internal::Grid_line<FT>::weight(shape.columns, c);
      if (shape.rows > 1) weights[i] *= internal::Grid_line<FT>::weight(shape.rows, r);
      goes_on = goes_on && (weights[i] == FT(0) || !is_irregular(vertices[i]));
    }
    for (int i = 0; i < shape.entries; ++i) {
      const bool is_cell = i < shape.columns * shape.rows,
                 has_weight = is_cell && weights[i] != FT(0);
      const bool exists = is_cell && vertices[i] != null && (goes_on || has_weight);
      s.add(vertices[exists ? i : shape.center], has_weight ? weights[i] : FT(0));
    }
  }

  const Level_connectivity& level_;
  CatmullClark_mask<FT> plain_;
};

/*!
\ingroup PkgPNSubdivision3Schemes

Point-normal Catmull-Clark subdivision of quad meshes as a tensor product of curves. On regular parts the rule is
`Grid_average`, which keeps tori given by grids of their parallels and meridians, and the parallels of all surfaces of
revolution, exactly. In both directions of the grid a vertex has a normal of its own, that of the grid line.
Point-normal subdivision with one normal a vertex keeps spheres and cylinders only.

At irregular vertices, and at edges and faces beside them, the rule is that of `CatmullClark_scheme`. Near them, and on rough
data, the surface is less smooth than by that scheme (\ref PNSubdivision_grid_lines).

With equal or absent normals the result is not that of the linear scheme, since grid lines have curve normals anyway:
`linear()` is the linear scheme. Accepts quads only, and has no rules for creases, pieces, limits,
interpolation, tessellation and other schemes for the normals.
\cgalModels{PNSubdivisionScheme_3}
*/
struct CatmullClark_scheme::Grid : internal::Scheme_of_mask<PQQ_host, Grid_CatmullClark_mask>
{
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "grid-catmull-clark"; }

  /// its rows are averaged by `Grid_average`.
  static constexpr bool has_grid_rows = true;

  /// throws `std::invalid_argument` if a face is not a quad.
  template <class Element_names>
  void check(const Level_connectivity& level, const Element_names& names) const
  {
    internal::check_quadrilaterals(level, names);
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_GRID_CATMULLCLARK_SCHEME_H
