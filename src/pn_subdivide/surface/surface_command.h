// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_COMMAND_H
#define PN_SUBDIVIDE_SURFACE_COMMAND_H

#include "io/Limit_choice.h"
#include "io/Report.h"
#include "pieces/Pieces_options.h"
#include "surface/limit_surface.h"
#include "surface/surface_schemes.h"

#include <optional>
#include <string>

namespace pn_subdivide {

struct Surface_options
{
  std::string input, output; // "-": standard input, output
  std::optional<std::string> format;
  Scheme_choice scheme;
  unsigned levels = 1;
  bool has_levels = false; // --levels is given
  bool linear = false;
  std::optional<std::string> normals, roundness, output_normals, curvature, interpolate,
    merge_distance, texture_rule, write_tags, chord, chord_bound, planes, nearest, directions;
  unsigned threads = 1; // 0: all cores
  Crease_options creases;
  Limit_choice limit;
  Verify_options verify;
  Pieces_options pieces;
  bool merge_points = false, no_mend = false, repair = false, triangulate = false;
  bool drop_attributes = false;
  bool check = false;
  bool part = false; // --part, see with_part()
  bool ascii = false, split_seams = false;
  Report_options report;
};

// The command `pn_subdivide surface`. Throws Usage_error, Error or what the library throws; the
// output file is then as it was. Throws Tolerance_error after writing it.
void run_surface_command(const Surface_options& options);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_COMMAND_H
