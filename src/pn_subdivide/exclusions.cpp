// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "command_line.h"

#include "io/Error.h"
#include "pieces/Ranks.h"

#include <CLI/CLI.hpp>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

namespace pn_subdivide {
namespace {

// Values: "a|b" these, "!a" all but this one, "*" any, which is named, "" any, or the option has none.
struct Exclusion
{
  const char *options, *values; // "a|b": each of them
  const char *other, *other_values;
  const char *reason, *remedy;
  const char* unless = nullptr; // one of these options is given
};

constexpr const char* in_pieces = "pieces"; // is no option
constexpr const char* title_of_pieces = "refinement in pieces (--memory, --pieces, .pvtp, mpirun)";

constexpr const char *no_round = "without normals nothing is round",
                     *is_linear = "in linear schemes normals take no part",
                     *no_control_mesh = "its triangles are no control mesh for further rounds",
                     *uniform = "--levels N refines uniformly",
                     *of_uniform = "it is of uniformly refined meshes",
                     *doubled = "with vertices that are doubled it is no mesh for further rounds",
                     *through_points =
                       "surfaces with sharp edges cannot be made to pass through points",
                     *no_rules = "that scheme has no rules for it",
                     *other_scheme = "catmull-clark has", *leave_out = "leave one of the two out",
                     *without_edges = "sqrt3|doo-sabin"; // schemes that keep none

const Exclusion exclusions[] = {
  // what there must be to average
  {"--normals|--normal-scheme", "", "--linear", "", is_linear, ""},
  {"--normal-scheme", "", "--normals", "none", "there are no normals for it to average", ""},
  {"--roundness", "", "--linear", "", no_round, ""},
  {"--roundness", "", "--normals", "none", no_round, ""},
  {"--output-normals", "control|both", "--linear", "", is_linear, ""},
  {"--output-normals", "control|both", "--normals", "none", "there are no control normals then",
   ""},
  {"--surface-normals", "", "--output-normals", "!surface", "it is --output-normals surface", ""},
  // checks
  {"--check", "", "--linear", "", "--check compares with the linear result", ""},
  {"--check", "", "--levels", "0", "nothing is refined that could be compared", ""},
  // parts
  {"--part", "", "--sharp", "!surfaces", "its edges are those between recognized surfaces", ""},
  {"--part", "", "--sharpness", "", "edges between surfaces are sharp forever", ""},
  {"--part", "", "--linear", "", "without normals nothing becomes round", ""},
  {"--part", "", "--interpolate", "", through_points, ""},
  {"--part", "", "--write-tags", "", no_control_mesh, "take --sharp surfaces"},
  {"--part", "", "--output-normals", "control|both", no_control_mesh, "take --sharp surfaces"},
  {"--part", "", in_pieces, "", "planes are made of their whole rims", ""},
  {"--part", "", "--curvature", "", of_uniform, "take --levels N, too", "--levels|--chord"},
  {"--part", "", "--limit-tolerance", "", of_uniform, "take --levels N, too", "--levels|--chord"},
  {"--part", "", "--texture-rule", "!all", "it is linear inside the control faces",
   "take all, or --levels N, too", "--levels|--chord"},
  {"--planes", "rims", "--output-normals", "control|both", no_control_mesh, ""},
  {"--planes", "rims", "--write-tags", "", no_control_mesh, ""},
  // creases
  {"--sharpness", "", "--sharp", "none", "no edge is sharp", ""},
  {"--sharpness", "", "--sharp", "surfaces", "creases between surfaces are sharp forever", ""},
  {"--interpolate", "", "--sharp", "surfaces", through_points, ""},
  {"--write-tags", "", "--scheme", without_edges, "that scheme keeps no edges", ""},
  // triangles within a distance
  {"--chord", "", "--levels", "*", leave_out, ""},
  {"--chord", "", "--scheme", without_edges, "a round of that scheme halves no edge", ""},
  {"--chord", "", "--output-normals", "control|both", no_control_mesh, uniform},
  {"--chord", "", "--write-tags", "", no_control_mesh, uniform},
  {"--chord", "", "--limit-tolerance", "",
   "its points are limits to 1/1024 of the chord's tolerance and better", uniform},
  {"--chord", "", "--curvature", "", "it is measured on uniformly refined meshes", uniform},
  {"--chord", "", "--texture-rule", "!all", "take all, which is linear inside the control faces",
   ""},
  // attributes
  {"--nearest|--directions", "", "--drop-attributes", "", "no numbers of vertices are read", ""},
  {"--texture-rule", "", "--drop-attributes", "", "no texture coordinates are read", ""},
  {"--split-seams", "", "--output-normals", "control|both", doubled, ""},
  {"--split-seams", "", "--write-tags", "", doubled, ""},
  // grids
  {"--limit|--surface-normals", "", "--scheme", "grid-catmull-clark", no_rules, other_scheme},
  {"--output-normals", "surface", "--scheme", "grid-catmull-clark", no_rules, other_scheme},
  {"--interpolate|--chord|--check", "", "--scheme", "grid-catmull-clark", no_rules, other_scheme},
  {"--scheme", "grid-catmull-clark", in_pieces, "", "it has no rules for it", other_scheme},
  // pieces
  {"--scheme", without_edges, in_pieces, "", "it halves no edges", "take catmull-clark or loop"},
  {"--chord", "", in_pieces, "", leave_out,
   "--chord makes few triangles where it is flat, --levels N refines uniformly"},
  {"--sharp", "surfaces", in_pieces, "",
   "recognize first, with --levels 0 --output-normals both, and refine that .ply file with "
   "--drop-attributes",
   ""},
  {"--memory", "", "--pieces", "", leave_out, ""},
  {"--curvature|--check|--verify|--interpolate|--ascii|--split-seams|--write-tags", "", in_pieces,
   "", leave_out, ""},
  // what is behind all others: it is found last
  {"--texture-rule", "boundaries|all", "--scheme", without_edges,
   "this scheme keeps no edges that could stay straight", ""},
  // curves
  {"--end", "", "--closed", "", "a closed polygon has no ends", ""},
  {"--sharp", "", "--end", "none", "the parts between corners end where the corners are", ""},
  {"--sharp", "arcs", "--interpolate", "", "lines and arcs pass through their points already", ""},
  {"--interpolate", "", "--end", "none", "without its ends the curve does not pass through them",
   ""}};

bool is_one_of(const std::string& value, const std::string& values)
{
  return ("|" + values + "|").find("|" + value + "|") != std::string::npos;
}

// Of what the command has; a flag may be given as --flag=false.
class Given_options
{
public:
  explicit Given_options(const CLI::App& command)
    : command_(command)
  {}

  // as people have to write it, or empty if it is not given
  std::string find(const std::string& option, const std::string& values) const
  {
    if (option == in_pieces) return is_in_pieces() ? title_of_pieces : "";
    const std::string value = value_of(option);
    if (value.empty() || (values.empty() && value == "false")) return {};
    if (values.empty()) return option;
    const bool is_meant =
      values == "*" || (values[0] == '!' ? value != values.substr(1) : is_one_of(value, values));
    return is_meant ? option + " " + value : "";
  }
  bool any(const std::string& options) const
  {
    const auto all = command_.get_options();
    return std::any_of(all.begin(), all.end(), [&](const CLI::Option* option) {
      return option->count() > 0 && is_one_of(option->get_name(), options);
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
    return any("--memory|--pieces|--resume") || boost::algorithm::to_lower_copy(end) == ".pvtp" ||
           ranks().number() > 1;
  }

  const CLI::App& command_;
};

std::string message(const std::string& option, const std::string& other, const Exclusion& e)
{
  const std::string remedy = *e.remedy == 0 ? "" : std::string("; ") + e.remedy;
  return option + " and " + other + " exclude each other: " + e.reason + remedy;
}

} // namespace

void require_no_exclusions(const CLI::App& command)
{
  const Given_options given(command);
  for (const Exclusion& e : exclusions) {
    const std::string other = given.find(e.other, e.other_values);
    if (other.empty() || (e.unless != nullptr && given.any(e.unless))) continue;
    std::istringstream options(e.options);
    for (std::string name; std::getline(options, name, '|');)
      if (const std::string option = given.find(name, e.values); !option.empty())
        throw Usage_error(message(option, other, e));
  }
}

} // namespace pn_subdivide
