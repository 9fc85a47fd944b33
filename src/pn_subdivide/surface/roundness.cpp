// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Text_reader.h"
#include "surface/control_mesh.h"

#include <algorithm>
#include <utility>

namespace pn_subdivide {
namespace {

using Source = Roundness_option::Source;

void require_range(const Mesh_data& mesh)
{
  const auto require = [](double w, const auto& name) {
    // schemes with negative weights write what is a little beyond
    if (w >= -0.5 && w <= 1.5) return;
    throw Error(name() + formatted(" has the roundness %g: it must be from 0 to 1", w));
  };
  for (std::size_t v = 0; v < mesh.roundness.size(); ++v)
    require(mesh.roundness[v],
            [&] { return "vertex " + std::to_string(mesh.number_in_file(Index(v))); });
  if (mesh.corner_roundness.empty()) return;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (std::size_t i = 0; i < mesh.face(f).size(); ++i)
      require(mesh.corner_roundness[mesh.first_corner(f) + i],
              [&] { return "corner " + std::to_string(i) + " of face " + std::to_string(f); });
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

void suit(Mesh_data& mesh)
{
  if (is_one(mesh.roundness) && is_one(mesh.corner_roundness)) Roundness_of_file{mesh};
}

} // namespace

Roundness_option parse_roundness_option(const std::string& text)
{
  if (text == "auto") return {};
  if (text == "file") return {Source::file, 1};
  if (text == "estimate") return {Source::estimate, 1};
  return {Source::constant, parse_roundness(text, "auto, file, estimate or ")};
}

Roundness_of_file::Roundness_of_file(Mesh_data& mesh)
  : of_vertices(std::exchange(mesh.roundness, {}))
  , of_corners(std::exchange(mesh.corner_roundness, {}))
{}

void Roundness_of_file::put_into(Mesh_data& mesh)
{
  mesh.roundness = std::move(of_vertices);
  mesh.corner_roundness = std::move(of_corners);
}

void set_roundness(Mesh_data& mesh, const Roundness_option& option, Roundness_of_file&& of_file,
                   bool has_normals_of_file, const Creases& creases)
{
  switch (option.source) {
  case Source::automatic:
    if (has_normals_of_file && !of_file.of_vertices.empty()) of_file.put_into(mesh);
    break;
  case Source::file:
    if (of_file.of_vertices.empty())
      throw Error("--roundness file, but the vertices have no property 'roundness'; --roundness "
                  "estimate reads it off the points");
    of_file.put_into(mesh);
    break;
  case Source::estimate:
    put_estimated_roundness(mesh, creases);
    break;
  case Source::constant:
    mesh.roundness.assign(mesh.points.size(), option.value);
    mesh.corner_roundness.clear();
    break;
  }
  if (creases.without_fractions && option.source != Source::automatic)
    creases.without_fractions->has_roundness = false; // that of the mesh
  require_range(mesh);
  suit(mesh);
}

void suit_roundness(Mesh_data& mesh)
{
  const bool has_control_normals =
    mesh.has_control_normals() || (mesh.has_normals() && mesh.normal_kind == Normal_kind::control);
  if (has_control_normals)
    suit(mesh);
  else
    Roundness_of_file{mesh};
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
