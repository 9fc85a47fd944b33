// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_WRITE_TEXT_H
#define PN_SUBDIVIDE_WRITE_TEXT_H

#include "io/Mesh_data.h"
#include "io/Output_file.h"

#include <cstddef>
#include <cstdint>

namespace pn_subdivide {

// The three coordinates of a point or vector with blanks between.
inline void write_triple(Output_file& out, const Triple& t)
{
  out.number(t[0]);
  out.text(" ");
  out.number(t[1]);
  out.text(" ");
  out.number(t[2]);
}

inline void write_count(Output_file& out, std::size_t n)
{
  out.number(static_cast<std::uint64_t>(n));
}

// What text OFF and PLY have in common after their headers: a line for each vertex, with what it has
// besides its point, and one for each face.
inline void write_vertices_and_faces(Output_file& out, const Mesh_data& mesh)
{
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    write_triple(out, mesh.points[v]);
    if (mesh.has_normals()) {
      out.text(" ");
      write_triple(out, mesh.normals[v]);
    }
    if (!mesh.scalars.empty()) {
      out.text(" ");
      out.number(mesh.scalars[v]);
    }
    if (!mesh.colors.empty())
      for (const std::uint8_t c : mesh.colors[v]) {
        out.text(" ");
        write_count(out, c);
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

#endif // PN_SUBDIVIDE_WRITE_TEXT_H
