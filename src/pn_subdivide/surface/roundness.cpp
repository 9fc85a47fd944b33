// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/roundness.h"

#include "io/Error.h"
#include "io/parse_numbers.h"
#include "surface/control_normals.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace pn_subdivide {
namespace {

using Source = Roundness_option::Source;

void require_range(const std::vector<double>& roundness)
{
  for (std::size_t v = 0; v < roundness.size(); ++v) {
    // schemes with negative weights write what is a little beyond
    if (roundness[v] >= -0.5 && roundness[v] <= 1.5) continue;
    char number[40];
    std::snprintf(number, sizeof number, "%g", roundness[v]);
    throw Error("vertex " + std::to_string(v) + " has the roundness " + number +
                ": it must be from 0 to 1");
  }
}

bool is_constant(const std::vector<double>& roundness)
{
  return std::all_of(roundness.begin(), roundness.end(),
                     [&](double w) { return w == roundness.front(); });
}

bool is_one(const std::vector<double>& roundness)
{
  return std::all_of(roundness.begin(), roundness.end(), [](double w) { return w == 1; });
}

} // namespace

Roundness_option parse_roundness_option(const std::string& text)
{
  if (text == "auto") return {};
  if (text == "file") return {Source::file, 1};
  if (text == "estimate") return {Source::estimate, 1};
  return {Source::constant, parse_roundness(text, "auto, file, estimate or ")};
}

void set_roundness(Mesh_data& mesh, const Roundness_option& option, std::vector<double> of_file,
                   bool has_normals_of_file, const Creases& creases)
{
  switch (option.source) {
  case Source::automatic:
    if (has_normals_of_file && !of_file.empty()) mesh.roundness = std::move(of_file);
    break;
  case Source::file:
    if (of_file.empty())
      throw Error("--roundness file, but the vertices have no property 'roundness'; --roundness "
                  "estimate reads it off the points");
    mesh.roundness = std::move(of_file);
    break;
  case Source::estimate:
    mesh.roundness = estimated_roundness(mesh, creases);
    break;
  case Source::constant:
    mesh.roundness.assign(mesh.points.size(), option.value);
    break;
  }
  require_range(mesh.roundness);
  if (is_one(mesh.roundness)) mesh.roundness.clear();
}

void suit_roundness(Mesh_data& mesh)
{
  const bool has_control_normals =
    mesh.has_control_normals() || (mesh.has_normals() && mesh.normal_kind == Normal_kind::control);
  if (!has_control_normals || is_one(mesh.roundness)) mesh.roundness.clear();
}

std::string roundness_description(const std::vector<double>& roundness)
{
  if (roundness.empty()) return {};
  const std::string of_all = std::to_string(roundness.size()) + " vertices";
  if (is_constant(roundness))
    return roundness.front() == 0 ? ", roundness 0 at all " + of_all : std::string();
  const auto zeros = std::count(roundness.begin(), roundness.end(), 0.);
  if (zeros > 0) return ", roundness 0 at " + std::to_string(zeros) + " of " + of_all;
  const auto below_1 =
    roundness.size() - std::size_t(std::count(roundness.begin(), roundness.end(), 1.));
  return ", roundness below 1 at " + std::to_string(below_1) + " of " + of_all;
}

} // namespace pn_subdivide
