// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_INTERPOLATE_SURFACE_H
#define PN_SUBDIVIDE_INTERPOLATE_SURFACE_H

#include "io/Limit_choice.h"
#include "surface/Surface.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <optional>
#include <string>

namespace pn_subdivide {

struct Interpolation
{
  Interpolation_mode mode = Interpolation_mode::slide;
  bool improves_normals = false; // they were estimated
  unsigned threads = 1;
};

// Throws Usage_error if surfaces of the scheme cannot be made to pass through points.
void require_interpolation(const Scheme_choice& choice);
bool can_interpolate(const Scheme_choice& choice);

// Makes a mesh the control net of a surface through its vertices; without normals by the linear scheme. With creases
// it gets the normals of their wedges, and the tangents. Passes on the library's exceptions.
Interpolation_report interpolate_surface(Surface& surface, const Scheme_choice& choice,
                                         const Interpolation& interpolation,
                                         const std::optional<Crease_maps>& creases);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_INTERPOLATE_SURFACE_H
