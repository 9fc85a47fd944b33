// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "options.h"

#include "io/mesh_io.h"

#include <CLI/CLI.hpp>

#include <sstream>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

constexpr std::size_t columns = 100;

// The words of `text` in lines of at most `columns` characters, all but the first indented.
std::string wrapped(const std::string& text, std::size_t indent)
{
  std::istringstream words(text);
  std::string lines, word;
  std::size_t column = indent;
  while (words >> word) {
    const bool is_first = column == indent;
    if (!is_first && column + 1 + word.size() > columns) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!is_first) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

// A dot before each name: ".ply .off".
std::string extensions(std::string formats)
{
  for (std::size_t i = 0; i < formats.size(); ++i)
    if (i == 0 || formats[i - 1] == ' ') formats.insert(i++, ".");
  return formats;
}

std::string files_and_exit_codes()
{
  return "Meshes: reads " + extensions(readable_formats()) + ", writes " +
         extensions(writable_formats()) + R"(.
Exit code: 0 success; 1 failure, 2 wrong command line: one line on standard error tells why,
and OUTPUT is as it was; 3 the deviation exceeds --tolerance, 4 a warning with --strict: OUTPUT
is written.
)";
}

class Command_help : public CLI::Formatter
{
public:
  Command_help() { column_width(name_column); }

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override
  {
    if (app->get_parent() == nullptr || mode == CLI::AppFormatMode::Sub)
      return CLI::Formatter::make_help(app, std::move(name), mode);
    std::string help =
      make_description(app) + make_usage(app, std::move(name)) + make_positionals(app);
    for (const std::string& group : app->get_groups()) {
      const std::vector<const CLI::Option*> options = app->get_options(
        [&](const CLI::Option* o) { return o->nonpositional() && o->get_group() == group; });
      if (!options.empty()) help += make_group(group, false, options);
    }
    return help + '\n' + make_footer(app);
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override
  {
    std::string name = "  " + make_option_name(option, is_positional) +
                       (is_positional ? std::string() : make_option_opts(option));
    if (name.size() + 1 < name_column)
      name.resize(name_column, ' ');
    else
      name += "\n" + std::string(name_column, ' ');
    return name + wrapped(make_option_desc(option), name_column) + "\n";
  }

private:
  static constexpr std::size_t name_column = 26;
};

} // namespace

std::shared_ptr<CLI::FormatterBase> command_help()
{
  return std::make_shared<Command_help>();
}

std::string top_level_footer()
{
  return R"(What people look for, with any mesh in the place of part.obj:
  smooth it                pn_subdivide part.obj smooth.ply --levels 3
  keep its edges           pn_subdivide part.obj smooth.ply --levels 3 --sharp angle:40
  a part of CAD as an STL  pn_subdivide part.stl fine.stl --part
  compare with the linear  pn_subdivide part.obj linear.ply --levels 3 --linear
  color by curvature       pn_subdivide part.obj color.ply --levels 3 --curvature mean
  pass through its points  pn_subdivide part.obj smooth.ply --levels 3 --interpolate slide
  mend what is broken      pn_subdivide part.stl smooth.ply --repair
  faces by the million     pn_subdivide part.obj huge.ply --levels 10 --memory 2G
  a curve                  pn_subdivide curve polygon.txt curve.txt --levels 6

)" + files_and_exit_codes() +
         R"(All options: pn_subdivide surface --help, pn_subdivide curve --help, man pn_subdivide.
)";
}

std::string surface_footer()
{
  return R"(Messages count vertices and faces from 0. The normals in OUTPUT are those of its faces. Control
normals for a further round, which may be far off these (up to 70 degrees on coarse meshes),
are written with --output-normals control or both.
)" + files_and_exit_codes() +
         R"(
Examples:
  pn_subdivide head.obj smooth.ply --levels 3
  pn_subdivide part.stl fine.stl --part
  pn_subdivide house.obj smooth.ply --levels 3 --sharp angle:40 --limit
  pn_subdivide part.stl smooth.ply --repair --report smooth.json
)";
}

std::string curve_footer()
{
  return R"(Files are text with a vertex a line: x y nx ny, or x y z nx ny nz, or without normals x y or
x y z; blank lines and # comments are skipped. 0 0 (0 0 0) means: no control normal here.
Missing normals are estimated. Messages count lines from 1.
)" + files_and_exit_codes() +
         R"(
Examples:
  pn_subdivide curve bottle.txt smooth.txt --closed --levels 6
  pn_subdivide curve bottle.txt smooth.txt --scheme 4-point --closed --comb smooth.svg
)";
}

} // namespace pn_subdivide
