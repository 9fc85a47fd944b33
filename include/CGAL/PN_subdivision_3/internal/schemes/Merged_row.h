// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// approximate, since intervals may have no order
template <class FT>
double magnitude(const FT& x)
{
  return std::abs(double(CGAL::to_double(x)));
}

// Gathers the weights of a row whose vertices occur many times. Short rows are searched; long ones, about
// vertices of large valence, have a hash table.
template <class FT>
class Merged_row
{
public:
  using Index = Level_connectivity::Index;

  void add(Index vertex, const FT& weight)
  {
    if (entries_.size() > searched) return add_to_long_row(vertex, weight);
    for (auto& entry : entries_)
      if (entry.first == vertex) {
        entry.second += weight;
        return;
      }
    entries_.emplace_back(vertex, weight);
  }

  // writes the row; the entry of the largest weight comes last, by add_rest()
  template <class Stencil>
  void emit_row(Stencil& s) const
  {
    auto largest = entries_.begin();
    for (auto e = entries_.begin(); e != entries_.end(); ++e)
      if (magnitude(e->second) > magnitude(largest->second)) largest = e;
    for (auto e = entries_.begin(); e != entries_.end(); ++e)
      if (e != largest && !CGAL::certainly(e->second == FT(0))) s.add(e->first, e->second);
    s.add_rest(largest->first);
  }

private:
  static constexpr std::size_t searched = 64;

  void add_to_long_row(Index vertex, const FT& weight)
  {
    if (slots_.size() < 2 * entries_.size() + 2) make_slots();
    std::size_t& slot = find(vertex);
    if (slot != 0) {
      entries_[slot - 1].second += weight;
      return;
    }
    entries_.emplace_back(vertex, weight);
    slot = entries_.size();
  }

  void make_slots()
  {
    shift_ = 32;
    std::size_t size = 1;
    for (; size < 4 * entries_.size(); size *= 2) --shift_;
    slots_.assign(size, 0);
    for (std::size_t i = 0; i < entries_.size(); ++i) find(entries_[i].first) = i + 1;
  }

  // the slot that has the vertex, or the empty one where it belongs
  std::size_t& find(Index vertex)
  {
    // Fibonacci hashing: the upper bits of the product
    std::size_t i = static_cast<Index>(vertex * Index(2654435769u)) >> shift_;
    while (slots_[i] != 0 && entries_[slots_[i] - 1].first != vertex)
      i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }

  boost::container::small_vector<std::pair<Index, FT>, searched> entries_;
  std::vector<std::size_t> slots_; // positions in entries_, counted from 1; 0: empty
  int shift_ = 0;
};

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

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H
