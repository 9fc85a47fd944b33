// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLY_COLUMNS_H
#define PN_SUBDIVIDE_PLY_COLUMNS_H

#include "io/Attributes.h"
#include "io/Ply_header.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pn_subdivide {

// The scalar properties of an element that are carried, all but those that mean points, normals and
// faces.
class Ply_columns
{
public:
  Ply_columns() = default;

  Ply_columns(const Ply_element& element, const std::vector<std::string>& others)
  {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Ply_property& p = element.properties[k];
      const bool is_other = std::find(others.begin(), others.end(), p.name) != others.end();
      carries_.push_back(!p.is_list && !is_other);
      if (!carries_.back()) continue;
      positions_.push_back(k);
      columns_.push_back({p.name, p.type, {}, {}, true});
    }
  }

  bool carries(std::size_t position) const
  {
    return position < carries_.size() && carries_[position];
  }

  void reserve(std::size_t elements)
  {
    for (Column& column : columns_) column.values.reserve(elements);
  }

  // All scalars of the next element.
  void add(const std::vector<double>& scalars)
  {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      columns_[i].values.push_back(scalars[positions_[i]]);
  }

  Columns take() { return std::move(columns_); }

private:
  Columns columns_;
  std::vector<std::size_t> positions_; // of the columns among the properties
  std::vector<bool> carries_;
};

// What comments of a PLY file say about its attributes: "TextureFile wood.png", "mtllib house.mtl"
// and, for the numbers 0, 1, ... of a property 'material', "material 0 red".
void read_ply_comments(const std::vector<std::string>& comments, Attributes& attributes);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLY_COLUMNS_H
