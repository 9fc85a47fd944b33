// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_STENCIL_H
#define CGAL_PN_SUBDIVISION_3_STENCIL_H

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The stencils of a few consecutive new vertices: for each a row of (old vertex, weight) entries.

A mask writes rows with `add()` and `add_rest()` and knows nothing else of this class. An old vertex
may occur more than once in a row, its weights then add up.

\tparam FT_ the number type of the weights
*/
template <class FT_>
class Stencil
{
public:
  using FT = FT_;
  using Index = std::uint32_t;

  struct Entry
  {
    Index vertex;
    FT weight;
  };

  /// \name Writing
  /// @{

  /// adds the entry (`vertex`, `weight`) to the row.
  void add(Index vertex, const FT& weight) { entries_.push_back(Entry{vertex, weight}); }

  /// adds `vertex` with the weight that the row misses to 1.
  ///
  /// The weights of the row then sum to 1: in exact number types exactly, in floating point exactly
  /// when they are added in the order of their emission. Emit the largest weight in this way.
  void add_rest(Index vertex)
  {
    FT sum(0);
    for (const Entry* e = entries_.data() + row_begin(); e != entries_.data() + entries_.size();
         ++e)
      sum += e->weight;
    add(vertex, FT(1) - sum);
  }
  /// @}

  /// \name Rows
  /// @{
  void close_row()
  {
    const std::size_t length = entries_.size() - row_begin();
    if (ends_.empty())
      uniform_length_ = length;
    else if (length != uniform_length_)
      uniform_length_ = 0;
    ends_.push_back(entries_.size());
  }
  void clear()
  {
    entries_.clear();
    ends_.clear();
    uniform_length_ = 0;
  }
  std::size_t number_of_rows() const { return ends_.size(); }
  const Entry* begin(std::size_t row) const
  {
    return entries_.data() + (row == 0 ? 0 : ends_[row - 1]);
  }
  const Entry* end(std::size_t row) const { return entries_.data() + ends_[row]; }
  /// the length of every row if all rows are equally long, 0 otherwise.
  std::size_t uniform_length() const { return uniform_length_; }
  /// @}

private:
  std::size_t row_begin() const { return ends_.empty() ? 0 : ends_.back(); }

  boost::container::small_vector<Entry, 320> entries_;
  boost::container::small_vector<std::size_t, 32> ends_;
  std::size_t uniform_length_ = 0;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_STENCIL_H
