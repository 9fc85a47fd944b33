// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Held_attributes.h"

#include "io/Obj_attributes.h"
#include "io/Text_reader.h"
#include "io/corner_normals.h"

#include <algorithm>
#include <utility>

namespace pn_subdivide {
namespace {

bool contains(const Column_group& group, const Column& column)
{
  return std::find(group.begin(), group.end(), &column) != group.end();
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

} // namespace

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
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) {
      const Texture_point& t = of_corners[corner++];
      if (is_none(t) || (is_set[v] && result[v] != t)) return {};
      result[v] = t;
      is_set[v] = true;
    }
  return result;
}

namespace {

template <class T>
void append_copies(std::vector<T>& values, const std::vector<Mesh_data::Index>& originals)
{
  if (values.empty()) return;
  for (const Mesh_data::Index v : originals) values.push_back(T(values[v]));
}

} // namespace

std::size_t split_at_seams(Mesh_data& mesh)
{
  std::vector<Texture_point>& texture = mesh.attributes.texture;
  if (texture.empty() || has_depth(texture)) return 0;
  const auto without = std::size_t(std::count_if(texture.begin(), texture.end(), is_none));
  std::replace_if(texture.begin(), texture.end(), is_none, Texture_point{0, 0, 0});
  const Different_values different(mesh, texture);
  std::vector<Mesh_data::Index> originals, number, corners;
  std::vector<bool> is_taken(mesh.points.size(), false);
  for (const Mesh_data::Index v : different.vertex) {
    number.push_back(is_taken[v] ? Mesh_data::Index(mesh.points.size() + originals.size()) : v);
    if (is_taken[v]) originals.push_back(v);
    is_taken[v] = true;
  }
  for (const std::size_t i : different.of_corner) corners.push_back(number[i]);
  for (Corner_normal& n : mesh.several_normals) n.vertex = corners[n.corner];
  mesh.set_vertices(std::move(corners));
  append_copies(mesh.points, originals);
  append_copies(mesh.normals, originals);
  append_copies(mesh.control_normals, originals);
  append_copies(mesh.roundness, originals);
  append_copies(mesh.tags.vertices, originals);
  for (Column& column : mesh.attributes.of_vertices) append_copies(column.values, originals);
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
    Column column{i == 0 ? "texture_u" : "texture_v",
                  attributes.texture_type,
                  {},
                  {},
                  attributes.has_texture_type_of_file};
    for (const Texture_point& t : texture) column.values.push_back(t[i]);
    attributes.of_vertices.push_back(std::move(column));
  }
  attributes.texture.clear();
}

} // namespace pn_subdivide
