// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_CACHE_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_CACHE_H

#include <CGAL/PN_limit_surface_3/internal/limit/Has_final_rules.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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
    , any_round_((std::max)(101u, first_tuned_round(scheme) | 1u))
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

  // the ring of a vertex of the kind
  static void append_ring(const Level_connectivity& level, Index v, const Kind& kind,
                          std::vector<Index>& ring)
  {
    Vertex_ring::append(level, v, kind.rings, ring);
  }

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

  Level_connectivity refined(const Level_connectivity& level) const
  {
    return refined(level, any_round_);
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
    const Level_connectivity fine = refined(refined(around.level));
    const bool at_border = level.is_border_vertex(v);
    Kind kind;
    for (kind.rings = 1; kind.rings <= most_rings; ++kind.rings) {
      const Sub_level cut(fine, around.centers, kind.rings + 3, nothing);
      const Index c = cut.centers.front();
      Ring_pair rings;
      Vertex_ring::append(cut.level, c, kind.rings, rings.ring);
      Vertex_ring::append(refined(cut.level), c, kind.rings, rings.next_ring);
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
      append_ring(levels[r], 0, kind, rounds.back().rings.ring);
      append_ring(levels[r + 1], 0, kind, rounds.back().rings.next_ring);
    }
    Ring_layout layout;
    layout.number = valence;
    layout.at_border = true;
    kind.ring_rules = std::make_unique<Rules>(scheme_, rounds, layout);
    return kind;
  }

  // Triangles about vertex 0, which is on the border. Edge i leads to it from neighbor i, which is
  // vertex 1 + i, and then come the edges opposite to vertex 0.
  static Level_connectivity fan_of_triangles(Index triangles)
  {
    const Index spokes = triangles + 1;
    Level_size size;
    size.vertices = 1 + spokes;
    size.edges = spokes + triangles;
    size.faces = triangles;
    size.corners = std::size_t(3) * triangles;
    Level_connectivity level(size);
    level.set_uniform_degree(3);
    for (Index i = 0; i < spokes; ++i) {
      level.set_target(2 * i, 0);
      level.set_target(2 * i + 1, 1 + i);
    }
    level.set_halfedge_of_vertex(0, 2 * triangles);
    level.set_border(2 * triangles);
    level.set_border(1);
    level.set_next(2 * triangles, 1);
    level.set_halfedge_of_vertex(1, 1);
    for (Index i = 0; i < triangles; ++i) {
      const Index in = 2 * i, out = 2 * i + 3, across = 2 * (spokes + i), outer = across + 1;
      level.set_target(across, 1 + i);
      level.set_target(outer, 2 + i);
      level.set_next(in, out);
      level.set_next(out, across);
      level.set_next(across, in);
      for (const Index h : {in, out, across}) level.set_face(h, i);
      level.set_halfedge_of_face(i, in);
      level.set_border(outer);
      level.set_halfedge_of_vertex(2 + i, outer);
      level.set_next(i == 0 ? 1 : outer - 2, outer);
    }
    level.set_next(2 * (spokes + triangles) - 1, 2 * triangles);
    return level;
  }

  const Scheme& scheme_;
  // an odd one, in which sqrt(3) keeps the border, not the first, and one with the rules of all later ones
  unsigned any_round_;
  std::map<Key, Kind> kinds_;
  std::mutex mutex_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_CACHE_H
