// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/creases.h"

#include "io/Error.h"
#include "io/Text_reader.h"
#include "options.h"

#include <filesystem>

namespace pn_subdivide {
namespace {

using Source = Crease_plan::Source;

unsigned parse_min_facets(const std::string& text)
{
  constexpr double most = 1000000;
  const double n = parse_numbers(text, 1, "--min-facets")[0];
  const bool is_number = text.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number || n < 3 || n > most)
    throw Usage_error("--min-facets " + text + ": it takes a whole number of at least 3");
  return static_cast<unsigned>(n);
}

double parse_tolerance(const std::string& text)
{
  const double tolerance = parse_numbers(text, 1, "--surface-tolerance")[0];
  if (!(tolerance > 0)) throw Usage_error("--surface-tolerance " + text + ": it must be positive");
  return tolerance;
}

double parse_angle(const std::string& text, const std::string& option, const std::string& before)
{
  const double degrees = parse_numbers(text, 1, option)[0];
  if (!(degrees >= 0 && degrees <= 180))
    throw Usage_error(before + text + ": the angle must be between 0 and 180 degrees");
  return degrees;
}

// of the options that need --sharp surfaces the first that is given, or an empty word
std::string given_option(const Crease_options& options)
{
  const std::pair<const char*, const std::optional<std::string>*> all[] = {
    {"--min-facets", &options.min_facets},
    {"--surface-tolerance", &options.surface_tolerance},
    {"--sharp-angle", &options.sharp_angle},
    {"--surface-labels", &options.surface_labels}};
  for (const auto& [name, value] : all)
    if (*value) return name;
  return {};
}

double parse_sharpness(const std::string& text)
{
  if (text == "inf") return std::numeric_limits<double>::infinity();
  const double s = parse_numbers(text, 1, "--sharpness")[0];
  if (s < 0) throw Usage_error("--sharpness " + text + ": it must not be negative");
  return s;
}

Border parse_border(const std::string& text)
{
  return parse_word<Border>("--border", text,
                            {{"surface", Border::surface},
                             {"curve", Border::curve},
                             {"corners", Border::corners},
                             {"fixed", Border::fixed}});
}

// Words that name no file were meant for something else.
void require_selection(const std::string& file)
{
  if (std::filesystem::exists(file)) return;
  if (file.find_first_not_of("0123456789.") == std::string::npos)
    throw Usage_error("--sharp " + file + ": there is no such file; did you mean angle:" + file +
                      "?");
  const std::string meant = did_you_mean(file, {"auto", "none", "file", "surfaces", "angle:DEG"});
  if (!meant.empty()) throw Usage_error("--sharp " + file + ": there is no such file" + meant);
}

void parse_sharp(const std::string& text, Crease_plan& plan)
{
  if (text == "auto")
    plan.source = Source::automatic;
  else if (text == "none")
    plan.source = Source::none;
  else if (text == "file")
    plan.source = Source::normals;
  else if (text == "surfaces")
    plan.source = Source::surfaces;
  else if (split_at_colon(text).first == "angle") {
    plan.source = Source::angle;
    plan.degrees = parse_angle(split_at_colon(text).second, "--sharp angle:DEG", "--sharp angle:");
  } else {
    if (text.empty() || text == "-")
      throw Usage_error(
        "--sharp '" + text +
        "': expected auto, none, file, surfaces, angle:DEG or the name of a selection file");
    plan.source = Source::selection;
    plan.file = text;
    require_selection(text);
    try {
      plan.selection = read_selection(text);
    } catch (const Error& e) {
      throw Error(std::string("--sharp ") + e.what());
    }
  }
}

} // namespace

bool wants_surfaces(const Crease_options& options)
{
  return options.sharp == "surfaces";
}

Recognition_plan Recognition_plan::make(const Crease_options& options)
{
  Recognition_plan plan;
  if (options.min_facets) plan.min_facets = parse_min_facets(*options.min_facets);
  if (options.surface_tolerance) plan.tolerance = parse_tolerance(*options.surface_tolerance);
  if (options.sharp_angle)
    plan.sharp_angle = parse_angle(*options.sharp_angle, "--sharp-angle", "--sharp-angle ");
  const std::string option = given_option(options);
  if (!option.empty() && !wants_surfaces(options))
    throw Usage_error(option + " needs --sharp surfaces or --part");
  return plan;
}

Crease_plan Crease_plan::make(const Crease_options& options)
{
  Crease_plan plan;
  if (options.border) plan.border = parse_border(*options.border);
  if (options.sharpness) plan.sharpness = parse_sharpness(*options.sharpness);
  plan.has_sharpness = options.sharpness.has_value();
  if (options.sharp) parse_sharp(*options.sharp, plan);
  plan.recognition = Recognition_plan::make(options);
  return plan;
}

void Crease_plan::require_schemes(const Crease_options& options, const Scheme_choice& choice) const
{
  std::string option;
  if (source != Source::automatic && source != Source::none)
    option = "--sharp " + *options.sharp;
  else if (has_sharpness)
    option = "--sharpness " + *options.sharpness;
  else if (border != Border::surface)
    option = "--border " + *options.border;
  const std::string without = scheme_without_creases(choice);
  if (!option.empty() && !without.empty())
    throw Usage_error(option + ": " + without + " has no rules for creases; " +
                      creasing_scheme_names() + " have");
}

} // namespace pn_subdivide
