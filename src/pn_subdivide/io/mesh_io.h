// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MESH_IO_H
#define PN_SUBDIVIDE_MESH_IO_H

#include "io/Mesh_data.h"

#include <string>

namespace pn_subdivide {

// The formats follow from the file name. CGAL's readers and writers of polygon soups are used for
// STL only. The others lose what this command promises to keep: they drop normals (OBJ, PLY) or
// write OBJ faces without normal indices, do not check indices (PLY), take damaged lines for short
// ones (OFF), and in no case can tell where a file is damaged.

// Both throw Usage_error if the extension of the file name is not among the known ones.
void require_readable_format(const std::string& file);
void require_writable_format(const std::string& file);

// Whether the format has a place for scalars and colors of the vertices.
bool holds_scalars(const std::string& file);

// Throws Error if it can be seen beforehand that the file cannot be written.
void require_writable_place(const std::string& file);

// Reads .ply, .off, .obj and .stl. Indices are within range and faces have three vertices or more;
// everything else is left to the soup checks. Throws Error, which names the file and the place.
Mesh_data read_mesh(const std::string& file);

enum class Encoding { binary, text };

// Writes .ply, .off, .obj and .vtp (.off and .obj are always text). The file appears as a whole or
// not at all. Throws Error.
void write_mesh(const std::string& file, const Mesh_data& mesh, Encoding encoding);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MESH_IO_H
