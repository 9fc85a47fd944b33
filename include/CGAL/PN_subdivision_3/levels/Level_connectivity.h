// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_LEVELS_LEVEL_CONNECTIVITY_H
#define CGAL_PN_SUBDIVISION_3_LEVELS_LEVEL_CONNECTIVITY_H

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Schemes
/// numbers of elements of a level.
struct Level_size
{
  /// all vertices.
  std::uint64_t vertices = 0;
  /// all edges.
  std::uint64_t edges = 0;
  /// all faces.
  std::uint64_t faces = 0;
  /// (face, vertex) incidences, that is the half-edges that are not on the border
  std::uint64_t corners = 0;
  /// vertices without edges
  std::uint64_t isolated_vertices = 0;
  /// the sum of the valences of the border vertices. Of refined levels this and `isolated_vertices` are known
  /// only where the host's sizes depend on them.
  std::uint64_t border_valences = 0;

  /// all half-edges, two an edge.
  std::uint64_t halfedges() const { return 2 * edges; }
  /// half-edges without a face.
  std::uint64_t border_halfedges() const { return halfedges() - corners; }
};

/*!
\ingroup PkgPNSubdivision3Schemes

The connectivity of one level of refinement: an oriented 2-manifold with border as flat arrays of
half-edges. This is what a mask sees of a mesh.

All elements are numbered from zero. The half-edges of edge `e` are `2 * e` and `2 * e + 1`. A
half-edge that has no face is a *border half-edge*; border half-edges are linked by `next()` along
the border. A border vertex stores a border half-edge as its `halfedge_of_vertex()`; a vertex
without edges stores `null`.
*/
class Level_connectivity
{
public:
  /// numbers the elements of a kind.
  using Index = std::uint32_t;

  /// the number of no element.
  static constexpr Index null = static_cast<Index>(-1);

  Level_connectivity() = default;

  /// allocates a level; its elements are undefined until they are set.
  explicit Level_connectivity(const Level_size& size) { resize(size); }

  /// the same, with room for a later `resize()`.
  Level_connectivity(const Level_size& size, const Level_size& room)
  {
    for (Array* a : {&target_, &next_, &face_}) a->reserve(room.halfedges());
    halfedge_of_vertex_.reserve(room.vertices);
    halfedge_of_face_.reserve(room.faces);
    resize(size);
  }

  /// copies `other` and makes room for more vertices and edges, which are undefined until they are
  /// set.
  /// \pre `size` has as many faces as `other`, and at least as many vertices and edges
  Level_connectivity(const Level_connectivity& other, const Level_size& size)
    : Level_connectivity(size)
  {
    uniform_degree_ = other.uniform_degree_;
    std::copy(other.target_.begin(), other.target_.end(), target_.begin());
    std::copy(other.next_.begin(), other.next_.end(), next_.begin());
    std::copy(other.face_.begin(), other.face_.end(), face_.begin());
    std::copy(other.halfedge_of_vertex_.begin(), other.halfedge_of_vertex_.end(),
              halfedge_of_vertex_.begin());
    std::copy(other.halfedge_of_face_.begin(), other.halfedge_of_face_.end(),
              halfedge_of_face_.begin());
  }

  /// \name Size
  /// @{

  /// the numbers of elements.
  const Level_size& size() const { return size_; }
  /// the number of vertices.
  Index number_of_vertices() const { return static_cast<Index>(size_.vertices); }
  /// the number of edges.
  Index number_of_edges() const { return static_cast<Index>(size_.edges); }
  /// the number of half-edges.
  Index number_of_halfedges() const { return static_cast<Index>(size_.halfedges()); }
  /// the number of faces.
  Index number_of_faces() const { return static_cast<Index>(size_.faces); }
  /// whether an edge has a face on one side only.
  bool has_border() const { return has_border_; }
  /// the degree of all faces, 0 if they differ.
  Index uniform_degree() const { return uniform_degree_; }
  /// @}

  /// \name Navigation
  /// @{

  /// the other half-edge of the edge.
  static Index opposite(Index h) { return h ^ 1u; }
  /// the edge of a half-edge.
  static Index edge(Index h) { return h >> 1; }
  /// the first half-edge of an edge.
  static Index halfedge_of_edge(Index e) { return e << 1; }
  /// the vertex that `h` points to.
  Index target(Index h) const { return target_[h]; }
  /// the vertex that `h` comes from.
  Index source(Index h) const { return target_[opposite(h)]; }
  /// the half-edge after `h` in its face or along its border.
  Index next(Index h) const { return next_[h]; }
  /// the half-edge before `h` in its face or along its border.
  /// <br><b>Cost:</b> linear in the number of half-edges of the face; on the border, in the valence of the
  /// source of `h`.
  Index prev(Index h) const
  {
    if (is_border(h)) {
      Index p = opposite(h);
      while (!is_border(p)) p = next_around_target(p);
      return p;
    }
    Index p = h;
    while (next(p) != h) p = next(p);
    return p;
  }
  /// the next half-edge with the same target, clockwise.
  Index next_around_target(Index h) const { return opposite(next(h)); }
  /// the face of `h`, `null` on the border.
  Index face(Index h) const { return face_[h]; }
  /// a half-edge that points to `v`, on the border if `v` is; `null` if `v` has no edge.
  Index halfedge_of_vertex(Index v) const { return halfedge_of_vertex_[v]; }
  /// a half-edge of `f`.
  Index halfedge_of_face(Index f) const { return halfedge_of_face_[f]; }
  /// @}

  /// \name Queries
  /// @{

  /// whether `h` has no face.
  bool is_border(Index h) const { return has_border_ && face_[h] == null; }
  /// whether `e` has a face on one side only.
  bool is_border_edge(Index e) const { return is_border(2 * e) || is_border(2 * e + 1); }
  /// whether `v` has no edge.
  bool is_isolated(Index v) const { return halfedge_of_vertex_[v] == null; }
  /// \pre `v` is not isolated
  bool is_border_vertex(Index v) const { return is_border(halfedge_of_vertex_[v]); }
  /// the number of edges at `v`.
  Index valence(Index v) const
  {
    const Index first = halfedge_of_vertex_[v];
    if (first == null) return 0;
    Index n = 0;
    Index h = first;
    do {
      ++n;
      h = next_around_target(h);
    } while (h != first);
    return n;
  }
  /// calls `f(w)` for the neighbors `w` of the target of `h`, clockwise; if that is on the border and
  /// `h` a border half-edge, from the one border neighbor to the other.
  template <class Function>
  void for_each_neighbor(Index h, const Function& f) const
  {
    Index g = h;
    do {
      g = next(g);
      f(target(g));
      g = opposite(g);
    } while (g != h);
  }
  /// the number of half-edges of the face of `h`.
  Index degree(Index h) const
  {
    Index m = 0;
    Index g = h;
    do {
      ++m;
      g = next(g);
    } while (g != h);
    return m;
  }
  /// whether the face of `h` has `m` half-edges. <br><b>Cost:</b> `m`
  bool has_degree(Index h, Index m) const
  {
    Index g = next(h);
    for (Index i = 1; i < m; ++i, g = next(g))
      if (g == h) return false;
    return g == h;
  }
  /// @}

  /// \name Counted valences
  /// What a mask that has its own rules at extraordinary vertices asks for besides the valences.
  /// @{

  /// a vertex to which no such rule applies, and the valence by which it counts beside others; 0 if
  /// it counts as regular. In the order of the vertices.
  struct Counted_valence
  {
    /// the vertex.
    Index vertex;
    /// its valence as it counts.
    Index valence;
  };
  /// the valences that count as another number.
  const std::vector<Counted_valence>& counted_valences() const { return counted_valences_; }
  /// sets the valences that count as another number.
  void set_counted_valences(std::vector<Counted_valence> valences)
  {
    counted_valences_ = std::move(valences);
  }
  /// @}

  /// \name Modification
  /// Used while a level is built. Different elements may be set by different threads.
  /// @{

  /// sets the vertex that `h` points to.
  void set_target(Index h, Index v) { target_[h] = v; }
  /// sets the half-edge after `h`.
  void set_next(Index h, Index n) { next_[h] = n; }
  /// sets the face of `h`.
  void set_face(Index h, Index f) { face_[h] = f; }
  /// puts `h` on the border.
  void set_border(Index h) { face_[h] = null; }
  /// sets `halfedge_of_vertex()`.
  void set_halfedge_of_vertex(Index v, Index h) { halfedge_of_vertex_[v] = h; }
  /// marks a vertex as one without edges.
  void set_isolated(Index v) { halfedge_of_vertex_[v] = null; }
  /// sets `halfedge_of_face()`.
  void set_halfedge_of_face(Index f, Index h) { halfedge_of_face_[f] = h; }
  /// sets the numbers of elements.
  void set_size(const Level_size& size)
  {
    size_ = size;
    has_border_ = size.border_halfedges() != 0;
  }
  /// sets the degree of all faces; 0 if they differ.
  void set_uniform_degree(Index m) { uniform_degree_ = m; }
  /// further elements are undefined until they are set.
  void resize(const Level_size& size)
  {
    set_size(size);
    for (Array* a : {&target_, &next_, &face_})
      a->resize(size.halfedges(), boost::container::default_init);
    halfedge_of_vertex_.resize(size.vertices, boost::container::default_init);
    halfedge_of_face_.resize(size.faces, boost::container::default_init);
  }
  /// @}

private:
  using Array = boost::container::vector<Index>;

  Level_size size_;
  bool has_border_ = false;
  Index uniform_degree_ = 0;
  Array target_, next_, face_;
  Array halfedge_of_vertex_, halfedge_of_face_;
  std::vector<Counted_valence> counted_valences_;
};

namespace internal {

// Half-edges in a circle, to go through by a loop: those from `first` on by steps.
template <Level_connectivity::Index (Level_connectivity::*step)(Level_connectivity::Index) const>
struct Halfedge_circle
{
  const Level_connectivity& level;
  const Level_connectivity::Index first;
  Level_connectivity::Index halfedge = first;
  bool is_closed = false;

  Halfedge_circle begin() const { return *this; }
  static std::nullptr_t end() { return nullptr; }
  Level_connectivity::Index operator*() const { return halfedge; }
  void operator++()
  {
    halfedge = (level.*step)(halfedge);
    is_closed = halfedge == first;
  }
  bool operator!=(std::nullptr_t) const { return !is_closed; }
};

// the half-edges of the face of h, from h on
inline Halfedge_circle<&Level_connectivity::next>
halfedges_around_face(const Level_connectivity& level, Level_connectivity::Index h)
{
  return {level, h};
}
// the half-edges that lead to the target of h, from h on, clockwise
inline Halfedge_circle<&Level_connectivity::next_around_target>
halfedges_around_target(const Level_connectivity& level, Level_connectivity::Index h)
{
  return {level, h};
}

// f(i) of every i below n; for_chunks says in which threads
template <class For_chunks, class Function>
void for_each_index(const For_chunks& for_chunks, Level_connectivity::Index n, const Function& f)
{
  using Index = Level_connectivity::Index;
  for_chunks(n, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) f(i);
  });
}

// all indices below n
inline std::vector<Level_connectivity::Index> first_indices(std::size_t n)
{
  std::vector<Level_connectivity::Index> result(n);
  std::iota(result.begin(), result.end(), 0u);
  return result;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Schemes
The old element that an element of the refined level comes from. `Index` may be wider than that of a level,
to number more than one level holds.
*/
template <class Index>
struct Basic_element_parent
{
  /// A corner is given by the half-edge of its face that leads to it, a border edge by its half-edge that
  /// has a face; all other elements are given by their own index.
  enum class Kind { vertex, edge, face, corner, border_edge };

  /// the kind of the old element.
  Kind kind;
  /// its number.
  Index index;
  /// which one it is of the children of the same kind that the old element has, counted from 0.
  Index ordinal = 0;
};

/// \ingroup PkgPNSubdivision3Schemes
/// the parent of an element of a level.
using Element_parent = Basic_element_parent<Level_connectivity::Index>;

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_LEVELS_LEVEL_CONNECTIVITY_H
