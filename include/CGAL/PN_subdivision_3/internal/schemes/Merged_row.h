// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/container/small_vector.hpp>

#include <cmath>
#include <cstddef>
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
  void emit(Stencil& s) const
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

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H
