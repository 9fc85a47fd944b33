// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

The weights of a subdivision scheme. A mask knows the connectivity of a level and nothing of points,
normals or threads. Each function writes the row of one new vertex: old vertices and their weights,
whose sum is 1. Rows are flattened: a new edge vertex for example is given by old vertices, not by
new face vertices. A mask provides those of the functions that its host calls; they may be called by
several threads at once.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::CatmullClark_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Loop_mask}
\cgalHasModelsEnd
*/
class PNSubdivisionMask_3
{
public:
  using Index = CGAL::PN_subdivision_3::Level_connectivity::Index;

  /// writes the row of the new vertex of the old vertex `v`.
  template <class Stencil>
  void vertex(Index v, Stencil& stencil) const;

  /// writes the row of the new vertex of the old edge `e`.
  template <class Stencil>
  void edge(Index e, Stencil& stencil) const;

  /// writes the row of the new vertex of the old face `f`.
  template <class Stencil>
  void face(Index f, Stencil& stencil) const;
};
