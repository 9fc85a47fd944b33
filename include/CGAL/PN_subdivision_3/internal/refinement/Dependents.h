// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_DEPENDENTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_DEPENDENTS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/Stencil_block.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Which new vertices of a round read an old one: the rows of the round, transposed.
class Dependents
{
public:
  using Index = Level_connectivity::Index;

  Dependents() = default;

  template <class Round>
  Dependents(const Round& round, std::size_t number_of_old_vertices)
    : begin_(number_of_old_vertices + 1, 0)
  {
    const auto n = static_cast<Index>(round.refined_size().vertices);
    Stencil_block<typename Round::FT> buffer;
    for (Index r = 0; r < n; ++r)
      round.for_each_entry(r, buffer, [&](Index v) { ++begin_[v + 1]; });
    for (std::size_t v = 0; v < number_of_old_vertices; ++v) begin_[v + 1] += begin_[v];
    // while the lists are filled, the end of each is where it begins
    readers_.resize(begin_.back());
    for (Index r = n; r-- > 0;)
      round.for_each_entry(r, buffer, [&](Index v) { readers_[--begin_[v + 1]] = r; });
    begin_.erase(begin_.begin());
    begin_.push_back(readers_.size());
  }

  bool is_empty() const { return begin_.empty(); }

  // calls f(r) for the new vertices whose rows read v; for some of them more than once
  template <class Function>
  void for_each(Index v, const Function& f) const
  {
    for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) f(readers_[i]);
  }

  std::size_t memory() const
  {
    return begin_.capacity() * sizeof(std::size_t) + readers_.capacity() * sizeof(Index);
  }

private:
  std::vector<std::size_t> begin_;
  std::vector<Index> readers_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_DEPENDENTS_H
