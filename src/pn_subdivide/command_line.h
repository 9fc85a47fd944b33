// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_COMMAND_LINE_H
#define PN_SUBDIVIDE_COMMAND_LINE_H

#include "options.h"

#include <memory>
#include <string>
#include <variant>

namespace CLI {
class App;
class FormatterBase;
} // namespace CLI

namespace pn_subdivide {

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

#endif // PN_SUBDIVIDE_COMMAND_LINE_H
