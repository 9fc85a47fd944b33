// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OFF_COLORS_H
#define PN_SUBDIVIDE_OFF_COLORS_H

#include "io/Attributes.h"
#include "io/Text_reader.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pn_subdivide {

// The colors of vertices or faces in an OFF file: three or four numbers, whole ones from 0 to 255 or
// others from 0 to 1. If files have both, all become numbers from 0 to 1. Where there is no color it
// is the gray that the format's own viewer takes. A single number is one of a color map, which the
// file does not hold.
class Off_colors
{
public:
  // Reads so many words, the color of the next element.
  void read(Text_reader& in, std::size_t words);

  bool has_numbers_of_color_map() const { return has_numbers_of_color_map_; }

  // Empty if there is no color, or a number of a color map.
  Columns columns() const;

private:
  struct Color_entry
  {
    std::array<double, 4> channels;
    std::size_t words; // of the channels in the file
    bool is_whole;

    bool is_fraction() const;
  };

  static constexpr Color_entry gray{{170, 170, 170, 255}, 0, true};

  std::size_t size_ = 0;
  std::vector<Color_entry> entries_; // empty, as long as there is no color
  bool has_alpha_ = false, has_numbers_of_color_map_ = false;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OFF_COLORS_H
