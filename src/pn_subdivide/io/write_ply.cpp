// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"
#include "io/write_text.h"

#include <algorithm>

namespace pn_subdivide {
namespace {

bool fits_uchar(const Mesh_data& mesh)
{
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    if (mesh.face(f).size() > 255) return false;
  return true;
}

bool fits_int(const Mesh_data& mesh)
{
  return mesh.points.size() <= 0x7fffffffu;
}

void write_header(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  out.text(encoding == Encoding::text ? "ply\nformat ascii 1.0\n"
                                      : "ply\nformat binary_little_endian 1.0\n");
  out.text("comment written by pn_subdivide\nelement vertex ");
  write_count(out, mesh.points.size());
  out.text("\nproperty double x\nproperty double y\nproperty double z\n");
  if (mesh.has_normals()) out.text("property double nx\nproperty double ny\nproperty double nz\n");
  if (!mesh.scalars.empty()) out.text("property double " + mesh.scalar_name + "\n");
  if (!mesh.colors.empty())
    out.text("property uchar red\nproperty uchar green\nproperty uchar blue\n");
  out.text("element face ");
  write_count(out, mesh.number_of_faces());
  out.text(fits_uchar(mesh) ? "\nproperty list uchar " : "\nproperty list uint ");
  out.text(fits_int(mesh) ? "int" : "uint");
  out.text(" vertex_indices\nend_header\n");
}

void write_doubles(Output_file& out, const Triple& t)
{
  for (const double x : t) out.little_endian(x);
}

void write_as_binary(Output_file& out, const Mesh_data& mesh)
{
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    write_doubles(out, mesh.points[v]);
    if (mesh.has_normals()) write_doubles(out, mesh.normals[v]);
    if (!mesh.scalars.empty()) out.little_endian<double>(mesh.scalars[v]);
    if (!mesh.colors.empty())
      for (const std::uint8_t c : mesh.colors[v]) out.little_endian(c);
  }
  const bool short_lists = fits_uchar(mesh);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Mesh_data::Face face = mesh.face(f);
    if (short_lists)
      out.little_endian(static_cast<std::uint8_t>(face.size()));
    else
      out.little_endian(static_cast<std::uint32_t>(face.size()));
    for (const Mesh_data::Index v : face) out.little_endian<std::uint32_t>(v);
  }
}

} // namespace

void write_ply(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  write_header(out, mesh, encoding);
  if (encoding == Encoding::text)
    write_vertices_and_faces(out, mesh);
  else
    write_as_binary(out, mesh);
}

} // namespace pn_subdivide
