// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NO_NORMAL_MAP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NO_NORMAL_MAP_H

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// stands for a normal map that the user has not given
struct No_normal_map
{};

template <class Map>
struct Key_of_map
{
  using type = typename boost::property_traits<Map>::key_type;
};
template <>
struct Key_of_map<No_normal_map>
{
  using type = void;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NO_NORMAL_MAP_H
