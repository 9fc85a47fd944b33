// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"

#include "io/Obj_attributes.h"
#include "io/Text_reader.h"
#include "io/mesh_normals.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <system_error>
#include <utility>

namespace pn_subdivide {
namespace fs = std::filesystem;

namespace {

bool is_float(double x)
{
  return !(std::abs(x) > std::numeric_limits<float>::max());
}

// Columns of a group become such of a type, if none has one of the file.
template <class Fits>
void make_typed(const Column_group& group, Scalar_type type, double factor, const Fits& fits,
                Columns& columns)
{
  const auto may_become = [&](const Column* column) {
    return !column->has_type_of_file && column->type == Scalar_type::float64 &&
           std::all_of(column->values.begin(), column->values.end(), fits);
  };
  if (!std::all_of(group.begin(), group.end(), may_become)) return;
  for (Column& column : columns) {
    if (!contains(group, column)) continue;
    column.type = type;
    for (double& x : column.values) x = nearest(type, factor * x);
  }
}

// Fractions of 1 become bytes.
void make_bytes(Columns& columns)
{
  make_typed(
    find_color(columns), Scalar_type::uint8, 255, [](double) { return true; }, columns);
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

std::string name_of(const Column& column, const Columns& columns, const std::string& elements)
{
  if (column.name != "alpha" && contains(find_color(columns), column))
    return "colors of " + elements;
  if (elements == "vertices" && contains(find_texture(columns), column))
    return "texture coordinates of vertices";
  for (const Obj_statement& statement : obj_statements)
    if (elements == "faces" && column.name == statement.column) return statement.plural;
  return "'" + Text_reader::printable(column.name) + "' of " + elements;
}

template <class T>
void append_copies(std::vector<T>& values, const std::vector<Index>& originals)
{
  if (values.empty()) return;
  for (const Index v : originals) values.push_back(T(values[v]));
}

} // namespace

void take_types_of_format(const Mesh_file& output, Attributes& attributes)
{
  if (!held_by(output).scalars) return;
  make_bytes(attributes.of_vertices);
  make_bytes(attributes.of_faces);
  make_typed(find_texture(attributes.of_vertices), Scalar_type::float32, 1, is_float,
             attributes.of_vertices);
  make_floats_of_corners(attributes);
}

void move_file_references(Attributes& attributes, const Mesh_file& input, const Mesh_file& output)
{
  if (attributes.material_files.empty() && attributes.texture_files.empty()) return;
  const fs::path from = folder_of(input), to = folder_of(output);
  if (from == to) return;
  for (std::string& names : attributes.material_files) names = all_moved(names, from, to);
  for (std::string& name : attributes.texture_files) name = moved(name, from, to);
}

std::vector<std::string> Held_attributes::rest() const
{
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  if (!texture_ && !attributes_.texture.empty()) add("texture coordinates");
  for (const Column& column : attributes_.of_vertices)
    if (taken_.count(&column) == 0) add(name_of(column, attributes_.of_vertices, "vertices"));
  for (const Column& column : attributes_.of_faces)
    if (taken_.count(&column) == 0) add(name_of(column, attributes_.of_faces, "faces"));
  if (!texture_files_ && !attributes_.texture_files.empty()) add("names of texture files");
  if (!material_files_ && !attributes_.material_files.empty()) add("names of material files");
  return names;
}

Column_group all_of(const Columns& columns)
{
  Column_group group;
  for (const Column& column : columns) group.push_back(&column);
  return group;
}

std::vector<Texture_point> texture_of_vertices(const Mesh_data& mesh)
{
  const std::vector<Texture_point>& of_corners = mesh.attributes.texture;
  const Column_group columns = find_texture(mesh.attributes.of_vertices);
  std::vector<Texture_point> result(mesh.points.size(), {0, 0, 0});
  if (of_corners.empty()) {
    if (columns.empty()) return {};
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = {columns[0]->values[v], columns[1]->values[v], 0};
    return result;
  }
  std::vector<bool> is_set(result.size(), false);
  for (std::size_t c = 0; c < of_corners.size(); ++c) {
    const Index v = mesh.vertices_of_corners()[c];
    if (is_none(of_corners[c]) || (is_set[v] && result[v] != of_corners[c])) return {};
    result[v] = of_corners[c];
    is_set[v] = true;
  }
  return result;
}

std::size_t split_at_seams(Mesh_data& mesh)
{
  std::vector<Texture_point>& texture = mesh.attributes.texture;
  if (texture.empty() || has_depth(texture)) return 0;
  const auto without = std::size_t(std::count_if(texture.begin(), texture.end(), is_none));
  std::replace_if(texture.begin(), texture.end(), is_none, Texture_point{0, 0, 0});
  const Different_values different(mesh, texture);
  std::vector<Index> originals, number, corners;
  std::vector<bool> is_taken(mesh.points.size(), false);
  for (const Index v : different.vertex) {
    number.push_back(is_taken[v] ? Index(mesh.points.size() + originals.size()) : v);
    if (is_taken[v]) originals.push_back(v);
    is_taken[v] = true;
  }
  for (const std::size_t i : different.of_corner) corners.push_back(number[i]);
  for (Corner_normal& n : mesh.several_normals) n.vertex = corners[n.corner];
  mesh.set_vertices(std::move(corners));
  mesh.for_each_array_of_vertices([&](auto& values) { append_copies(values, originals); });
  return without;
}

void move_texture_to_vertices(Mesh_data& mesh)
{
  Attributes& attributes = mesh.attributes;
  const std::vector<Texture_point> texture = texture_of_vertices(mesh);
  if (attributes.texture.empty() || texture.empty() || has_depth(texture) ||
      !find_texture(attributes.of_vertices).empty())
    return;
  for (std::size_t i = 0; i < 2; ++i) {
    Column column{i == 0 ? "texture_u" : "texture_v", attributes.texture_type};
    column.has_type_of_file = attributes.has_texture_type_of_file;
    for (const Texture_point& t : texture) column.values.push_back(t[i]);
    attributes.of_vertices.push_back(std::move(column));
  }
  attributes.texture.clear();
}

} // namespace pn_subdivide
