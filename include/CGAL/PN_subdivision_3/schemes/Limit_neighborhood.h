// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_LIMIT_NEIGHBORHOOD_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_LIMIT_NEIGHBORHOOD_H

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

What has to be regular around a vertex for a scheme to do there, from now on, the same in every round: to map the
ring of the vertex to that of its successor by one matrix. A scheme has a static constant `limit_neighborhood` of this
type; without it, these are the defaults, which serve all schemes with masks no larger than those of the package.
*/
struct Limit_neighborhood
{
  /// in how many rings the other vertices have to be regular. With 0 the rules at a vertex depend on its valence and
  /// the degrees of its faces alone.
  unsigned regular_rings = 2;
  /// whether these vertices may lie on the border.
  bool takes_border = false;
  /// whether the surface is one of piecewise polynomials where all vertices are regular.
  bool is_spline = false;
  /// whether vertices keep their points and normals.
  bool keeps_points = false;
  /// whether the surface has tangent planes. Where it has none, control normals stand in for its normals; vertices
  /// then have to keep their points.
  bool has_tangent_planes = true;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_LIMIT_NEIGHBORHOOD_H
