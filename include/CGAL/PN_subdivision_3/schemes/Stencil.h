// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_STENCIL_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_STENCIL_H

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

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
  BOOST_FORCEINLINE void add(Index vertex, const FT& weight)
  {
    if (size_ == capacity_) grow();
    entries_[size_].vertex = vertex;
    entries_[size_].weight = weight;
    ++size_;
  }

  /// adds `vertex` with the weight that the row misses to 1.
  ///
  /// The weights of the row then sum to 1: in exact number types exactly, in floating point exactly
  /// when they are added in the order of their emission. Emit the largest weight in this way. In an
  /// empty row it adds the weight 1, a copy of the vertex.
  void add_rest(Index vertex)
  {
    FT sum(0);
    for (std::size_t i = row_begin(); i < size_; ++i) sum += entries_[i].weight;
    add(vertex, FT(1) - sum);
  }
  /// @}

  /// \name Rows
  /// @{

  /// the most rows that a stencil holds.
  static constexpr std::size_t maximum_number_of_rows = 32;

  /// ends the row. \pre `number_of_rows() < maximum_number_of_rows`
  void close_row()
  {
    const std::size_t length = size_ - row_begin();
    if (rows_ == 0)
      uniform_length_ = length;
    else if (length != uniform_length_)
      uniform_length_ = 0;
    ends_[rows_++] = size_;
  }
  void clear()
  {
    size_ = rows_ = 0;
    uniform_length_ = 0;
  }
  std::size_t number_of_rows() const { return rows_; }
  const Entry* begin(std::size_t row) const
  {
    return entries_.get() + (row == 0 ? 0 : ends_[row - 1]);
  }
  const Entry* end(std::size_t row) const { return entries_.get() + ends_[row]; }
  /// the length of every row if all rows are equally long, 0 otherwise.
  std::size_t uniform_length() const { return uniform_length_; }
  /// @}

private:
  std::size_t row_begin() const { return rows_ == 0 ? 0 : ends_[rows_ - 1]; }

  BOOST_NOINLINE void grow()
  {
    std::unique_ptr<Entry[]> larger(new Entry[2 * capacity_]);
    std::move(entries_.get(), entries_.get() + size_, larger.get());
    entries_ = std::move(larger);
    capacity_ *= 2;
  }

  std::size_t capacity_ = 512;
  std::unique_ptr<Entry[]> entries_{new Entry[capacity_]};
  std::size_t size_ = 0;
  std::size_t rows_ = 0;
  std::size_t uniform_length_ = 0;
  std::array<std::size_t, maximum_number_of_rows> ends_;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_STENCIL_H
