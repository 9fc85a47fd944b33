// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_COMMAND_HELP_H
#define PN_SUBDIVIDE_COMMAND_HELP_H

#include <CLI/CLI.hpp>

#include <string>

namespace pn_subdivide {

// The help of both commands, in 100 columns; CLI11 alone leaves lines as long as they are.
class Command_help : public CLI::Formatter
{
public:
  Command_help() { column_width(name_column); }

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;

private:
  static constexpr std::size_t name_column = 26;
};

// What stands below the options: remarks and, last, examples.
std::string top_level_footer();
std::string surface_footer();
std::string curve_footer();

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_COMMAND_HELP_H
