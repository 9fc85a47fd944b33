// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_PARAMETERS_DEFAULT_VISITOR_H
#define CGAL_PN_SUBDIVISION_3_PARAMETERS_DEFAULT_VISITOR_H

#include <cstddef>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Attributes
An element of the control mesh, that is the mesh before the call. Refinement is in place, and the descriptor of a
control element belongs to one of its children afterwards. Hence the element is given by its position: `index` counts
the vertices, edges or faces in the order of `vertices(mesh)`, `edges(mesh)` or `faces(mesh)` before the call, from 0
on. In a `Surface_mesh` without removed elements this is the number of the descriptor.
*/
struct Control_element
{
  /// the kinds of elements.
  enum class Kind { vertex, edge, face };

  /// the kind of the element.
  Kind kind;
  /// its position among those of its kind, counted from 0.
  std::size_t index;

  /// whether they are the same element.
  friend bool operator==(const Control_element& a, const Control_element& b)
  {
    return a.kind == b.kind && a.index == b.index;
  }
  /// orders by kind, then by index.
  friend bool operator<(const Control_element& a, const Control_element& b)
  {
    return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
  }
  /// whether they are different elements.
  friend bool operator!=(const Control_element& a, const Control_element& b) { return !(a == b); }
};

namespace internal {

// What a member returns that need not be called.
struct Not_visited
{};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Attributes

A visitor of `subdivide()` that does nothing, as a base class of those that do
something: a member that hides one of these is called, the others cost nothing.

\cgalModels{PNSubdivisionVisitor_3}
\sa `Control_element`
*/
struct Default_visitor
{
  /// is called after a round.
  internal::Not_visited round_done(unsigned, std::size_t) const { return {}; }
  /// is called for every vertex of the refined mesh.
  template <class Vertex>
  internal::Not_visited vertex_created(const Vertex&, const Control_element&) const
  {
    return {};
  }
  /// is called for every edge of the refined mesh.
  template <class Edge>
  internal::Not_visited edge_created(const Edge&, const Control_element&) const
  {
    return {};
  }
  /// is called for every face of the refined mesh.
  template <class Face>
  internal::Not_visited face_created(const Face&, const Control_element&) const
  {
    return {};
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_PARAMETERS_DEFAULT_VISITOR_H
