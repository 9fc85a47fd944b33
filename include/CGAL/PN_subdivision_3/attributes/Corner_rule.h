// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ATTRIBUTES_CORNER_RULE_H
#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_CORNER_RULE_H

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Attributes
how the values of corners are refined. Inside the charts, where values agree, the scheme's linear rows apply. At seams
and borders of charts one of the six rules applies that OpenSubdiv has for face-varying data.

Seams and borders are refined as borders of the surface. The rules differ in what stays where it is. Whatever the
rule, the value of a chart stays at three kinds of vertices: with a sharp edge inside the chart, at corners of the
surface, and where several parts of the chart meet.
*/
enum class Corner_rule {
  /// nothing else stays.
  none,
  /// the values of charts that have one face at a vertex.
  corners_only,
  /// as `corners_only`, and all values at vertices that three or more charts meet at; of two charts at a vertex,
  /// both or none are kept for sharp edges inside.
  corners_plus1,
  /// as `corners_plus1`, and the values at ends of seams inside a chart, and both values at vertices where one of
  /// two charts has one face, so also that of the concave corner beside it.
  corners_plus2,
  /// all values at seams and borders, which are straight then.
  boundaries,
  /// all values: linearly inside every face.
  all
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_ATTRIBUTES_CORNER_RULE_H
