// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Obj_tags.h"

#include "io/Error.h"
#include "io/Output_file.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace pn_subdivide {
namespace {

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

std::string Obj_tags::read(Text_reader& in)
{
  const std::string name(in.word());
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
