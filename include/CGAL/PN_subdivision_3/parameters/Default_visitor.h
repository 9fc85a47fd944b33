// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_PARAMETERS_DEFAULT_VISITOR_H
#define CGAL_PN_SUBDIVISION_3_PARAMETERS_DEFAULT_VISITOR_H

#include <CGAL/PN_subdivision_3/parameters/Control_element.h>

#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {

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

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_PARAMETERS_DEFAULT_VISITOR_H
