// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_LONG_RINGS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_LONG_RINGS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The neighbors of separated vertices of large valence, in a row. Each of the n edges there has a row of all
// of them: walking round the vertex n times takes longer than the averages.
class Long_rings
{
public:
  using Index = Level_connectivity::Index;

  // none
  Long_rings() = default;

  template <class Separated>
  Long_rings(const Level_connectivity& level, const Separated& separated)
  {
    for (const Index v : separated.vertices_of_valence(longest_walked + 1))
      rings_.emplace(v, Ring(level, v));
  }

  // calls f(w) for the neighbors of the target of h, clockwise, from the source of h on
  template <class Function>
  void for_each_neighbor(const Level_connectivity& level, Index h, const Function& f) const
  {
    const auto ring = rings_.empty() ? rings_.end() : rings_.find(level.target(h));
    if (ring != rings_.end()) return ring->second.for_each_from(h, f);
    Index g = h;
    do {
      f(level.source(g));
      g = level.next_around_target(g);
    } while (g != h);
  }

private:
  static constexpr Index longest_walked = 64;

  class Ring
  {
  public:
    Ring(const Level_connectivity& level, Index v)
    {
      const Index first = level.halfedge_of_vertex(v);
      Index h = first;
      do {
        places_.emplace_back(h, neighbors_.size());
        neighbors_.push_back(level.source(h));
        h = level.next_around_target(h);
      } while (h != first);
      std::sort(places_.begin(), places_.end());
    }

    template <class Function>
    void for_each_from(Index h, const Function& f) const
    {
      const std::size_t place =
        std::lower_bound(places_.begin(), places_.end(), std::pair(h, std::size_t(0)))->second;
      for (std::size_t i = place; i < neighbors_.size(); ++i) f(neighbors_[i]);
      for (std::size_t i = 0; i < place; ++i) f(neighbors_[i]);
    }

  private:
    std::vector<Index> neighbors_;
    std::vector<std::pair<Index, std::size_t>> places_; // of half-edges, in their order
  };

  std::map<Index, Ring> rings_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_LONG_RINGS_H
