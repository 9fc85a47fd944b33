// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Held_attributes.h"
#include "io/Vtp_writer.h"
#include "io/formats.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pn_subdivide {
namespace {

bool contains(const Column_group& group, const Column& column)
{
  return std::find(group.begin(), group.end(), &column) != group.end();
}

struct Vtp_content
{
  Held_attributes held;
  Column_group vertex_color, face_color;
  std::vector<Texture_point> texture; // per vertex
  Column_group own_texture, scalars;  // of vertices
  Scalar_type corner_texture_type;
  Column roundness;

  explicit Vtp_content(const Mesh_data& mesh)
    : held(mesh)
    , vertex_color(find_color(mesh.attributes.of_vertices))
    , face_color(find_color(mesh.attributes.of_faces))
    , texture(texture_of_vertices(mesh))
    , corner_texture_type(mesh.attributes.texture_type)
  {
    const Attributes& attributes = mesh.attributes;
    roundness.values = mesh.roundness;
    held.take(all_of(attributes.of_vertices));
    held.take(all_of(attributes.of_faces));
    held.take_texture_files();
    held.take_material_files();
    if (has_depth(texture)) texture.clear();
    if (!texture.empty()) held.take_texture();
    if (attributes.texture.empty()) own_texture = find_texture(attributes.of_vertices);
    for (const Column& column : attributes.of_vertices)
      if (!contains(vertex_color, column) && !contains(own_texture, column))
        scalars.push_back(&column);
  }

  Scalar_type texture_type() const
  {
    return own_texture.empty() ? corner_texture_type : own_texture[0]->type;
  }
};

void write_field_data(Vtp_writer& vtp, const Attributes& attributes)
{
  const auto has_words = [](const Column& column) { return !column.words.empty(); };
  const Columns& columns = attributes.of_faces;
  if (attributes.texture_files.empty() && attributes.material_files.empty() &&
      std::none_of(columns.begin(), columns.end(), has_words))
    return;
  vtp.line("<FieldData>");
  for (const Column& column : columns)
    if (has_words(column)) vtp.words(column.name, column.words);
  if (!attributes.texture_files.empty()) vtp.words("texture files", attributes.texture_files);
  if (!attributes.material_files.empty()) vtp.words("material files", attributes.material_files);
  vtp.line("</FieldData>");
}

void write_point_data(Vtp_writer& vtp, const Mesh_data& mesh, const Vtp_content& content)
{
  if (!mesh.has_normals() && mesh.attributes.of_vertices.empty() && content.texture.empty()) return;
  std::string tag = "<PointData";
  if (mesh.has_normals()) tag += " Normals=\"Normals\"";
  if (!content.scalars.empty()) tag += " Scalars=\"" + xml_text(content.scalars[0]->name) + "\"";
  if (!content.texture.empty()) tag += " TCoords=\"TCoords\"";
  vtp.line((tag + ">").c_str());
  if (mesh.has_normals()) vtp.triples("Normals", mesh.normals);
  if (mesh.has_control_normals()) vtp.triples("control_normals", mesh.control_normals);
  if (!mesh.roundness.empty()) vtp.columns("roundness", {&content.roundness});
  for (const Column* column : content.scalars) vtp.columns(column->name, {column});
  if (!content.vertex_color.empty()) vtp.columns("colors", content.vertex_color);
  if (!content.texture.empty()) vtp.texture(content.texture, content.texture_type());
  vtp.line("</PointData>");
}

void write_cell_data(Vtp_writer& vtp, const Mesh_data& mesh, const Vtp_content& content)
{
  if (mesh.attributes.of_faces.empty()) return;
  vtp.line("<CellData>");
  for (const Column& column : mesh.attributes.of_faces)
    if (!contains(content.face_color, column)) vtp.columns(column.name, {&column});
  if (!content.face_color.empty()) vtp.columns("colors", content.face_color);
  vtp.line("</CellData>");
}

} // namespace

std::vector<std::string> not_held_by_vtp(const Mesh_data& mesh)
{
  return Vtp_content(mesh).held.rest();
}

void write_vtp(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  const std::size_t faces = mesh.number_of_faces();
  const Vtp_content content(mesh);
  Vtp_writer vtp(out, encoding);
  vtp.begin(mesh.has_normals() ? comment_of(mesh.normal_kind) : "");
  write_field_data(vtp, mesh.attributes);
  vtp.begin_piece(mesh.points.size(), faces);
  write_point_data(vtp, mesh, content);
  write_cell_data(vtp, mesh, content);
  vtp.line("<Points>");
  vtp.triples("Points", mesh.points);
  vtp.line("</Points>\n<Polys>");
  vtp.integers("connectivity", mesh.number_of_corners(), [&] {
    for (std::size_t f = 0; f < faces; ++f)
      for (const Mesh_data::Index& v : mesh.face(f))
        vtp.value<std::int64_t>(v, &v + 1 == mesh.face(f).end());
  });
  vtp.integers("offsets", faces, [&] {
    std::int64_t end = 0;
    for (std::size_t f = 0; f < faces; ++f) {
      end += static_cast<std::int64_t>(mesh.face(f).size());
      vtp.value<std::int64_t>(end, true);
    }
  });
  vtp.line("</Polys>");
  vtp.end();
}

} // namespace pn_subdivide
