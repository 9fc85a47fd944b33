// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CREASE_OPTIONS_H
#define PN_SUBDIVIDE_CREASE_OPTIONS_H

#include <optional>
#include <string>

namespace pn_subdivide {

// --sharp, --sharpness, --border and what goes with them, as they are on the command line.
struct Crease_options
{
  std::optional<std::string> sharp, sharpness, border;
  // with --sharp surfaces
  std::optional<std::string> min_facets, surface_tolerance, sharp_angle, surface_labels;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CREASE_OPTIONS_H
