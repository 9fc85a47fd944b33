// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

An object that `CGAL::PN_subdivision_3::subdivide()` and `CGAL::PN_subdivision_3::subdivide_to_limit()` call for each
round and for the elements of the refined mesh. A visitor needs at least one of these members; missing ones, and those
inherited from `CGAL::PN_subdivision_3::Default_visitor`, are not called and cost nothing. A member with one of these
names that cannot be called with these arguments is a compile-time error, which shows what is expected.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::PN_subdivision_3::Control_element`
*/
class PNSubdivisionVisitor_3
{
public:
  /// is called after each round is computed, counted from 1, even for a mesh without faces. If it throws, the subdivision
  /// is canceled. It must not look at the mesh, which is being written, and with `Parallel_tag` it may be called from
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
  /// `parent` is the control face that the face lies in, or the element that it comes from.
  void face_created(boost::graph_traits<PolygonMesh>::face_descriptor f,
                    const CGAL::PN_subdivision_3::Control_element& parent);

  /// @}
};
