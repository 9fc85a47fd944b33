// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OPTIONS_H
#define PN_SUBDIVIDE_OPTIONS_H

// The options as they are on the command line, and the commands.

#include "io/Report.h"
#include "surface/surface_schemes.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace CLI {
class App;
class FormatterBase;
} // namespace CLI

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

// std::monostate: help or the version was asked for and has been printed.
using Command = std::variant<std::monostate, Surface_options, Curve_options>;

// Throws Usage_error.
Command parse_command_line(int argc, char** argv);

// The commands. They throw Usage_error, Error or what the library throws; the files to be written are then as they were.
// They throw Tolerance_error and Strict_error after writing them.
void run_surface_command(const Surface_options& options);
void run_curve_command(const Curve_options& options);

// As in "bspline:DEGREE (DEGREE 2 to 9), ...".
std::string curve_scheme_names();

// The help of both commands, in 100 columns; CLI11 alone leaves lines as long as they are.
std::shared_ptr<CLI::FormatterBase> command_help();
// What stands below the options: remarks and, last, examples.
std::string top_level_footer();
std::string surface_footer();
std::string curve_footer();

// Throws Usage_error if options of a command that has been parsed exclude each other, and says why and what to do. What the
// schemes and the data do not allow is found where they are known.
void require_no_exclusions(const CLI::App& command);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OPTIONS_H
