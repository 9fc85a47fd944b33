// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "curve/curve_command.h"

#include "curve/curve_picture.h"
#include "curve/curve_schemes.h"
#include "io/Error.h"
#include "io/Report.h"
#include "io/curve_io.h"
#include "io/mesh_io.h"
#include "surface/verification.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

// Curves with fewer points are done before anybody could read about them.
constexpr std::size_t points_worth_a_report = 1000000;

PN::Curve_end parse_end(const Curve_options& options, const Curve_scheme& scheme)
{
  if (options.closed) {
    if (options.end)
      throw Usage_error("--end and --closed exclude each other: a closed polygon has no ends");
    return PN::Curve_end::closed;
  }
  if (!options.end) return scheme.primal ? PN::Curve_end::reflect : PN::Curve_end::none;
  if (*options.end == "reflect") return PN::Curve_end::reflect;
  if (*options.end == "none") return PN::Curve_end::none;
  throw Usage_error("--end '" + *options.end + "': it takes reflect or none");
}

Curve_rule parse_rule(const Curve_options& options)
{
  Curve_rule rule{parse_curve_scheme("--scheme", options.scheme), std::nullopt, options.linear};
  rule.end = parse_end(options, rule.scheme);
  if (!options.normal_scheme) return rule;
  if (options.linear)
    throw Usage_error("--normal-scheme and --linear exclude each other: in linear schemes normals "
                      "take no part");
  rule.normal_scheme = parse_curve_scheme("--normal-scheme", *options.normal_scheme);
  if (rule.normal_scheme->primal != rule.scheme.primal)
    throw Usage_error("--normal-scheme " + *options.normal_scheme + " does not go with --scheme " +
                      options.scheme +
                      ": one is primal (points for vertices and for edges), the "
                      "other is dual");
  return rule;
}

bool same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  const auto place = [&error](const std::string& file) {
    return std::filesystem::weakly_canonical(file, error);
  };
  return place(a) == place(b);
}

void require_writable_places(const Curve_options& options)
{
  require_writable_place(options.output);
  if (!options.comb) return;
  require_writable_place(*options.comb);
  if (same_file(*options.comb, options.output) || same_file(*options.comb, options.input))
    throw Usage_error("--comb " + *options.comb + ": the drawing needs a file of its own");
}

// How it came to its normals, for the closing line.
std::string set_control_normals(Curve_data& polygon, PN::Curve_end end)
{
  if (polygon.has_normals) return "normals of the file";
  Curve_2* const planar = std::get_if<Curve_2>(&polygon.points);
  if (planar == nullptr)
    throw Error("this is a curve in space without normals, and they can be estimated in the plane "
                "only: give lines 'x y z nx ny nz', or use --linear");
  *planar = PN::estimate_control_normals(*planar, end);
  polygon.has_normals = true;
  return "estimated normals";
}

std::string caption(const Curve_rule& rule, const Curve_options& options)
{
  std::string s = (rule.linear ? "Linear " : "PN ") + rule.scheme.name;
  if (rule.normal_scheme) s += ", normals by " + rule.normal_scheme->name;
  return s + ", " + std::to_string(options.levels) + (options.levels == 1 ? " round" : " rounds");
}

std::string input_title(const Curve_options& options)
{
  return options.input == "-" ? "standard input" : options.input;
}
std::string output_title(const Curve_options& options)
{
  return options.output == "-" ? "standard output" : options.output;
}

// Runs a step and names the file in what it throws.
template <class Function>
auto naming(const std::string& file, const Function& function)
{
  try {
    return function();
  } catch (const std::bad_alloc&) {
    throw Error(file + ": not enough memory");
  } catch (const std::exception& e) {
    throw Error(file + ": " + e.what());
  }
}

// All is written before anything gets its name, and standard output comes last.
void write_files(const Curve_options& options, const Curve_rule& rule, const Curve_data& polygon,
                 const Curve_data& curve)
{
  std::unique_ptr<Output_file> out, comb;
  naming(output_title(options), [&] {
    out = std::make_unique<Output_file>(options.output);
    write_curve(*out, curve);
  });
  if (options.comb)
    naming(*options.comb, [&] {
      comb = std::make_unique<Output_file>(*options.comb);
      comb->text(curve_picture(caption(rule, options), polygon, curve, rule.end));
      comb->commit();
    });
  naming(output_title(options), [&] { out->commit(); });
}

std::string closing_line(const Curve_options& options, const Curve_rule& rule,
                         const Curve_data& curve, const std::string& normals, const Report& report)
{
  char time[40];
  std::snprintf(time, sizeof time, ", %.2f s", report.seconds());
  return output_title(options) + ": " + std::to_string(curve.size()) +
         (curve.size() == 1 ? " point, " : " points, ") + caption(rule, options) + ", " + normals +
         time;
}

} // namespace

void run_curve_command(const Curve_options& options)
{
  Report report(options.quiet);
  const Curve_rule rule = parse_rule(options);
  std::optional<Verification> verification;
  if (options.verify.shape) verification.emplace(options.verify);
  require_writable_places(options);

  Curve_data polygon = read_curve(options.input);
  if (polygon.size() >= points_worth_a_report)
    report.progress("read " + input_title(options) + ": " + std::to_string(polygon.size()) +
                    " points");
  std::string normals = "no normals";
  const Curve_data curve = naming(input_title(options), [&] {
    if (!rule.linear) normals = set_control_normals(polygon, rule.end);
    polygon = refine_curve(polygon, rule, 0); // what the drawing shows: normals of unit length
    const Curve_data refined = refine_curve(polygon, rule, options.levels);
    if (verification) verification->measure(refined);
    return refined;
  });
  if (verification) verification->print(options.output == "-" ? stderr : stdout);
  if (curve.size() >= points_worth_a_report)
    report.progress("writing " + output_title(options) + ": " + std::to_string(curve.size()) +
                    " points");
  write_files(options, rule, polygon, curve);
  report.note(closing_line(options, rule, curve, normals, report));
  report.print_warnings();
  if (verification) verification->require_tolerance();
  report.print_notes();
}

} // namespace pn_subdivide
