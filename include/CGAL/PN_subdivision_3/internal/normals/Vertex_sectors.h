// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_VERTEX_SECTORS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_VERTEX_SECTORS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Normals are estimated sector by sector. A sector is a vertex with one of its fans; here a whole
// vertex. at_target(h) and at_source(h) are the sectors of the corners of face(h).
class Vertex_sectors
{
public:
  using Index = Level_connectivity::Index;

  explicit Vertex_sectors(const Level_connectivity& level)
    : level_(level)
  {}

  Index number_of_sectors() const { return level_.number_of_vertices(); }
  bool is_empty(Index s) const { return level_.is_isolated(s); }
  Fan fan(Index s) const { return fan_of_vertex(level_, s); }
  Index at_target(Index h) const { return level_.target(h); }
  Index at_source(Index h) const { return level_.source(h); }

private:
  const Level_connectivity& level_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_VERTEX_SECTORS_H
