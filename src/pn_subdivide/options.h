// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OPTIONS_H
#define PN_SUBDIVIDE_OPTIONS_H

// The options as they are on the command line.

#include "io/Report.h"
#include "surface/surface_schemes.h"

#include <cstddef>
#include <optional>
#include <string>

namespace pn_subdivide {

// The options --limit, --limit-tolerance and --surface-normals or --curve-normals.
struct Limit_choice
{
  const char* shape = "surface";
  bool points = false, normals = false;
  std::optional<double> tolerance;                  // of the bounding box
  const char* normals_option = "--surface-normals"; // that asks for normals

  bool is_used() const { return points || normals; }
  double tolerance_or_default() const { return tolerance.value_or(1e-9); }
};

// --verify and --tolerance.
struct Verify_options
{
  std::optional<std::string> shape;
  std::optional<double> tolerance;
};

// --sharp, --sharpness, --border and what goes with them.
struct Crease_options
{
  std::optional<std::string> sharp, sharpness, border;
  // with --sharp surfaces
  std::optional<std::string> min_facets, surface_tolerance, sharp_angle, surface_labels;
};

// --memory, --pieces and --resume.
struct Pieces_options
{
  std::optional<std::string> memory;
  std::optional<std::size_t> pieces;
  bool resume = false;

  bool any() const { return memory || pieces || resume; }
};

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

struct Curve_options
{
  std::string input, output; // "-": standard input, output
  std::string scheme = "bspline:3";
  std::optional<std::string> normal_scheme, normals, end, comb, sharp, interpolate, roundness;
  Limit_choice limit{"curve", false, false, std::nullopt};
  Verify_options verify;
  unsigned levels = 1;
  bool closed = false, linear = false;
  Report_options report;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OPTIONS_H
