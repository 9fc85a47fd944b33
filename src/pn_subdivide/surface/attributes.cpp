// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/attributes.h"

#include "io/Error.h"
#include "io/Text_reader.h"
#include "surface/surface_schemes.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>

namespace pn_subdivide {
namespace {

using Range = std::pair<double, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// Colors between 0 and 1 stay there, others within their own bounds; everything else is not bounded.
std::vector<Range> ranges_of(const Columns& columns)
{
  const Column_group color = find_color(columns);
  std::vector<Range> ranges;
  for (const Column& column : columns) {
    Range range(-infinity, infinity);
    if (contains(color, column) && !column.values.empty()) {
      const auto ends = std::minmax_element(column.values.begin(), column.values.end());
      range = {(std::min)(*ends.first, 0.), (std::max)(*ends.second, 1.)};
      if (traits(column.type).is_integer) range = {0, traits(column.type).highest};
    }
    ranges.push_back(range);
  }
  return ranges;
}

std::vector<std::string> names_in(const std::string& list)
{
  std::vector<std::string> names;
  std::istringstream words(list);
  for (std::string name; std::getline(words, name, ',');)
    if (!name.empty()) names.push_back(name);
  return names;
}

Column* find(Columns& columns, const std::string& name)
{
  const auto is_named = [&](const Column& column) { return column.name == name; };
  const auto found = std::find_if(columns.begin(), columns.end(), is_named);
  return found == columns.end() ? nullptr : &*found;
}

[[noreturn]] void throw_unknown(const char* option, const std::string& name, const Columns& columns)
{
  std::vector<std::string> names;
  for (const Column& column : columns)
    names.push_back("'" + Text_reader::printable(column.name) + "'");
  throw Error(std::string(option) + " '" + name + "': the vertices have no such number" +
              (names.empty() ? "" : "; they have " + enumeration(names)));
}

// A name that is none of a column is that before x, y and z.
std::vector<std::string> names_of_directions(const Columns& columns, const std::string& list)
{
  std::vector<std::string> names;
  for (const std::string& name : names_in(list)) {
    if (find_column(columns, name) != nullptr) {
      names.push_back(name);
      continue;
    }
    const bool is_joined = find_column(columns, name + "x") != nullptr;
    for (const char* const axis : {"x", "y", "z"}) {
      names.push_back(name + (is_joined ? "" : "_") + axis);
      if (find_column(columns, names.back()) == nullptr)
        throw_unknown("--directions", name, columns);
    }
  }
  if (names.size() % 3 != 0)
    throw Error("--directions '" + list + "': a direction has three numbers, these are " +
                std::to_string(names.size()));
  return names;
}

} // namespace

Texture_rule parse_texture_rule(const std::string& text)
{
  return parse_word<Texture_rule>("--texture-rule", text,
                                  {{"none", Texture_rule::none},
                                   {"corners-only", Texture_rule::corners_only},
                                   {"corners-plus1", Texture_rule::corners_plus1},
                                   {"corners-plus2", Texture_rule::corners_plus2},
                                   {"boundaries", Texture_rule::boundaries},
                                   {"all", Texture_rule::all}});
}

void set_rules(Attributes& attributes, const std::optional<std::string>& nearest,
               const std::optional<std::string>& directions)
{
  Columns& columns = attributes.of_vertices;
  const Column_group color = find_color(columns);
  for (Column& column : columns)
    column.is_label = traits(column.type).is_integer && !contains(color, column);
  for (const std::string& name : names_in(nearest.value_or(""))) {
    Column* const column = find(columns, name);
    if (column == nullptr) throw_unknown("--nearest", name, columns);
    column->is_label = true;
  }
  const std::vector<std::string> names = names_of_directions(columns, directions.value_or(""));
  for (std::size_t i = 0; i < names.size(); i += 3) {
    attributes.directions.push_back({names[i], names[i + 1], names[i + 2]});
    for (const std::string& name : attributes.directions.back()) {
      Column& column = *find(columns, name);
      const std::vector<std::string> labels = names_in(nearest.value_or(""));
      if (std::find(labels.begin(), labels.end(), name) != labels.end())
        throw Error("--directions '" + name + "': --nearest has it, too");
      column.is_label = false;
    }
  }
}

Old_elements::Old_elements(const Surface& surface)
  : corner_(surface.number_of_halfedges())
  , face_(surface.number_of_halfedges())
{
  std::size_t corner = 0;
  for (const Halfedge h : corners_of(surface)) {
    corner_[h] = corner++;
    face_[h] = surface.face(h);
  }
}

void Old_elements::follow(const Surface& surface, const Triangulation& triangulation,
                          Attributes& attributes) const
{
  std::vector<std::size_t> corners, faces;
  for (const Halfedge h : corners_of(surface))
    corners.push_back(corner_[triangulation.old_corner[h]]);
  for (const Face f : surface.faces())
    faces.push_back(face_[triangulation.old_corner[surface.halfedge(f)]]);
  select(attributes.texture, corners);
  select(attributes.of_faces, faces);
}

Carried_attributes::Carried_attributes(const Surface& surface, Attributes attributes,
                                       Texture_rule rule)
  : attributes_(std::move(attributes))
  , ranges_(ranges_of(attributes_.of_vertices))
{
  places_.assign(attributes_.of_vertices.size(), {none, 0});
  add_directions();
  add_others(surface.number_of_vertices());
  table_.has_face_parents = !attributes_.of_faces.empty();
  if (attributes_.texture.empty()) return;

  PN::Attribute_array texture;
  texture.rule = rule;
  texture.dimension = has_depth(attributes_.texture) ? 3 : 2;
  texture.values.resize(texture.dimension * surface.number_of_halfedges());
  std::size_t corner = 0;
  for (const Halfedge h : corners_of(surface)) {
    std::copy_n(attributes_.texture[corner++].begin(), texture.dimension,
                texture.values.begin() + std::ptrdiff_t(texture.dimension * std::size_t(h)));
  }
  table_.corners.push_back(std::move(texture));
  attributes_.texture = {};
}

void Carried_attributes::add_directions()
{
  const Columns& columns = attributes_.of_vertices;
  for (const auto& names : attributes_.directions) {
    PN::Attribute_array array;
    array.dimension = names.size();
    array.rule_of_vertices = PN::Attribute_rule::direction;
    std::size_t component = 0;
    for (const std::string& name : names) {
      const Column& column = *find_column(columns, name);
      places_[std::size_t(&column - columns.data())] = {table_.vertices.size(), component};
      array.values.resize(names.size() * column.values.size());
      for (std::size_t v = 0; v < column.values.size(); ++v)
        array.values[names.size() * v + component] = column.values[v];
      ++component;
    }
    table_.vertices.push_back(std::move(array));
  }
}

void Carried_attributes::add_others(std::size_t vertices)
{
  bool has_labels = false;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    Column& column = attributes_.of_vertices[i];
    has_labels = has_labels || column.is_label;
    if (places_[i].array != none || column.is_label) continue;
    places_[i].array = table_.vertices.size();
    table_.vertices.emplace_back();
    table_.vertices.back().values = std::move(column.values);
  }
  if (!has_labels) return;
  PN::Attribute_array numbers;
  numbers.rule_of_vertices = PN::Attribute_rule::nearest;
  numbers.values.resize(vertices);
  std::iota(numbers.values.begin(), numbers.values.end(), 0.);
  table_.vertices.push_back(std::move(numbers));
}

void Carried_attributes::suit(const Surface& surface, const std::string& scheme,
                              const std::string& input, Report& report)
{
  if (!table_.corners.empty() && !keeps_edges(scheme) && PN::has_seam(surface, table_.corners[0])) {
    table_.corners.clear();
    report.warn_of_dropped(
      input +
        ": not carried over to the result: texture coordinates, because they have "
        "seams and " +
        scheme + " keeps no edges",
      {"texture coordinates"});
  }
  std::vector<std::string> integers;
  for (const Column& column : attributes_.of_vertices)
    if (column.is_label && traits(column.type).is_integer)
      integers.push_back("'" + Text_reader::printable(column.name) + "'");
  if (!integers.empty())
    report.note(input + ": whole numbers of vertices are those of the nearest control vertex: " +
                enumeration(integers));
}

template <class Corners>
void Carried_attributes::fill(Attributes& attributes, Table& table, const Corners& corners) const
{
  for (std::size_t i = 0; i < attributes.of_vertices.size(); ++i) {
    Column& column = attributes.of_vertices[i];
    if (column.is_label) {
      select(column.values, table.vertices.back().values);
      continue;
    }
    const Place& place = places_[i];
    auto& array = table.vertices[place.array];
    if (array.dimension == 1)
      column.values = std::move(array.values);
    else {
      column.values.resize(array.values.size() / array.dimension);
      for (std::size_t v = 0; v < column.values.size(); ++v)
        column.values[v] = array.values[v * array.dimension + place.component];
    }
    const auto [lowest, highest] = ranges_[i];
    for (double& x : column.values) {
      if (x < lowest) x = lowest;
      if (x > highest) x = highest;
      x = nearest(column.type, x);
    }
  }
  select(attributes.of_faces, table.face_parents);
  if (table.corners.empty()) return;
  // Corners next to one without coordinates have none either.
  const auto& texture = table.corners[0];
  attributes.texture.reserve(corners.size());
  for (const auto& h : corners) {
    const auto begin = texture.values.begin() + std::ptrdiff_t(texture.dimension * std::size_t(h));
    Texture_point t = {0, 0, 0};
    for (std::size_t i = 0; i < texture.dimension; ++i)
      t[i] = nearest(attributes.texture_type, *(begin + std::ptrdiff_t(i)));
    attributes.texture.push_back(t);
  }
}

Attributes Carried_attributes::take(const Surface& refined)
{
  fill(attributes_, table_, corners_of(refined));
  return std::move(attributes_);
}

Attributes Carried_attributes::of_piece(const Table& table,
                                        const std::vector<std::size_t>& corners) const
{
  Attributes attributes = attributes_;
  Table copy = table;
  fill(attributes, copy, corners);
  return attributes;
}

} // namespace pn_subdivide
