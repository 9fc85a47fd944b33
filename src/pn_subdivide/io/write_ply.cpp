// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Ply_header.h"
#include "io/formats.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace pn_subdivide {
namespace {

// A list of each face with as many numbers for each corner, or empty.
struct Corner_list
{
  const char* name;
  Scalar_type type;
  std::size_t dimension;
  std::function<void(std::size_t, std::vector<double>&)> read; // the numbers of a face
};

struct Ply_content
{
  const Mesh_data& mesh;
  Column_group of_vertices, of_faces;
  std::vector<Corner_list> lists;
  bool has_short_lists = true; // of at most 255 values

  explicit Ply_content(const Mesh_data& m)
    : mesh(m)
    , of_vertices(all_of(m.attributes.of_vertices))
    , of_faces(all_of(m.attributes.of_faces))
  {
    if (has_texture())
      lists.push_back({texture_list, m.attributes.texture_type, 2,
                       [this](std::size_t f, auto& numbers) { read_texture(f, numbers); }});
    if (has_several_control_normals())
      lists.push_back({normals_list, Scalar_type::float64, 3,
                       [this](std::size_t f, auto& numbers) { read_normals(f, numbers); }});
    if (has_several_control_normals() && has_roundness() && !m.corner_roundness.empty())
      lists.push_back({roundness_list, Scalar_type::float64, 1,
                       [this](std::size_t f, auto& numbers) { read_roundness(f, numbers); }});
    std::size_t of_corner = 1;
    for (const Corner_list& list : lists) of_corner = (std::max)(of_corner, list.dimension);
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      if (std::size_t(m.face(f).size()) * of_corner > 255) has_short_lists = false;
  }
  Ply_content(const Ply_content&) = delete; // the lists refer to it
  Ply_content& operator=(const Ply_content&) = delete;

  // They may be equal on all sides of a crease.
  bool has_several_control_normals() const
  {
    return !mesh.corner_control_normals.empty() ||
           (mesh.has_control_normals() && !mesh.tags.edges.empty());
  }
  bool has_roundness() const { return !mesh.roundness.empty(); }
  bool has_tags() const { return mesh.tags.any(); }
  double sharpness(std::size_t v) const
  {
    return mesh.tags.vertices.empty() ? 0 : mesh.tags.vertices[v];
  }
  bool has_texture() const { return !mesh.attributes.texture.empty(); }

  Ply_shape shape() const
  {
    return {
      mesh.points.size(), mesh.number_of_faces(), mesh.has_normals(), mesh.has_control_normals(),
      mesh.normal_kind,   has_short_lists,        has_roundness(),    has_texture()};
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

  // Three numbers for each corner of a face, or none if all have the normals of their vertices.
  void read_normals(std::size_t f, std::vector<double>& numbers) const
  {
    numbers.clear();
    if (mesh.corner_control_normals.empty()) return;
    bool are_others = false;
    std::size_t corner = mesh.first_corner(f);
    for (const Index v : mesh.face(f)) {
      const Triple& n = mesh.corner_control_normals[corner++];
      are_others = are_others || n != mesh.control_normals[v];
      numbers.insert(numbers.end(), n.begin(), n.end());
    }
    if (!are_others) numbers.clear();
  }

  // The same of the roundness, one number for each corner.
  void read_roundness(std::size_t f, std::vector<double>& numbers) const
  {
    numbers.clear();
    bool are_others = false;
    std::size_t corner = mesh.first_corner(f);
    for (const Index v : mesh.face(f)) {
      numbers.push_back(mesh.corner_roundness[corner++]);
      are_others = are_others || numbers.back() != mesh.roundness[v];
    }
    if (!are_others) numbers.clear();
  }

  // What read_texture() loses.
  std::vector<std::string> lost_texture() const
  {
    std::vector<std::string> lost;
    const std::vector<Texture_point>& texture = mesh.attributes.texture;
    if (has_depth(texture)) lost.emplace_back("third texture coordinates");
    for (std::size_t f = 0; f < mesh.number_of_faces() && has_texture(); ++f) {
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

// `extra` is text of what else there is: comments, properties of vertices, properties of faces, elements.
std::string header(const Ply_shape& shape, Encoding encoding,
                   const std::array<std::string, 4>& extra)
{
  std::string text = encoding == Encoding::text ? "ply\nformat ascii 1.0\n"
                                                : "ply\nformat binary_little_endian 1.0\n";
  text += "comment written by pn_subdivide\n";
  if (shape.has_normals) text += std::string("comment ") + comment_of(shape.normal_kind) + "\n";
  text += extra[0];
  text += "element vertex " + std::to_string(shape.vertices);
  text += "\nproperty double x\nproperty double y\nproperty double z\n";
  if (shape.has_normals) text += "property double nx\nproperty double ny\nproperty double nz\n";
  if (shape.has_control_normals)
    text += "property double control_nx\nproperty double control_ny\nproperty double control_nz\n";
  if (shape.has_roundness) text += "property double roundness\n";
  text += extra[1] + "element face " + std::to_string(shape.faces);
  text += "\n" + shape.list() + (shape.fits_int() ? "int" : "uint") + " vertex_indices\n";
  return text + extra[2] + extra[3] + "end_header\n";
}

std::string edge_header(const Ply_content& content)
{
  if (!content.has_tags()) return {};
  const std::string index = content.shape().fits_int() ? "int" : "uint";
  std::string text = "element edge " + std::to_string(content.mesh.tags.edges.size()) + "\n";
  for (std::size_t i = 0; i < std::size(edge_properties); ++i)
    text += "property " + (i < 2 ? index : "double") + " " + edge_properties[i] + "\n";
  return text;
}

void write_header(Output_file& out, const Ply_content& content, Encoding encoding)
{
  const Attributes& attributes = content.mesh.attributes;
  const Ply_shape shape = content.shape();
  std::string of_faces = properties(content.of_faces);
  for (const Corner_list& list : content.lists)
    of_faces += shape.list() + traits(list.type).ply + " " + list.name + "\n";
  const std::string own = content.has_tags() ? "property double sharpness\n" : "";
  out.text(header(
    shape, encoding,
    {comments(attributes), own + properties(content.of_vertices), of_faces, edge_header(content)}));
}

// Of the sizes of lists.
Scalar_type size_type(const Ply_content& content)
{
  return content.has_short_lists ? Scalar_type::uint8 : Scalar_type::uint32;
}

void write_vertices(Row_writer& rows, const Ply_content& content)
{
  const Mesh_data& mesh = content.mesh;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    rows.triple(mesh.points[v]);
    if (mesh.has_normals()) rows.triple(mesh.normals[v]);
    if (mesh.has_control_normals()) rows.triple(mesh.control_normals[v]);
    if (content.has_roundness()) rows.number(mesh.roundness[v]);
    if (content.has_tags()) rows.number(content.sharpness(v));
    rows.values(content.of_vertices, v);
    rows.end_row();
  }
}

void write_faces(Row_writer& rows, const Ply_content& content)
{
  std::vector<double> numbers;
  for (std::size_t f = 0; f < content.mesh.number_of_faces(); ++f) {
    const Mesh_data::Face face = content.mesh.face(f);
    rows.count(face.size(), size_type(content));
    for (const Index v : face) rows.count(v);
    rows.values(content.of_faces, f);
    for (const Corner_list& list : content.lists) {
      list.read(f, numbers);
      rows.count(numbers.size(), size_type(content));
      for (const double x : numbers) rows.number(x, list.type);
    }
    rows.end_row();
  }
}

void write_edges(Row_writer& rows, const Crease_tags& tags)
{
  for (const Crease_tags::Edge& edge : tags.edges) {
    for (const std::uint32_t v : edge.ends) rows.count(v);
    rows.number(edge.sharpness);
    for (const Triple& tangent : edge.tangents) rows.triple(tangent);
    rows.end_row();
  }
}

} // namespace

std::vector<std::string> not_held_by_ply(const Mesh_data& mesh, Encoding)
{
  return Ply_content(mesh).lost_texture();
}

std::string ply_header(const Ply_shape& shape, const Attributes& attributes)
{
  std::string of_faces = properties(all_of(attributes.of_faces));
  if (shape.has_texture)
    of_faces += shape.list() + traits(attributes.texture_type).ply + " " + texture_list + "\n";
  return header(shape, Encoding::binary,
                {comments(attributes), properties(all_of(attributes.of_vertices)), of_faces, ""});
}

void write_ply(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  const Ply_content content(mesh);
  write_header(out, content, encoding);
  Row_writer rows(out, encoding);
  write_vertices(rows, content);
  write_faces(rows, content);
  write_edges(rows, mesh.tags);
}

} // namespace pn_subdivide
