// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_LIMIT_SURFACE_H
#define PN_SUBDIVIDE_LIMIT_SURFACE_H

#include "io/Limit_choice.h"
#include "surface/Surface.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <optional>
#include <string>

namespace pn_subdivide {

// Throws Usage_error if the scheme has no limit points at vertices.
void require_limit_of_vertices(const std::string& scheme, const Limit_choice& choice);

// Puts the vertices of a mesh of the given level on the limit surface, gives them the surface's normals,
// or both. Points without normals count as those of the linear scheme. Passes on the library's
// exceptions.
Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         unsigned levels, unsigned threads);
// The same of a mesh that has creases or crease borders, with their tangents if it is refined; normals are
// those of corners afterwards.
Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         const Crease_maps& creases, unsigned levels, unsigned threads);

// Puts the vertices on the limit surface, with its normals: zero where it is not known to have one, on creases for
// instance. False if limits are not known: of schemes without limits at vertices, and of edges that are sharp for some
// more rounds.
bool move_to_surface(Surface& surface, const Scheme_choice& scheme,
                     const std::optional<Crease_maps>& creases, unsigned levels, unsigned threads);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LIMIT_SURFACE_H
