// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_STENCIL_BLOCK_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_STENCIL_BLOCK_H

#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The stencils of a few new vertices, which are averaged together.
template <class FT_>
class Stencil_block
{
public:
  using FT = FT_;
  using Index = typename Stencil<FT>::Index;
  using Entry = typename Stencil<FT>::Entry;

  static constexpr std::size_t maximum_number_of_rows = 32;

  // the row that is being written
  Stencil<FT>& row() { return row_; }
  // ends it. \pre number_of_rows() < maximum_number_of_rows
  void close_row()
  {
    const std::size_t length = row_.size_ - row_.begin_;
    if (rows_ == 0)
      uniform_length_ = length;
    else if (length != uniform_length_)
      uniform_length_ = 0;
    ends_[rows_++] = row_.begin_ = row_.size_;
  }
  void clear()
  {
    row_.size_ = row_.begin_ = rows_ = 0;
    uniform_length_ = 0;
  }

  std::size_t number_of_rows() const { return rows_; }
  std::size_t number_of_entries() const { return row_.begin_; }
  const Entry* begin(std::size_t row) const
  {
    return row_.entries_.get() + (row == 0 ? 0 : ends_[row - 1]);
  }
  const Entry* end(std::size_t row) const { return row_.entries_.get() + ends_[row]; }
  // the length of every row if all rows are equally long, 0 otherwise
  std::size_t uniform_length() const { return uniform_length_; }

private:
  Stencil<FT> row_;
  std::size_t rows_ = 0;
  std::size_t uniform_length_ = 0;
  std::array<std::size_t, maximum_number_of_rows> ends_;
};

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

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_STENCIL_BLOCK_H
