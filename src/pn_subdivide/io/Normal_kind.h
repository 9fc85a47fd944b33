// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_NORMAL_KIND_H
#define PN_SUBDIVIDE_NORMAL_KIND_H

#include <string>
#include <vector>

namespace pn_subdivide {

// What the normals of a mesh are: data for a further round, those of its faces, or those of the surface that
// the rounds lead to.
enum class Normal_kind { control, of_mesh, of_surface };

// by which files say so: "control normals"
const char* comment_of(Normal_kind kind);
// Where no comment says anything they are control normals.
Normal_kind normal_kind_of(const std::vector<std::string>& comments);
// Does a comment say that they are?
bool are_said_to_be_control(const std::vector<std::string>& comments);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_NORMAL_KIND_H
