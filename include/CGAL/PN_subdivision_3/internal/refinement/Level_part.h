// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_PART_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_PART_H

#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_extraction.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Some faces of a level as a level of their own, and what their elements are in the whole: whatever has a value for each
// of these is cut by these lists.
struct Level_part
{
  using Index = Level_connectivity::Index;
  using Origins = std::vector<Index>;
  static constexpr Index null = Level_connectivity::null;

  Level_connectivity level;
  Origins vertices, edges, faces;

  // takes the level out of the extraction; edges and faces are listed if something needs them
  template <class Candidates>
  Level_part(Piece_extraction<Candidates>& extraction, bool lists_all)
    : level(std::move(extraction.piece()))
    , vertices(extraction.take_old_vertices())
  {
    if (!lists_all) return;
    edges = extraction.old_edges();
    faces = extraction.old_faces();
  }

  Index halfedge(Index h) const { return 2 * edges[h / 2] + (h & 1u); }
  // of the half-edges with a face; null for the others
  Origins corners() const
  {
    Origins result(level.number_of_halfedges(), null);
    for (Index h = 0; h < result.size(); ++h)
      if (!level.is_border(h)) result[h] = halfedge(h);
    return result;
  }

  // what is sharp there
  template <class FT>
  Creases<FT> creases(const Creases<FT>& whole) const
  {
    return creases_of_part(
      whole, level, [this](Index e) { return edges[e]; }, [this](Index v) { return vertices[v]; });
  }
  // the slots in the whole of those of the part
  template <class FT>
  Origins slot_origins(const Creases<FT>& creases, const Corner_slots<FT>& whole) const
  {
    Origins result = vertices;
    result.resize(creases.number_of_slots);
    take_slot_values(
      level, creases, [this](Index h) { return halfedge(h); }, whole, Itself(), result);
    return result;
  }

  // Both, empty and the vertices if nothing is sharp.
  template <class Level_creases>
  std::pair<Level_creases, Origins> creases_and_slots(const Level_connectivity& whole,
                                                      const Level_creases& of_whole) const
  {
    if constexpr (are_creases_v<Level_creases>)
      if (!of_whole.empty()) {
        Level_creases cut = creases(of_whole);
        Origins origins = slot_origins(cut, Corner_slots(whole, of_whole));
        return {std::move(cut), std::move(origins)};
      }
    return {Level_creases(static_cast<Index>(vertices.size())), vertices};
  }

private:
  struct Itself
  {
    Index operator[](Index i) const { return i; }
  };
};

// the values of a part
template <class Values>
Values values_of_part(const Values& whole, const Level_part::Origins& origins)
{
  Values part;
  part.reserve(origins.size());
  for (const Level_part::Index i : origins) part.push_back(whole[i]);
  return part;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_PART_H
