// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ATTRIBUTE_TABLE_H
#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ATTRIBUTE_TABLE_H

#include <CGAL/PN_subdivision_3/attributes/Corner_rule.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Attributes
Numbers for all elements of one kind, `dimension` of them for each: those of element `i` are from
`values[i * dimension]` on.
*/
struct Attribute_array
{
  /// how many numbers each element has.
  std::size_t dimension = 1;
  /// the numbers, those of an element next to each other.
  std::vector<double> values;
  /// of values of corners only.
  Corner_rule rule = Corner_rule::smooth;
};

/*!
\ingroup PkgPNSubdivision3Attributes

Attributes in arrays, of which the number and the dimensions are known at run time only; see `attributes()` for maps.
Elements are numbered in the order of `vertices(mesh)`, `edges(mesh)` and `faces(mesh)` and, for corners,
`halfedge(e, mesh)` and its opposite for every edge `e` in the order of `edges(mesh)`: for a `Surface_mesh` without
removed elements, by the numbers of the descriptors. `subdivide()` reads the arrays and leaves in them the values of
the refined mesh, in its order.
*/
struct Attribute_table
{
  /// of vertices: by the scheme's linear rows.
  std::vector<Attribute_array> vertices;
  /// of corners: that of a half-edge belongs to its face, at its target. Those of border half-edges are not read,
  /// and 0 afterwards.
  std::vector<Attribute_array> corners;
  /// of edges: the halves of an edge get its values, all other edges 0.
  std::vector<Attribute_array> edges;
  /// whether `face_parents` are wanted.
  bool has_face_parents = false;
  /// for every refined face the number of the control face that it comes from, see `face_parents()`. Not read.
  std::vector<std::uint32_t> face_parents;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ATTRIBUTE_TABLE_H
