// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "options.h"

#include "io/Error.h"
#include "pieces/Ranks.h"

#include <CLI/CLI.hpp>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace pn_subdivide {
namespace {

// Words with blanks between: options, perhaps with their values, "=a|b" these, "=!a" all but this one, "=*" any, which is named.
struct Exclusion
{
  const char *options, *others; // each of them
  const char* reason;
  const char *remedy = "", *unless = ""; // one of these options is given
};

constexpr const char* in_pieces = "pieces"; // is no option
constexpr const char* title_of_pieces = "refinement in pieces (--memory, --pieces, .pvtp, mpirun)";

constexpr const char *is_linear = "in linear schemes normals take no part",
                     *control_data = "--output-normals=control|both --write-tags",
                     *no_control_mesh = "its triangles are no control mesh for further rounds",
                     *uniform = "--levels N refines uniformly",
                     *through_points =
                       "surfaces with sharp edges cannot be made to pass through points",
                     *other_scheme = "catmull-clark has", *leave_out = "leave one of the two out",
                     *without_edges = "--scheme=sqrt3|doo-sabin"; // schemes that keep none

const Exclusion exclusions[] = {
  // what there must be to average
  {"--normals --normal-scheme", "--linear", is_linear},
  {"--normal-scheme", "--normals=none", "there are no normals for it to average"},
  {"--roundness", "--linear --normals=none", "without normals nothing is round"},
  {"--output-normals=control|both", "--linear", is_linear},
  {"--output-normals=control|both", "--normals=none", "there are no control normals then"},
  {"--surface-normals", "--output-normals=!surface", "it is --output-normals surface"},
  // checks
  {"--check", "--linear", "--check compares with the linear result"},
  {"--check", "--levels=0", "nothing is refined that could be compared"},
  // parts
  {"--part", "--sharp=!surfaces", "its edges are those between recognized surfaces"},
  {"--part", "--sharpness", "edges between surfaces are sharp forever"},
  {"--part", "--linear", "without normals nothing becomes round"},
  {"--part", "--interpolate", through_points},
  {"--part", "--write-tags --output-normals=control|both", no_control_mesh,
   "take --sharp surfaces"},
  {"--part", in_pieces, "planes are made of their whole rims"},
  {"--part", "--curvature --limit-tolerance", "it is of uniformly refined meshes",
   "take --levels N, too", "--levels --chord"},
  {"--part", "--texture-rule=!all", "it is linear inside the control faces",
   "take all, or --levels N, too", "--levels --chord"},
  {"--planes=rims", control_data, no_control_mesh},
  // creases
  {"--sharpness", "--sharp=none", "no edge is sharp"},
  {"--sharpness", "--sharp=surfaces", "creases between surfaces are sharp forever"},
  {"--interpolate", "--sharp=surfaces", through_points},
  {"--write-tags", without_edges, "that scheme keeps no edges"},
  // triangles within a distance
  {"--chord", "--levels=*", leave_out},
  {"--chord", without_edges, "a round of that scheme halves no edge"},
  {"--chord", control_data, no_control_mesh, uniform},
  {"--chord", "--limit-tolerance",
   "its points are limits to 1/1024 of the chord's tolerance and better", uniform},
  {"--chord", "--curvature", "it is measured on uniformly refined meshes", uniform},
  {"--chord", "--texture-rule=!all", "take all, which is linear inside the control faces"},
  // attributes
  {"--nearest --directions", "--drop-attributes", "no numbers of vertices are read"},
  {"--texture-rule", "--drop-attributes", "no texture coordinates are read"},
  {"--split-seams", control_data,
   "with vertices that are doubled it is no mesh for further rounds"},
  // grids
  {"--limit --surface-normals --output-normals=surface --interpolate --chord --check",
   "--scheme=grid-catmull-clark", "that scheme has no rules for it", other_scheme},
  {"--scheme=grid-catmull-clark", in_pieces, "it has no rules for it", other_scheme},
  // pieces
  {without_edges, in_pieces, "it halves no edges", "take catmull-clark or loop"},
  {"--chord", in_pieces, leave_out,
   "--chord makes few triangles where it is flat, --levels N refines uniformly"},
  {"--sharp=surfaces", in_pieces,
   "recognize first, with --levels 0 --output-normals both, and refine that .ply file with "
   "--drop-attributes"},
  {"--memory", "--pieces", leave_out},
  {"--curvature --check --verify --interpolate --ascii --split-seams --write-tags", in_pieces,
   leave_out},
  // what is behind all others: it is found last
  {"--texture-rule=boundaries|all", without_edges,
   "this scheme keeps no edges that could stay straight"},
  // curves
  {"--end", "--closed", "a closed polygon has no ends"},
  {"--sharp", "--end=none", "the parts between corners end where the corners are"},
  {"--sharp=arcs", "--interpolate", "lines and arcs pass through their points already"},
  {"--interpolate", "--end=none", "without its ends the curve does not pass through them"}};

bool is_one_of(const std::string& value, const std::string& values, const std::string& between)
{
  return (between + values + between).find(between + value + between) != std::string::npos;
}

// Of what the command has; a flag may be given as --flag=false.
class Given_options
{
public:
  explicit Given_options(const CLI::App& command)
    : command_(command)
  {}

  // as people have to write it, or empty if it is not given
  std::string find(const std::string& word) const
  {
    if (word == in_pieces) return is_in_pieces() ? title_of_pieces : "";
    const std::size_t end = (std::min)(word.find('='), word.size());
    std::string option = word.substr(0, end);
    const std::string values = word.substr(end), value = value_of(option);
    if (value.empty() || (values.empty() && value == "false")) return {};
    if (values.empty()) return option;
    const bool is_meant =
      values == "=*" ||
      (values[1] == '!' ? value != values.substr(2) : is_one_of(value, values.substr(1), "|"));
    return is_meant ? option + " " + value : "";
  }
  bool any(const std::string& options) const
  {
    const auto all = command_.get_options();
    return std::any_of(all.begin(), all.end(), [&](const CLI::Option* option) {
      return option->count() > 0 && is_one_of(option->get_name(), options, " ");
    });
  }

private:
  std::string value_of(const std::string& option) const
  {
    const CLI::Option* const found = command_.get_option_no_throw(option);
    return found == nullptr || found->count() == 0 ? "" : found->results().back();
  }
  bool is_in_pieces() const
  {
    if (command_.get_option_no_throw("--pieces") == nullptr) return false; // a curve
    const std::string end = std::filesystem::path(value_of("OUTPUT")).extension().string();
    return any("--memory --pieces --resume") || boost::algorithm::to_lower_copy(end) == ".pvtp" ||
           ranks().number() > 1;
  }

  const CLI::App& command_;
};

} // namespace

void require_no_exclusions(const CLI::App& command)
{
  const Given_options given(command);
  for (const Exclusion& e : exclusions) {
    if (given.any(e.unless)) continue;
    std::istringstream others(e.others);
    for (std::string other_word; others >> other_word;) {
      const std::string other = given.find(other_word);
      std::istringstream options(e.options);
      for (std::string word; !other.empty() && options >> word;)
        if (const std::string option = given.find(word); !option.empty())
          throw Usage_error(option + " and " + other + " exclude each other: " + e.reason +
                            (*e.remedy == 0 ? "" : "; ") + e.remedy);
    }
  }
}

} // namespace pn_subdivide
