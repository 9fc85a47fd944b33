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
#include <string>

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

// The values of an element with a blank before each.
inline void write_values(Output_file& out, const Column_group& columns, std::size_t element)
{
  for (const Column* column : columns) {
    out.text(" ");
    out.number(column->values[element]);
  }
}

// What text OFF and PLY have in common after their headers: a line for each vertex and one for each
// face; `rest_of_vertex(v)` and `rest_of_face(f)` write what these have besides points, normals and
// vertices.
template <class Rest_of_vertex, class Rest_of_face>
void write_vertices_and_faces(Output_file& out, const Mesh_data& mesh,
                              const Rest_of_vertex& rest_of_vertex,
                              const Rest_of_face& rest_of_face)
{
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    write_triple(out, mesh.points[v]);
    if (mesh.has_normals()) {
      out.text(" ");
      write_triple(out, mesh.normals[v]);
    }
    rest_of_vertex(v);
    out.text("\n");
  }
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    write_count(out, mesh.face(f).size());
    for (const Mesh_data::Index v : mesh.face(f)) {
      out.text(" ");
      write_count(out, v);
    }
    rest_of_face(f);
    out.text("\n");
  }
}

// Text as it stands between quotes in XML, whose files are UTF-8. What XML cannot hold, most control characters
// and bytes that are no UTF-8, becomes '?'.
std::string xml_text(const std::string& text);

// Does XML hold all of it?
bool is_xml_text(const std::string& text);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_WRITE_TEXT_H
