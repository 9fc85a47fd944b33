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

void write_obj(Output_file& out, const Mesh_data& mesh, Encoding)
{
  for (const Triple& p : mesh.points) {
    out.text("v ");
    write_triple(out, p);
    out.text("\n");
  }
  for (const Triple& n : mesh.normals) {
    out.text("vn ");
    write_triple(out, n);
    out.text("\n");
  }
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    out.text("f");
    for (const Mesh_data::Index v : mesh.face(f)) {
      const std::size_t number = std::size_t(v) + 1;
      out.text(" ");
      write_count(out, number);
      if (!mesh.has_normals()) continue;
      out.text("//");
      write_count(out, number);
    }
    out.text("\n");
  }
}

} // namespace pn_subdivide
