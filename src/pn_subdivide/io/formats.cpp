// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <system_error>

namespace pn_subdivide {
namespace {

bool is_float(double x)
{
  return !(std::abs(x) > std::numeric_limits<float>::max());
}

bool has_no_type(const Column* column)
{
  return !column->has_type_of_file && column->type == Scalar_type::float64;
}

// Fractions of 1 become bytes.
void make_bytes(const Column_group& color, Columns& columns)
{
  if (!std::all_of(color.begin(), color.end(), has_no_type)) return;
  for (Column& column : columns) {
    if (std::find(color.begin(), color.end(), &column) == color.end()) continue;
    column.type = Scalar_type::uint8;
    for (double& x : column.values) x = nearest(Scalar_type::uint8, 255 * x);
  }
}

void make_floats(const Column_group& texture, Columns& columns)
{
  const auto holds_floats = [](const Column* column) {
    return has_no_type(column) &&
           std::all_of(column->values.begin(), column->values.end(), is_float);
  };
  if (!std::all_of(texture.begin(), texture.end(), holds_floats)) return;
  for (Column& column : columns) {
    if (std::find(texture.begin(), texture.end(), &column) == texture.end()) continue;
    column.type = Scalar_type::float32;
    for (double& x : column.values) x = nearest(Scalar_type::float32, x);
  }
}

void make_floats_of_corners(Attributes& attributes)
{
  if (attributes.has_texture_type_of_file) return;
  for (const Texture_point& t : attributes.texture)
    if (!std::all_of(t.begin(), t.end(), is_float)) return;
  attributes.texture_type = Scalar_type::float32;
  for (Texture_point& t : attributes.texture)
    for (double& x : t) x = nearest(Scalar_type::float32, x);
}

} // namespace

void take_types_of_format(const Mesh_file& output, Attributes& attributes)
{
  if (!holds_scalars(output)) return;
  make_bytes(find_color(attributes.of_vertices), attributes.of_vertices);
  make_bytes(find_color(attributes.of_faces), attributes.of_faces);
  make_floats(find_texture(attributes.of_vertices), attributes.of_vertices);
  make_floats_of_corners(attributes);
}

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Mesh_file& file)
{
  std::error_code error;
  const fs::path path = file.name == "-" ? fs::path("x") : fs::path(file.name);
  const fs::path folder = fs::weakly_canonical(fs::absolute(path, error).parent_path(), error);
  return error ? path.parent_path() : folder;
}

// "C:\parts\a.mtl" and "\\server\a.mtl", on every system
bool is_of_windows(const std::string& name)
{
  const bool has_drive = name.size() > 2 &&
                         std::isalpha(static_cast<unsigned char>(name[0])) != 0 && name[1] == ':' &&
                         (name[2] == '\\' || name[2] == '/');
  return has_drive || name.compare(0, 2, "\\\\") == 0;
}

std::string moved(const std::string& name, const fs::path& from, const fs::path& to)
{
  if (fs::path(name).is_absolute() || is_of_windows(name)) return name;
  return (from / name).lexically_normal().lexically_proximate(to).generic_string();
}

// A line may name several files, and the name of one may have blanks.
std::string all_moved(const std::string& names, const fs::path& from, const fs::path& to)
{
  std::error_code error;
  if (names.find(' ') == std::string::npos || is_of_windows(names) ||
      fs::exists(from / names, error))
    return moved(names, from, to);
  std::istringstream in(names);
  std::string result, name;
  while (in >> name) result += (result.empty() ? "" : " ") + moved(name, from, to);
  return result;
}

} // namespace

void move_file_references(Attributes& attributes, const Mesh_file& input, const Mesh_file& output)
{
  if (attributes.material_files.empty() && attributes.texture_files.empty()) return;
  const fs::path from = folder_of(input), to = folder_of(output);
  if (from == to) return;
  for (std::string& names : attributes.material_files) names = all_moved(names, from, to);
  for (std::string& name : attributes.texture_files) name = moved(name, from, to);
}

} // namespace pn_subdivide
