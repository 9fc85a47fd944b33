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
#include "io/mesh_io.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pn_subdivide {

class Output_file;

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

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FORMATS_H
