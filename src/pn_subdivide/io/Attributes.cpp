// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Attributes.h"

#include <algorithm>
#include <cmath>

namespace pn_subdivide {
namespace {

// The columns of these names, which must be there and have one type.
Column_group find_all(const Columns& columns, const std::vector<std::string>& names)
{
  Column_group found;
  for (const std::string& name : names) {
    const Column* const column = find_column(columns, name);
    if (column == nullptr || (!found.empty() && column->type != found[0]->type)) return {};
    found.push_back(column);
  }
  return found;
}

} // namespace

bool is_none(const Texture_point& t)
{
  return !(std::isfinite(t[0]) && std::isfinite(t[1]) && std::isfinite(t[2]));
}

bool is_less(const Texture_point& a, const Texture_point& b)
{
  if (is_none(a) || is_none(b)) return !is_none(a) && is_none(b);
  return a < b;
}

bool are_equal(const Texture_point& a, const Texture_point& b)
{
  return a == b || (is_none(a) && is_none(b));
}

bool has_depth(const std::vector<Texture_point>& texture)
{
  return std::any_of(texture.begin(), texture.end(),
                     [](const Texture_point& t) { return !is_none(t) && t[2] != 0; });
}

const Column* find_column(const Columns& columns, const std::string& name)
{
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&name](const Column& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

Column_group find_color(const Columns& columns)
{
  for (const std::string before : {"", "diffuse_"}) {
    Column_group color = find_all(columns, {before + "red", before + "green", before + "blue"});
    if (color.empty()) continue;
    const Column* const alpha = find_column(columns, before + "alpha");
    if (alpha != nullptr && alpha->type == color[0]->type) color.push_back(alpha);
    return color;
  }
  return {};
}

Column_group find_texture(const Columns& columns)
{
  const std::vector<std::string> pairs[] = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
  for (const auto& names : pairs) {
    Column_group texture = find_all(columns, names);
    if (!texture.empty()) return texture;
  }
  return {};
}

} // namespace pn_subdivide
