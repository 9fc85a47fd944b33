// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_ADAPTIVE_LEVEL_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_ADAPTIVE_LEVEL_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_extraction.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What is known of a face of a level: where it comes from, and what limit points have told of it.
struct Adaptive_face
{
  using Index = Level_connectivity::Index;

  // Of which face the middles have been seen: there are none of faces of the control mesh, nor of children of polygons,
  // before a round is made of them.
  enum class Seen : unsigned char { none, of_parent, of_itself };

  Index origin = 0;       // the face of the control mesh
  bool is_wanted = false; // a part of what is tessellated here, not of a ring around it
  bool is_split = false;  // not flat enough, or to be seen
  Seen seen = Seen::none;
  Index node = Level_connectivity::null, before = Level_connectivity::null;
  double measured = 0;    // how far the middles were from the triangles
  double discrepancy = 0; // and from where they had been expected
};

// The part of a level that is refined further: the faces that are wanted, with rings around them; their slots and edges
// have the numbers of Split_edges, or null.
template <class Value, class Level_creases>
struct Adaptive_level
{
  using Index = Level_connectivity::Index;
  using Slot_value = Value;

  Valued_level<Value> level; // values are those of the slots
  Level_creases creases;
  std::vector<Index> slot_ids, edges;
  std::vector<Adaptive_face> faces;
  std::vector<std::vector<Value>>
    planes{}; // attributes of vertices, three a plane, as points of the slots without normals
  std::vector<std::vector<double>>
    corners{}; // attributes of the corners of each face that is wanted
};

// The slots of the corners of a level.
template <class Level_creases>
class Slots_of_corners;
template <>
class Slots_of_corners<No_creases>
{
public:
  using Index = Level_connectivity::Index;
  Slots_of_corners(const Level_connectivity& level, No_creases)
    : level_(level)
  {}
  Index operator()(Index h) const { return level_.target(h); }

private:
  const Level_connectivity& level_;
};
template <class FT>
class Slots_of_corners<Creases<FT>> : public Corner_slots<FT>
{
public:
  using Corner_slots<FT>::Corner_slots;
};

// Leaves those faces that are marked, and some rings around them.
template <class Level>
void cut_adaptive_level(Level& level, Face_marks kept, unsigned rings)
{
  const Level_connectivity& whole = level.level.level;
  for (unsigned r = 0; r < rings; ++r) add_ring(whole, kept);
  const auto number = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), char(1)));
  if (10 * number > 9 * kept.size()) return; // it would save little
  const All_candidates candidates(whole, kept);
  Piece_extraction<All_candidates> extraction(whole, candidates, false);
  Level_part part(extraction, true);
  auto [creases, origins] = part.creases_and_slots(whole, level.creases);
  Level left{{},
             std::move(creases),
             {},
             values_of_part(level.edges, part.edges),
             values_of_part(level.faces, part.faces),
             {},
             {}};
  left.level.values = values_of_part(level.level.values, origins);
  left.slot_ids = values_of_part(level.slot_ids, origins);
  for (const auto& plane : level.planes) left.planes.push_back(values_of_part(plane, origins));
  if (!level.corners.empty())
    for (const Level_part::Index f : part.faces)
      left.corners.push_back(std::move(level.corners[f]));
  left.level.level = std::move(part.level);
  level = std::move(left);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_ADAPTIVE_LEVEL_H
