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
#include <array>
#include <limits>

namespace pn_subdivide {
namespace {

using Range = std::pair<double, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Colors between 0 and 1 stay there, others within their own bounds; everything else is not bounded.
std::vector<Range> ranges_of(const Columns& columns)
{
  const Column_group color = find_color(columns);
  std::vector<Range> ranges;
  for (const Column& column : columns) {
    const bool is_color = std::find(color.begin(), color.end(), &column) != color.end();
    Range range(-infinity, infinity);
    if (is_color && !column.values.empty()) {
      const auto ends = std::minmax_element(column.values.begin(), column.values.end());
      range = {(std::min)(*ends.first, 0.), (std::max)(*ends.second, 1.)};
      if (traits(column.type).is_integer) range = {0, traits(column.type).highest};
    }
    ranges.push_back(range);
  }
  return ranges;
}

struct Rule_name
{
  const char* name;
  Texture_rule rule;
};
constexpr std::array<Rule_name, 6> rule_names{{{"none", Texture_rule::none},
                                               {"corners-only", Texture_rule::corners_only},
                                               {"corners-plus1", Texture_rule::corners_plus1},
                                               {"corners-plus2", Texture_rule::corners_plus2},
                                               {"boundaries", Texture_rule::boundaries},
                                               {"all", Texture_rule::all}}};

} // namespace

Texture_rule parse_texture_rule(const std::string& text)
{
  std::vector<std::string> names;
  for (const Rule_name& known : rule_names) {
    if (text == known.name) return known.rule;
    names.emplace_back(known.name);
  }
  throw Usage_error("--texture-rule '" + text +
                    "': expected none, corners-only, corners-plus1, "
                    "corners-plus2, boundaries or all" +
                    did_you_mean(text, names));
}

void require_texture_rule(Texture_rule rule, const std::string& text, const std::string& scheme)
{
  const bool needs_edges = rule == Texture_rule::boundaries || rule == Texture_rule::all;
  if (needs_edges && !keeps_edges(scheme))
    throw Usage_error("--texture-rule " + text + " and --scheme " + scheme +
                      " exclude each other: this scheme keeps no edges that could stay straight");
}

Old_elements::Old_elements(const Surface& surface)
  : corner_(surface.number_of_halfedges())
  , face_(surface.number_of_halfedges())
{
  std::size_t corner = 0;
  for (const Surface::Halfedge_index h : corners_of(surface)) {
    corner_[h] = corner++;
    face_[h] = surface.face(h);
  }
}

void Old_elements::follow(const Surface& surface, const Triangulation& triangulation,
                          Attributes& attributes) const
{
  std::vector<std::size_t> corners, faces;
  for (const Surface::Halfedge_index h : corners_of(surface))
    corners.push_back(corner_[triangulation.old_corner[h]]);
  for (const Surface::Face_index f : surface.faces())
    faces.push_back(face_[triangulation.old_corner[surface.halfedge(f)]]);
  select(attributes.texture, corners);
  select(attributes.of_faces, faces);
}

Carried_attributes::Carried_attributes(const Surface& surface, Attributes attributes,
                                       Texture_rule rule)
  : attributes_(std::move(attributes))
  , ranges_(ranges_of(attributes_.of_vertices))
{
  for (Column& column : attributes_.of_vertices) {
    table_.vertices.emplace_back();
    table_.vertices.back().values = std::move(column.values);
  }
  table_.has_face_parents = !attributes_.of_faces.empty();
  if (attributes_.texture.empty()) return;

  CGAL::PN_subdivision_3::Attribute_array texture;
  texture.rule = rule;
  texture.dimension = has_depth(attributes_.texture) ? 3 : 2;
  texture.values.resize(texture.dimension * surface.number_of_halfedges());
  std::size_t corner = 0;
  for (const Surface::Halfedge_index h : corners_of(surface)) {
    std::copy_n(attributes_.texture[corner++].begin(), texture.dimension,
                texture.values.begin() + std::ptrdiff_t(texture.dimension * std::size_t(h)));
  }
  table_.corners.push_back(std::move(texture));
  attributes_.texture = {};
}

void Carried_attributes::suit(const Surface& surface, const std::string& scheme,
                              const std::string& input, Report& report)
{
  if (!table_.corners.empty() && !keeps_edges(scheme) &&
      CGAL::PN_subdivision_3::has_seam(surface, table_.corners[0])) {
    table_.corners.clear();
    report.warn_of_dropped(
      input +
        ": not carried over to the result: texture coordinates, because they have "
        "seams and " +
        scheme + " keeps no edges",
      {"texture coordinates"});
  }
  const std::vector<std::string> integers = averaged_integers();
  if (!integers.empty())
    report.note(input +
                ": whole numbers of vertices are averaged and rounded: " + enumeration(integers));
}

std::vector<std::string> Carried_attributes::averaged_integers() const
{
  const Column_group color = find_color(attributes_.of_vertices);
  std::vector<std::string> names;
  for (const Column& column : attributes_.of_vertices)
    if (traits(column.type).is_integer &&
        std::find(color.begin(), color.end(), &column) == color.end())
      names.push_back("'" + Text_reader::printable(column.name) + "'");
  return names;
}

Attributes Carried_attributes::take(const Surface& refined)
{
  for (std::size_t i = 0; i < attributes_.of_vertices.size(); ++i) {
    Column& column = attributes_.of_vertices[i];
    column.values = std::move(table_.vertices[i].values);
    const auto [lowest, highest] = ranges_[i];
    for (double& x : column.values) {
      if (x < lowest) x = lowest;
      if (x > highest) x = highest;
      x = nearest(column.type, x);
    }
  }
  select(attributes_.of_faces, table_.face_parents);
  if (!table_.corners.empty()) take_texture(refined);
  return std::move(attributes_);
}

// Corners next to one without coordinates have none either.
void Carried_attributes::take_texture(const Surface& refined)
{
  const auto& texture = table_.corners[0];
  const std::vector<Surface::Halfedge_index> corners = corners_of(refined);
  attributes_.texture.reserve(corners.size());
  for (const Surface::Halfedge_index h : corners) {
    const auto begin = texture.values.begin() + std::ptrdiff_t(texture.dimension * std::size_t(h));
    Texture_point t = {0, 0, 0};
    for (std::size_t i = 0; i < texture.dimension; ++i)
      t[i] = nearest(attributes_.texture_type, *(begin + std::ptrdiff_t(i)));
    attributes_.texture.push_back(t);
  }
}

} // namespace pn_subdivide
