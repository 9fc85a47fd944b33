// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

The connectivity of a subdivision scheme: which new vertices, edges and faces a level has, with
indices in closed form, and which row of the mask belongs to a new vertex.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::PQQ_host}
\cgalHasModels{CGAL::PN_subdivision_3::PTQ_host}
\cgalHasModelsEnd
*/
class PNSubdivisionHost_3
{
public:
  using Index = CGAL::PN_subdivision_3::Level_connectivity::Index;

  /// returns the numbers of elements after one round on a level of the size `s`.
  static CGAL::PN_subdivision_3::Level_size
  refined_size(const CGAL::PN_subdivision_3::Level_size& s, unsigned round);

  /// throws `std::invalid_argument` with the name of the element if `level` is not accepted.
  template <class Element_names>
  static void check(const CGAL::PN_subdivision_3::Level_connectivity& level,
                    const Element_names& names);

  /// prepares one round on `level`.
  PNSubdivisionHost_3(const CGAL::PN_subdivision_3::Level_connectivity& level, unsigned round);

  /// writes the row of the vertex `new_vertex` of the refined level by one call of `mask`.
  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index new_vertex, Stencil& s) const;

  /// sets the connectivity of the refined level. `for_chunks(n, function)` calls `function(begin,
  /// end)` for chunks of the range [0, `n`), possibly by several threads.
  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const;
};
