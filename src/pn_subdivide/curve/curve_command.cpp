// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "command_line.h"

#include "curve/Curve_data.h"
#include "curve/curve_picture.h"
#include "curve/curve_schemes.h"
#include "curve/limit_curve.h"
#include "io/Error.h"
#include "io/Report.h"
#include "io/Text_reader.h"
#include "io/mesh_io.h"
#include "pieces/Ranks.h"
#include "surface/verification.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <new>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

// Curves with fewer points are done before anybody could read about them.
constexpr std::size_t points_worth_a_report = 1000000;

PN::Curve_end parse_end(const Curve_options& options, const Curve_scheme& scheme)
{
  if (options.closed) return PN::Curve_end::closed;
  if (!options.end) return scheme.primal ? PN::Curve_end::reflect : PN::Curve_end::none;
  if (*options.end == "reflect") return PN::Curve_end::reflect;
  if (*options.end == "none") return PN::Curve_end::none;
  throw Usage_error("--end '" + *options.end + "': it takes reflect or none");
}

// Chaikin's stencils stay inside the polygon: nothing is reflected.
void warn_of_end(const Curve_options& options, const Curve_rule& rule, Report& report)
{
  if (options.end == "reflect" && !rule.scheme.primal && rule.scheme.lost_points == 2 &&
      !rule.normal_scheme)
    report.warn("--end reflect: " + options.scheme +
                " needs no points beyond the ends, so this is --end none, and the curve does not "
                "reach the ends; that of bspline:3 does");
}

// The center of --normals spherical:X,Y,Z, if it is given.
std::optional<Triple> center_of_normals(const Curve_options& options)
{
  if (!options.normals) return std::nullopt;
  const auto [name, arguments] = split_at_colon(*options.normals);
  if (name != "spherical")
    throw Usage_error("--normals '" + *options.normals + "': curves take spherical:X,Y,Z");
  const std::vector<double> x = parse_numbers(arguments, 3, "--normals spherical:X,Y,Z");
  return Triple{x[0], x[1], x[2]};
}

Curve_data with_spherical_normals(const Curve_data& polygon, const Triple& center)
{
  const auto* const points = std::get_if<Curve_3>(&polygon.points);
  if (points == nullptr)
    throw Error("--normals spherical:X,Y,Z, but the curve is in the plane: give lines 'x y z'");
  return {
    PN::spherical_control_normals(*points, Curve_kernel::Point_3(center[0], center[1], center[2])),
    true};
}

Curve_rule parse_rule(const Curve_options& options)
{
  if (options.scheme == "levels:-" && options.input == "-")
    throw Usage_error("--scheme levels:-: standard input is the polygon already");
  Curve_rule rule{parse_curve_scheme("--scheme", options.scheme), std::nullopt, options.linear};
  rule.end = parse_end(options, rule.scheme);
  if (options.sharp && !rule.scheme.primal)
    throw Usage_error("--sharp needs a primal scheme (bspline of odd degree, N-point): " +
                      options.scheme + " keeps no end points");
  if (options.sharp == "-" && options.input == "-")
    throw Usage_error("--sharp -: standard input is the polygon already");
  if (options.roundness) rule.roundness = parse_roundness(*options.roundness);
  if (!options.normal_scheme) return rule;
  rule.normal_scheme = parse_curve_scheme("--normal-scheme", *options.normal_scheme);
  if (!rule.scheme.levels.empty() || !rule.normal_scheme->levels.empty())
    throw Usage_error(
      "--normal-scheme does not go with levels:FILE: masks that differ from round to "
      "round are those of points and normals");
  if (rule.normal_scheme->primal != rule.scheme.primal)
    throw Usage_error("--normal-scheme " + *options.normal_scheme + " does not go with --scheme " +
                      options.scheme +
                      ": one is primal (points for vertices and for edges), the "
                      "other is dual");
  return rule;
}

std::optional<Interpolation_mode> interpolation_of(const Curve_options& options,
                                                   const Curve_rule& rule)
{
  const std::optional<Interpolation_mode> mode = parse_interpolation(options.interpolate);
  if (mode) require_interpolation(options.scheme, rule);
  return mode;
}

void require_writable_places(const Curve_options& options)
{
  require_writable_place(options.output);
  if (options.report.file)
    require_own_file("--report", *options.report.file,
                     {options.input, options.output, options.comb.value_or(""),
                      options.sharp.value_or("arcs") == "arcs" ? "" : *options.sharp});
  if (!options.comb) return;
  require_writable_place(*options.comb);
  if (!boost::algorithm::iends_with(*options.comb, ".svg"))
    throw Usage_error("--comb " + *options.comb +
                      ": the drawing is an SVG file, whose name ends in .svg");
  require_own_file("--comb", *options.comb, {options.input, options.output});
}

bool has_normal(const Curve_data& curve)
{
  const auto is_normal = [](const auto& item) { return item.second != CGAL::NULL_VECTOR; };
  return std::visit(
    [&](const auto& points) { return std::any_of(points.begin(), points.end(), is_normal); },
    curve.points);
}

void require_a_turn(const std::vector<Curve_data>& parts)
{
  if (std::any_of(parts.begin(), parts.end(), has_normal)) return;
  throw Error("this is a straight curve in space without normals, and it has none of its own: give "
              "lines 'x y z nx ny nz', or use --linear");
}

// The polygon with its normals; in parts if it has corners.
std::vector<Curve_data> arcs_of(const Curve_data& polygon, const Curve_rule& rule,
                                std::vector<std::size_t>& corners, std::string& normals,
                                const std::string& title, Report& report)
{
  Arc_parts arcs = split_into_arcs(polygon, rule.end, rule.linear);
  if (arcs.found_any) {
    report.note("recognized: " + arcs.summary);
    if (!rule.linear) normals = "normals of lines and arcs";
  } else
    report.warn(title +
                ": no lines and arcs are recognized; the curve is that without --sharp arcs");
  corners = std::move(arcs.corners);
  return std::move(arcs.parts);
}

std::vector<Curve_data> control_parts(const Curve_data& polygon, const Curve_rule& rule,
                                      const std::vector<std::size_t>& corners)
{
  const bool estimate = !rule.linear && !polygon.has_normals;
  std::vector<Curve_data> parts;
  if (!corners.empty())
    parts = split_curve(polygon, rule.end, corners, estimate);
  else if (estimate)
    std::visit(
      [&](const auto& points) {
        parts.push_back({PN::estimate_control_normals(points, rule.end), true});
      },
      polygon.points);
  else
    parts.push_back(polygon);
  if (estimate && std::holds_alternative<Curve_3>(polygon.points)) require_a_turn(parts);
  return parts;
}

// The refined parts, and what they are together.
struct Refined_curve
{
  std::vector<Curve_data> parts;
  Curve_data whole;
};

// Parts become the control polygons of curves through their points. Of several reports what they have
// reached together.
void interpolate_parts(std::vector<Curve_data>& parts, const Curve_rule& rule,
                       const std::vector<std::size_t>& corners, Interpolation_mode mode,
                       const std::string& title, Report& report)
{
  Curve_rule part_rule = rule;
  if (!corners.empty()) part_rule.end = PN::Curve_end::reflect;
  Interpolation_report whole;
  whole.tolerance = HUGE_VAL;
  for (Curve_data& part : parts) whole = joined(whole, interpolate_curve(part, part_rule, mode));
  report.note(description(whole));
  const std::string text = warning(whole, mode);
  if (!text.empty()) report.warn(title + ": " + text);
}

// On the limit curve, if that is asked for.
void move_to_limits(std::vector<Curve_data>& parts, const Curve_rule& part_rule, unsigned rounds,
                    const Limit_choice& choice, const std::string& title, Report& report)
{
  Limit_summary whole;
  for (Curve_data& part : parts) whole.add(set_limits(part, part_rule, rounds, choice));
  report.note(whole.description(choice));
  report.set_limit(whole.numbers(choice));
  const std::string text = whole.warning();
  if (!text.empty()) report.warn(title + ": " + text);
}

// finish(parts, rule) is called before they are joined
template <class Finish>
Refined_curve refined_parts(const std::vector<Curve_data>& parts, const Curve_rule& rule,
                            const std::vector<std::size_t>& corners, std::size_t size,
                            unsigned levels, const Finish& finish)
{
  Refined_curve refined;
  Curve_rule part_rule = rule;
  if (!corners.empty()) part_rule.end = PN::Curve_end::reflect;
  for (const Curve_data& part : parts)
    refined.parts.push_back(refine_curve(part, part_rule, levels));
  finish(refined.parts, part_rule);
  if (corners.empty()) {
    refined.whole = refined.parts.front();
    return refined;
  }
  // Vertex 0 of a closed polygon is in the last part. What is refined more often is a point.
  const std::size_t first = *std::min_element(corners.begin(), corners.end());
  refined.whole = joined_curve(refined.parts, rule.end, levels < 32 ? (size - first) << levels : 0);
  return refined;
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
    throw Error(file + ": " + message_of(e));
  }
}

// All is written before anything gets its name, and standard output comes last.
void write_files(const Curve_options& options, const Curve_rule& rule, const Curve_data& polygon,
                 const Refined_curve& curve)
{
  std::unique_ptr<Output_file> out, comb;
  naming(output_title(options), [&] {
    out = std::make_unique<Output_file>(options.output);
    write_curve(*out, curve.whole);
  });
  if (options.comb)
    naming(*options.comb, [&] {
      comb = std::make_unique<Output_file>(*options.comb);
      comb->text(curve_picture(caption(rule, options), polygon, curve.parts, rule.end,
                               options.sharp.has_value()));
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

const char* description_of_normals(const Curve_rule& rule, bool has_center,
                                   const Curve_data& polygon)
{
  if (rule.linear) return "no normals";
  if (has_center) return "normals of the sphere";
  return polygon.has_normals ? "normals of the file" : "estimated normals";
}

} // namespace

void run_curve_command(const Curve_options& options)
{
  if (ranks().number() > 1)
    throw Usage_error("curves are not shared among ranks: leave mpirun out");
  Report report(options.report);
  const Curve_rule rule = parse_rule(options);
  const std::optional<Interpolation_mode> interpolation = interpolation_of(options, rule);
  require_consistent(options.limit);
  require_limits_of_points(options.scheme, rule, options.limit);
  const std::optional<Triple> center = center_of_normals(options);
  std::optional<Verification> verification;
  if (options.verify.shape) verification.emplace(options.verify);
  require_writable_places(options);
  warn_of_end(options, rule, report);

  Curve_data polygon = read_curve(options.input);
  if (polygon.size() >= points_worth_a_report)
    report.progress("read " + input_title(options) + ": " + std::to_string(polygon.size()) +
                    " points");
  if (center)
    polygon =
      naming(input_title(options), [&] { return with_spherical_normals(polygon, *center); });
  std::string normals = description_of_normals(rule, center.has_value(), polygon);
  std::vector<std::size_t> corners;
  const bool has_arcs = options.sharp == "arcs";
  if (options.sharp && !has_arcs) corners = read_corners(*options.sharp, polygon.size());
  const Refined_curve refined = naming(input_title(options), [&] {
    const std::size_t size = polygon.size();
    std::vector<Curve_data> parts =
      has_arcs ? arcs_of(polygon, rule, corners, normals, input_title(options), report)
               : control_parts(polygon, rule, corners);
    if (interpolation)
      interpolate_parts(parts, rule, corners, *interpolation, input_title(options), report);
    // normals of unit length, as the drawing shows them too
    const auto keep = [](std::vector<Curve_data>&, const Curve_rule&) {};
    const Refined_curve control = refined_parts(parts, rule, corners, size, 0, keep);
    polygon = control.whole;
    const auto finish = [&](std::vector<Curve_data>& curves, const Curve_rule& part_rule) {
      if (options.limit.is_used())
        move_to_limits(curves, part_rule, options.levels, options.limit, input_title(options),
                       report);
    };
    Refined_curve curve = refined_parts(control.parts, rule, corners, size, options.levels, finish);
    if (verification) verification->measure(curve.whole);
    return curve;
  });
  const Curve_data& curve = refined.whole;
  if (verification) verification->print(options.output == "-" ? stderr : stdout);
  if (curve.size() >= points_worth_a_report)
    report.progress("writing " + output_title(options) + ": " + std::to_string(curve.size()) +
                    " points");
  write_files(options, rule, polygon, refined);
  report.note(closing_line(options, rule, curve, normals, report));
  report.print_warnings();
  report.write_file({options.input, options.output, curve.size(), 0, options.levels});
  if (verification) verification->require_tolerance();
  report.print_notes();
  report.require_no_warnings();
}

} // namespace pn_subdivide
