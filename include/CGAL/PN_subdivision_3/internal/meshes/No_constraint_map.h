// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NO_CONSTRAINT_MAP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NO_CONSTRAINT_MAP_H

#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// stands for a map of constraints that the user has not given
struct No_constraint_map
{};

template <class Map>
constexpr bool is_constraint_map_v = !std::is_same_v<Map, No_constraint_map>;

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NO_CONSTRAINT_MAP_H
