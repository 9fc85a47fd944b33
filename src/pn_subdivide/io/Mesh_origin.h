// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MESH_ORIGIN_H
#define PN_SUBDIVIDE_MESH_ORIGIN_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pn_subdivide {

// Of which faces, by which rounds, a mesh has been made. A further call needs it to number edges, and to begin at
// vertices, as one call would do: new vertices are numbered, and sums ordered, by these.
struct Mesh_origin
{
  struct Rounds
  {
    std::string scheme;
    unsigned number;
  };

  std::vector<Rounds>
    rounds;                 // of one call after the other; empty: the mesh has been made of nothing
  std::size_t vertices = 0; // before these
  std::vector<std::uint32_t> corners; // of the faces before these, one face after the other
  std::vector<std::size_t> face_end;  // where each ends

  bool any() const { return !rounds.empty(); }
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MESH_ORIGIN_H
