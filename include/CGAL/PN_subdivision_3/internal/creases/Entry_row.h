// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ENTRY_ROW_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ENTRY_ROW_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A single row that a mask writes, to be read and changed.
template <class FT>
class Entry_row
{
public:
  using Index = Level_connectivity::Index;

  struct Entry
  {
    Index vertex;
    FT weight;
  };

  void add(Index vertex, const FT& weight) { entries_.push_back({vertex, weight}); }
  void add_rest(Index vertex)
  {
    FT sum(0);
    for (const Entry& e : entries_) sum += e.weight;
    add(vertex, FT(1) - sum);
  }
  void clear() { entries_.clear(); }

  const Entry* begin() const { return entries_.data(); }
  const Entry* end() const { return entries_.data() + entries_.size(); }

private:
  std::vector<Entry> entries_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ENTRY_ROW_H
