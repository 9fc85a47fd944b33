// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "options.h"

#include "curve/Curve_data.h"
#include "curve/curve_schemes.h"
#include "io/Error.h"
#include "io/Text_reader.h"
#include "io/mesh_io.h"
#include "pieces/Ranks.h"
#include "surface/verification.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cstdio>

namespace pn_subdivide {
namespace {

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

// The refined parts, and what they are together.
struct Refined_curve
{
  std::vector<Curve_data> parts;
  Curve_data whole;
};

class Curve_run
{
public:
  explicit Curve_run(const Curve_options& options)
    : options_(options)
    , report_(options.report)
    , input_(options.input == "-" ? "standard input" : options.input)
    , output_(options.output == "-" ? "standard output" : options.output)
    , rule_(parse_rule(options))
    , interpolation_(parse_interpolation(options.interpolate))
  {
    if (interpolation_) require_interpolation(options.scheme, rule_);
    require_consistent(options.limit);
    require_limits_of_points(options.scheme, rule_, options.limit);
    center_ = center_of_normals(options);
    if (options.verify.shape) verification_.emplace(options.verify);
    require_writable_places(options);
  }

  void operator()()
  {
    warn_of_end();
    read();
    const Refined_curve refined = naming(input_, [&] { return refine(); });
    const Curve_data& curve = refined.whole;
    if (verification_) verification_->print(options_.output == "-" ? stderr : stdout);
    if (curve.size() >= points_worth_a_report)
      report_.progress("writing " + output_ + ": " + std::to_string(curve.size()) + " points");
    write_files(refined);
    report_.note(output_ + ": " + plural(curve.size(), "point, ", "points, ") + caption() + ", " +
                 normals_ + formatted(", %.2f s", report_.seconds()));
    report_.print_warnings();
    report_.write_file({options_.input, options_.output, curve.size(), 0, options_.levels});
    if (verification_) verification_->require_tolerance();
    report_.print_notes();
    report_.require_no_warnings();
  }

private:
  // Chaikin's stencils stay inside the polygon: nothing is reflected.
  void warn_of_end()
  {
    if (options_.end == "reflect" && !rule_.scheme.primal && rule_.scheme.lost_points == 2 &&
        !rule_.normal_scheme)
      report_.warn("--end reflect: " + options_.scheme +
                   " needs no points beyond the ends, so this is --end none, and the curve does "
                   "not reach the ends; that of bspline:3 does");
  }

  void read()
  {
    polygon_ = read_curve(options_.input);
    if (polygon_.size() >= points_worth_a_report)
      report_.progress("read " + input_ + ": " + std::to_string(polygon_.size()) + " points");
    if (center_)
      polygon_ = naming(input_, [&] { return with_spherical_normals(polygon_, *center_); });
    normals_ = rule_.linear           ? "no normals"
               : center_              ? "normals of the sphere"
               : polygon_.has_normals ? "normals of the file"
                                      : "estimated normals";
    if (options_.sharp && options_.sharp != "arcs")
      corners_ = read_corners(*options_.sharp, polygon_.size());
  }

  Refined_curve refine()
  {
    const std::size_t size = polygon_.size();
    std::vector<Curve_data> parts = options_.sharp == "arcs" ? arcs() : control_parts();
    if (!corners_.empty()) part_rule_.end = PN::Curve_end::reflect;
    if (interpolation_) interpolate(parts);
    // normals of unit length, as the drawing shows them too
    const Refined_curve control = joined_parts(refined(parts, 0), size, 0);
    polygon_ = control.whole;
    std::vector<Curve_data> curves = refined(control.parts, options_.levels);
    if (options_.limit.is_used()) move_to_limits(curves);
    Refined_curve curve = joined_parts(std::move(curves), size, options_.levels);
    if (verification_) verification_->measure(curve.whole);
    return curve;
  }

  // The polygon with its normals, in parts.
  std::vector<Curve_data> arcs()
  {
    Arc_parts arcs = split_into_arcs(polygon_, rule_.end, rule_.linear);
    if (arcs.found_any) {
      report_.note("recognized: " + arcs.summary);
      if (!rule_.linear) normals_ = "normals of lines and arcs";
    } else
      report_.warn(input_ +
                   ": no lines and arcs are recognized; the curve is that without --sharp arcs");
    corners_ = std::move(arcs.corners);
    return std::move(arcs.parts);
  }

  std::vector<Curve_data> control_parts() const
  {
    const bool estimate = !rule_.linear && !polygon_.has_normals;
    std::vector<Curve_data> parts;
    if (!corners_.empty())
      parts = split_curve(polygon_, rule_.end, corners_, estimate);
    else if (estimate)
      std::visit(
        [&](const auto& points) {
          parts.push_back({PN::estimate_control_normals(points, rule_.end), true});
        },
        polygon_.points);
    else
      parts.push_back(polygon_);
    if (estimate && std::holds_alternative<Curve_3>(polygon_.points)) require_a_turn(parts);
    return parts;
  }

  // Parts become the control polygons of curves through their points. Of several reports what they have
  // reached together.
  void interpolate(std::vector<Curve_data>& parts)
  {
    Interpolation_report whole;
    whole.tolerance = HUGE_VAL;
    for (Curve_data& part : parts)
      whole = joined(whole, interpolate_curve(part, part_rule_, *interpolation_));
    tell(whole, *interpolation_, input_, report_);
  }

  // On the limit curve, if that is asked for.
  void move_to_limits(std::vector<Curve_data>& parts)
  {
    Limit_summary whole;
    for (Curve_data& part : parts)
      whole.add(set_limits(part, part_rule_, options_.levels, options_.limit));
    whole.tell(options_.limit, input_, report_);
  }

  std::vector<Curve_data> refined(const std::vector<Curve_data>& parts, unsigned levels) const
  {
    std::vector<Curve_data> result;
    for (const Curve_data& part : parts) result.push_back(refine_curve(part, part_rule_, levels));
    return result;
  }

  Refined_curve joined_parts(std::vector<Curve_data> parts, std::size_t size, unsigned levels) const
  {
    Refined_curve result;
    result.parts = std::move(parts);
    if (corners_.empty()) {
      result.whole = result.parts.front();
      return result;
    }
    // Vertex 0 of a closed polygon is in the last part. What is refined more often is a point.
    const std::size_t first = *std::min_element(corners_.begin(), corners_.end());
    result.whole =
      joined_curve(result.parts, rule_.end, levels < 32 ? (size - first) << levels : 0);
    return result;
  }

  // All is written before anything gets its name, and standard output comes last.
  void write_files(const Refined_curve& curve) const
  {
    std::unique_ptr<Output_file> out, comb;
    naming(output_, [&] {
      out = std::make_unique<Output_file>(options_.output);
      write_curve(*out, curve.whole);
    });
    if (options_.comb)
      naming(*options_.comb, [&] {
        comb = std::make_unique<Output_file>(*options_.comb);
        comb->text(
          curve_picture(caption(), polygon_, curve.parts, rule_.end, options_.sharp.has_value()));
        comb->commit();
      });
    naming(output_, [&] { out->commit(); });
  }

  std::string caption() const
  {
    std::string s = (rule_.linear ? "Linear " : "PN ") + rule_.scheme.name;
    if (rule_.normal_scheme) s += ", normals by " + rule_.normal_scheme->name;
    return s + ", " + plural(options_.levels, "round", "rounds");
  }

  const Curve_options& options_;
  Report report_;
  const std::string input_, output_; // for messages
  const Curve_rule rule_;
  Curve_rule part_rule_ = rule_; // of the parts between corners
  const std::optional<Interpolation_mode> interpolation_;
  std::optional<Triple> center_;
  std::optional<Verification> verification_;
  Curve_data polygon_;
  std::string normals_; // for the closing line
  std::vector<std::size_t> corners_;
};

} // namespace

void run_curve_command(const Curve_options& options)
{
  if (ranks().number() > 1)
    throw Usage_error("curves are not shared among ranks: leave mpirun out");
  Curve_run run(options);
  run();
}

} // namespace pn_subdivide
