// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Held_attributes.h"
#include "io/Ply_shape.h"
#include "io/formats.h"
#include "io/write_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pn_subdivide {
namespace {

struct Ply_content
{
  const Mesh_data& mesh;
  Column_group of_vertices, of_faces;
  bool has_texture;
  bool has_short_lists = true; // of at most 255 values

  explicit Ply_content(const Mesh_data& m)
    : mesh(m)
    , of_vertices(all_of(m.attributes.of_vertices))
    , of_faces(all_of(m.attributes.of_faces))
    , has_texture(!m.attributes.texture.empty())
  {
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      if (m.face(f).size() > (has_texture ? 127u : 255u)) has_short_lists = false;
  }

  Ply_shape shape() const
  {
    return {mesh.points.size(), mesh.number_of_faces(), mesh.has_normals(), has_short_lists};
  }

  // Two numbers for each corner of a face, or none if a corner has none.
  void read_texture(std::size_t f, std::vector<double>& numbers) const
  {
    numbers.clear();
    const std::size_t first = mesh.first_corner(f);
    for (std::size_t c = first; c < first + std::size_t(mesh.face(f).size()); ++c) {
      const Texture_point& t = mesh.attributes.texture[c];
      if (is_none(t)) return numbers.clear();
      numbers.push_back(t[0]);
      numbers.push_back(t[1]);
    }
  }

  // What read_texture() loses.
  std::vector<std::string> lost_texture() const
  {
    std::vector<std::string> lost;
    const std::vector<Texture_point>& texture = mesh.attributes.texture;
    if (has_depth(texture)) lost.emplace_back("third texture coordinates");
    for (std::size_t f = 0; f < mesh.number_of_faces() && has_texture; ++f) {
      const auto begin = texture.begin() + std::ptrdiff_t(mesh.first_corner(f));
      const auto end = begin + std::ptrdiff_t(mesh.face(f).size());
      if (std::any_of(begin, end, is_none) && !std::all_of(begin, end, is_none)) {
        lost.emplace_back("texture coordinates of faces that lack some");
        break;
      }
    }
    return lost;
  }
};

std::string comments(const Attributes& attributes)
{
  std::string text;
  for (const std::string& file : attributes.texture_files)
    text += "comment TextureFile " + file + "\n";
  for (const std::string& file : attributes.material_files) text += "comment mtllib " + file + "\n";
  for (const Column& column : attributes.of_faces)
    for (std::size_t i = 0; i < column.words.size(); ++i)
      text += "comment " + column.name + " " + std::to_string(i) + " " + column.words[i] + "\n";
  return text;
}

std::string properties(const Column_group& columns)
{
  std::string text;
  for (const Column* column : columns)
    text += std::string("property ") + traits(column->type).ply + " " + column->name + "\n";
  return text;
}

// `extra` is text of the attributes: comments, properties of vertices, properties of faces.
std::string header(const Ply_shape& shape, Encoding encoding,
                   const std::array<std::string, 3>& extra)
{
  std::string text = encoding == Encoding::text ? "ply\nformat ascii 1.0\n"
                                                : "ply\nformat binary_little_endian 1.0\n";
  text += "comment written by pn_subdivide\n" + extra[0];
  text += "element vertex " + std::to_string(shape.vertices);
  text += "\nproperty double x\nproperty double y\nproperty double z\n";
  if (shape.has_normals) text += "property double nx\nproperty double ny\nproperty double nz\n";
  text += extra[1] + "element face " + std::to_string(shape.faces);
  text += "\n" + shape.list() + (shape.fits_int() ? "int" : "uint") + " vertex_indices\n";
  return text + extra[2] + "end_header\n";
}

void write_header(Output_file& out, const Ply_content& content, Encoding encoding)
{
  const Attributes& attributes = content.mesh.attributes;
  const Ply_shape shape = content.shape();
  std::string of_faces = properties(content.of_faces);
  if (content.has_texture)
    of_faces += shape.list() + traits(attributes.texture_type).ply + " texcoord\n";
  out.text(
    header(shape, encoding, {comments(attributes), properties(content.of_vertices), of_faces}));
}

void write_triple_in_binary(Output_file& out, const Triple& t)
{
  for (const double x : t) out.little_endian(x);
}

void write_values_in_binary(Output_file& out, const Column_group& columns, std::size_t element)
{
  for (const Column* column : columns)
    write_little_endian(out, column->type, column->values[element]);
}

void write_size_in_binary(Output_file& out, const Ply_content& content, std::size_t size)
{
  if (content.has_short_lists)
    out.little_endian(static_cast<std::uint8_t>(size));
  else
    out.little_endian(static_cast<std::uint32_t>(size));
}

void write_in_binary(Output_file& out, const Ply_content& content)
{
  const Mesh_data& mesh = content.mesh;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    write_triple_in_binary(out, mesh.points[v]);
    if (mesh.has_normals()) write_triple_in_binary(out, mesh.normals[v]);
    write_values_in_binary(out, content.of_vertices, v);
  }
  std::vector<double> texture;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Mesh_data::Face face = mesh.face(f);
    write_size_in_binary(out, content, std::size_t(face.size()));
    for (const Mesh_data::Index v : face) out.little_endian<std::uint32_t>(v);
    write_values_in_binary(out, content.of_faces, f);
    if (!content.has_texture) continue;
    content.read_texture(f, texture);
    write_size_in_binary(out, content, texture.size());
    for (const double x : texture) write_little_endian(out, mesh.attributes.texture_type, x);
  }
}

void write_in_text(Output_file& out, const Ply_content& content)
{
  std::vector<double> texture;
  write_vertices_and_faces(
    out, content.mesh, [&](std::size_t v) { write_values(out, content.of_vertices, v); },
    [&](std::size_t f) {
      write_values(out, content.of_faces, f);
      if (!content.has_texture) return;
      content.read_texture(f, texture);
      out.text(" ");
      write_count(out, texture.size());
      for (const double x : texture) {
        out.text(" ");
        out.number(x);
      }
    });
}

} // namespace

std::vector<std::string> not_held_by_ply(const Mesh_data& mesh)
{
  return Ply_content(mesh).lost_texture();
}

std::string ply_header(const Ply_shape& shape)
{
  return header(shape, Encoding::binary, {});
}

void write_ply(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  const Ply_content content(mesh);
  write_header(out, content, encoding);
  if (encoding == Encoding::text)
    write_in_text(out, content);
  else
    write_in_binary(out, content);
}

} // namespace pn_subdivide
