// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_FORMATS_H
#define PN_SUBDIVIDE_FORMATS_H

#include "io/Attributes.h"
#include "io/Mesh_data.h"
#include "io/Output_file.h"
#include "io/mesh_io.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace pn_subdivide {

// One function of each kind per format. They take the content of a file, or the file to be filled, and
// throw Error without the file's name, which `read_mesh()` and `write_mesh()` put in front.
Mesh_data read_ply(const std::string& content, bool with_attributes);
Mesh_data read_off(const std::string& content, bool with_attributes);
Mesh_data read_obj(const std::string& content, bool with_attributes);
Mesh_data read_stl(const std::string& content, bool with_attributes);

void write_ply(Output_file& out, const Mesh_data& mesh, Encoding encoding);
void write_off(Output_file& out, const Mesh_data& mesh, Encoding encoding);
void write_obj(Output_file& out, const Mesh_data& mesh, Encoding encoding);
// Faces must be triangles. Throws Error if a coordinate is too great for the floats of a binary file.
void write_stl(Output_file& out, const Mesh_data& mesh, Encoding encoding);
void write_vtp(Output_file& out, const Mesh_data& mesh, Encoding encoding);

// A piece of a surface: the numbers of its points and faces in the whole.
struct Vtp_ids
{
  std::vector<std::uint64_t> points, cells;
};
void write_vtp(Output_file& out, const Mesh_data& mesh, Encoding encoding, const Vtp_ids* ids);
// The arrays of all pieces, as the file that names them has them; the types are those of a mesh, which may be empty.
std::string pvtp_arrays(const Mesh_data& like, bool has_texture);

// What of the attributes the format has no place for.
std::vector<std::string> not_held_by_ply(const Mesh_data& mesh, Encoding encoding);
std::vector<std::string> not_held_by_off(const Mesh_data& mesh, Encoding encoding);
std::vector<std::string> not_held_by_obj(const Mesh_data& mesh, Encoding encoding);
std::vector<std::string> not_held_by_stl(const Mesh_data& mesh, Encoding encoding);
std::vector<std::string> not_held_by_vtp(const Mesh_data& mesh, Encoding encoding);

// What the floats of a binary file do to the points, for people; empty if nobody will notice.
std::string loss_in_stl(const Mesh_data& mesh);

// Where the format has types, other programs read colors as bytes and texture coordinates as floats. Those that
// a file has given no type become such.
void take_types_of_format(const Mesh_file& output, Attributes& attributes);

// The names of material and texture files are relative to the folder of the mesh file. Makes them
// those that hold for the output, where it is in another folder. Standard input and output are in the
// current folder.
void move_file_references(Attributes& attributes, const Mesh_file& input, const Mesh_file& output);

// What of a mesh's attributes a file format takes, so that the rest can be named.
class Held_attributes
{
public:
  explicit Held_attributes(const Mesh_data& mesh)
    : attributes_(mesh.attributes)
  {}

  // Returns its argument.
  Column_group take(Column_group columns)
  {
    taken_.insert(columns.begin(), columns.end());
    return columns;
  }
  void take_texture() { texture_ = true; }
  void take_texture_files() { texture_files_ = true; }
  void take_material_files() { material_files_ = true; }

  // For people, as in "groups" or "'quality' of vertices".
  std::vector<std::string> rest() const;

private:
  const Attributes& attributes_;
  std::set<const Column*> taken_;
  bool texture_ = false, texture_files_ = false, material_files_ = false;
};

Column_group all_of(const Columns& columns);

// Texture coordinates of the vertices: their own, or those of the corners if these are the same all
// round each vertex and every corner has some. Empty if there are none; vertices without faces have 0.
std::vector<Texture_point> texture_of_vertices(const Mesh_data& mesh);

// Vertices whose corners have different texture coordinates get a copy for each, behind the others, as formats with
// texture coordinates of vertices need it. Corners without any get 0 0; returns how many.
std::size_t split_at_seams(Mesh_data& mesh);

// Texture coordinates of corners become the columns of vertices that other programs read from .ply files; the mesh
// must be split at its seams.
void move_texture_to_vertices(Mesh_data& mesh);

// The three coordinates of a point or vector with blanks between.
inline void write_triple(Output_file& out, const Triple& t)
{
  out.number(t[0]);
  out.text(" ");
  out.number(t[1]);
  out.text(" ");
  out.number(t[2]);
}

inline void write_count(Output_file& out, std::size_t n)
{
  out.number(static_cast<std::uint64_t>(n));
}

// Writes rows of numbers: in a text with blanks between them, one a line.
class Row_writer
{
public:
  Row_writer(Output_file& out, Encoding encoding)
    : out_(out)
    , is_text_(encoding == Encoding::text)
  {}

  // x must be a number of the type.
  void number(double x, Scalar_type type = Scalar_type::float64)
  {
    if (!is_text_) return write_little_endian(out_, type, x);
    begin_word();
    out_.number(x);
  }
  void count(std::size_t n, Scalar_type type = Scalar_type::uint32)
  {
    if (!is_text_) return write_little_endian(out_, type, static_cast<double>(n));
    begin_word();
    write_count(out_, n);
  }
  void triple(const Triple& t)
  {
    for (const double x : t) number(x);
  }
  // those of an element
  void values(const Column_group& columns, std::size_t element)
  {
    for (const Column* column : columns) number(column->values[element], column->type);
  }
  void end_row()
  {
    if (is_text_) out_.text("\n");
    is_first_ = true;
  }

private:
  void begin_word()
  {
    if (!is_first_) out_.text(" ");
    is_first_ = false;
  }

  Output_file& out_;
  bool is_text_, is_first_ = true;
};

// Text as it stands between quotes in XML, whose files are UTF-8. What XML cannot hold, most control characters
// and bytes that are no UTF-8, becomes '?'.
std::string xml_text(const std::string& text);

// Does XML hold all of it?
bool is_xml_text(const std::string& text);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FORMATS_H
