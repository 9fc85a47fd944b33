// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_MESHES_REFINABLE_MESH_TRAITS_H
#define CGAL_PN_SUBDIVISION_3_MESHES_REFINABLE_MESH_TRAITS_H

// Declared, not included: whoever calls with one of these meshes has it.
namespace OpenMesh {
template <class Traits>
class PolyMesh_ArrayKernelT;
template <class Traits>
class TriMesh_ArrayKernelT;
} // namespace OpenMesh

namespace CGAL {

template <typename P>
class Surface_mesh;

namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Functions
/// what any model of `MutableFaceGraph` can do.
struct Any_mesh_traits
{
  /// `resize(v, e, f)` of the mesh drops its last elements, without an exception and without a trace.
  static constexpr bool has_resize = false;
  /// removed elements are recycled by `add_vertex()` unless `set_recycle_garbage(false)` is called.
  static constexpr bool recycles = false;
  /// the mesh has `has_garbage()` and `collect_garbage()`.
  static constexpr bool has_collect_garbage = false;
  /// `adjust_outgoing_halfedge(v)` of the mesh lets a border vertex show its border.
  static constexpr bool has_adjust_outgoing_halfedge = false;
  /// different threads may set the connectivity of different elements at the same time.
  static constexpr bool has_concurrent_connectivity = false;
  /// elements are numbers of slots, and the mesh has the members of `Surface_mesh` that number, link and resize them:
  /// `Vertex_index` and its like, `num_vertices()`, `number_of_vertices()`, `is_removed()`, `target()`, `set_target()` and so on.
  /// It is then read and written without tables of its elements.
  static constexpr bool has_slots = false;
};

namespace internal {

struct Surface_mesh_traits : Any_mesh_traits
{
  static constexpr bool has_resize = true;
  static constexpr bool recycles = true;
  static constexpr bool has_collect_garbage = true;
  static constexpr bool has_slots = true;
  static constexpr bool has_concurrent_connectivity = true;
};

struct Openmesh_traits : Any_mesh_traits
{
  static constexpr bool has_resize = true;
  static constexpr bool has_adjust_outgoing_halfedge = true;
};

template <class P>
Surface_mesh_traits known_mesh_traits(const Surface_mesh<P>*);
template <class T>
Openmesh_traits known_mesh_traits(const OpenMesh::PolyMesh_ArrayKernelT<T>*);
template <class T>
Openmesh_traits known_mesh_traits(const OpenMesh::TriMesh_ArrayKernelT<T>*);
Any_mesh_traits known_mesh_traits(const void*);

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

The abilities of a mesh beyond `MutableFaceGraph`. Known are `Surface_mesh`, the array kernels of OpenMesh, and meshes
derived from these; of every other mesh nothing is assumed. Specialize it for a mesh of your own, deriving from
`Any_mesh_traits`, to have it written by several threads or shrunk at once.
*/
template <class PolygonMesh>
struct Refinable_mesh_traits
  : decltype(internal::known_mesh_traits(static_cast<const PolygonMesh*>(nullptr)))
{};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_MESHES_REFINABLE_MESH_TRAITS_H
