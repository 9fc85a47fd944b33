// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"

#include <algorithm>

namespace pn_subdivide {
namespace {

// Bytes, or fractions from 0 to 1.
bool is_color_of_off(const Column_group& color)
{
  if (color.empty()) return false;
  const Scalar_type type = color[0]->type;
  if (type == Scalar_type::uint8) return true;
  if (traits(type).is_integer) return false;
  return std::all_of(color.begin(), color.end(), [](const Column* channel) {
    return std::all_of(channel->values.begin(), channel->values.end(),
                       [](double x) { return x >= 0 && x <= 1; });
  });
}

struct Off_content
{
  Held_attributes held;
  Column_group vertex_color, face_color;
  std::vector<Texture_point> texture; // per vertex

  explicit Off_content(const Mesh_data& mesh)
    : held(mesh)
    , texture(texture_of_vertices(mesh))
  {
    const Attributes& attributes = mesh.attributes;
    if (const Column_group color = find_color(attributes.of_vertices); is_color_of_off(color))
      vertex_color = held.take(color);
    if (const Column_group color = find_color(attributes.of_faces); is_color_of_off(color))
      face_color = held.take(color);
    if (has_depth(texture)) texture.clear();
    if (texture.empty()) return;
    if (attributes.texture.empty())
      held.take(find_texture(attributes.of_vertices));
    else
      held.take_texture();
  }
};

// Fractions have a point, by which they are told from bytes.
void write_color(Output_file& out, const Column_group& color, std::size_t element)
{
  for (const Column* channel : color) {
    const double x = channel->values[element];
    out.text(" ");
    out.number(x);
    if (channel->type != Scalar_type::uint8 && (x == 0 || x == 1)) out.text(".0");
  }
}

} // namespace

std::vector<std::string> not_held_by_off(const Mesh_data& mesh, Encoding)
{
  return Off_content(mesh).held.rest();
}

void write_off(Output_file& out, const Mesh_data& mesh, Encoding)
{
  const Off_content content(mesh);
  out.text(content.texture.empty() ? "" : "ST");
  out.text(content.vertex_color.empty() ? "" : "C");
  out.text(mesh.has_normals() ? "NOFF\n" : "OFF\n");
  write_count(out, mesh.points.size());
  out.text(" ");
  write_count(out, mesh.number_of_faces());
  out.text(" 0\n");
  write_vertices_and_faces(
    out, mesh,
    [&](std::size_t v) {
      write_color(out, content.vertex_color, v);
      for (std::size_t i = 0; i < 2 && !content.texture.empty(); ++i) {
        out.text(" ");
        out.number(content.texture[v][i]);
      }
    },
    [&](std::size_t f) { write_color(out, content.face_color, f); });
}

} // namespace pn_subdivide
