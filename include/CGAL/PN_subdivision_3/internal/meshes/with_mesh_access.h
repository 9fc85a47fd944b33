// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WITH_MESH_ACCESS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WITH_MESH_ACCESS_H

#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Bgl_mesh_access.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {

// Declared, not included: Surface_mesh has a licence of its own, and whoever calls with one has it.
namespace Properties {
template <typename I, typename T, typename CRTP_derived_class>
class Property_map_base;
}

namespace PN_subdivision_3 {
namespace internal {

// The numbers of the elements of a Surface_mesh: their places or, where some are removed, their positions among the
// others; new elements come behind all places.
class Place_numbers
{
public:
  using Index = Level_connectivity::Index;

  template <class Is_removed>
  Place_numbers(std::uint64_t place_count, std::uint64_t number, const Is_removed& is_removed)
    : number_(static_cast<Index>(number))
    , removed_(static_cast<Index>(place_count - number))
  {
    if (removed_ == 0) return;
    places_.reserve(number_);
    for (Index i = 0; i < place_count; ++i)
      if (!is_removed(i)) places_.push_back(i);
  }

  bool are_places() const { return removed_ == 0; }
  Index number() const { return number_; } // of elements that are not removed
  Index place(Index i) const { return i < places_.size() ? places_[i] : i + removed_; }
  std::uint64_t places_for(std::uint64_t n) const { return n + removed_; }

  // maps places to numbers; null for places of removed elements, or beyond the last element
  class Inverse
  {
  public:
    explicit Inverse(const Place_numbers& numbers)
      : numbers_(numbers.places_.size() + numbers.removed_, Level_connectivity::null)
    {
      for (Index i = 0; i < numbers.places_.size(); ++i) numbers_[numbers.places_[i]] = i;
    }
    Index operator()(Index place) const
    {
      if (numbers_.empty()) return place;
      return place < numbers_.size() ? numbers_[place] : Level_connectivity::null;
    }

  private:
    std::vector<Index> numbers_;
  };

private:
  Index number_, removed_;
  std::vector<Index> places_; // empty if none is removed
};

// A Surface_mesh, or one of its like. It grows by one resize() into fresh memory. (A reserve() before it would make the resize() ten
// times slower.)
template <class Mesh>
class Surface_mesh_access : public Element_names
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;

public:
  using Index = Level_connectivity::Index;
  using vertex_descriptor = Vertex;

  explicit Surface_mesh_access(Mesh& mesh)
    : mesh_(mesh)
    , vertices_(mesh.num_vertices(), mesh.number_of_vertices(),
                [&](Index i) { return mesh.is_removed(Vertex(i)); })
    , edges_(mesh.num_edges(), mesh.number_of_edges(),
             [&](Index i) { return mesh.is_removed(Edge(i)); })
    , faces_(mesh.num_faces(), mesh.number_of_faces(),
             [&](Index i) { return mesh.is_removed(Face(i)); })
  {
    old_size_.vertices = vertices_.number();
    old_size_.edges = edges_.number();
    old_size_.faces = faces_.number();
  }

  // the last round of a host writes the mesh itself, if numbers are places
  static constexpr bool may_be_child_of_hosts = true;
  bool is_child_of_hosts() const
  {
    return vertices_.are_places() && edges_.are_places() && faces_.are_places();
  }
  static constexpr bool has_concurrent_connectivity = true;

  static constexpr std::uint64_t index_limit() { return Level_connectivity::null; }

  Level_size size() const { return old_size_; }
  Vertex vertex(Index v) const { return Vertex(vertices_.place(v)); }
  Halfedge halfedge_at(Index h) const { return Halfedge(2 * edges_.place(h >> 1) + (h & 1u)); }
  Edge edge_at(Index e) const { return Edge(edges_.place(e)); }
  Face face_at(Index f) const { return Face(faces_.place(f)); }

  std::string vertex_name(Index v) const override { return numbered_name("vertex", vertex(v)); }
  std::string halfedge_name(Index h) const override
  {
    return numbered_name("half-edge", halfedge_at(h));
  }
  std::string face_name(Index f) const override { return numbered_name("face", face_at(f)); }

  // an element that does not belong to the mesh becomes an invalid index
  void read(Level_connectivity& level) const
  {
    const Place_numbers::Inverse vertices(vertices_), edges(edges_), faces(faces_);
    read_connectivity(
      *this, mesh_, vertices,
      [&](Halfedge h) {
        const Index e = edges(static_cast<Index>(h) >> 1);
        return e < edges_.number() ? 2 * e + (static_cast<Index>(h) & 1u)
                                   : Level_connectivity::null;
      },
      faces, level);
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
  // Removes the elements that the result does not use and, if the user's maps follow, all that were
  // removed before. Where memory is lacking the elements removed before stay: the result is right, and
  // nothing may fail any more.
  void trim(const Level_size& size, bool collect)
  {
    if (is_child_of_hosts()) return resize(size);
    if constexpr (Refinable_mesh_traits<std::remove_const_t<Mesh>>::has_collect_garbage)
      remove_beyond(size, collect);
  }

  // the child of a host, if numbers are places
  void set_target(Index h, Index v) { mesh_.set_target(Halfedge(h), Vertex(v)); }
  void set_next(Index h, Index n) { mesh_.set_next(Halfedge(h), Halfedge(n)); }
  void set_face(Index h, Index f) { mesh_.set_face(Halfedge(h), Face(f)); }
  void set_border(Index h) { mesh_.set_face(Halfedge(h), Mesh::null_face()); }
  void set_halfedge_of_vertex(Index v, Index h) { mesh_.set_halfedge(Vertex(v), Halfedge(h)); }
  void set_isolated(Index) {}
  void set_halfedge_of_face(Index f, Index h) { mesh_.set_halfedge(Face(f), Halfedge(h)); }

  // gives the grown mesh the connectivity of the level
  template <class For_chunks>
  void write(const Level_connectivity& level, const For_chunks& for_chunks)
  {
    write_connectivity(*this, mesh_, level, for_chunks);
  }

private:
  void remove_beyond(const Level_size& size, bool collect)
  {
    for (auto f = number_of_places(mesh_.num_faces(), faces_); f > size.faces;)
      mesh_.remove_face(face_at(--f));
    for (auto e = number_of_places(mesh_.num_edges(), edges_); e > size.edges;)
      mesh_.remove_edge(edge_at(--e));
    for (auto v = number_of_places(mesh_.num_vertices(), vertices_); v > size.vertices;)
      mesh_.remove_vertex(vertex(--v));
    try {
      if (collect) mesh_.collect_garbage();
    } catch (const std::bad_alloc&) {
    }
  }

  // how many numbers have places in the mesh as it is
  static Index number_of_places(std::uint64_t place_count, const Place_numbers& numbers)
  {
    return static_cast<Index>(place_count - numbers.places_for(0));
  }

  void resize(const Level_size& size)
  {
    using Size = typename Mesh::size_type;
    mesh_.resize(static_cast<Size>(vertices_.places_for(size.vertices)),
                 static_cast<Size>(edges_.places_for(size.edges)),
                 static_cast<Size>(faces_.places_for(size.faces)));
  }

  Mesh& mesh_;
  Place_numbers vertices_, edges_, faces_;
  Level_size old_size_;
};

// the values of a map of Surface_mesh, void of other maps
template <class I, class T, class Map>
T value_in_surface_mesh(const Properties::Property_map_base<I, T, Map>*);
void value_in_surface_mesh(const void*);
template <class Map>
using Value_in_surface_mesh = decltype(value_in_surface_mesh(static_cast<const Map*>(nullptr)));

// whether all elements that a mesh gets have one and the same value in the map
template <class Map>
constexpr bool has_one_new_value_v = !std::is_void_v<Value_in_surface_mesh<Map>>;

// Whether different keys may be put by different threads: known of the maps of Surface_mesh only,
// and not of its bits.
template <class Map>
constexpr bool has_concurrent_put_v =
  has_one_new_value_v<Map> && !std::is_same_v<Value_in_surface_mesh<Map>, bool>;

// returns f(access) with the access that fits the mesh
template <class Mesh, class Function>
auto with_mesh_access(Mesh& mesh, const Function& f)
{
  constexpr bool has_slots = Refinable_mesh_traits<std::remove_const_t<Mesh>>::has_slots;
  std::conditional_t<has_slots, Surface_mesh_access<Mesh>, Bgl_mesh_access<Mesh>> access(mesh);
  return f(access);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WITH_MESH_ACCESS_H
