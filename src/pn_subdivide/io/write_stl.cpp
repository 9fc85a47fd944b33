// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Held_attributes.h"
#include "io/Output_file.h"
#include "io/corner_normals.h"
#include "io/formats.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace pn_subdivide {
namespace {

void require_room(const Mesh_data& mesh)
{
  if (mesh.number_of_faces() > std::numeric_limits<std::uint32_t>::max())
    throw Error("STL files hold at most 2^32 - 1 triangles, not " +
                std::to_string(mesh.number_of_faces()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (const double x : mesh.points[v])
      if (!(std::abs(x) <= double(std::numeric_limits<float>::max())))
        throw Error("vertex " + std::to_string(v) +
                    " has a coordinate that is too great for the single precision of STL");
}

void write_triple(Output_file& out, const Triple& t)
{
  for (const double x : t) out.little_endian(static_cast<float>(x));
}

} // namespace

std::vector<std::string> not_held_by_stl(const Mesh_data& mesh)
{
  return Held_attributes(mesh).rest();
}

void write_stl(Output_file& out, const Mesh_data& mesh, Encoding)
{
  require_room(mesh);
  std::string header = "binary STL written by pn_subdivide"; // not to begin with 'solid'
  header.resize(80);
  out.text(header);
  out.little_endian(static_cast<std::uint32_t>(mesh.number_of_faces()));
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Mesh_data::Face face = mesh.face(f);
    if (face.size() != 3) throw Error("STL files hold triangles only");
    const auto corner = [&](std::size_t i) -> const Triple& {
      return mesh.points[face.begin()[i]];
    };
    write_triple(out, face_normal(mesh, f));
    for (std::size_t i = 0; i < 3; ++i) write_triple(out, corner(i));
    out.little_endian(std::uint16_t(0));
  }
}

} // namespace pn_subdivide
