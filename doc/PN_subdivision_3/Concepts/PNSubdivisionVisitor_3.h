// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

What `CGAL::PN_subdivision_3::subdivide()` and `CGAL::PN_subdivision_3::subdivide_to_limit()` tell of their rounds and
of the elements of the refined mesh. A visitor needs one of these members; those that it has not, or inherits from
`CGAL::PN_subdivision_3::Default_visitor`, are not called and cost nothing. A member of one of these names that cannot
be called with these arguments is an error when the call is compiled, which shows what is expected.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::PN_subdivision_3::Control_element`
*/
class PNSubdivisionVisitor_3
{
public:
  /// is called after each round is computed, counted from 1, also of a mesh without faces. An exception of it cancels the
  /// subdivision. It must not look at the mesh, which is being written, and with `Parallel_tag` it may be called from
  /// another thread.
  void round_done(unsigned round, std::size_t number_of_faces);

  /// \name Elements
  /// These are called when the mesh is complete, for all elements of it in their order, those with an old descriptor
  /// included: first for the vertices, then for the edges, then for the faces.
  /// @{

  /// `origin` is the control element that the vertex comes from.
  void vertex_created(boost::graph_traits<PolygonMesh>::vertex_descriptor v,
                      const CGAL::PN_subdivision_3::Control_element& origin);
  /// `origin` is the control edge that the edge is a part of, or the control face that it lies in.
  void edge_created(boost::graph_traits<PolygonMesh>::edge_descriptor e,
                    const CGAL::PN_subdivision_3::Control_element& origin);
  /// `parent` is the control face that the face lies in, or what else it comes from.
  void face_created(boost::graph_traits<PolygonMesh>::face_descriptor f,
                    const CGAL::PN_subdivision_3::Control_element& parent);

  /// @}
};
