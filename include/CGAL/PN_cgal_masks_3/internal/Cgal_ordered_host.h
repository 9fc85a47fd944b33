// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_INTERNAL_CGAL_ORDERED_HOST_H
#define CGAL_PN_CGAL_MASKS_3_INTERNAL_CGAL_ORDERED_HOST_H

#include <CGAL/PN_subdivision_3/hosts/DQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <boost/container/vector.hpp>

#include <cstddef>

namespace CGAL::PN_subdivision_3::internal {

// The numbers that the children of a level have in CGAL's Subdivision_method_3, by those of this package's hosts. There they are
// the order in which Euler operations make them; a round of ours has the same vertices in the same order, but for
// dual ones, and this has the same edges, half-edges and faces, from which the order of the next round follows.
class Cgal_order
{
public:
  using Index = Level_connectivity::Index;

  Index halfedge(Index h) const
  {
    const Index e = h >> 1;
    return e < first_ ? h : halfedge_[e - first_] ^ (h & 1u);
  }
  Index face(Index f) const { return face_.empty() ? f : face_[f]; }
  Index vertex(Index v) const { return vertex_.empty() ? v : vertex_[v]; }
  // where face f begins, which would begin at h
  Index halfedge_of_face(Index f, Index h) const
  {
    if (!start_.empty()) return halfedge(start_[f]);
    // the middle triangle at a refined border edge begins at the second of the inner edges of its face
    return halfedge(h >= first_inner_of_sqrt3_ ? h - 2 : h);
  }

  // Every edge is split in its order. The half-edges c_1, ..., c_m of a face then are those from its last one on, which is c_m
  // and comes before c_1. The new vertices of c_1 and c_2 are joined, the new vertex of the face splits that edge, and is
  // joined to the new vertices of c_3, ..., c_m:
  //
  //          c_3
  //       .---+---.        The spokes have the order of the c_i. Spoke 2, the second half of an edge, leads to c_2, all
  //       | 3 | 2 |        others to the new vertex of the face.
  //   c_4 +---*---+ c_2
  //       | 4 | 1 |        Quadrilateral 2 keeps the number of the face; 1, 3, ..., m come behind all faces.
  //       `---+---'
  //          c_1
  void number(const PQQ_host&, const Level_connectivity& level, bool)
  {
    set_room(2 * level.number_of_edges(), level.size().corners, level.size().corners);
    start_.resize(face_.size(), boost::container::default_init);
    const Index faces = level.number_of_faces();
    Index corner = 0;
    for (Index f = 0; f < faces; ++f) {
      const Start start(level, f);
      const Index m = start.degree, later = faces + corner - f;
      for (Index k = 0; k < m; ++k) {
        const Index turned = start.turned(k), c = turned == 0 ? m : turned;
        halfedge_[corner + k] = 2 * (first_ + corner + c - 1) + (c == 2 ? 1 : 0);
        const Index quad = k == 0 ? f : later + k - 1, next = k + 1 == m ? 0 : k + 1;
        face_[quad] = c == 2 ? f : later + (c == 1 ? 0 : c - 2);
        const bool begins_at_own_spoke = c == 1 || c == m;
        start_[quad] =
          begins_at_own_spoke ? 2 * (first_ + corner + k) + 1 : 2 * (first_ + corner + next);
      }
      corner += m;
    }
  }

  // Of a triangle the corners c_1, c_2, c_0 are cut off.
  void number(const PTQ_host&, const Level_connectivity& level, bool)
  {
    const Index faces = level.number_of_faces();
    set_room(2 * level.number_of_edges(), 3 * std::size_t(faces), 4 * std::size_t(faces));
    start_.resize(face_.size(), boost::container::default_init);
    for (Index f = 0; f < faces; ++f) {
      const Start start(level, f);
      face_[f] = f;
      for (Index i = 0; i < 3; ++i) {
        const Index n = (start.turned(i) + 2) % 3;
        halfedge_[3 * f + i] = 2 * (first_ + 3 * f + n) + 1;
        face_[faces + 3 * f + i] = faces + 3 * f + n;
        start_[faces + 3 * f + i] = 2 * (first_ + 3 * f + i);
        if (n == 2) start_[f] = start_[faces + 3 * f + i] + 1;
      }
    }
  }

  // Faces are split one after the other, then old edges are removed and their quadrilaterals split anew: by elements that
  // take the place of those removed, or are appended.
  void number(const Sqrt3_host& host, const Level_connectivity& level, bool recycles)
  {
    const Level_size size =
      Sqrt3_host::refined_size(level.size(), host.has_refined_border() ? 2 : 1);
    set_room(0, size.edges, size.faces);
    first_inner_of_sqrt3_ = 2 * level.number_of_edges();
    for (Index e = 0; e < level.number_of_edges(); ++e) halfedge_[e] = 2 * e;
    split_triangles(level, host.has_refined_border());
    if (!recycles) append_flipped(level);
  }

  // The corners round every vertex; edges and faces decide on nothing.
  void number(const DQQ_host& host, const Level_connectivity& level, bool)
  {
    first_ = Level_connectivity::null;
    vertex_.resize(level.size().corners, boost::container::default_init);
    Index next = 0;
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      if (level.is_isolated(v)) continue;
      for_each_halfedge_to(level, v, [&](Index h) {
        if (!level.is_border(h)) vertex_[host.vertex_of_corner(h)] = next++;
      });
    }
  }

private:
  using Table = boost::container::vector<Index>;

  // where a face begins: at its last half-edge
  struct Start
  {
    Start(const Level_connectivity& level, Index f)
    {
      Index last = 0;
      for_each_halfedge_of_face(level, f, [&](Index h) {
        if (h >= last) {
          last = h;
          ordinal = degree;
        }
        ++degree;
      });
    }
    Index turned(Index k) const { return k >= ordinal ? k - ordinal : k + degree - ordinal; }

    Index degree = 0, ordinal = 0;
  };

  void set_room(Index first, std::size_t edges, std::size_t faces)
  {
    first_ = first;
    halfedge_.resize(edges, boost::container::default_init);
    face_.resize(faces, boost::container::default_init);
  }

  void split_triangles(const Level_connectivity& level, bool refines_border)
  {
    const Index edges = level.number_of_edges(), faces = level.number_of_faces();
    Index next = edges, last_part = edges + 3 * faces;
    for (Index f = 0; f < faces; ++f) {
      const Index inner = edges + 3 * f, triangle = faces + 2 * f;
      const Index first = level.halfedge_of_face(f);
      Index border = 3, h = first; // which half-edge
      for (Index i = 0; i < 3; ++i, h = level.next(h))
        if (refines_border && level.is_border(Level_connectivity::opposite(h))) {
          border = i;
          break;
        }
      if (border == 3) {
        for (Index i = 0; i < 3; ++i) halfedge_[inner + i] = 2 * next++ + 1;
        face_[f] = f;
        face_[triangle] = triangle;
        face_[triangle + 1] = triangle + 1;
        continue;
      }
      halfedge_[h >> 1] = (2 * next) ^ (Level_connectivity::opposite(h) & 1u);
      halfedge_[last_part++] = h;
      halfedge_[inner + 2] = 2 * (next + 1) + 1;
      halfedge_[inner] = 2 * (next + 2);
      halfedge_[inner + 1] = 2 * (next + 3);
      next += 4;
      const Index parts[3] = {triangle, triangle + 1, f}; // at the border, after it, before it
      for (Index i = 0; i < 3; ++i)
        face_[i == 0 ? f : triangle + i - 1] = parts[(i + 3 - border) % 3];
    }
  }

  void append_flipped(const Level_connectivity& level)
  {
    const Index edges = level.number_of_edges(), faces = level.number_of_faces();
    // edges and faces that stay come first
    Table edge_at(halfedge_.size()), face_at(face_.size());
    Table ordinal(level.number_of_halfedges());
    for (Index f = 0; f < faces; ++f) {
      Index h = level.halfedge_of_face(f);
      for (Index i = 0; i < 3; ++i, h = level.next(h)) ordinal[h] = i;
    }
    const Index none = Level_connectivity::null;
    Index flipped = 0;
    for (Index e = 0; e < edges; ++e)
      if (!level.is_border_edge(e)) {
        edge_at[e] = none;
        face_at[triangle(level, 2 * e + 1, ordinal)] = none;
        ++flipped;
      }
    close_gaps(edge_at);
    close_gaps(face_at);
    Index edge = static_cast<Index>(edge_at.size()) - flipped,
          face = static_cast<Index>(face_at.size()) - flipped;
    for (Index e = 0; e < edges; ++e)
      if (!level.is_border_edge(e)) {
        edge_at[e] = edge++;
        face_at[triangle(level, 2 * e + 1, ordinal)] = face++;
      }
    for (Index& h : halfedge_) h = 2 * edge_at[h >> 1] + (h & 1u);
    for (Index& f : face_) f = face_at[f];
  }
  // the new triangle of a half-edge with a face, before its edge is flipped
  Index triangle(const Level_connectivity& level, Index h, const Table& ordinal) const
  {
    const Index f = level.face(h), i = ordinal[h];
    return face_[i == 0 ? f : level.number_of_faces() + 2 * f + i - 1];
  }
  static void close_gaps(Table& at)
  {
    Index next = 0;
    for (Index& i : at)
      if (i != Level_connectivity::null) i = next++;
  }

  Index first_ = 0; // the edges before it keep their numbers
  Index first_inner_of_sqrt3_ = Level_connectivity::null;
  Table halfedge_, face_, vertex_;
  Table start_; // of the faces, in half-edges of the host
};

// The child of a host in another order.
template <class Child>
class Reordered_child
{
public:
  using Index = Level_connectivity::Index;

  Reordered_child(Child& child, const Cgal_order& order)
    : child_(child)
    , order_(order)
  {}

  void set_next(Index h, Index n) { child_.set_next(order_.halfedge(h), order_.halfedge(n)); }
  void set_target(Index h, Index v) { child_.set_target(order_.halfedge(h), order_.vertex(v)); }
  void set_face(Index h, Index f) { child_.set_face(order_.halfedge(h), order_.face(f)); }
  void set_border(Index h) { child_.set_border(order_.halfedge(h)); }
  void set_isolated(Index v) { child_.set_isolated(order_.vertex(v)); }
  void set_halfedge_of_vertex(Index v, Index h)
  {
    child_.set_halfedge_of_vertex(order_.vertex(v), order_.halfedge(h));
  }
  void set_halfedge_of_face(Index f, Index h)
  {
    child_.set_halfedge_of_face(order_.face(f), order_.halfedge_of_face(f, h));
  }

private:
  Child& child_;
  const Cgal_order& order_;
};

// A host whose children have the numbers of CGAL's. `recycles`: whether the mesh puts new elements in the places of removed
// ones. Its parents are asked for vertices alone.
template <class Host, bool recycles>
class Cgal_ordered_host : public Host
{
public:
  using Index = Level_connectivity::Index;

  Cgal_ordered_host(const Level_connectivity& level, unsigned round)
    : Host(level, round)
  {
    order_.number(static_cast<const Host&>(*this), level, recycles);
    if constexpr (!Host::keeps_vertices) {
      base_vertex_.resize(level.size().corners, boost::container::default_init);
      for (Index v = 0; v < base_vertex_.size(); ++v) base_vertex_[order_.vertex(v)] = v;
    }
  }

  Element_parent parent_of_vertex(Index v) const { return Host::parent_of_vertex(base_vertex(v)); }
  void parent_of_edge(Index) const = delete;
  void parent_of_face(Index) const = delete;

  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index v, Stencil& s) const
  {
    Host::stencil(mask, base_vertex(v), s);
  }

  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const
  {
    Reordered_child<Child> reordered(child, order_);
    Host::connect(reordered, for_chunks);
  }

private:
  Index base_vertex(Index v) const { return base_vertex_.empty() ? v : base_vertex_[v]; }

  Cgal_order order_;
  boost::container::vector<Index> base_vertex_; // empty if all have the same number
};

// A scheme whose host is such a one.
template <class Scheme, bool recycles>
struct Cgal_ordered : Scheme_adaptor<Scheme>
{
  using Host = Cgal_ordered_host<typename Scheme::Host, recycles>;
};

template <bool recycles, class Scheme>
Cgal_ordered<Scheme, recycles> in_order_of_cgal(const Scheme& scheme)
{
  return {{scheme}};
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CGAL_MASKS_3_INTERNAL_CGAL_ORDERED_HOST_H
