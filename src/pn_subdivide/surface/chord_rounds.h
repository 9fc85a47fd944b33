// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CHORD_ROUNDS_H
#define PN_SUBDIVIDE_CHORD_ROUNDS_H

#include "surface/Recognized_part.h"
#include "surface/control_mesh.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <optional>

namespace pn_subdivide {

// --chord EPS and --chord-bound: throws Usage_error if they do not go with --levels and the rest.
std::optional<Box_length> parse_chord(const Surface_options& options);

// The rounds of a part after which no edge is farther from its surface than `chord`.
struct Chord_rounds
{
  unsigned rounds = 0;
  double estimate = 0; // of what is left where no surface is known, or what was measured
};

// `mesh`: with its control normals. Throws Error if it takes too many rounds or faces.
Chord_rounds rounds_for_chord(const Mesh_data& mesh, const Recognized_part& part,
                              const Creases& creases, const Scheme_choice& scheme, double chord,
                              unsigned threads);

// The same of any surface: the least number of rounds after which this is measured to be no farther from its limit.
// at_limits: whether vertices will be put on it.
Chord_rounds rounds_for_chord(const Mesh_data& mesh, const Creases& creases,
                              const Scheme_choice& scheme, double chord, bool at_limits,
                              unsigned threads);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CHORD_ROUNDS_H
