// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_EXPECTED_TIME_H
#define PN_SUBDIVIDE_EXPECTED_TIME_H

#include "surface/Surface.h"
#include "surface/surface_schemes.h"

namespace pn_subdivide {

// About how many seconds the rounds take on one thread; 0 for meshes without large valences and large
// faces, whose rounds are reported one by one. Some schemes combine, for each edge at a vertex, all of its
// neighbors: the time then grows with the square of the valence.
double expected_seconds(Surface& surface, const Scheme_choice& choice, unsigned levels);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_EXPECTED_TIME_H
