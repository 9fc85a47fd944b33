// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Output_file.h"
#include "io/formats.h"
#include "io/mesh_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace pn_subdivide {
namespace {

// The groups of the faces, which are solids of a text, or nullptr.
const Column* groups_of(const Mesh_data& mesh)
{
  const Column* const groups = find_column(mesh.attributes.of_faces, "group");
  return groups != nullptr && traits(groups->type).is_integer ? groups : nullptr;
}

// Groups with names of their own, and -1 for all other faces, in the order of their first faces.
std::vector<double> solids_of(const Column& groups)
{
  std::vector<double> solids;
  std::set<double> known;
  for (const double x : groups.values)
    if (const double group = (std::max)(x, -1.); known.insert(group).second)
      solids.push_back(group);
  return solids;
}

std::string name_of(const Column& groups, double group)
{
  if (group < 0) return {};
  return " " + word_of(groups, group);
}

void require_triangles(const Mesh_data& mesh)
{
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    if (mesh.face(f).size() != 3) throw Error("STL files hold triangles only");
}

void require_room(const Mesh_data& mesh)
{
  if (mesh.number_of_faces() > std::numeric_limits<std::uint32_t>::max())
    throw Error("STL files hold at most 2^32 - 1 triangles, not " +
                std::to_string(mesh.number_of_faces()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (const double x : mesh.points[v])
      if (!(std::abs(x) <= double(std::numeric_limits<float>::max())))
        throw Error("vertex " + std::to_string(v) +
                    " has a coordinate that is too great for the single precision of STL");
}

void write_facet_in_text(Output_file& out, const Mesh_data& mesh, std::size_t f)
{
  out.text("facet normal ");
  write_triple(out, face_normal(mesh, f));
  out.text("\nouter loop\n");
  for (const Index v : mesh.face(f)) {
    out.text("vertex ");
    write_triple(out, mesh.points[v]);
    out.text("\n");
  }
  out.text("endloop\nendfacet\n");
}

// A solid for each group.
void write_in_text(Output_file& out, const Mesh_data& mesh)
{
  const Column none{"", Scalar_type::int32, std::vector<double>(mesh.number_of_faces(), -1.), {}};
  const Column* const given = groups_of(mesh);
  const Column& groups = given != nullptr ? *given : none;
  std::map<double, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    faces[(std::max)(groups.values[f], -1.)].push_back(f);
  for (const double group : solids_of(groups)) {
    const std::string name = name_of(groups, group);
    out.text("solid" + name + "\n");
    for (const std::size_t f : faces[group]) write_facet_in_text(out, mesh, f);
    out.text("endsolid" + name + "\n");
  }
}

void write_floats(Output_file& out, const Triple& t)
{
  for (const double x : t) out.little_endian(static_cast<float>(x));
}

void write_in_binary(Output_file& out, const Mesh_data& mesh)
{
  require_room(mesh);
  std::string header = "binary STL written by pn_subdivide"; // not to begin with 'solid'
  const Column* const groups = groups_of(mesh);
  if (groups != nullptr && solids_of(*groups).size() == 1)
    header += ":" + name_of(*groups, groups->values[0]);
  header.resize(80);
  out.text(header);
  out.little_endian(static_cast<std::uint32_t>(mesh.number_of_faces()));
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    write_floats(out, face_normal(mesh, f));
    for (const Index v : mesh.face(f)) write_floats(out, mesh.points[v]);
    out.little_endian(std::uint16_t(0));
  }
}

double shortest_edge(const Mesh_data& mesh)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Mesh_data::Face face = mesh.face(f);
    const Index* last = face.end() - 1;
    for (const Index& v : face) {
      const Triple d = difference(mesh.points[v], mesh.points[*last]);
      const double length = std::hypot(d[0], d[1], d[2]);
      if (length > 0) shortest = (std::min)(shortest, length);
      last = &v;
    }
  }
  return shortest;
}

// Points that have others as neighbors in single precision, but not as they are.
std::size_t number_of_joined(const Mesh_data& mesh)
{
  using Place = std::pair<std::array<float, 3>, Triple>;
  std::vector<Place> places;
  for (const Triple& p : mesh.points)
    places.push_back({{float(p[0]), float(p[1]), float(p[2])}, p});
  std::sort(places.begin(), places.end());
  std::size_t joined = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    joined += places[i].first == places[i - 1].first && places[i].second != places[i - 1].second;
  return joined;
}

} // namespace

std::vector<std::string> not_held_by_stl(const Mesh_data& mesh, Encoding encoding)
{
  Held_attributes held(mesh);
  const Column* const groups = groups_of(mesh);
  if (groups != nullptr && (encoding == Encoding::text || solids_of(*groups).size() == 1))
    held.take({groups});
  return held.rest();
}

// Every mesh is rounded by some 1e-7 of its size; far from the origin, or among tiny numbers, that becomes more.
std::string loss_in_stl(const Mesh_data& mesh)
{
  double moved = 0;
  for (const Triple& p : mesh.points)
    for (const double x : p) moved = (std::max)(moved, std::abs(double(float(x)) - x));
  if (!(moved > 0)) return {};
  constexpr double of_size = 1e-6, of_edge = 0.1;
  const std::size_t joined = number_of_joined(mesh);
  if (joined == 0 && moved <= of_size * diagonal_of(Bounding_box(mesh.points)) &&
      moved <= of_edge * shortest_edge(mesh))
    return {};
  return formatted("its single precision moves points by up to %.3g", moved) +
         (joined == 0 ? "" : ", and makes " + std::to_string(joined) + " equal to others") +
         "; take --ascii, .ply or .obj, or move the mesh to the origin";
}

void write_stl(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  require_triangles(mesh);
  if (encoding == Encoding::text)
    write_in_text(out, mesh);
  else
    write_in_binary(out, mesh);
}

} // namespace pn_subdivide
