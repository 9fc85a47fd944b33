// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLY_ORIGIN_H
#define PN_SUBDIVIDE_PLY_ORIGIN_H

#include "io/Mesh_data.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pn_subdivide {

// What the header of a PLY file without attributes says.
struct Ply_shape
{
  std::uint64_t vertices = 0, faces = 0;
  bool has_normals = false, has_control_normals = false;
  Normal_kind normal_kind = Normal_kind::control;
  bool has_short_lists = true; // of at most 255 values
  bool has_roundness = false;

  bool fits_int() const { return vertices <= 0x7fffffffu; }
  std::string list() const
  {
    return has_short_lists ? "property list uchar " : "property list uint ";
  }
};

// as of a binary file
std::string ply_header(const Ply_shape& shape, const Mesh_origin& origin);

// The origin of a mesh in a PLY file: comments such as "2 rounds of loop from control_face of 8 vertices", one for each
// kind of rounds, and the faces before them as an element of this name.
constexpr const char* origin_element = "control_face";

std::string origin_comments(const Mesh_origin& origin);
// of the header, with its properties; empty if there is no origin
std::string origin_header(const Mesh_origin& origin);
// the faces, in binary
std::string origin_bytes(const Mesh_origin& origin);

void read_origin_comments(const std::vector<std::string>& comments, Mesh_origin& origin);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLY_ORIGIN_H
