// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MESH_IO_H
#define PN_SUBDIVIDE_MESH_IO_H

#include "io/Mesh_data.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

// CGAL's readers and writers of polygon soups lose what this command promises to keep: they drop
// normals (OBJ, PLY) or write OBJ faces without normal indices, do not check indices (PLY), take
// damaged lines for short ones (OFF, STL), and in no case can tell where a file is damaged. Assimp,
// VTK, OpenMesh and tinyobjloader read floats, drop most attributes, and take indices out of range
// and damaged numbers for others.

// A file of the command line: its name, and its format as the extension or --format says.
struct Mesh_file
{
  std::string name;   // "-": standard input or output
  std::string format; // "ply", ...

  // for messages
  std::string title(const char* of_stream) const { return name == "-" ? of_stream : name; }
};

// The formats that are read and those that are written, as in "ply off obj".
std::string readable_formats();
std::string writable_formats();

// The format follows from the extension or, for "-", is the one given. Throw Usage_error if there is
// no such format.
Mesh_file input_mesh_file(const std::string& name, const std::optional<std::string>& format);
Mesh_file output_mesh_file(const std::string& name, const std::optional<std::string>& format);

// Whether the format has a place for scalars and colors of the vertices, for their normals, for control
// normals beside these, for normals of corners, for faces with more than three vertices.
struct Held_values
{
  bool scalars, normals, control_normals, corner_normals, polygons;
};
const Held_values& held_by(const Mesh_file& file);

// Throws Error if it can be seen beforehand that the file cannot be written.
void require_writable_place(const std::string& file);

// Do the names mean one file, through links or other folders?
bool same_file(const std::string& a, const std::string& b);

// Throws Usage_error or Error if the file of an option cannot be one: it is none of `others`, in which empty words and "-" do
// not count.
void require_own_file(const std::string& option, const std::string& file,
                      const std::vector<std::string>& others);

enum class Encoding { binary, text };

// What of the mesh's attributes the format has no place for, for people: "groups".
std::vector<std::string> not_held(const Mesh_file& file, const Mesh_data& mesh,
                                  Encoding encoding = Encoding::binary);

// What the format's numbers do to the points, for people; empty if nobody will notice.
std::string lost_precision(const Mesh_file& file, const Mesh_data& mesh, Encoding encoding);

// Indices are within range and faces have three vertices or more; everything else is left to the
// soup checks. Throws Error, which names the file and the place.
Mesh_data read_mesh(const Mesh_file& file, bool with_attributes = true);
Mesh_data read_mesh(const std::string& name);

// The file appears as a whole or not at all; OFF and OBJ are always text.
// Throws Error.
void write_mesh(const Mesh_file& file, const Mesh_data& mesh, Encoding encoding);
void write_mesh(const std::string& name, const Mesh_data& mesh, Encoding encoding);

// What a file of CGAL's format of selections (.selection.txt) holds: numbers of vertices in the first
// line, of faces in the second, edges as pairs of vertex numbers in the third. Lines may be blank.
struct Selection
{
  std::vector<std::int64_t> vertices, faces;
  std::vector<std::array<std::int64_t, 2>> edges;
};

// Throws Error, which names the file and the line. Numbers are not negative.
Selection read_selection(const std::string& file);

class Output_file;
// Whatever is sharp for some rounds or for ever.
void write_selection(Output_file& out, const Crease_tags& tags);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MESH_IO_H
