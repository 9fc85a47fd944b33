// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_REFINE_SURFACE_H
#define PN_SUBDIVIDE_REFINE_SURFACE_H

#include "surface/Surface.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <CGAL/PN_subdivision_3/attributes.h>

#include <cstddef>
#include <functional>
#include <optional>

namespace pn_subdivide {

// About how many seconds the rounds take on one thread; 0 for meshes without large valences and large
// faces, whose rounds are reported one by one. Some schemes combine, for each edge at a vertex, all of its
// neighbors: the time then grows with the square of the valence.
double expected_seconds(Surface& surface, const Scheme_choice& choice, unsigned levels);

// About how many seconds the rounds take on one thread; 0 for meshes without large valences and large
// faces, whose rounds are reported one by one. Some schemes combine, for each edge at a vertex, all of its
// neighbors: the time then grows with the square of the valence.
double expected_seconds(Surface& surface, const Scheme_choice& choice, unsigned levels);

struct Refinement
{
  unsigned levels = 1;
  unsigned threads = 1;
  std::optional<Crease_maps> creases;
  Wedge_list* wedges = nullptr;                                  // with creases: gets the normals
  CGAL::PN_subdivision_3::Attribute_table* attributes = nullptr; // there must be one, perhaps empty
  std::function<void(unsigned, std::size_t)> round_done;         // (round, faces), after each round
};

// Throws Usage_error if this program was built without TBB and there is more than one thread.
void require_threads(unsigned threads);

// Refines with the scheme, point-normal if the mesh has normals, linear if not. Old vertices come
// first in the result, in their order, but for Doo-Sabin. With creases, which the schemes must have
// rules for, the normals of vertices that have several are in the list of wedges afterwards. The roundness of the mesh, if it has one, is refined with
// it. Passes on the library's
// exceptions.
void refine_surface(Surface& surface, const Scheme_choice& choice, const Refinement& refinement);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_REFINE_SURFACE_H
