// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"

namespace pn_subdivide {
namespace {

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
    if (const Column_group color = find_color(attributes.of_vertices); is_plain_color(color))
      vertex_color = held.take(color);
    if (const Column_group color = find_color(attributes.of_faces); is_plain_color(color))
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
void write_color(Output_file& out, Row_writer& rows, const Column_group& color, std::size_t element)
{
  for (const Column* channel : color) {
    const double x = channel->values[element];
    rows.number(x);
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
  Row_writer rows(out, Encoding::text);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    rows.triple(mesh.points[v]);
    if (mesh.has_normals()) rows.triple(mesh.normals[v]);
    write_color(out, rows, content.vertex_color, v);
    for (std::size_t i = 0; i < 2 && !content.texture.empty(); ++i)
      rows.number(content.texture[v][i]);
    rows.end_row();
  }
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    rows.count(mesh.face(f).size());
    for (const Index v : mesh.face(f)) rows.count(v);
    write_color(out, rows, content.face_color, f);
    rows.end_row();
  }
}

} // namespace pn_subdivide
