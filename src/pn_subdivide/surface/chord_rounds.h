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

// --levels auto --chord EPS: throws Usage_error if these do not go with each other and the rest.
std::optional<Box_length> parse_chord(const Surface_options& options);

// The rounds of a part after which no edge is farther from its surface than `chord`.
struct Chord_rounds
{
  unsigned rounds = 0;
  double estimate = 0; // of what is left where no surface is known
};

// `mesh`: with its control normals. Throws Error if it takes too many rounds or faces.
Chord_rounds rounds_for_chord(const Mesh_data& mesh, const Recognized_part& part,
                              const Creases& creases, const Scheme_choice& scheme, double chord,
                              unsigned threads);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CHORD_ROUNDS_H
