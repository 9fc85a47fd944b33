// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CREASE_PLAN_H
#define PN_SUBDIVIDE_CREASE_PLAN_H

#include "io/Limit_choice.h"
#include "io/mesh_io.h"
#include "surface/surface_schemes.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>

#include <limits>
#include <optional>
#include <string>

namespace pn_subdivide {

struct Crease_options;
struct Surface_options;

// How --sharp surfaces looks for surfaces, as --min-facets, --surface-tolerance and --sharp-angle say it.
struct Recognition_plan
{
  unsigned min_facets = 8;
  std::optional<double> tolerance; // without: of the rounding of the file
  double sharp_angle = 30;         // in degrees
  bool tries_tolerances = true;    // whether another one recognizes more

  // Throws Usage_error, also if the options are given without --sharp surfaces.
  static Recognition_plan make(const Crease_options& options);
};

bool wants_surfaces(const Crease_options& options);

using Border = CGAL::PN_subdivision_3::Border;

// What is to be sharp, as --sharp, --sharpness and --border say it.
struct Crease_plan
{
  enum class Source { automatic, none, normals, angle, selection, surfaces };

  Source source = Source::automatic;
  double degrees = 0;  // of an angle
  std::string file;    // of a selection
  Selection selection; // what is in it
  double sharpness = std::numeric_limits<double>::infinity();
  bool has_sharpness = false;
  Border border = Border::surface;
  Recognition_plan recognition; // of surfaces

  // Throws Usage_error, and Error if the file of a selection cannot be read.
  static Crease_plan make(const Crease_options& options);

  // Throws Usage_error if the plan needs rules for creases that the schemes do not have. Without a
  // name the scheme is one that has.
  void require_schemes(const Crease_options& options, const Scheme_choice& choice) const;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CREASE_PLAN_H
