// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_CACHE_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_CACHE_H

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A face by its half-edges in turn, each with its target.
using Made_face = std::vector<std::pair<Level_connectivity::Index, Level_connectivity::Index>>;

// The level of faces of one degree whose half-edges and vertices have numbers already. All other half-edges are on the border,
// which passes every vertex once at most; a vertex inside has one of its half-edges.
inline Level_connectivity level_of_faces(Level_connectivity::Index vertices,
                                         Level_connectivity::Index edges,
                                         const std::vector<Made_face>& faces)
{
  using Index = Level_connectivity::Index;
  Level_size size;
  size.vertices = vertices;
  size.edges = edges;
  size.faces = faces.size();
  size.corners = faces.size() * faces.front().size();
  Level_connectivity level(size);
  level.set_uniform_degree(static_cast<Index>(faces.front().size()));
  for (Index h = 0; h < level.number_of_halfedges(); ++h) level.set_border(h);
  for (Index f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      const auto [h, target] = faces[f][i];
      const Index next = faces[f][(i + 1) % faces[f].size()].first;
      level.set_target(h, target);
      level.set_target(Level_connectivity::opposite(next), target);
      level.set_next(h, next);
      level.set_face(h, f);
      level.set_halfedge_of_vertex(target, h);
    }
    level.set_halfedge_of_face(f, faces[f].front().first);
  }
  std::vector<Index> border_from(vertices);
  for (Index h = 0; h < level.number_of_halfedges(); ++h)
    if (level.is_border(h)) border_from[level.source(h)] = h;
  for (Index h = 0; h < level.number_of_halfedges(); ++h)
    if (level.is_border(h)) {
      level.set_next(h, border_from[level.target(h)]);
      level.set_halfedge_of_vertex(level.target(h), h);
    }
  return level;
}

// Faces all around vertex 0: edge i leads to it from its neighbor 1 + i, and behind the neighbors come the
// diagonal vertices of quads. An open wheel is cut open along edge 0: its neighbor is there twice, the second time as the last
// vertex.
inline Level_connectivity wheel(Level_connectivity::Index valence, Level_connectivity::Index degree,
                                bool is_open = false)
{
  using Index = Level_connectivity::Index;
  const Index n = valence, outer = (degree - 2) * n, spokes = n + (is_open ? 1 : 0);
  // the k-th vertex of the rim
  const auto rim = [&](Index k) {
    if (is_open && k == outer) return 1 + outer;
    k %= outer;
    return degree == 3 ? 1 + k : (k % 2 == 0 ? 1 + k / 2 : 1 + n + k / 2);
  };
  std::vector<Made_face> faces(n);
  for (Index i = 0; i < n; ++i) {
    faces[i] = {{2 * i + 1, 1 + i}};
    for (Index k = (degree - 2) * i; k < (degree - 2) * (i + 1); ++k)
      faces[i].emplace_back(2 * (spokes + k), rim(k + 1));
    faces[i].emplace_back(2 * ((i + 1) % spokes), 0);
  }
  Level_connectivity level = level_of_faces(1 + outer + (is_open ? 1 : 0), spokes + outer, faces);
  if (!is_open) level.set_halfedge_of_vertex(0, 0);
  return level;
}

// Triangles about vertex 0, which is on the border. Edge i leads to it from neighbor i, which is
// vertex 1 + i, and then come the edges opposite to vertex 0.
inline Level_connectivity fan_of_triangles(Level_connectivity::Index triangles)
{
  using Index = Level_connectivity::Index;
  const Index spokes = triangles + 1;
  std::vector<Made_face> faces;
  for (Index i = 0; i < triangles; ++i)
    faces.push_back({{2 * i, 0}, {2 * i + 3, 2 + i}, {2 * (spokes + i), 1 + i}});
  return level_of_faces(1 + spokes, spokes + triangles, faces);
}

// One face, whose corners are the vertices in their order.
inline Level_connectivity single_face(Level_connectivity::Index degree)
{
  Made_face face;
  for (Level_connectivity::Index i = 0; i < degree; ++i) face.emplace_back(2 * i, i);
  Level_connectivity level = level_of_faces(degree, degree, {face});
  Level_size size = level.size();
  size.border_valences = 2 * std::uint64_t(degree);
  level.set_size(size);
  return level;
}

// A vertex and the vertices of some rings of faces around it, in an order that depends on the
// connectivity alone: the vertex; its neighbors, clockwise, on the border from one border neighbor
// to the other; the other vertices of its faces in the same sense; then ring by ring.
class Vertex_ring
{
public:
  using Index = Level_connectivity::Index;

  // Appends the rings behind what is there. Vertices of the first ring that coincide, as they may on the coarsest
  // meshes, occur as often as they are met.
  static void append(const Level_connectivity& level, Index v, unsigned rings,
                     std::vector<Index>& ring)
  {
    const Index h = level.halfedge_of_vertex(v);
    const auto begin = static_cast<std::ptrdiff_t>(ring.size());
    ring.push_back(v);
    level.for_each_neighbor(h, [&](Index w) { ring.push_back(w); });
    for (const Index g : halfedges_around_target(level, h))
      if (!level.is_border(g))
        for (Index c = level.next(level.next(g)); level.next(c) != g; c = level.next(c))
          ring.push_back(level.target(c));
    if (rings > 1) append_outer_rings(level, h, rings, {ring.begin() + begin, ring.end()}, ring);
  }

  // The first ring that the vertex will have in the next round of a host that splits edges, in the
  // same order.
  template <class Host>
  static void append_next(const Level_connectivity& level, const Host& host, Index v,
                          std::vector<Index>& ring)
  {
    const auto halfedges = halfedges_around_target(level, level.halfedge_of_vertex(v));
    ring.push_back(v);
    for (const Index h : halfedges)
      ring.push_back(host.vertex_of_edge(Level_connectivity::edge(level.next(h))));
    if constexpr (Host::refined_degree == 4)
      for (const Index h : halfedges)
        if (!level.is_border(h)) ring.push_back(host.vertex_of_face(level.face(h)));
  }

private:
  static void append_outer_rings(const Level_connectivity& level, Index h, unsigned rings,
                                 std::unordered_set<Index>&& known, std::vector<Index>& ring)
  {
    std::vector<Index> in; // a half-edge into each vertex of the last ring, found from the center
    for (const Index g : halfedges_around_target(level, h)) {
      in.push_back(level.next(g));
      if (!level.is_border(g))
        for (Index c = level.next(level.next(g)); level.next(c) != g; c = level.next(c))
          in.push_back(c);
    }
    std::vector<Index> next_in;
    for (unsigned r = 1; r < rings; ++r) {
      next_in.clear();
      for (const Index first : in)
        for (const Index g : halfedges_around_target(level, first))
          if (!level.is_border(g))
            for (Index c = level.next(g); c != g; c = level.next(c))
              if (known.insert(level.target(c)).second) {
                ring.push_back(level.target(c));
                next_in.push_back(c);
              }
      in.swap(next_in);
    }
  }
};

// The kinds of rings that the vertices of a level have: one for each valence, in the interior and on
// the border. A kind is made where it occurs first, from the scheme itself at work around the vertex.
// On borders of sqrt(3), which are refined in every other round, two rounds make a step.
template <class Scheme, class FT>
class Ring_rules_cache
{
  using Key =
    std::tuple<bool, bool, Level_connectivity::Index>; // on the border, next round is odd, valence

public:
  using Index = Level_connectivity::Index;
  using Rules = Ring_rules<Scheme, FT>;
  using Host = typename Scheme::Host;

  struct Kind
  {
    std::unique_ptr<Rules> ring_rules;
    unsigned rings = 1; // how many the class takes
  };

  explicit Ring_rules_cache(const Scheme& scheme)
    : scheme_(scheme)
    , any_round_((std::max)(101u, facts_of(scheme).first_round | 1u))
  {}

  // the kind of a vertex with edges, in the round that is next; threads may ask at the same time
  const Kind& at(const Level_connectivity& level, Index v, unsigned next_round)
  {
    return at(level, v, key(level, v, level.valence(v), next_round));
  }

  // The same for one thread, which mostly asks for the kind that it asked for before.
  class Recent
  {
  public:
    Recent(Ring_rules_cache& rules_cache, const Level_connectivity& level, unsigned next_round)
      : rules_cache_(rules_cache)
      , level_(level)
      , next_round_(next_round)
    {}
    const Kind& operator()(Index v, Index valence)
    {
      const Key key = Ring_rules_cache::key(level_, v, valence, next_round_);
      if (kind_ == nullptr || key != key_) {
        kind_ = &rules_cache_.at(level_, v, key);
        key_ = key;
      }
      return *kind_;
    }

  private:
    Ring_rules_cache& rules_cache_;
    const Level_connectivity& level_;
    const unsigned next_round_;
    Key key_{};
    const Kind* kind_ = nullptr;
  };

private:
  static constexpr bool is_sqrt3 = std::is_same_v<Host, Sqrt3_host>;
  static constexpr unsigned most_rings = 3;

  static Key key(const Level_connectivity& level, Index v, Index valence, unsigned next_round)
  {
    const bool at_border = level.is_border_vertex(v);
    return {at_border, !is_sqrt3 || !at_border || next_round % 2 != 0, valence};
  }
  const Kind& at(const Level_connectivity& level, Index v, const Key& key)
  {
    const auto [at_border, is_odd, valence] = key;
    const std::lock_guard<std::mutex> lock(mutex_);
    Kind& kind = kinds_[key];
    if (!kind.ring_rules)
      kind = is_sqrt3 && at_border ? make_sqrt3_border(valence, is_odd) : make(level, v);
    return kind;
  }

  static Level_connectivity refined(const Level_connectivity& level, unsigned round)
  {
    return child_level<Host>(level, round, For_chunks());
  }

  // Refined twice, any vertex is alone among regular ones.
  Kind make(const Level_connectivity& level, Index v) const
  {
    constexpr auto nothing =
      Sub_level::Keeps::nothing; // so that it is the same at all vertices of the kind
    Sub_level around(level, {v}, 2, nothing);
    const Level_connectivity fine = refined(refined(around.level, any_round_), any_round_);
    const bool at_border = level.is_border_vertex(v);
    Kind kind;
    for (kind.rings = 1; kind.rings <= most_rings; ++kind.rings) {
      const Sub_level cut(fine, around.centers, kind.rings + 3, nothing);
      const Index c = cut.centers.front();
      Ring_pair rings;
      Vertex_ring::append(cut.level, c, kind.rings, rings.ring);
      Vertex_ring::append(refined(cut.level, any_round_), c, kind.rings, rings.next_ring);
      Ring_layout layout;
      layout.number = cut.level.valence(c);
      layout.at_border = at_border;
      layout.has_diagonals = Host::refined_degree == 4;
      kind.ring_rules = std::make_unique<Rules>(
        scheme_, std::vector<Ring_round>{{cut.level, any_round_, rings}}, layout);
      if (kind.ring_rules->is_valid()) return kind;
    }
    throw std::invalid_argument("PN_subdivision_3: the scheme has no limit mask on " +
                                std::to_string(most_rings) + " rings about a vertex of valence " +
                                std::to_string(level.valence(v)) +
                                (at_border ? " on the border" : ""));
  }

  // The vertex and its neighbors, of a fan that starts with an odd round. After it one more triangle is
  // at the vertex, and after the next as many as before.
  Kind make_sqrt3_border(Index valence, bool is_odd) const
  {
    const Index triangles = valence - (is_odd ? 1 : 2);
    if (triangles == 0)
      throw std::invalid_argument(
        "PN_subdivision_3: a face has two border edges, as none has after "
        "an odd round of sqrt(3): `rounds_done` cannot be right");
    std::vector<Level_connectivity> levels = {fan_of_triangles(triangles)};
    const unsigned first = is_odd ? any_round_ : any_round_ + 1;
    if (!is_odd) levels.front() = refined(levels.front(), any_round_);
    for (unsigned r = 0; r < 2; ++r) levels.push_back(refined(levels.back(), first + r));
    std::vector<Ring_round> rounds;
    Kind kind;
    for (unsigned r = 0; r < 2; ++r) {
      rounds.push_back({levels[r], first + r, {}});
      Vertex_ring::append(levels[r], 0, kind.rings, rounds.back().rings.ring);
      Vertex_ring::append(levels[r + 1], 0, kind.rings, rounds.back().rings.next_ring);
    }
    Ring_layout layout;
    layout.number = valence;
    layout.at_border = true;
    kind.ring_rules = std::make_unique<Rules>(scheme_, rounds, layout);
    return kind;
  }

  const Scheme& scheme_;
  // an odd one, in which sqrt(3) keeps the border, not the first, and one with the rules of all later ones
  unsigned any_round_;
  std::map<Key, Kind> kinds_;
  std::mutex mutex_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_CACHE_H
