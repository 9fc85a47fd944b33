// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_STENCIL_BLOCK_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_STENCIL_BLOCK_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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
  using Entry = typename Stencil<FT>::Entry;

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

// By keys, equal ones in their order: by numbers of one type, so that elements of all types share the sorting.
template <class Element, class Key>
void sort_stably(std::vector<Element>& elements, const Key& key)
{
  using Index = Level_connectivity::Index;
  std::vector<std::pair<Index, Index>> order; // keys and places
  order.reserve(elements.size());
  for (const Element& e : elements) order.emplace_back(key(e), static_cast<Index>(order.size()));
  std::sort(order.begin(), order.end());
  std::vector<Element> sorted;
  sorted.reserve(elements.size());
  for (const auto& of_element : order) sorted.push_back(std::move(elements[of_element.second]));
  elements.swap(sorted);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_STENCIL_BLOCK_H
