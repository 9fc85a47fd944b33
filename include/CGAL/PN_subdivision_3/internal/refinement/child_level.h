// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_CHILD_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_CHILD_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The child that a host makes of its level: of this size, with room for what a cut adds to it.
template <class Host>
Level_connectivity child_level(const Host& host, const Level_size& size, const Level_size& room,
                               const For_chunks& for_chunks)
{
  Level_connectivity child(size, room);
  child.set_uniform_degree(Host::refined_degree);
  host.connect(child, for_chunks);
  return child;
}

// of a round
template <class Round>
Level_connectivity child_level(const Round& round, const For_chunks& for_chunks)
{
  return child_level(round.host(), round.refined_size(), round.refined_size(), for_chunks);
}

// without a round of its own
template <class Host>
Level_connectivity child_level(const Level_connectivity& level, unsigned round,
                               const For_chunks& for_chunks)
{
  const Level_size size = Host::refined_size(level.size(), round);
  return child_level(Host(level, round), size, size, for_chunks);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_CHILD_LEVEL_H
