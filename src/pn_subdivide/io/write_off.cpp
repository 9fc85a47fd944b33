// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"
#include "io/write_text.h"

namespace pn_subdivide {

void write_off(Output_file& out, const Mesh_data& mesh, Encoding)
{
  out.text(mesh.has_normals() ? "NOFF\n" : "OFF\n");
  write_count(out, mesh.points.size());
  out.text(" ");
  write_count(out, mesh.number_of_faces());
  out.text(" 0\n");
  write_vertices_and_faces(out, mesh);
}

} // namespace pn_subdivide
