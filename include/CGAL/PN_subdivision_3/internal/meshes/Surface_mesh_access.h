// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_SURFACE_MESH_ACCESS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_SURFACE_MESH_ACCESS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Element_names.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>

namespace CGAL {

// Declared, not included: Surface_mesh has a licence of its own, and whoever calls with one has it.
template <typename P>
class Surface_mesh;

namespace Properties {
template <typename I, typename T, typename CRTP_derived_class>
class Property_map_base;
}

namespace PN_subdivision_3 {
namespace internal {

// A Surface_mesh without removed elements: indices are those of the level, and the mesh grows by
// one resize() into fresh memory. (A reserve() before it would make the resize() ten times slower.)
template <class Mesh>
class Surface_mesh_access : public Element_names
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;

public:
  using Index = Level_connectivity::Index;
  using vertex_descriptor = Vertex;

  explicit Surface_mesh_access(Mesh& mesh)
    : mesh_(mesh)
  {
    old_size_.vertices = mesh.number_of_vertices();
    old_size_.edges = mesh.number_of_edges();
    old_size_.faces = mesh.number_of_faces();
  }

  // the last round of a host writes the mesh itself
  static constexpr bool is_child_of_hosts = true;
  static constexpr bool has_concurrent_connectivity = true;

  static constexpr std::uint64_t index_limit() { return Level_connectivity::null; }

  Level_size size() const { return old_size_; }
  Vertex vertex(Index v) const { return Vertex(v); }
  Halfedge halfedge_at(Index h) const { return Halfedge(h); }
  typename Mesh::Edge_index edge_at(Index e) const { return typename Mesh::Edge_index(e); }
  Face face_at(Index f) const { return Face(f); }

  std::string vertex_name(Index v) const override { return "vertex " + std::to_string(v); }
  std::string halfedge_name(Index h) const override { return "half-edge " + std::to_string(h); }
  std::string face_name(Index f) const override { return "face " + std::to_string(f); }

  void read(Level_connectivity& level) const
  {
    for (Index h = 0; h < 2 * old_size_.edges; ++h) {
      level.set_target(h, mesh_.target(Halfedge(h)));
      level.set_next(h, mesh_.next(Halfedge(h)));
      level.set_face(h, mesh_.face(Halfedge(h)));
    }
    for (Index v = 0; v < old_size_.vertices; ++v)
      level.set_halfedge_of_vertex(v, mesh_.halfedge(Vertex(v)));
    for (Index f = 0; f < old_size_.faces; ++f)
      level.set_halfedge_of_face(f, mesh_.halfedge(Face(f)));
  }

  // never smaller than before: what the user holds must be there to be put back
  void grow(const Level_size& size)
  {
    Level_size larger;
    larger.vertices = (std::max)(size.vertices, old_size_.vertices);
    larger.edges = (std::max)(size.edges, old_size_.edges);
    larger.faces = (std::max)(size.faces, old_size_.faces);
    resize(larger);
  }
  // the vertices alone
  void grow_vertices(const Level_size& size)
  {
    Level_size larger = old_size_;
    larger.vertices = (std::max)(size.vertices, old_size_.vertices);
    resize(larger);
  }
  void shrink() { resize(old_size_); }
  // removes the elements that the result does not use
  void trim(const Level_size& size, bool /*collect*/) { resize(size); }

  // the child of a host
  void set_target(Index h, Index v) { mesh_.set_target(Halfedge(h), Vertex(v)); }
  void set_next(Index h, Index n) { mesh_.set_next(Halfedge(h), Halfedge(n)); }
  void set_face(Index h, Index f) { mesh_.set_face(Halfedge(h), Face(f)); }
  void set_border(Index h) { mesh_.set_face(Halfedge(h), Mesh::null_face()); }
  void set_halfedge_of_vertex(Index v, Index h) { mesh_.set_halfedge(Vertex(v), Halfedge(h)); }
  void set_isolated(Index) {}
  void set_halfedge_of_face(Index f, Index h) { mesh_.set_halfedge(Face(f), Halfedge(h)); }

private:
  void resize(const Level_size& size)
  {
    using Size = typename Mesh::size_type;
    mesh_.resize(static_cast<Size>(size.vertices), static_cast<Size>(size.edges),
                 static_cast<Size>(size.faces));
  }

  Mesh& mesh_;
  Level_size old_size_;
};

// Whether different keys may be put by different threads: known of the maps of Surface_mesh only,
// and not of its bits.
template <class I, class T, class Map>
std::bool_constant<!std::is_same_v<T, bool>>
is_surface_mesh_map(const Properties::Property_map_base<I, T, Map>*);
std::false_type is_surface_mesh_map(const void*);

template <class I, class T, class Map>
std::true_type is_property_of_surface_mesh(const Properties::Property_map_base<I, T, Map>*);
std::false_type is_property_of_surface_mesh(const void*);

// whether all elements that a mesh gets have one and the same value in the map
template <class Property_map>
constexpr bool has_one_new_value_v =
  decltype(is_property_of_surface_mesh(static_cast<const Property_map*>(nullptr)))::value;

template <class Property_map>
constexpr bool has_concurrent_put_v =
  decltype(is_surface_mesh_map(static_cast<const Property_map*>(nullptr)))::value;

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_SURFACE_MESH_ACCESS_H
