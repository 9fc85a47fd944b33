// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "formats.h"
#include "write_text.h"

namespace pn_subdivide {

void write_off(Output_file& out, const Mesh_data& mesh, Encoding)
{
  out.text(mesh.has_normals() ? "NOFF\n" : "OFF\n");
  write_count(out, mesh.points.size());
  out.text(" ");
  write_count(out, mesh.number_of_faces());
  out.text(" 0\n");
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    write_triple(out, mesh.points[v]);
    if (mesh.has_normals()) {
      out.text(" ");
      write_triple(out, mesh.normals[v]);
    }
    out.text("\n");
  }
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    write_count(out, mesh.face(f).size());
    for (const Mesh_data::Index v : mesh.face(f)) {
      out.text(" ");
      write_count(out, v);
    }
    out.text("\n");
  }
}

} // namespace pn_subdivide
