// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CONTROL_MESH_H
#define PN_SUBDIVIDE_CONTROL_MESH_H

#include "io/Report.h"
#include "io/mesh_io.h"
#include "options.h"

namespace pn_subdivide {

// The mesh of a file as the options want it: an oriented 2-manifold, its equal or near points merged, its faces
// split into triangles. Reports what was changed, what the command does not carry and where the surface is open
// although border edges lie on each other. Throws Error.
Mesh_data read_control_mesh(const Mesh_file& file, const Surface_options& options, Report& report);

// EPS, or P% of the diagonal of the mesh's box.
struct Box_length
{
  double value = 0; // a part of the diagonal, not percent
  bool is_of_diagonal = false;

  double of(const Mesh_data& mesh) const;
};

// Throws Usage_error if it is no number or negative; option: for messages.
Box_length parse_box_length(const std::string& text, const std::string& option);

// The scheme of the options or, where they name none, the one that suits the faces.
Scheme_choice chosen_scheme(const Mesh_data& mesh, const Scheme_choice& choice);

// Throws Error if the scheme wants triangles and a face is none.
void require_faces_for_scheme(const Mesh_data& mesh, const Scheme_choice& choice);

// As in "26 vertices, 24 faces".
std::string size_of(const Mesh_data& mesh);

// Steps on fewer faces are done before anybody could read about them.
constexpr std::size_t faces_worth_a_report = 100000;

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CONTROL_MESH_H
