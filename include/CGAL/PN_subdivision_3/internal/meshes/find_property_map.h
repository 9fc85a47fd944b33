// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_FIND_PROPERTY_MAP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_FIND_PROPERTY_MAP_H

#include <optional>
#include <string>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The property map of a CGAL::Surface_mesh that has this name and type, if it has one.
// Surface_mesh::property_map() returns a pair before CGAL 6 and an optional since.
template <class Element, class Value, class Mesh>
auto find_property_map(const Mesh& mesh, const std::string& name)
{
  using Found = std::optional<typename Mesh::template Property_map<Element, Value>>;
  auto found = mesh.template property_map<Element, Value>(name);
  if constexpr (std::is_same_v<decltype(found), Found>)
    return found;
  else
    return found.second ? Found(found.first) : Found();
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_FIND_PROPERTY_MAP_H
