// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_BGL_MESH_ACCESS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_BGL_MESH_ACCESS_H

#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/meshes/Refinable_mesh_traits.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Descriptor>
using Idx_of = decltype(std::declval<const Descriptor&>().idx());
template <class Descriptor>
using Has_idx = boost::is_detected<Idx_of, Descriptor>;

// Names of elements in messages: the descriptor's own number where it has one, otherwise the
// position in the order of iteration.
template <class Descriptor>
std::string element_name(const char* kind, const Descriptor& d, std::size_t position)
{
  if constexpr (std::is_convertible_v<Descriptor, std::size_t>)
    return numbered_name(kind, static_cast<std::size_t>(d));
  else if constexpr (Has_idx<Descriptor>::value)
    return numbered_name(kind, static_cast<std::size_t>(d.idx()));
  else
    return std::string(kind) + " number " + std::to_string(position);
}

// What no index of the mesh may reach: the null value of the mesh's own index type if it has one,
// and that of the levels.
template <class Descriptor>
constexpr std::uint64_t index_limit()
{
  if constexpr (Has_idx<Descriptor>::value) {
    using Index = std::decay_t<Idx_of<Descriptor>>;
    constexpr auto largest = static_cast<std::uint64_t>((std::numeric_limits<Index>::max)());
    return largest < Level_connectivity::null ? largest : Level_connectivity::null;
  } else
    return Level_connectivity::null;
}

// While elements are added to a mesh that recycles removed ones, it must not: the order of vertices
// would be lost, and if the copy of a property's default value fails while a place is recycled,
// Surface_mesh counts its removed elements wrongly. Meshes that do not recycle need nothing.
template <class Mesh>
struct Recycling_pause
{
  explicit Recycling_pause(Mesh& m)
    : mesh(m)
  {
    if constexpr (may_recycle) recycles = m.does_recycle_garbage();
    if constexpr (may_recycle) mesh.set_recycle_garbage(false);
  }
  ~Recycling_pause()
  {
    if constexpr (may_recycle) mesh.set_recycle_garbage(recycles);
  }
  Recycling_pause(const Recycling_pause&) = delete;
  Recycling_pause& operator=(const Recycling_pause&) = delete;

  static constexpr bool may_recycle = Refinable_mesh_traits<Mesh>::recycles;
  Mesh& mesh;
  bool recycles = false;
};

// Copies the connectivity of a mesh, the elements of which have the numbers that the access gives
// them, and the functions give back. Those that do not belong to the mesh have invalid numbers.
template <class Access, class Graph, class Vertex_number, class Halfedge_number, class Face_number>
void read_connectivity(const Access& access, const Graph& graph, const Vertex_number& vertex_number,
                       const Halfedge_number& halfedge_number, const Face_number& face_number,
                       Level_connectivity& level)
{
  using Traits = boost::graph_traits<Graph>;
  using Index = Level_connectivity::Index;
  const auto vertices = static_cast<Index>(access.size().vertices);
  const auto halfedges = static_cast<Index>(2 * access.size().edges);
  const auto faces = static_cast<Index>(access.size().faces);
  for (Index h = 0; h < halfedges; ++h) {
    const auto d = access.halfedge_at(h);
    level.set_target(h, vertex_number(target(d, graph)));
    level.set_next(h, halfedge_number(next(d, graph)));
    const auto f = face(d, graph);
    if (f == Traits::null_face())
      level.set_border(h);
    else // null would be the border
      level.set_face(h, (std::min)(face_number(f), faces));
  }
  for (Index v = 0; v < vertices; ++v) {
    const auto h = halfedge(access.vertex(v), graph);
    if (h == Traits::null_halfedge())
      level.set_isolated(v);
    else // null would be a vertex without edges
      level.set_halfedge_of_vertex(v, (std::min)(halfedge_number(h), halfedges));
  }
  for (Index f = 0; f < faces; ++f)
    level.set_halfedge_of_face(f, halfedge_number(halfedge(access.face_at(f), graph)));
}

// gives a mesh that has grown the connectivity of the level
template <class Access, class Graph, class For_chunks>
void write_connectivity(const Access& access, Graph& graph, const Level_connectivity& level,
                        const For_chunks& for_chunks)
{
  using Traits = boost::graph_traits<Graph>;
  using Index = Level_connectivity::Index;
  for_each_index(for_chunks, level.number_of_edges(), [&](Index e) {
    for (const Index h : {2 * e, 2 * e + 1}) {
      const auto d = access.halfedge_at(h);
      set_target(d, access.vertex(level.target(h)), graph);
      set_next(d, access.halfedge_at(level.next(h)), graph);
      set_face(d, level.is_border(h) ? Traits::null_face() : access.face_at(level.face(h)), graph);
    }
  });
  for_each_index(for_chunks, level.number_of_vertices(), [&](Index v) {
    if (!level.is_isolated(v))
      set_halfedge(access.vertex(v), access.halfedge_at(level.halfedge_of_vertex(v)), graph);
  });
  for_each_index(for_chunks, level.number_of_faces(), [&](Index f) {
    set_halfedge(access.face_at(f), access.halfedge_at(level.halfedge_of_face(f)), graph);
  });
}

// Any MutableFaceGraph through BGL. Elements are numbered in the order of iteration; the elements
// that grow() adds follow.
template <class Graph>
class Bgl_mesh_access : public Element_names
{
  using Traits = boost::graph_traits<std::remove_const_t<Graph>>;
  using Mesh_traits = Refinable_mesh_traits<std::remove_const_t<Graph>>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Face = typename Traits::face_descriptor;

public:
  using Index = Level_connectivity::Index;
  using vertex_descriptor = Vertex;

  explicit Bgl_mesh_access(Graph& graph)
    : graph_(graph)
  {
    if constexpr (Mesh_traits::has_resize) { // BGL counts removed elements too
      old_places_.vertices = num_vertices(graph_);
      old_places_.edges = num_edges(graph_);
      old_places_.faces = num_faces(graph_);
    }
    for (Vertex v : vertices(graph_)) vertices_.push_back(v);
    for (auto e : edges(graph_)) edges_.push_back(halfedge(e, graph_));
    for (Face f : faces(graph_)) faces_.push_back(f);
    old_size_.vertices = vertices_.size();
    old_size_.edges = edges_.size();
    old_size_.faces = faces_.size();
  }

  static constexpr bool may_be_child_of_hosts = false;
  static constexpr bool is_child_of_hosts() { return false; }
  static constexpr bool has_concurrent_connectivity = Mesh_traits::has_concurrent_connectivity;

  static constexpr std::uint64_t index_limit() { return internal::index_limit<Vertex>(); }

  Level_size size() const { return old_size_; }
  Vertex vertex(Index v) const { return vertices_[v]; }
  Halfedge halfedge_at(Index h) const
  {
    return (h & 1u) == 0 ? edges_[h >> 1] : opposite(edges_[h >> 1], graph_);
  }
  typename Traits::edge_descriptor edge_at(Index e) const { return edge(edges_[e], graph_); }
  Face face_at(Index f) const { return faces_[f]; }

  std::string vertex_name(Index v) const override
  {
    return element_name("vertex", vertices_[v], v);
  }
  std::string halfedge_name(Index h) const override
  {
    return element_name("half-edge", halfedge_at(h), h);
  }
  std::string face_name(Index f) const override { return element_name("face", faces_[f], f); }

  // an element that does not belong to the mesh becomes an invalid index
  void read(Level_connectivity& level) const
  {
    std::unordered_map<Vertex, Index> vertex_index;
    std::unordered_map<Halfedge, Index> halfedge_index;
    std::unordered_map<Face, Index> face_index;
    fill_index(vertex_index, vertices_.size(), [&](Index v) { return vertices_[v]; });
    fill_index(halfedge_index, 2 * edges_.size(), [&](Index h) { return halfedge_at(h); });
    fill_index(face_index, faces_.size(), [&](Index f) { return faces_[f]; });
    read_connectivity(
      *this, graph_, [&](Vertex v) { return find(vertex_index, v); },
      [&](Halfedge h) { return find(halfedge_index, h); },
      [&](Face f) { return find(face_index, f); }, level);
  }

  // adds unconnected elements behind all others, removed ones included; what was added before an
  // exception, shrink() removes
  void grow(const Level_size& size)
  {
    grow_vertices(size);
    edges_.reserve(size.edges);
    faces_.reserve(size.faces);
    const Recycling_pause<Graph> pause(graph_);
    while (edges_.size() < size.edges) edges_.push_back(halfedge(add_edge(graph_), graph_));
    while (faces_.size() < size.faces) faces_.push_back(add_face(graph_));
  }
  // the vertices alone
  void grow_vertices(const Level_size& size)
  {
    vertices_.reserve(size.vertices);
    const Recycling_pause<Graph> pause(graph_);
    while (vertices_.size() < size.vertices) vertices_.push_back(add_vertex(graph_));
  }
  void shrink()
  {
    if constexpr (Mesh_traits::has_resize)
      resize(old_places_);
    else
      remove_beyond(old_size_);
  }
  // Removes the elements that the result does not use and, if the user's maps follow, all that were
  // removed before. Where memory is lacking the elements removed before stay: the result is right, and
  // nothing may fail any more.
  void trim(const Level_size& size, bool collect)
  {
    if constexpr (Mesh_traits::has_resize)
      if (old_places_.vertices == old_size_.vertices && old_places_.edges == old_size_.edges &&
          old_places_.faces == old_size_.faces)
        return resize(size);
    remove_beyond(size);
    if constexpr (Mesh_traits::has_collect_garbage) try {
        if (collect && graph_.has_garbage()) graph_.collect_garbage();
      } catch (const std::bad_alloc&) {
      }
  }

  // gives the grown mesh the connectivity of the level
  template <class For_chunks>
  void write(const Level_connectivity& level, const For_chunks& for_chunks)
  {
    write_connectivity(*this, graph_, level, for_chunks);
    if constexpr (Mesh_traits::has_adjust_outgoing_halfedge)
      for (Vertex v : vertices_)
        if (halfedge(v, graph_) != Traits::null_halfedge()) graph_.adjust_outgoing_halfedge(v);
  }

private:
  // A mesh that keeps its elements in arrays (Surface_mesh, those of OpenMesh) loses the last ones
  // again without a trace and without an exception. Removing them would leave removed places.
  void resize(const Level_size& size)
  {
    graph_.resize(static_cast<unsigned>(size.vertices), static_cast<unsigned>(size.edges),
                  static_cast<unsigned>(size.faces));
  }

  void remove_beyond(const Level_size& size)
  {
    for (; faces_.size() > size.faces; faces_.pop_back()) remove_face(faces_.back(), graph_);
    for (; edges_.size() > size.edges; edges_.pop_back())
      remove_edge(edge(edges_.back(), graph_), graph_);
    for (; vertices_.size() > size.vertices; vertices_.pop_back())
      remove_vertex(vertices_.back(), graph_);
  }

  template <class Map, class Descriptor_of>
  static void fill_index(Map& map, std::size_t n, const Descriptor_of& descriptor)
  {
    map.reserve(n);
    for (Index i = 0; i < n; ++i) map.emplace(descriptor(i), i);
  }
  template <class Map, class Descriptor>
  static Index find(const Map& map, const Descriptor& d)
  {
    const auto it = map.find(d);
    return it == map.end() ? Level_connectivity::null : it->second;
  }

  Graph& graph_;
  std::vector<Vertex> vertices_;
  std::vector<Halfedge> edges_;
  std::vector<Face> faces_;
  Level_size old_size_, old_places_; // the latter of a mesh with resize()
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_BGL_MESH_ACCESS_H
