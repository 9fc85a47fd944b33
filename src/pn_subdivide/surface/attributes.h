// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_ATTRIBUTES_H
#define PN_SUBDIVIDE_SURFACE_ATTRIBUTES_H

#include "io/Attributes.h"
#include "io/Report.h"
#include "surface/Surface.h"

#include <CGAL/PN_subdivision_3/attributes.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {

// A mesh's corners and the faces that they belong to, before its faces are split.
class Old_elements
{
public:
  explicit Old_elements(const Surface& surface);

  // The attributes of faces and corners become those of the split faces.
  void follow(const Surface& surface, const Triangulation& triangulation,
              Attributes& attributes) const;

private:
  std::vector<std::size_t> corner_, face_; // by half-edge
};

using Texture_rule = PN::Corner_rule;

// Throws Usage_error unless it is one of the words of --texture-rule.
Texture_rule parse_texture_rule(const std::string& text);

// Whole numbers of vertices that are no color, and those that --nearest names, are labels; --directions names unit vectors: each by
// three names in a row, or by one before x, y and z. Throws Error if there is no such number.
void set_rules(Attributes& attributes, const std::optional<std::string>& nearest,
               const std::optional<std::string>& directions);

// Attributes on their way through the rounds: the library gets the numbers of vertices and corners,
// which follow the rows of the scheme, and tells the parents of faces, from which these have their
// values.
class Carried_attributes
{
public:
  using Table = PN::Attribute_table;

  Carried_attributes(const Surface& surface, Attributes attributes, Texture_rule rule);

  // To be refined along with the mesh.
  Table& table() { return table_; }
  const Table& table() const { return table_; }

  // Drops texture coordinates with seams or gaps, with a warning, if the scheme keeps no edges. Notes
  // which integers are labels.
  void suit(const Surface& surface, const std::string& scheme, const std::string& input,
            Report& report);

  // Those of the refined mesh. Integers are rounded, colors stay in range.
  Attributes take(const Surface& refined);
  // Those of a piece with this table, and with these half-edges with a face.
  Attributes of_piece(const Table& table, const std::vector<std::size_t>& corners) const;

private:
  using Range = std::pair<double, double>;
  // of a column in the table: in which array, and behind how many others
  struct Place
  {
    std::size_t array, component;
  };

  void add_directions();
  // labels are those of the control vertices whose numbers the last array has
  void add_others(std::size_t vertices);
  template <class Corners>
  void fill(Attributes& attributes, Table& table, const Corners& corners) const;

  Attributes attributes_;     // without the numbers that are in the table
  std::vector<Place> places_; // of the columns of vertices
  std::vector<Range> ranges_; // of the columns of vertices
  Table table_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_ATTRIBUTES_H
