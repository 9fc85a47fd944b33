// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WITH_MESH_ACCESS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WITH_MESH_ACCESS_H

#include <CGAL/PN_subdivision_3/internal/meshes/Bgl_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Surface_mesh_access.h>

#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Mesh>
constexpr bool is_surface_mesh_v = false;
template <class Point>
inline constexpr bool is_surface_mesh_v<Surface_mesh<Point>> = true;

// calls f(access) with the access that fits the mesh
template <class Mesh, class Function>
void with_mesh_access(Mesh& mesh, const Function& f)
{
  if constexpr (is_surface_mesh_v<std::remove_const_t<Mesh>>) {
    Surface_mesh_access<Mesh> access(mesh);
    f(access);
  } else {
    Bgl_mesh_access<Mesh> access(mesh);
    f(access);
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WITH_MESH_ACCESS_H
