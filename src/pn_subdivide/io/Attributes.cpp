// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Attributes.h"

#include "io/Error.h"

#include <cmath>

namespace pn_subdivide {

const Scalar_traits& traits(Scalar_type type)
{
  // in the order of the enumerators
  static const Scalar_traits table[] = {
    {"char", "int8", "Int8", 1, true, -128, 127},
    {"uchar", "uint8", "UInt8", 1, true, 0, 255},
    {"short", "int16", "Int16", 2, true, -32768, 32767},
    {"ushort", "uint16", "UInt16", 2, true, 0, 65535},
    {"int", "int32", "Int32", 4, true, -2147483648., 2147483647},
    {"uint", "uint32", "UInt32", 4, true, 0, 4294967295.},
    {"float", "float32", "Float32", 4, false, 0, 0},
    {"double", "float64", "Float64", 8, false, 0, 0}};
  return table[static_cast<std::size_t>(type)];
}

std::string description(Scalar_type type)
{
  const Scalar_traits& t = traits(type);
  if (!t.is_integer) return t.ply;
  return formatted("%s (whole numbers from %.0f to %.0f)", t.ply, t.lowest, t.highest);
}

double nearest(Scalar_type type, double x)
{
  if (type == Scalar_type::float64) return x;
  if (type == Scalar_type::float32) return static_cast<double>(static_cast<float>(x));
  const Scalar_traits& t = traits(type);
  if (!(x > t.lowest)) return t.lowest;
  return x < t.highest ? std::floor(x + 0.5) : t.highest;
}

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

bool remove_columns(Columns& columns, const std::vector<std::string>& names)
{
  const auto end = std::remove_if(columns.begin(), columns.end(), [&names](const Column& column) {
    return std::find(names.begin(), names.end(), column.name) != names.end();
  });
  const bool found = end != columns.end();
  columns.erase(end, columns.end());
  return found;
}

std::string word_of(const Column& column, double value)
{
  if (value < static_cast<double>(column.words.size()))
    return column.words[static_cast<std::size_t>(value)];
  return std::to_string(static_cast<std::int64_t>(value));
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

bool is_plain_color(const Column_group& color)
{
  if (color.empty()) return false;
  const Scalar_type type = color[0]->type;
  if (type == Scalar_type::uint8) return true;
  if (traits(type).is_integer) return false;
  return std::all_of(color.begin(), color.end(), [](const Column* channel) {
    return std::all_of(channel->values.begin(), channel->values.end(),
                       [](double x) { return x >= 0 && x <= 1; });
  });
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
