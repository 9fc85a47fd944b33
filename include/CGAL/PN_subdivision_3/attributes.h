// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ATTRIBUTES_H
#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Attributes
whether all edges of refined meshes that lie on control edges are parts of them. Schemes that split edges refine
attributes of edges and seams of attributes of corners, the others (Doo-Sabin, \f$ \sqrt{3} \f$) refuse both.
*/
template <class Scheme>
constexpr bool splits_edges_v = internal::Splits_edges<typename Scheme::Host>::value;

namespace parameters {

/// \ingroup PkgPNSubdivision3Attributes
/// a map whose values at vertices are refined by the rule of their type, see `Attribute_traits`: integers are labels, all else
/// is averaged by the scheme's linear rows. Keys are vertices.
template <class Map>
internal::Vertex_attribute<Map> vertex_attribute(Map map)
{
  return {map};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map of labels: each vertex gets the value of the nearest control vertex, see `Attribute_rule`. Keys are vertices, values of any
/// type that can be copied.
template <class Map>
auto nearest_attribute(Map map)
{
  using Rule = internal::Given_rule<Attribute_rule::nearest>;
  return internal::Vertex_attribute<Map, Rule>{map};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map of unit vectors, which are unit vectors again when they have been averaged. Keys are vertices.
template <class Map>
auto direction_attribute(Map map)
{
  using Rule = internal::Given_rule<Attribute_rule::direction>;
  return internal::Vertex_attribute<Map, Rule>{map};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map whose values at corners are refined: that of a half-edge belongs to its face, at its target; border
/// half-edges are neither read nor written. Keys are half-edges, values can be compared by `==`.
template <class Map>
internal::Corner_attribute<Map> corner_attribute(Map map,
                                                 Corner_rule rule = Corner_rule::corners_plus1)
{
  return {map, rule};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map whose values the halves of an edge inherit; all other new edges get `T()`. Keys are edges.
template <class Map>
internal::Edge_attribute<Map> edge_attribute(Map map)
{
  return {map};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map whose values faces inherit from the control face that they come from, see `face_parents()`. Keys are
/// faces.
template <class Map>
internal::Face_attribute<Map> face_attribute(Map map)
{
  return {map};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map that gets the parents of refined faces. Keys are faces. Values are `Control_element`s, or integers: the
/// number of the control face in the order of `faces(mesh)`. With Doo-Sabin subdivision a face that comes from an edge
/// or a vertex has the least number of the faces there.
template <class Map>
internal::Face_parents<Map> face_parents(Map map)
{
  return {map};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map that gets the control vertices, edges and faces that the refined vertices come from, lie on or lie in. Keys
/// are vertices, values `Control_element`s.
template <class Map>
internal::Vertex_parents<Map> vertex_parents(Map map)
{
  return {map};
}

/// \ingroup PkgPNSubdivision3Attributes
/// a map that gets the control edges and faces that the refined edges lie on or lie in. Keys are edges, values
/// `Control_element`s.
template <class Map>
internal::Edge_parents<Map> edge_parents(Map map)
{
  return {map};
}

} // namespace parameters

/*!
\ingroup PkgPNSubdivision3Attributes
whether a map of corners has a seam: an edge at one of whose ends the values of its two faces differ. Maps with seams
need a scheme that splits edges, see `splits_edges_v`.
\tparam Values a property map of half-edges whose values can be compared, or an `Attribute_array`
*/
template <class PolygonMesh, class Values>
bool has_seam(const PolygonMesh& mesh, const Values& values)
{
  return internal::with_mesh_access(mesh, [&](const auto& access) {
    return internal::has_seam(access, internal::checked_level(access), values);
  });
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_ATTRIBUTES_H
