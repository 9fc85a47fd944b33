// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_RECOGNITION_PLAN_H
#define PN_SUBDIVIDE_RECOGNITION_PLAN_H

#include <optional>

namespace pn_subdivide {

struct Crease_options;
struct Surface_options;

// How --sharp surfaces looks for surfaces, as --min-facets, --surface-tolerance and --sharp-angle say it.
struct Recognition_plan
{
  unsigned min_facets = 8;
  std::optional<double> tolerance; // without: of the rounding of the file
  double sharp_angle = 30;         // in degrees

  // Throws Usage_error, also if the options are given without --sharp surfaces.
  static Recognition_plan make(const Crease_options& options);
};

bool wants_surfaces(const Crease_options& options);

// Throws Usage_error if other options exclude --sharp surfaces.
void require_options_for_surfaces(const Surface_options& options);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_RECOGNITION_PLAN_H
