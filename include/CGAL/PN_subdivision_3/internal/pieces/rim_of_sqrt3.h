// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_RIM_OF_SQRT3_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_RIM_OF_SQRT3_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Piece_elements.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Rim_closure.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Whole_level.h>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Host>
bool refines_border([[maybe_unused]] unsigned round)
{
  if constexpr (std::is_same_v<Host, Sqrt3_host>)
    return Sqrt3_host::refines_border(round);
  else
    return false;
}

// Closes the rim of a piece before a round that refines the border. Before it there was a round that did
// not, after which the first half-edge of a face at the border lies there. Returns for each vertex that was
// added a neighbor in the piece.
inline std::vector<Level_connectivity::Index>
close_rim(Level_connectivity& level, Piece_elements& elements, const Whole_level& whole)
{
  using Index = Level_connectivity::Index;
  const auto is_rim = [&](Index b) {
    const Index h = Level_connectivity::opposite(b), f = level.face(h);
    return level.halfedge_of_face(f) != h || !whole.border_faces.contains(elements.faces.number(f));
  };
  const Rim_closure closure(level, is_rim);
  const auto add = [](Numbered_elements& of, std::uint64_t size) {
    while (of.size() < size) of.push_back(Numbered_elements::no_number, false);
  };
  add(elements.vertices, level.size().vertices);
  add(elements.edges, level.size().edges);
  add(elements.faces, level.size().faces);
  return closure.neighbors_of_new_vertices();
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_RIM_OF_SQRT3_H
