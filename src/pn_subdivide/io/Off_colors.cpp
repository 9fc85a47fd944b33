// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Off_colors.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace pn_subdivide {

void Off_colors::read(Text_reader& in, std::size_t words)
{
  ++size_;
  if (words == 0 && entries_.empty()) return;
  entries_.resize(size_ - 1, gray);
  Color_entry entry = gray;
  entry.words = words;
  if (words == 1) {
    in.integer("a number of the color map");
    has_numbers_of_color_map_ = true;
  } else if (words == 2 || words > 4) {
    in.fail("a color of " + std::to_string(words) + " numbers; it has three or four");
  }
  for (std::size_t i = 0; words > 1 && i < words; ++i) {
    const std::string_view word = in.word();
    entry.channels[i] = in.to_number(word, "a color");
    if (word.find_first_not_of("0123456789+-") != std::string_view::npos) entry.is_whole = false;
  }
  const double highest = entry.is_whole ? 255 : 1;
  for (std::size_t i = 0; words > 1 && i < words; ++i)
    if (!(entry.channels[i] >= 0 && entry.channels[i] <= highest))
      in.fail(
        std::string(
          "a color out of range: its numbers must be whole ones from 0 to 255, or from 0 to 1") +
        reading_without_it);
  has_alpha_ = has_alpha_ || words == 4;
  entries_.push_back(entry);
}

// Among fractions 1 0 0 is as much a color as 255 0 0.
bool Off_colors::Color_entry::is_fraction() const
{
  const auto end = channels.begin() + std::ptrdiff_t(words);
  return !is_whole || (words > 0 && *std::max_element(channels.begin(), end) <= 1);
}

Columns Off_colors::columns() const
{
  if (has_numbers_of_color_map_ || entries_.empty()) return {};
  const bool all_whole = std::all_of(entries_.begin(), entries_.end(),
                                     [](const Color_entry& entry) { return entry.is_whole; });
  const char* const names[] = {"red", "green", "blue", "alpha"};
  Columns columns;
  for (std::size_t i = 0; i < (has_alpha_ ? 4 : 3); ++i) {
    Column column;
    column.name = names[i];
    column.type = all_whole ? Scalar_type::uint8 : Scalar_type::float64;
    for (const Color_entry& entry : entries_) {
      const double x = entry.channels[i];
      const bool is_opaque = i == 3 && entry.words < 4;
      column.values.push_back(all_whole ? x : !entry.is_fraction() ? x / 255 : is_opaque ? 1 : x);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

} // namespace pn_subdivide
