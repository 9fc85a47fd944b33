// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLY_ORIGIN_H
#define PN_SUBDIVIDE_PLY_ORIGIN_H

#include "io/Mesh_origin.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pn_subdivide {

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
