// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

The connectivity of a subdivision scheme: which vertices, edges and faces a refined level has, with
indices in closed form, and which row of the mask belongs to a new vertex. One object serves one
round.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::PQQ_host}
\cgalHasModels{CGAL::PN_subdivision_3::PTQ_host}
\cgalHasModels{CGAL::PN_subdivision_3::DQQ_host}
\cgalHasModels{CGAL::PN_subdivision_3::Sqrt3_host}
\cgalHasModelsEnd

\sa `PNSubdivisionMask_3`
\sa `CGAL::PN_subdivision_3::Level_connectivity`
*/
class PNSubdivisionHost_3
{
public:
  /// `Level_connectivity::Index`.
  using Index = CGAL::PN_subdivision_3::Level_connectivity::Index;

  /// the degree of all refined faces, 0 if they may differ.
  static constexpr Index refined_degree = unspecified;

  /// whether the refined level begins with the old vertices, in their order. If so, a round makes no kind of
  /// element fewer. If not, elements of the mesh that the refined level does not use are removed at the end.
  static constexpr bool keeps_vertices = unspecified;

  /// returns the numbers of elements after a round on a level of the size `s`; rounds are counted
  /// from 1. `Level_size::isolated_vertices` and `Level_size::border_valences` of the result matter
  /// only if this function itself depends on them.
  static CGAL::PN_subdivision_3::Level_size
  refined_size(const CGAL::PN_subdivision_3::Level_size& s, unsigned round);

  /// throws `std::invalid_argument` with the name of the element if the control mesh is not
  /// accepted. `names.vertex_name(v)`, `names.halfedge_name(h)` and `names.face_name(f)` return
  /// strings for the message.
  template <class Element_names>
  static void check(const CGAL::PN_subdivision_3::Level_connectivity& level,
                    const Element_names& names);

  /// prepares one round on `level`, which outlives the host.
  PNSubdivisionHost_3(const CGAL::PN_subdivision_3::Level_connectivity& level, unsigned round);

  /// \name Parents
  /// Optional: which old element a new one comes from. Attributes and visitors that are called for new elements need
  /// them; the hosts of the package have them.
  /// @{

  /// the old element that a new vertex comes from.
  CGAL::PN_subdivision_3::Element_parent parent_of_vertex(Index new_vertex) const;
  /// the old element that a new edge is a part of or lies in.
  CGAL::PN_subdivision_3::Element_parent parent_of_edge(Index new_edge) const;
  /// the old element that a new face is a part of or comes from.
  CGAL::PN_subdivision_3::Element_parent parent_of_face(Index new_face) const;
  /// optional: every edge is split in halves, and everything else lies inside the old faces. `false` if it is missing.
  static constexpr bool splits_edges = unspecified;
  /// @}

  /// writes the row of the vertex `new_vertex` of the refined level, by one call of a function of
  /// `mask`. It is called by several threads at a time.
  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index new_vertex, Stencil& s) const;

  /// sets the connectivity of the refined level, all of it: target, next and face of each
  /// half-edge, the half-edge of each vertex (on the border a border half-edge) and of each face.
  ///
  /// `child` has the functions that `CGAL::PN_subdivision_3::Level_connectivity` lists under
  /// Modification for elements: `set_target()`, `set_next()`, `set_face()`, `set_border()`,
  /// `set_halfedge_of_vertex()`, `set_isolated()` and `set_halfedge_of_face()`. It may be the
  /// user's mesh: read only from the old level. The half-edges `2 * e` and `2 * e + 1` are opposite.
  ///
  /// `for_chunks(n, f)` calls `f(begin, end)` for pieces that cover [0, `n`), by several threads
  /// in the parallel case, each of which sets elements of its own. The function may be called again
  /// after a failure of `for_chunks()`; it must not fail itself.
  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const;
};
