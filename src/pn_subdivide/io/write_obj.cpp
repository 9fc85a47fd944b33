// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/corner_normals.h"
#include "io/formats.h"
#include "io/write_text.h"

namespace pn_subdivide {

namespace {

void write_normals(Output_file& out, const std::vector<Triple>& normals)
{
  for (const Triple& n : normals) {
    out.text("vn ");
    write_triple(out, n);
    out.text("\n");
  }
}

// `normal_of(corner, vertex)` counts from 0.
template <class Normal_of>
void write_faces(Output_file& out, const Mesh_data& mesh, const Normal_of& normal_of)
{
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    out.text("f");
    for (const Mesh_data::Index v : mesh.face(f)) {
      out.text(" ");
      write_count(out, std::size_t(v) + 1);
      if (mesh.has_normals()) {
        out.text("//");
        write_count(out, normal_of(corner, v) + 1);
      }
      ++corner;
    }
    out.text("\n");
  }
}

} // namespace

void write_obj(Output_file& out, const Mesh_data& mesh, Encoding)
{
  for (const Triple& p : mesh.points) {
    out.text("v ");
    write_triple(out, p);
    out.text("\n");
  }
  if (mesh.has_corner_normals()) {
    const Different_normals different(mesh);
    write_normals(out, different.normals);
    write_faces(out, mesh,
                [&](std::size_t corner, Mesh_data::Index) { return different.of_corner[corner]; });
  } else {
    write_normals(out, mesh.normals);
    write_faces(out, mesh, [](std::size_t, Mesh_data::Index v) { return std::size_t(v); });
  }
}

} // namespace pn_subdivide
