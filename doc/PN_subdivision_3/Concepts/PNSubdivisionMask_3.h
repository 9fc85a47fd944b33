// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

The weights of a subdivision scheme on one level. A mask knows the connectivity of the level and
nothing of points, normals or threads.

Each function writes the row of one new vertex, that is old vertices with their weights, by
`Stencil::add()` and `Stencil::add_rest()`. The rows are those of `CGAL::PN_subdivision_3::Stencil`; a
host may also pass a class of its own with these two functions.

- A mask provides those of the functions that its host calls: for `PQQ_host` the functions `vertex()`,
  `edge()` and `face()`; for `PTQ_host` `vertex()` and `edge()`; for `DQQ_host` `corner()`; for
  `Sqrt3_host` `vertex()`, `face()`, `border_vertex()` and `border_edge()`. A host of your own may call
  others.
- The weights of a row sum to 1. Where they are rounded, write the last one with `add_rest()`.
- Rows are flattened: they hold old vertices only. A new edge vertex for example is written in terms of
  old vertices, not of new face vertices.
- A vertex may occur several times in a row; its weights add up. A row with a single entry is a copy
  of that vertex, with its normal.
- `vertex()` is called for border vertices and for vertices without edges too, `edge()` for border
  edges too. A border vertex is recognized by its half-edge, see `Level_connectivity`.
- The functions are called by several threads at a time, in no particular order, and possibly more
  than once for a vertex; the row must be the same each time.
- The weights are computed in `FT`, a field: make numbers of `int` only, `FT(3) / FT(8)`, so that
  they are exact in exact number types. `cosine_weight()` returns cosines in any number type.

The level outlives the mask, which may keep a reference to it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::CatmullClark_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Loop_mask}
\cgalHasModels{CGAL::PN_subdivision_3::DooSabin_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Sqrt3_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Butterfly_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Kobbelt_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Midpoint_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Bilinear_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Grid_CatmullClark_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Tuned_CatmullClark_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Tuned_Loop_mask}
\cgalHasModelsEnd

\sa `PNSubdivisionHost_3`
\sa `PNSubdivisionScheme_3`
\sa `CGAL::PN_subdivision_3::Stencil`
*/
class PNSubdivisionMask_3
{
public:
  /// `Level_connectivity::Index`.
  using Index = CGAL::PN_subdivision_3::Level_connectivity::Index;

  /// writes the row of the old vertex `v` after the round.
  template <class Stencil>
  void vertex(Index v, Stencil& stencil) const;

  /// writes the row of the new vertex of the old edge `e`.
  template <class Stencil>
  void edge(Index e, Stencil& stencil) const;

  /// writes the row of the new vertex of the old face `f`.
  template <class Stencil>
  void face(Index f, Stencil& stencil) const;

  /// writes the row of the new vertex of a corner: that of the face of `h` at the target of `h`.
  template <class Stencil>
  void corner(Index h, Stencil& stencil) const;

  /// writes the row of the old border vertex that the border half-edge `h` leads to, in a round that refines
  /// the border.
  template <class Stencil>
  void border_vertex(Index h, Stencil& stencil) const;

  /// writes the row of the new vertex `i`, 0 or 1, of the border edge of `h`, a half-edge with a face;
  /// 0 is the one at the source of `h`.
  template <class Stencil>
  void border_edge(Index h, Index i, Stencil& stencil) const;
};
