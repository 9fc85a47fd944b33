// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Obj_attributes.h"

#include "io/Error.h"
#include "io/Output_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pn_subdivide {

const Obj_statement obj_statements[4] = {{"o", "object", "objects", true},
                                         {"g", "group", "groups", true},
                                         {"usemtl", "material", "materials", true},
                                         {"s", "smoothing_group", "smoothing groups", false}};

namespace {

constexpr std::array<double, 4> white = {1, 1, 1, 1}; // where there is no color
constexpr double for_ever = 10;

double sharpness_of(Text_reader& in)
{
  const double s = in.number("a sharpness");
  if (!(s >= 0)) in.fail("a sharpness that is negative or no number");
  return s >= for_ever ? std::numeric_limits<double>::infinity() : s;
}

// "2/1/0"
std::array<std::int64_t, 3> read_counts(Text_reader& in)
{
  std::string_view word = in.word();
  std::array<std::int64_t, 3> counts{};
  for (std::int64_t& n : counts) {
    const std::size_t slash = (std::min)(word.find('/'), word.size());
    n = in.to_integer(word.substr(0, slash), "a number of values, as in 2/1/0,");
    if (n < 0 || n > 1000000) in.fail("a number of values out of range");
    word.remove_prefix((std::min)(slash + 1, word.size()));
  }
  return counts;
}

void write_sharpness(Output_file& out, double sharpness)
{
  out.text(" ");
  out.number(sharpness > std::numeric_limits<double>::max() ? for_ever : sharpness);
  out.text("\n");
}

} // namespace

bool Obj_attributes::read(std::string_view keyword, Text_reader& in, Mesh_data& mesh)
{
  if (keyword == "vt") {
    read_texture_point(in);
    return true;
  }
  if (keyword == "mtllib") {
    mesh.attributes.material_files.emplace_back(in.name());
    return true;
  }
  for (std::size_t i = 0; i < std::size(obj_statements); ++i)
    if (keyword == obj_statements[i].keyword) {
      read_statement(obj_statements[i], states_[i], in, mesh);
      return true;
    }
  return false;
}

void Obj_attributes::skip(std::string_view keyword, Text_reader& in)
{
  const bool has_name = std::any_of(std::begin(obj_statements), std::end(obj_statements),
                                    [keyword](const Obj_statement& statement) {
                                      return statement.has_words && keyword == statement.keyword;
                                    });
  if (has_name || keyword == "mtllib") in.name();
}

void Obj_attributes::read_texture_point(Text_reader& in)
{
  Texture_point t = {0, 0, 0};
  std::size_t i = 0;
  do {
    t[i] = in.number("a texture coordinate");
    if (!std::isfinite(t[i]))
      in.fail(std::string("a texture coordinate that is not finite") + reading_without_it);
  } while (++i < t.size() && !in.at_end_of_line());
  points_.push_back(t);
}

void Obj_attributes::read_color(Text_reader& in, Mesh_data& mesh)
{
  ++vertices_;
  const std::size_t left = in.words_left();
  if (left < 2) return;
  if (left != 3 && left != 4) return mesh.drop("numbers behind coordinates that are no color");
  std::array<double, 4> color = white;
  for (std::size_t i = 0; i < left; ++i) {
    color[i] = in.number("a color");
    if (!(color[i] >= 0 && color[i] <= 1))
      in.fail(std::string("a color out of range: its numbers must be from 0 to 1") +
              reading_without_it);
  }
  has_alpha_ = has_alpha_ || left == 4;
  colors_.resize(vertices_ - 1, white);
  colors_.push_back(color);
}

void Obj_attributes::read_statement(const Obj_statement& statement, State& state, Text_reader& in,
                                    Mesh_data& mesh)
{
  std::string_view name = statement.has_words ? in.name() : in.word();
  if (name.empty()) name = "default";
  if (!statement.has_words) {
    double number = 0;
    if (name == "on")
      number = 1;
    else if (name != "off") {
      const bool is_number =
        name.size() < 10 && name.find_first_not_of("0123456789") == std::string_view::npos;
      if (!is_number) {
        mesh.drop("smoothing groups that are no number");
        return;
      }
      number = std::stod(std::string(name));
    }
    if (number == 0 && !state.is_used) return; // as it is without
    state.value = number;
  } else {
    auto& words = state.column.words;
    const auto place = state.numbers.find(name);
    if (place == state.numbers.end()) {
      state.value = static_cast<double>(words.size());
      state.numbers.emplace(std::string(name), state.value);
      words.emplace_back(name);
    } else {
      state.value = place->second;
    }
  }
  if (!state.is_used) state.column.values.assign(faces_, statement.has_words ? -1 : 0);
  state.is_used = true;
}

void Obj_attributes::end_face()
{
  ++faces_;
  for (State& state : states_)
    if (state.is_used) state.column.values.push_back(state.value);
}

void Obj_attributes::put(Mesh_data& mesh)
{
  put_texture(mesh);
  put_colors(mesh);
  for (std::size_t i = 0; i < std::size(obj_statements); ++i) {
    if (!states_[i].is_used) continue;
    Column& column = states_[i].column;
    column.name = obj_statements[i].column;
    column.type = Scalar_type::int32;
    mesh.attributes.of_faces.push_back(std::move(column));
  }
}

void Obj_attributes::put_texture(Mesh_data& mesh) const
{
  for (const Corner& c : corners_)
    if (c.point >= points_.size())
      throw Error("line " + std::to_string(c.line) + ": " +
                  out_of_range("the face's texture index", c.point + 1, points_.size(),
                               "texture coordinates"));
  if (corners_.empty()) {
    if (!points_.empty()) mesh.drop("texture coordinates that no face has");
    return;
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.attributes.texture.assign(mesh.number_of_corners(), {nan, nan, nan});
  for (const Corner& c : corners_) mesh.attributes.texture[c.corner] = points_[c.point];
}

void Obj_attributes::put_colors(Mesh_data& mesh)
{
  if (colors_.empty()) return;
  colors_.resize(vertices_, white);
  const char* const names[] = {"red", "green", "blue", "alpha"};
  for (std::size_t i = 0; i < (has_alpha_ ? 4 : 3); ++i) {
    Column column;
    column.name = names[i];
    for (const auto& color : colors_) column.values.push_back(color[i]);
    mesh.attributes.of_vertices.push_back(std::move(column));
  }
}

std::string Obj_tags::read(Text_reader& in)
{
  std::string name(in.word());
  const bool is_crease = name == "crease", is_corner = name == "corner";
  if (!is_crease && !is_corner) return name;
  const auto [integers, floats, strings] = read_counts(in);
  if (integers < (is_crease ? 2 : 1) || floats < 1 || strings != 0)
    in.fail(is_crease ? "a crease has two vertices and a sharpness: t crease 2/1/0 A B S"
                      : "a corner has a vertex and a sharpness: t corner 1/1/0 V S");
  std::vector<std::int64_t> vertices;
  for (std::int64_t i = 0; i < integers; ++i) {
    vertices.push_back(in.integer("a vertex number"));
    places_.push_back({vertices.back(), in.line()});
  }
  // one for all, or one for each
  std::vector<double> sharpness;
  for (std::int64_t i = 0; i < floats; ++i) sharpness.push_back(sharpness_of(in));
  const std::size_t parts = vertices.size() - (is_crease ? 1 : 0);
  if (sharpness.size() != 1 && sharpness.size() != parts)
    in.fail("a tag with " + std::to_string(sharpness.size()) + " sharpnesses for " +
            std::to_string(parts));
  for (std::size_t i = 0; i < parts; ++i) {
    const double s = sharpness[sharpness.size() == 1 ? 0 : i];
    if (!(s > 0)) continue;
    if (is_corner)
      corners_.emplace_back(vertices[i], s);
    else
      tags_.edges.push_back(
        {{static_cast<std::uint32_t>(vertices[i]), static_cast<std::uint32_t>(vertices[i + 1])},
         s,
         {}});
  }
  return {};
}

Crease_tags Obj_tags::take(std::size_t number_of_vertices)
{
  for (const Place& place : places_)
    if (place.vertex < 0 || static_cast<std::uint64_t>(place.vertex) >= number_of_vertices)
      throw Error("line " + std::to_string(place.line) + ": vertex " +
                  std::to_string(place.vertex) + " of a tag is out of range, there are " +
                  std::to_string(number_of_vertices) + " vertices, from 0 on");
  if (!corners_.empty()) tags_.vertices.assign(number_of_vertices, 0.);
  for (const auto& [v, s] : corners_) {
    double& sharpness = tags_.vertices[static_cast<std::size_t>(v)];
    sharpness = (std::max)(sharpness, s);
  }
  return std::move(tags_);
}

void write_obj_tags(Output_file& out, const Crease_tags& tags)
{
  for (const Crease_tags::Edge& edge : tags.edges) {
    out.text("t crease 2/1/0 ");
    out.number(static_cast<std::uint64_t>(edge.ends[0]));
    out.text(" ");
    out.number(static_cast<std::uint64_t>(edge.ends[1]));
    write_sharpness(out, edge.sharpness);
  }
  for (std::size_t v = 0; v < tags.vertices.size(); ++v) {
    if (!(tags.vertices[v] > 0)) continue;
    out.text("t corner 1/1/0 ");
    out.number(static_cast<std::uint64_t>(v));
    write_sharpness(out, tags.vertices[v]);
  }
}

} // namespace pn_subdivide
