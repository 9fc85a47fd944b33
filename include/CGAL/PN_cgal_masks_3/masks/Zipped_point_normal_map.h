// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_MASKS_ZIPPED_POINT_NORMAL_MAP_H
#define CGAL_PN_CGAL_MASKS_3_MASKS_ZIPPED_POINT_NORMAL_MAP_H

#include <boost/property_map/property_map.hpp>

#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Ref

A vertex point map and a vertex normal map as one property map of (point, normal) pairs.
Given to a function of `CGAL::Subdivision_method_3` as `vertex_point_map`, it lets CGAL's own hosts
carry normals along.

\tparam VertexPointMap a model of `ReadWritePropertyMap` with value type `Kernel::Point_3`
\tparam VertexNormalMap a model of `ReadWritePropertyMap` with the same key type and with value
  type `Kernel::Vector_3`

Both must accept vertices that are added to the mesh after the map was made.

\cgalModels{ReadWritePropertyMap}
\sa `CGAL::PN_subdivision_3::PN_mask_3`
*/
template <class VertexPointMap, class VertexNormalMap>
class Zipped_point_normal_map
{
public:
  /// the vertex descriptor.
  using key_type = typename boost::property_traits<VertexPointMap>::key_type;
  /// a point with its normal.
  using value_type = std::pair<typename boost::property_traits<VertexPointMap>::value_type,
                               typename boost::property_traits<VertexNormalMap>::value_type>;
  /// values are made of the two maps on request.
  using reference = value_type;
  /// readable and writable.
  using category = boost::read_write_property_map_tag;

  /// zips the two maps.
  Zipped_point_normal_map(const VertexPointMap& points, const VertexNormalMap& normals)
    : points_(points)
    , normals_(normals)
  {}

  /// the point and the normal of `v`.
  friend reference get(const Zipped_point_normal_map& map, const key_type& v)
  {
    return reference(get(map.points_, v), get(map.normals_, v));
  }

  /// sets the point and the normal of `v`.
  friend void put(const Zipped_point_normal_map& map, const key_type& v, const value_type& value)
  {
    put(map.points_, v, value.first);
    put(map.normals_, v, value.second);
  }

private:
  VertexPointMap points_;
  VertexNormalMap normals_;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CGAL_MASKS_3_MASKS_ZIPPED_POINT_NORMAL_MAP_H
