// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_DEPENDENTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_DEPENDENTS_H

#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
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

// Finds the new vertices of a round whose rows read any of some old ones. Finds out in the first call what
// reads what.
class Row_readers
{
public:
  using Index = Level_connectivity::Index;

  // in the order of the numbers
  template <class Round>
  std::vector<Index> operator()(const Round& round, std::size_t number_of_old_vertices,
                                const std::vector<Index>& old)
  {
    if (dependents_.is_empty()) {
      is_marked_.assign(round.refined_size().vertices, 0);
      dependents_ = Dependents(round, number_of_old_vertices);
    }
    std::vector<Index> readers;
    for (Index v : old)
      dependents_.for_each(v, [&](Index r) {
        if (is_marked_[r] != 0) return;
        is_marked_[r] = 1;
        readers.push_back(r);
      });
    // unless there are few, looking at all marks costs less than sorting
    if (readers.size() < is_marked_.size() / 256)
      std::sort(readers.begin(), readers.end());
    else
      collect_marks(readers);
    for (Index r : readers) is_marked_[r] = 0;
    return readers;
  }

  std::size_t memory() const { return dependents_.memory() + is_marked_.size(); }

private:
  void collect_marks(std::vector<Index>& marked) const
  {
    auto end = marked.begin();
    const char* const marks = is_marked_.data();
    const char* const last = marks + is_marked_.size();
    for (const char* m = marks; (m = std::find(m, last, 1)) != last; ++m)
      *end++ = static_cast<Index>(m - marks);
  }

  Dependents dependents_;
  std::vector<char> is_marked_; // none of them between two calls
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_DEPENDENTS_H
