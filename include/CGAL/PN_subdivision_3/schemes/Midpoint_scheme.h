// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_MIDPOINT_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_MIDPOINT_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of upsampling: old vertices are kept, and a new one is the mean of the two ends of its edge, inside as at
the border.

\tparam FT a field
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Midpoint_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long.
  explicit Midpoint_mask(const Level_connectivity& level)
    : level_(level)
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
    s.add(level_.source(h), half_);
    s.add(level_.target(h), half_);
  }

private:
  const Level_connectivity& level_;
  FT half_ = FT(1) / FT(2);
};

/*!
\ingroup PkgPNSubdivision3Schemes
Upsampling of triangles: `Midpoint_mask` on `PTQ_host`. The linear scheme refines a mesh and leaves its surface as it is;
the point-normal one bends edges into arcs between the vertices, which stay: circles where the normals are
those of a circle. Accepts triangles only.

Along its arcs the surface has no tangent planes, so that there are limit points, the vertices, but no surface normals:
`limit_points()` has the control normals in their place. Sharp edges and vertices are refused.
\cgalModels{PNSubdivisionScheme_3}
*/
struct Midpoint_scheme : internal::Scheme_of_mask<PTQ_host, Midpoint_mask>
{
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "midpoint"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 1;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood{0, true, false, true, false};
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_MIDPOINT_SCHEME_H
