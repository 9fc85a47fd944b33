// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H

#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Numbers that some elements of a level get: in a table of all if they may be many.
class Element_numbers
{
public:
  using Index = Level_connectivity::Index;

  Element_numbers(std::size_t all, bool are_many)
    : table_(are_many ? all : 0, Level_connectivity::null)
  {}

  // whether the element had no number
  bool insert(Index element, Index number)
  {
    if (table_.empty()) return few_.emplace(element, number).second;
    if (table_[element] != Level_connectivity::null) return false;
    table_[element] = number;
    return true;
  }
  // of an element that has one
  Index operator[](Index element) const
  {
    return table_.empty() ? few_.find(element)->second : table_[element];
  }

private:
  std::vector<Index> table_;
  std::unordered_map<Index, Index> few_;
};

// The faces within some rings about the center vertices of a level, as a level of its own. Rounds of
// a scheme on it are those of the whole level but near the border that cutting it out has made. A
// vertex at which the faces that are left form several fans occurs once for each.
class Sub_level
{
public:
  using Index = Level_connectivity::Index;

  // What is kept of the whole level: edges their orientation and faces their first half-edge, or, with walks, inner
  // vertices their half-edge, too, from which rows and stars go on; or nothing, so that about a single center all goes by
  // its half-edge.
  enum class Keeps { order, walks, nothing };

  // `centers` has no vertex twice, and none without edges
  Sub_level(const Level_connectivity& level, const std::vector<Index>& centers, unsigned rings,
            Keeps keeps = Keeps::order)
    : whole_(level)
    , is_anew_(keeps == Keeps::nothing)
    , are_many_(16 * centers.size() >= level.number_of_vertices())
    , edge_(level.number_of_edges(), are_many_)
  {
    collect_faces(centers, rings);
    number_edges();
    link_faces();
    link_border();
    number_vertices();
    if (keeps == Keeps::walks) keep_walks();
    build();
    for (const Index v : centers)
      centers_.push_back(vertex_[halfedge(whole_.halfedge_of_vertex(v))]);
  }

  const Level_connectivity& level() const { return level_; }
  // the centers' numbers in this level, in their order
  const std::vector<Index>& centers() const { return centers_; }
  // of each vertex its number in the whole level
  const std::vector<Index>& origin() const { return origin_; }
  // the same of edges, and of a half-edge
  const std::vector<Index>& edge_origin() const { return edges_; }
  Index halfedge_origin(Index h) const { return 2 * edges_[h / 2] + (h % 2 ^ turned_[h / 2]); }

private:
  static constexpr Index null = Level_connectivity::null;

  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  void collect_faces(const std::vector<Index>& centers, unsigned rings)
  {
    std::vector<Index> ring = centers, next_ring;
    Element_numbers vertices(whole_.number_of_vertices(), are_many_),
      faces(whole_.number_of_faces(), are_many_);
    for (const Index v : centers) vertices.insert(v, 0);
    for (unsigned r = 0; r < rings; ++r) {
      next_ring.clear();
      for (const Index v : ring) {
        const Index first = whole_.halfedge_of_vertex(v);
        Index h = first;
        do {
          if (!whole_.is_border(h) && faces.insert(whole_.face(h), 0)) {
            faces_.push_back(whole_.face(h));
            first_.push_back(is_anew_ ? h : whole_.halfedge_of_face(whole_.face(h)));
            for (Index g = whole_.next(h); g != h; g = whole_.next(g))
              if (vertices.insert(whole_.target(g), 0)) next_ring.push_back(whole_.target(g));
          }
          h = whole_.next_around_target(h);
        } while (h != first);
      }
      ring.swap(next_ring);
    }
  }

  void number_edges()
  {
    for (const Index first : first_) {
      Index h = first;
      do {
        if (edge_.insert(Level_connectivity::edge(h), static_cast<Index>(edges_.size()))) {
          edges_.push_back(Level_connectivity::edge(h));
          turned_.push_back(is_anew_ ? h & 1u : 0);
        }
        h = whole_.next(h);
      } while (h != first);
    }
    face_.assign(2 * edges_.size(), null);
    next_.assign(2 * edges_.size(), null);
    prev_.assign(2 * edges_.size(), null);
    vertex_.assign(2 * edges_.size(), null);
  }

  // the number here of a half-edge of the whole level
  Index halfedge(Index h) const
  {
    const Index e = edge_[Level_connectivity::edge(h)];
    return 2 * e + ((h & 1u) ^ turned_[e]);
  }

  void link_faces()
  {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Index first = first_[f];
      Index h = first;
      do {
        const Index g = halfedge(h);
        h = whole_.next(h);
        face_[g] = static_cast<Index>(f);
        next_[g] = halfedge(h);
        prev_[next_[g]] = g;
        ++corners_;
      } while (h != first);
    }
  }

  // the border goes on where the fan of faces at its target ends
  void link_border()
  {
    for (Index b = 0; b < face_.size(); ++b) {
      if (face_[b] != null) continue;
      Index p = prev_[opposite(b)];
      while (face_[opposite(p)] != null) p = prev_[opposite(p)];
      next_[b] = opposite(p);
    }
  }

  void number_vertices()
  {
    for (Index first = 0; first < next_.size(); ++first) {
      if (vertex_[first] != null) continue;
      const auto v = static_cast<Index>(origin_.size());
      origin_.push_back(whole_.target(halfedge_origin(first)));
      halfedge_of_vertex_.push_back(first);
      Index h = first;
      do {
        vertex_[h] = v;
        if (face_[h] == null) halfedge_of_vertex_[v] = h;
        h = opposite(next_[h]);
      } while (h != first);
    }
  }

  void keep_walks()
  {
    for (Index v = 0; v < origin_.size(); ++v)
      if (face_[halfedge_of_vertex_[v]] != null)
        halfedge_of_vertex_[v] = halfedge(whole_.halfedge_of_vertex(origin_[v]));
  }

  void build()
  {
    Level_size size;
    size.vertices = origin_.size();
    size.edges = edges_.size();
    size.faces = faces_.size();
    size.corners = corners_;
    level_ = Level_connectivity(size);
    level_.set_uniform_degree(whole_.uniform_degree());
    for (Index h = 0; h < next_.size(); ++h) {
      level_.set_next(h, next_[h]);
      level_.set_target(h, vertex_[h]);
      if (face_[h] == null)
        level_.set_border(h);
      else
        level_.set_face(h, face_[h]);
    }
    for (Index v = 0; v < origin_.size(); ++v)
      level_.set_halfedge_of_vertex(v, halfedge_of_vertex_[v]);
    for (Index f = 0; f < faces_.size(); ++f) level_.set_halfedge_of_face(f, halfedge(first_[f]));
  }

  const Level_connectivity& whole_;
  const bool is_anew_;
  bool are_many_;
  Element_numbers edge_;
  Level_connectivity level_;
  std::vector<Index> centers_, origin_;
  std::vector<Index> faces_, edges_;  // of the whole level
  std::vector<Index> first_, turned_; // half-edges of the faces; edges that are turned: 1
  std::vector<Index> face_, next_, prev_, vertex_; // of half-edges
  std::vector<Index> halfedge_of_vertex_;
  std::size_t corners_ = 0;
};

// The part of a level about some vertices, with its creases, their tangents and the values of its slots. At its rim,
// but not at the border of the level, the rules are those of a smooth border.
template <class FT, class Value>
class Creased_sub_level
{
public:
  using Index = Level_connectivity::Index;

  // `level` is not cut open, `values` are those of its slots
  Creased_sub_level(const Level_connectivity& level, const Creases<FT>& creases,
                    const std::vector<Value>& values, const std::vector<Index>& centers,
                    unsigned rings)
    : sub_(level, centers, rings, Sub_level::Keeps::walks)
    , creases_(creases_of_part(
        creases, sub_.level(), [&](Index e) { return sub_.edge_origin()[e]; },
        [&](Index v) { return sub_.origin()[v]; }))
    , values_(creases_.number_of_slots)
  {
    take_slot_values(
      sub_.level(), creases_, [&](Index h) { return sub_.halfedge_origin(h); },
      Corner_slots<FT>(level, creases), values, values_);
  }

  const Level_connectivity& level() const { return sub_.level(); }
  const Creases<FT>& creases() const { return creases_; }
  const std::vector<Value>& values() const { return values_; }
  // the centers' numbers in this level, in their order
  const std::vector<Index>& centers() const { return sub_.centers(); }

private:
  Sub_level sub_;
  Creases<FT> creases_;
  std::vector<Value> values_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H
