// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <cmath>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// approximate, since intervals may have no order
template <class FT>
double magnitude(const FT& x)
{
  return std::abs(double(CGAL::to_double(x)));
}

// Gathers the weights of a row whose vertices occur many times.
template <class FT>
class Merged_row
{
public:
  using Index = Level_connectivity::Index;

  void add(Index vertex, const FT& weight)
  {
    for (auto& entry : entries_)
      if (entry.first == vertex) {
        entry.second += weight;
        return;
      }
    entries_.emplace_back(vertex, weight);
  }

  // writes the row, the entry of the largest weight last and with the rest
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
  boost::container::small_vector<std::pair<Index, FT>, 64> entries_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_MERGED_ROW_H
