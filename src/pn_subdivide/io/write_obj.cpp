// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Obj_attributes.h"
#include "io/formats.h"
#include "io/mesh_normals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

// The number of a normal or of a texture point at a corner of a vertex, from 0, or `none`.
using Numbers = std::function<std::size_t(std::size_t corner, Index vertex)>;

std::size_t no_number(std::size_t, Index)
{
  return none;
}
std::size_t that_of_vertex(std::size_t, Index vertex)
{
  return vertex;
}
Numbers those_of_corners(std::vector<std::size_t> numbers)
{
  return [all = std::move(numbers)](std::size_t corner, Index) { return all[corner]; };
}

// Bytes as fractions of 255; fractions are written as they are.
struct Obj_color
{
  Column_group channels;
  double divisor = 1;

  // Without channels if OBJ does not hold the color, which has no alpha there.
  static Obj_color of(const Columns& columns)
  {
    Obj_color color;
    Column_group channels = find_color(columns);
    if (!is_plain_color(channels)) return color;
    channels.resize(3);
    color.divisor = channels[0]->type == Scalar_type::uint8 ? 255 : 1;
    color.channels = channels;
    return color;
  }
};

struct Obj_content
{
  Held_attributes held;
  Obj_color color;
  Column_group statements; // in the order of `obj_statements`; nullptr where there is none

  explicit Obj_content(const Mesh_data& mesh)
    : held(mesh)
    , color(Obj_color::of(mesh.attributes.of_vertices))
  {
    held.take(color.channels);
    held.take_material_files();
    if (!mesh.attributes.texture.empty())
      held.take_texture();
    else
      held.take(find_texture(mesh.attributes.of_vertices));
    for (const Obj_statement& statement : obj_statements) {
      const Column* column = find_column(mesh.attributes.of_faces, statement.column);
      if (column != nullptr && !traits(column->type).is_integer) column = nullptr;
      if (column != nullptr) held.take({column});
      statements.push_back(column);
    }
  }
};

std::string word_of(const Column& column, double value, bool has_words)
{
  if (!has_words) return value > 0 ? std::to_string(static_cast<std::int64_t>(value)) : "off";
  return value < 0 ? "default" : word_of(column, value);
}

// What holds for face f and did not for the one before. Where a file begins, nothing holds.
void write_statements(Output_file& out, const Column_group& statements, std::size_t f)
{
  for (std::size_t i = 0; i < statements.size(); ++i) {
    if (statements[i] == nullptr) continue;
    const bool has_words = obj_statements[i].has_words;
    const double value = statements[i]->values[f];
    const double before = f > 0 ? statements[i]->values[f - 1] : has_words ? -1 : 0;
    if (value == before) continue;
    out.text(obj_statements[i].keyword);
    out.text(" " + word_of(*statements[i], value, has_words) + "\n");
  }
}

void write_points(Output_file& out, const Mesh_data& mesh, const Obj_color& color)
{
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    out.text("v ");
    write_triple(out, mesh.points[v]);
    for (const Column* channel : color.channels) {
      out.text(" ");
      out.number(channel->values[v] / color.divisor);
    }
    out.text("\n");
  }
}

void write_texture_points(Output_file& out, const std::vector<Texture_point>& texture)
{
  const bool with_depth = has_depth(texture);
  for (const Texture_point& t : texture) {
    out.text("vt ");
    out.number(t[0]);
    out.text(" ");
    out.number(t[1]);
    if (with_depth) {
      out.text(" ");
      out.number(t[2]);
    }
    out.text("\n");
  }
}

Numbers write_texture(Output_file& out, const Mesh_data& mesh)
{
  if (mesh.attributes.texture.empty()) {
    const std::vector<Texture_point> of_vertices = texture_of_vertices(mesh);
    write_texture_points(out, of_vertices);
    return of_vertices.empty() ? no_number : that_of_vertex;
  }
  Different_values different(mesh, mesh.attributes.texture);
  std::vector<std::size_t> number(different.values.size(), none);
  std::size_t written = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (is_none(different.values[i])) continue;
    different.values[written] = different.values[i];
    number[i] = written++;
  }
  different.values.resize(written);
  write_texture_points(out, different.values);
  for (std::size_t& n : different.of_corner) n = number[n];
  return those_of_corners(std::move(different.of_corner));
}

// The normals of a mesh where some vertices have several, in the order of the first corners that have them.
struct Some_several
{
  static constexpr Index unknown = static_cast<Index>(-1);

  explicit Some_several(const Mesh_data& mesh)
    : of_vertex(mesh.points.size(), unknown)
  {
    std::unordered_map<Index, std::vector<Index>> of_several;
    auto several = mesh.several_normals.begin();
    for (std::size_t c = 0; c < mesh.number_of_corners(); ++c) {
      const Index v = mesh.vertices_of_corners()[c];
      if (several == mesh.several_normals.end() || several->corner != c) {
        if (of_vertex[v] == unknown) of_vertex[v] = add(mesh.normals[v]);
        continue;
      }
      std::vector<Index>& numbers = of_several[v];
      const auto same = std::find_if(numbers.begin(), numbers.end(), [&](Index i) {
        return are_equal(values[i], several->normal);
      });
      const bool is_new = same == numbers.end();
      of_corner[c] = is_new ? add(several->normal) : *same;
      if (is_new) numbers.push_back(of_corner[c]);
      ++several;
    }
  }
  Index add(const Triple& n)
  {
    values.push_back(n);
    return static_cast<Index>(values.size() - 1);
  }

  std::vector<Triple> values;
  std::vector<Index> of_vertex;
  std::unordered_map<std::size_t, Index> of_corner; // where the vertex has none
};

Numbers write_normals(Output_file& out, const Mesh_data& mesh)
{
  const auto write = [&out](const std::vector<Triple>& normals) {
    for (const Triple& n : normals) {
      out.text("vn ");
      write_triple(out, n);
      out.text("\n");
    }
  };
  if (!mesh.has_normals()) return no_number;
  if (!mesh.has_corner_normals()) {
    write(mesh.normals);
    return that_of_vertex;
  }
  if (!mesh.several_normals.empty()) {
    const auto some = std::make_shared<Some_several>(mesh);
    write(some->values);
    return [some](std::size_t corner, Index vertex) -> std::size_t {
      const Index number = some->of_vertex[vertex];
      return number != Some_several::unknown ? number : some->of_corner.at(corner);
    };
  }
  Different_values different(mesh, mesh.corner_normals);
  write(different.values);
  return those_of_corners(std::move(different.of_corner));
}

// v, v/t, v//n or v/t/n
void write_corner(Output_file& out, std::size_t v, std::size_t t, std::size_t n)
{
  out.text(" ");
  write_count(out, v + 1);
  if (t != none || n != none) out.text("/");
  if (t != none) write_count(out, t + 1);
  if (n == none) return;
  out.text("/");
  write_count(out, n + 1);
}

} // namespace

std::vector<std::string> not_held_by_obj(const Mesh_data& mesh, Encoding)
{
  return Obj_content(mesh).held.rest();
}

void write_obj(Output_file& out, const Mesh_data& mesh, Encoding)
{
  const Obj_content content(mesh);
  for (const std::string& file : mesh.attributes.material_files) out.text("mtllib " + file + "\n");
  write_points(out, mesh, content.color);
  const Numbers texture = write_texture(out, mesh);
  const Numbers normals = write_normals(out, mesh);
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    write_statements(out, content.statements, f);
    out.text("f");
    for (const Index v : mesh.face(f)) {
      write_corner(out, v, texture(corner, v), normals(corner, v));
      ++corner;
    }
    out.text("\n");
  }
  write_obj_tags(out, mesh.tags);
}

} // namespace pn_subdivide
