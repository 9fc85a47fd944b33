// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "command_line.h"

#include "io/Error.h"
#include "io/Report.h"
#include "io/formats.h"
#include "io/mesh_io.h"
#include "io/mesh_normals.h"
#include "io/soup_repair.h"
#include "pieces/Ranks.h"
#include "pieces/pieces_command.h"
#include "surface/Linear_check.h"
#include "surface/Planes_of_part.h"
#include "surface/Recognized_part.h"
#include "surface/Surface_table.h"
#include "surface/attributes.h"
#include "surface/border_curves.h"
#include "surface/control_mesh.h"
#include "surface/control_normals.h"
#include "surface/output_mesh.h"
#include "surface/output_tags.h"
#include "surface/part_choice.h"
#include "surface/refine_surface.h"
#include "surface/roundness.h"
#include "surface/verification.h"
#include "surface/vertex_curvature.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>
#include <optional>
#include <thread>
#include <utility>

namespace pn_subdivide {
namespace {

// What the command line says, looked through before anything is read.
struct Plan
{
  Mesh_file input, output;
  Normals_option normals;
  Roundness_option roundness;
  Output_normals output_normals;
  Limit_choice limit; // with the normals of the surface, if they are written
  Crease_plan creases;
  std::optional<Box_length> chord; // tessellated within it
  std::optional<Interpolation_mode> interpolation;
  std::optional<Curvature_kind> curvature;
  std::optional<Verification> verification;
  Texture_rule texture_rule;
  unsigned threads;
};

void require_consistent(const Surface_options& options)
{
  require_surface_schemes(options.scheme);
  require_consistent(options.limit);
  if (options.interpolate && !options.scheme.scheme.empty()) require_interpolation(options.scheme);
  if (options.format && options.input != "-" && options.output != "-")
    throw Usage_error(
      "--format is for standard input and output ('-'): the format of a file follows "
      "from its name");
}

Texture_rule texture_rule(const Surface_options& options)
{
  if (!options.texture_rule) return options.chord ? Texture_rule::all : Texture_rule::corners_plus1;
  const Texture_rule rule = parse_texture_rule(*options.texture_rule);
  if (!options.scheme.scheme.empty())
    require_texture_rule(rule, *options.texture_rule, options.scheme.scheme);
  return rule;
}

unsigned number_of_threads(const Surface_options& options)
{
  const unsigned threads =
    options.threads != 0 ? options.threads : (std::max)(1u, std::thread::hardware_concurrency());
  require_threads(threads);
  return threads;
}

Limit_choice limit_choice(const Surface_options& options, const Output_normals& normals)
{
  Limit_choice limit = options.limit;
  limit.normals = normals.kind == Normal_kind::of_surface;
  if (options.output_normals) limit.normals_option = "--output-normals";
  return limit;
}

void require_consistent_seams(const Surface_options& options, const Plan& plan)
{
  if (!options.split_seams) return;
  if (plan.output.format != "ply" && plan.output.format != "vtp")
    throw Usage_error("--split-seams is for .ply files: " + plan.output.title("standard output") +
                      " (" + plan.output.format + ") is none");
}

Plan make_plan(const Surface_options& options)
{
  Plan plan{input_mesh_file(options.input, options.format),
            output_mesh_file(options.output, options.format),
            {},
            {},
            {},
            {},
            {},
            parse_chord(options),
            parse_interpolation(options.interpolate),
            std::nullopt,
            std::nullopt,
            texture_rule(options),
            1};
  require_consistent(options);
  plan.output_normals = Output_normals::make(options, plan.output);
  if (!plan.chord) plan.limit = limit_choice(options, plan.output_normals);
  if (!options.scheme.scheme.empty()) require_limit_of_vertices(options.scheme.scheme, plan.limit);
  if (options.merge_distance) parse_box_length(*options.merge_distance, "--merge-distance");
  if (is_in_pieces(options, plan.output)) require_options_for_pieces(options, plan.output);
  require_options_for_planes(options);
  plan.creases = Crease_plan::make(options.creases);
  plan.creases.require_schemes(options.creases, options.scheme);
  plan.normals = parse_normals_option(options.linear ? "none" : options.normals.value_or("auto"));
  require_consistent_seams(options, plan);
  if (plan.interpolation) plan.normals.is_reciprocal = true; // natural normals begin with it
  if (options.roundness) plan.roundness = parse_roundness_option(*options.roundness);
  if (options.curvature) plan.curvature = parse_curvature_option(*options.curvature, plan.output);
  plan.threads = number_of_threads(options);
  if (options.verify.shape) {
    plan.verification.emplace(options.verify);
    plan.verification->require_surface();
  }
  require_writable_place(options.output);
  if (options.report.file)
    require_own_file("--report", *options.report.file,
                     {options.input, options.output, plan.creases.file});
  const std::string report = options.report.file.value_or("");
  require_tags_place(options, {options.input, options.output, plan.creases.file, report});
  if (options.creases.surface_labels)
    require_own_file("--surface-labels", *options.creases.surface_labels,
                     {options.input, options.output, report, options.write_tags.value_or("")});
  return plan;
}

std::string turned_by_repair(const Opposing_normals& opposing)
{
  if (opposing.of_all_faces == 0) return {};
  return std::string("; --repair turns ") +
         (opposing.number == 1 ? "it"
          : opposing.of_all_faces == opposing.number
            ? "them"
            : std::to_string(opposing.of_all_faces) + " of them, which oppose all their faces,") +
         " over";
}

void warn_of_opposing_normals(const Opposing_normals& opposing, const std::string& input,
                              Report& report)
{
  if (opposing.number == 0) return;
  report.warn(
    input + ": " + std::to_string(opposing.number) + " of " + std::to_string(opposing.of) +
    (opposing.number == 1 ? " normals points" : " normals point") +
    " against the faces (first: at vertex " + std::to_string(opposing.first_vertex) +
    std::string(
      opposing.number == opposing.of
        ? "), as if these were inside out"
        : "), and the surface may tear there; --normals estimate takes none of the file") +
    turned_by_repair(opposing));
}

void warn_of_other_normals(Normal_kind kind, const std::string& input, Report& report)
{
  if (kind == Normal_kind::control) return;
  report.warn(input + ": the " + comment_of(kind) +
              " in the file are taken for control normals, which they are not; --output-normals "
              "both writes a file with both, from which a further round takes the right ones");
}

// Those of surfaces that have been recognized, unless others are asked for.
bool takes_surface_normals(const Plan& plan, const std::optional<Recognized_part>& part)
{
  using Source = Normals_option::Source;
  const Source source = plan.normals.source;
  return part && (source == Source::automatic || source == Source::file);
}

std::string set_surface_normals(Mesh_data& mesh, const Plan& plan, const Recognized_part& part,
                                Creases& creases, Report& report)
{
  const std::string input = plan.input.title("standard input");
  const bool from_file = plan.normals.source == Normals_option::Source::file;
  Normals_option given = plan.normals;
  given.source = Normals_option::Source::file;
  if (from_file && !mesh.has_normals()) set_control_normals(mesh, given); // throws
  Roundness_of_file roundness_of_file(mesh);
  put_surface_normals(mesh, part, from_file);
  set_control_normals(mesh, given, creases, input, report);
  if (!from_file) mesh.roundness = part.roundness;
  set_roundness(mesh, plan.roundness, std::move(roundness_of_file), from_file, creases);
  if (from_file) warn_of_opposing_normals(find_opposing_normals(mesh), input, report);
  if (from_file && !plan.output_normals.copies)
    warn_of_other_normals(mesh.normal_kind, input, report);
  mesh.normal_kind = Normal_kind::control;
  return std::string(from_file ? "normals of the file" : "normals of the surfaces") +
         roundness_description(mesh.roundness);
}

// How it came to its normals, for the closing line.
std::string set_normals(Mesh_data& mesh, const Plan& plan, Creases& creases, Report& report)
{
  using Source = Normals_option::Source;
  const Source source = plan.normals.source;
  const bool from_file =
    source == Source::file || (source == Source::automatic && mesh.has_normals());
  const std::string input = plan.input.title("standard input");
  const Opposing_normals opposing = from_file ? find_opposing_normals(mesh) : Opposing_normals();
  if (from_file && mesh.vertices_with_several_normals > 0 && !creases.any())
    report.warn(input + ": " + std::to_string(mesh.vertices_with_several_normals) +
                (mesh.vertices_with_several_normals == 1 ? " vertex has" : " vertices have") +
                " several normals; their normalized sum is taken");
  const bool has_other_normals = mesh.normal_kind != Normal_kind::control;
  Roundness_of_file roundness_of_file(mesh);
  const bool are_smoothed = set_control_normals(mesh, plan.normals, creases, input, report);
  if (source != Source::none)
    set_roundness(mesh, plan.roundness, std::move(roundness_of_file),
                  from_file && !has_other_normals, creases);
  const std::string round = roundness_description(mesh.roundness);
  const std::string of_file = are_smoothed ? "smoothed normals of the file" : "normals of the file";
  if (from_file) {
    if (are_all_zero(mesh)) return "no normals, those of the file are zero";
    warn_of_opposing_normals(opposing, input, report);
    if (plan.output_normals.copies) return of_file + round;
    warn_of_other_normals(mesh.normal_kind, input, report);
    mesh.normal_kind = Normal_kind::control;
    return of_file + round;
  }
  mesh.normal_kind = Normal_kind::control;
  if (source == Source::none) return "no normals";
  const bool is_shape = source == Source::sphere || source == Source::cylinder;
  return (is_shape ? "normals of the given shape" : "estimated normals") + round;
}

Refinement refinement(const Surface_options& options, unsigned threads, const Report& report)
{
  Refinement r;
  r.levels = options.levels;
  r.threads = threads;
  if (report.is_quiet()) return r;
  r.round_done = [&report, levels = options.levels](unsigned k, std::size_t faces) {
    if (faces < faces_worth_a_report) return;
    report.progress("round " + std::to_string(k) + " of " + std::to_string(levels) + ": " +
                    std::to_string(faces) + " faces");
  };
  return r;
}

void add_curvature(Mesh_data& mesh, const Plan& plan, Curvature_values values, Report& report)
{
  const Curvature_range range = set_curvature(mesh, *plan.curvature, std::move(values));
  report.note(range.description(*plan.curvature));
  if (range.replaces_attributes)
    report.warn(plan.output.title("standard output") +
                ": the file's colors or values of vertices give way to those of the curvature");
}

// The control mesh is measured with its control normals, what has been refined with the normals of its limit.
Curvature_values curvature_of(const Surface& surface, const Wedge_list& wedges, const Plan& plan,
                              const Surface_options& options, const Scheme_choice& scheme,
                              const std::optional<Crease_maps>& creases, const Report& report)
{
  if (surface.number_of_faces() >= faces_worth_a_report)
    report.progress("measuring the curvature at " + std::to_string(surface.number_of_vertices()) +
                    " vertices");
  if (options.levels == 0 && !plan.limit.is_used())
    return measure_curvature(surface, creases, *plan.curvature, plan.threads);
  return measure_limit_curvature(surface, wedges, scheme, creases, options.levels, *plan.curvature,
                                 plan.threads);
}

Limit_summary limits(Surface& surface, const Plan& plan, const Surface_options& options,
                     const Scheme_choice& scheme, const std::optional<Crease_maps>& creases,
                     const Limit_choice& limit)
{
  return creases ? set_limits(surface, scheme, limit, *creases, options.levels, plan.threads)
                 : set_limits(surface, scheme, limit, options.levels, plan.threads);
}

// Limits of control normals, beside the normals of the surface.
Kept_normals control_normals_at_limits(const Surface& surface, const Plan& plan,
                                       const Surface_options& options, const Scheme_choice& scheme,
                                       const std::optional<Crease_maps>& creases)
{
  Surface copy = surface;
  Limit_choice limit = plan.limit;
  limit.normals = false;
  limits(copy, plan, options, scheme, creases_of(copy, creases), limit);
  return kept_normals(copy);
}

void report_limits(const Limit_summary& summary, const Plan& plan, Report& report)
{
  report.note(summary.description(plan.limit));
  report.set_limit(summary.numbers(plan.limit));
  const std::string warning = summary.warning();
  if (!warning.empty()) report.warn(plan.output.title("standard output") + ": " + warning);
}

void move_to_limits(Surface& surface, const Plan& plan, const Surface_options& options,
                    const Scheme_choice& scheme, const std::optional<Crease_maps>& creases,
                    Report& report)
{
  report_limits(limits(surface, plan, options, scheme, creases, plan.limit), plan, report);
}

// The mesh becomes a control net of the surface through its vertices.
void interpolate(Surface& surface, const Plan& plan, const Scheme_choice& scheme,
                 bool has_file_normals, const std::optional<Crease_maps>& creases, Report& report)
{
  using Source = Normals_option::Source;
  Interpolation interpolation;
  interpolation.mode = *plan.interpolation;
  interpolation.threads = plan.threads;
  const Source source = plan.normals.source;
  interpolation.improves_normals =
    interpolation.mode == Interpolation_mode::slide &&
    (source == Source::estimate || (source == Source::automatic && !has_file_normals));
  const Interpolation_report result = interpolate_surface(surface, scheme, interpolation, creases);
  report.note(description(result));
  const std::string text = warning(result, interpolation.mode);
  if (!text.empty()) report.warn(plan.input.title("standard input") + ": " + text);
}

void split_for_output(Surface& surface, const Mesh_file& output, Attributes& attributes,
                      Report& report)
{
  const Old_elements old(surface);
  const Triangulation triangulation = triangulate(surface);
  const std::size_t split = triangulation.split_faces;
  if (split > 0) old.follow(surface, triangulation, attributes);
  if (split > 0)
    report.note(output.title("standard output") + ": " + std::to_string(split) +
                (split == 1 ? " face" : " faces") + " split into triangles, as " + output.format +
                " files need them");
}

// Said before the work begins, so that nobody waits for a result that takes a day.
void announce_long_work(Surface& surface, const Surface_options& options,
                        const Scheme_choice& scheme, const Report& report)
{
  constexpr double long_time = 10;
  if (report.is_quiet() || options.levels == 0) return;
  const double seconds = expected_seconds(surface, scheme, options.levels);
  if (seconds < long_time) return;
  char text[60];
  std::snprintf(text, sizeof text, " takes about %.0f s on one thread", seconds);
  report.progress(scheme.scheme + text);
}

// Whether the user may be told of edges to be tagged: they could be sharp, and nobody has said which are.
bool may_suggest_tags(const Plan& plan, const Surface_options& options, const Scheme_choice& scheme)
{
  return options.creases.sharp.value_or("auto") == "auto" && !plan.interpolation &&
         scheme_without_creases(scheme).empty();
}

bool has_shape_normals(const Plan& plan)
{
  using Source = Normals_option::Source;
  return plan.normals.source == Source::sphere || plan.normals.source == Source::cylinder;
}

bool takes_file_normals(const Plan& plan, bool has_file_normals)
{
  using Source = Normals_option::Source;
  return has_file_normals &&
         (plan.normals.source == Source::file || plan.normals.source == Source::automatic);
}

Linear_check::Choices choices(const Plan& plan, const Surface_options& options,
                              const Scheme_choice& scheme, const Creases& creases,
                              bool has_file_normals, const Recognized_part* recognized)
{
  const bool is_smooth = !creases.any() && creases.border == Border::surface;
  return {plan.creases.source == Crease_plan::Source::automatic &&
            may_suggest_tags(plan, options, scheme),
          has_shape_normals(plan) || takes_file_normals(plan, has_file_normals),
          is_smooth && !plan.interpolation && !plan.chord && can_interpolate(scheme),
          plan.roundness.constant(), recognized};
}

// What --sharp auto makes of a mesh.
struct Seen_part
{
  std::optional<Recognized_part> part; // if the mesh looks like one
  bool is_taken = false;
  Turning_edges turning; // if they are to be told of
};

bool tells_of_turning_edges(const Plan& plan, const Surface_options& options,
                            const Scheme_choice& scheme)
{
  return !options.report.quiet && options.levels > 0 &&
         plan.normals.source != Normals_option::Source::none && !has_shape_normals(plan) &&
         may_suggest_tags(plan, options, scheme);
}

// To be called when it is settled which creases and normals of the file count.
Seen_part look_for_part(const Mesh_data& mesh, const Plan& plan, const Surface_options& options,
                        const Scheme_choice& scheme, const Creases& creases)
{
  constexpr std::size_t few_faces = 5000; // whose surfaces --check may take the time to find
  Seen_part seen;
  if (tells_of_turning_edges(plan, options, scheme))
    seen.turning = find_turning_edges(mesh, creases);
  if (is_in_pieces(options, plan.output)) return seen;
  const bool is_open = may_be_part(options, scheme) && !mesh.has_normals() && !creases.any();
  const bool is_wanted = is_open || seen.turning.number > 0 || options.check;
  if (!is_wanted) return seen;
  const bool looks = looks_like_part(mesh);
  if (!looks && !(options.check && mesh.number_of_faces() <= few_faces)) return seen;
  Recognition_plan recognition = plan.creases.recognition;
  recognition.tries_tolerances = false;
  seen.part = recognize_part(mesh, recognition);
  seen.is_taken = is_open && looks && seen.part->is_sure();
  return seen;
}

void take_part(Mesh_data& mesh, const Recognized_part& part, Plan& plan, bool has_border_option,
               Creases& creases, Report& report)
{
  plan.creases.source = Crease_plan::Source::surfaces;
  move_cut_vertices(mesh, part);
  put_surface_creases(creases, mesh, part);
  if (!has_border_option) put_part_borders(creases, mesh, part);
  add_hidden_segments(mesh, part);
  report.remark(plan.input.title("standard input") + ": " + taken_for_part(part));
}

// For the closing line: ", 12 edges turn ...", if somebody could want them sharp.
std::string turning_edges(const Mesh_data& mesh, const Seen_part& seen)
{
  if (!mesh.has_normals()) return {};
  const Turning_edges& turning = seen.turning;
  switch (edge_advice(seen.part ? &*seen.part : nullptr, turning.number, turning.of)) {
  case Edge_advice::part:
    return ", " + turning_edges_text(turning.number) + ": --part";
  case Edge_advice::angle:
    return ", " + turning_edges_text(turning.number) + ": --sharp angle:40";
  case Edge_advice::none:
    break;
  }
  return {};
}

void remark_on_texture(const Plan& plan, const Surface_options& options, Report& report)
{
  if (!options.texture_rule)
    report.remark(plan.input.title("standard input") +
                  ": with --chord texture coordinates are linear inside the control faces, as "
                  "--texture-rule all has them");
}

// Triangles within --chord; `rounds` gets the rounds that were done.
void tessellate(Surface& surface, const Plan& plan, Surface_options& options,
                const Scheme_choice& scheme, Refinement& rounds, double chord, Report& report)
{
  if (!rounds.attributes->corners.empty()) remark_on_texture(plan, options, report);
  const Tessellation result =
    tessellate_surface(surface, scheme, rounds.creases, chord, options.chord_bound == "proven",
                       plan.threads, *rounds.attributes);
  options.levels = result.depth;
  rounds.creases.reset(); // of the control mesh
  report_tessellation(result, chord, plan.output.title("standard output"), report);
}

// Limits are known of edges that are smooth or sharp forever.
void require_limit_of_creases(const Creases& creases, const Plan& plan, unsigned levels)
{
  const Limit_choice& limit = plan.limit;
  if (!limit.is_used() || creases.number_of_edges == 0) return;
  double sharpness = 0; // the largest that is not for ever
  for (const double s : creases.edges)
    if (!std::isinf(s)) sharpness = (std::max)(sharpness, s);
  if (sharpness <= levels) return;
  throw Usage_error(std::string(limit.points ? "--limit" : limit.normals_option) +
                    ": limits are known only of edges that are smooth or sharp forever; with this "
                    "--sharpness take --levels " +
                    std::to_string(static_cast<unsigned long>(std::ceil(sharpness))) + " or more");
}

// Control points slide on smooth surfaces only, and limits are known of edges that are smooth or sharp forever.
void require_interpolation_of_creases(const Creases& creases, const Plan& plan)
{
  if (!plan.interpolation) return;
  const bool slides = *plan.interpolation == Interpolation_mode::slide;
  if (creases.any() && slides)
    throw Error("--interpolate slide: control points slide on surfaces without sharp edges only; "
                "take --interpolate points, or --sharp none");
  if (creases.border != Border::surface && slides)
    throw Usage_error("--interpolate slide is known with --border surface only: take --interpolate "
                      "points");
  const auto is_finite = [](double s) { return s > 0 && !std::isinf(s); };
  if (std::any_of(creases.edges.begin(), creases.edges.end(), is_finite) ||
      std::any_of(creases.vertices.begin(), creases.vertices.end(), is_finite))
    throw Error("--interpolate points: limits are known only of edges that are smooth or sharp for "
                "ever; leave out --sharpness, or take --sharp none");
}

// Of creases that nobody has asked for no more than a note is made.
void warn_of_lost_normals(bool has_corner_normals, bool are_asked_for, const Plan& plan,
                          Report& report)
{
  if (!has_corner_normals || !holds_normals(plan.output) || holds_corner_normals(plan.output))
    return;
  const std::string text = plan.output.title("standard output") +
                           ": vertices on creases have several normals, " + plan.output.format +
                           " files hold one, which is their normalized sum; .obj holds all";
  if (are_asked_for)
    report.warn(text);
  else
    report.note(text);
}

void warn_of_lost_attributes(const std::vector<std::string>& names, const Plan& plan,
                             Report& report)
{
  if (!names.empty())
    report.warn_of_dropped(plan.output.title("standard output") + ": not written, " +
                             plan.output.format + " files cannot hold it: " + enumeration(names),
                           names);
}

// As .vtp has texture coordinates always, and .ply if it is asked for.
void split_seams(Mesh_data& mesh, const Plan& plan, const Surface_options& options, Report& report)
{
  if (plan.output.format != "vtp" && !options.split_seams) return;
  const std::size_t without = split_at_seams(mesh);
  if (options.split_seams && plan.output.format == "ply") move_texture_to_vertices(mesh);
  if (without > 0)
    report.warn(plan.output.title("standard output") + ": " + plural(without, "corner", "corners") +
                " without texture coordinates have 0 0, since those of vertices are written");
}

std::string rounds_of(const Plan& plan, const Surface_options& options, const Scheme_choice& scheme,
                      bool has_normals)
{
  const bool is_linear = !has_normals || plan.normals.source == Normals_option::Source::none;
  return (plan.chord ? "up to " : "") + std::to_string(options.levels) +
         (options.levels == 1 ? " round of " : " rounds of ") + (is_linear ? "linear " : "") +
         scheme.scheme;
}

std::string time_of(const Report& report)
{
  char time[40];
  std::snprintf(time, sizeof time, ", %.2f s", report.seconds());
  return time;
}

std::string closing_line(const Mesh_data& mesh, const Plan& plan, const Surface_options& options,
                         const Scheme_choice& scheme, const std::string& normals, bool has_normals,
                         const Creases& creases, const std::string& turning, const Report& report)
{
  std::string s = plan.output.title("standard output") + ": " + size_of(mesh) + ", " +
                  rounds_of(plan, options, scheme, has_normals) + ", " + normals +
                  creases.description();
  if (has_normals && !holds_normals(plan.output))
    s += " (not written, " + plan.output.format + " files hold none)";
  else if (has_normals && plan.output.format == "off" && !plan.output_normals.any() &&
           !options.output_normals)
    s += " (not written; --output-normals writes some)";
  return s + turning + time_of(report);
}

std::optional<Recognized_part> recognized_part(Mesh_data& mesh, const Plan& plan, Report& report)
{
  if (plan.creases.source != Crease_plan::Source::surfaces) return std::nullopt;
  Recognized_part part = recognize_part(mesh, plan.creases.recognition);
  const std::string input = plan.input.title("standard input");
  move_cut_vertices(mesh, part);
  if (const std::size_t n = part.moved.size(); n > 0)
    report.remark(input + ": " + std::to_string(n) + (n == 1 ? " vertex" : " vertices") +
                  " that a cut left on chords moved onto the surfaces");
  const Inside_out inside_out = find_inside_out(mesh);
  if (inside_out.number > 0) report.warn(input + ": " + inside_out.description());
  add_segments(mesh, part, input, report);
  if (mesh.has_normals() && plan.normals.source == Normals_option::Source::automatic) {
    report.remark(input + ": the normals in the file give way to those of the recognized surfaces "
                          "(--normals file takes them)");
    mesh.normals.clear();
    mesh.corner_normals.clear();
    mesh.vertices_with_several_normals = 0;
  }
  return part;
}

// A table of the recognized surfaces if it was asked for.
void report_surfaces(const Surface_table& table, bool are_asked_for, const std::string& input,
                     Report& report)
{
  if (are_asked_for) report.note(table.text());
  report.set_surfaces(table.rows());
  table.warn(input, report);
}

void write_in_pieces(const Pieces_job& job, const Plan& plan, const Surface_options& options,
                     const Scheme_choice& scheme, const std::string& normals,
                     const Creases& creases, const std::string& turning, Report& report)
{
  const unsigned number = ranks().number();
  const std::string pieces =
    std::to_string(job.pieces->number()) + (job.pieces->number() == 1 ? " piece" : " pieces") +
    (number == 1 ? "" : ", shared by " + std::to_string(number) + " ranks");
  const Any_pieces::Size& size = job.pieces->size();
  if (size.faces >= faces_worth_a_report)
    report.progress("refining and writing " + plan.output.name + ": " + std::to_string(size.faces) +
                    " faces, " + pieces);
  warn_of_lost_normals(job.has_lost_normals, true, plan, report);
  warn_of_lost_attributes(job.lost_attributes, plan, report);
  const Limit_summary limits = write_pieces(job, plan.output.name, plan.threads, report);
  if (plan.limit.is_used()) report_limits(limits, plan, report);
  report.note(plan.output.name + ": " + std::to_string(size.vertices) + " vertices, " +
              std::to_string(size.faces) + " faces, " +
              rounds_of(plan, options, scheme, job.has_normals) + ", " + normals +
              creases.description() + ", " + pieces + turning + time_of(report));
  report.print_warnings();
  report.write_file({options.input, options.output, size.vertices, size.faces, options.levels});
  report.print_notes();
  ranks().wait_for_all(); // none ends the others before they have said all
  report.require_no_warnings();
}

// The steps of the command, and what they hand on.
class Surface_run
{
public:
  explicit Surface_run(const Surface_options& given)
    : options_(with_part(given))
    , report_(options_.report, ranks().rank() != 0)
    , plan_(make_plan(options_))
    , input_(plan_.input.title("standard input"))
    , output_(plan_.output.title("standard output"))
    , in_pieces_(is_in_pieces(options_, plan_.output))
  {}

  void operator()()
  {
    naming_input([this] {
      read();
      find_creases_and_part();
      require_limits_of_creases();
      set_control_normals();
      if (in_pieces_)
        pieces_ =
          make_pieces_job(std::move(mesh_), creases_, options_, scheme_, plan_.input, plan_.output,
                          plan_.output_normals, plan_.limit, plan_.texture_rule, report_);
      else
        refine_and_measure();
    });
    if (in_pieces_)
      return write_in_pieces(pieces_, plan_, options_, scheme_, normals_, creases_, turning_,
                             report_);
    print_measures();
    suit_output();
    write();
    say_what_was_done();
  }

private:
  template <class Function>
  void naming_input(const Function& f)
  {
    try {
      f();
    } catch (const Usage_error&) {
      throw;
    } catch (const Output_error&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw Error(input_ + ": not enough memory for " + std::to_string(options_.levels) +
                  " rounds");
    } catch (const std::exception& e) {
      const std::string what = message_of(e);
      throw Error(what.rfind(input_ + ": ", 0) == 0 ? what : input_ + ": " + what);
    }
  }

  void read()
  {
    mesh_ = read_control_mesh(plan_.input, options_, report_);
    set_rules(mesh_.attributes, options_.nearest, options_.directions);
    scheme_ = chosen_scheme(mesh_, options_.scheme);
    if (options_.levels > 0 || plan_.limit.is_used() || plan_.interpolation || in_pieces_)
      require_faces_for_scheme(mesh_, scheme_);
    require_limit_of_vertices(scheme_.scheme, plan_.limit);
    if (plan_.interpolation) require_interpolation(scheme_);
  }

  void find_creases_and_part()
  {
    part_ = recognized_part(mesh_, plan_, report_);
    creases_ = find_creases(mesh_, plan_.creases, scheme_without_creases(scheme_),
                            part_ ? &*part_ : nullptr, input_, report_);
    if (options_.part && !options_.creases.border) put_part_borders(creases_, mesh_, *part_);
    const bool is_copy = plan_.output_normals.copies && mesh_.normal_kind != Normal_kind::control;
    if (is_copy) mesh_.are_said_to_be_control = true; // they stay what the file says that they are
    settle_file_normals(mesh_, plan_.normals, creases_, scheme_without_creases(scheme_).empty(),
                        input_, report_);
    if (!part_) seen_ = look_for_part(mesh_, plan_, options_, scheme_, creases_);
    if (!seen_.is_taken) return;
    part_ = std::exchange(seen_.part, std::nullopt);
    take_part(mesh_, *part_, plan_, options_.creases.border.has_value(), creases_, report_);
  }

  void require_limits_of_creases()
  {
    require_limit_of_creases(creases_, plan_, options_.levels);
    require_interpolation_of_creases(creases_, plan_);
  }

  void set_control_normals()
  {
    const bool keeps_curves =
      scheme_without_creases(scheme_).empty() && plan_.interpolation != Interpolation_mode::slide;
    if (keeps_curves) put_common_curves(creases_, mesh_);
    if (in_pieces_) require_mesh_for_pieces(mesh_, creases_, plan_.output_normals, plan_.output);
    has_file_normals_ = mesh_.has_normals();
    normals_ = takes_surface_normals(plan_, part_)
                 ? set_surface_normals(mesh_, plan_, *part_, creases_, report_)
                 : set_normals(mesh_, plan_, creases_, report_);
    if (keeps_curves) share_roundness(mesh_);
    has_normals_ = mesh_.has_normals();
    plan_.output_normals.suit(mesh_);
    if (!part_) turning_ = turning_edges(mesh_, seen_);
  }

  void refine_and_measure()
  {
    if (part_) table_.emplace(*part_, make_surface(mesh_));
    process();
    if (table_ && plan_.chord) table_->report_chord(chord_, output_, report_);
    if (table_) report_surfaces(*table_, !seen_.is_taken, input_, report_);
    if (check_) report_.set_check(check_->values());
    if (plan_.verification) plan_.verification->measure(mesh_.points);
  }

  // What the mesh becomes: refined, with curvatures, and with faces that the output can hold.
  void process()
  {
    const bool must_split = !holds_polygons(plan_.output);
    const bool is_creased = creases_.any() || creases_.border != Border::surface;
    const bool has_tags = is_creased && are_tags_written(options_, plan_.output_normals);
    const bool has_rims =
      part_ && (plan_.chord || takes_planes_from_rims(options_, plan_.output_normals));
    if (options_.levels == 0 && !plan_.limit.is_used() && !plan_.interpolation &&
        !plan_.curvature && !must_split && !has_tags && !has_rims) {
      mesh_.tags = Crease_tags();
      put_control_normals(mesh_, plan_.output_normals);
      return suit_roundness(mesh_);
    }
    if (plan_.chord) chord_ = plan_.chord->of(mesh_);
    Surface surface = make_surface(mesh_);
    Attributes attributes = std::move(mesh_.attributes);
    mesh_ = Mesh_data();
    if (table_) table_->number_faces(attributes);
    std::optional<Planes_of_part> planes;
    if (part_) planes.emplace(surface, *part_);
    Wedge_list wedges;
    Refinement rounds = refinement(options_, plan_.threads, report_);
    rounds.wedges = &wedges;
    prepare(surface, rounds, is_creased, has_tags);
    if (options_.levels > 0) attributes = refine(surface, rounds, std::move(attributes));
    std::optional<Curvature_values> curvature;
    if (plan_.curvature)
      curvature = curvature_of(surface, wedges, plan_, options_, scheme_, rounds.creases, report_);
    Kept_normals control = put_limits(surface, rounds, wedges);
    if (part_ && is_to_be_on_surfaces()) put_on_surfaces(surface, *segments_of(attributes), *part_);
    if (planes) settle_planes(*planes, surface, attributes, has_rims);
    Linear_check::Rounds compared{options_.levels, plan_.threads, plan_.limit, std::nullopt};
    if (plan_.chord) compared.chord = chord_;
    if (check_ && !has_rims) check_->compare(surface, scheme_, compared);
    Crease_tags tags;
    if (has_tags) tags = tags_of(surface, *rounds.creases);
    if (must_split) split_for_output(surface, plan_.output, attributes, report_);
    std::optional<Planes_from_rims> rims;
    if (has_rims) rims.emplace(surface, *segments_of(attributes), *part_);
    mesh_ = output_mesh(surface, rounds.creases, wedges, plan_.output_normals, std::move(control));
    suit_roundness(mesh_);
    mesh_.attributes = std::move(attributes);
    mesh_.tags = std::move(tags);
    if (curvature) add_curvature(mesh_, plan_, std::move(*curvature), report_);
    if (rims) put_rims(*rims, compared);
  }

  // before the first round
  void prepare(Surface& surface, Refinement& rounds, bool is_creased, bool has_tags)
  {
    if (!plan_.chord) announce_long_work(surface, options_, scheme_, report_);
    if (options_.check) {
      const Recognized_part* const recognized = part_        ? &*part_
                                                : seen_.part ? &*seen_.part
                                                             : nullptr;
      check_.emplace(surface, creases_,
                     choices(plan_, options_, scheme_, creases_, has_file_normals_, recognized));
    }
    if (is_creased)
      rounds.creases =
        add_creases(surface, creases_,
                    plan_.limit.is_used() || has_tags || plan_.interpolation.has_value() ||
                      plan_.curvature.has_value());
    if (plan_.interpolation)
      interpolate(surface, plan_, scheme_, has_file_normals_, rounds.creases, report_);
    if (check_) check_->set_net(surface, rounds.creases);
  }

  Attributes refine(Surface& surface, Refinement& rounds, Attributes attributes)
  {
    Carried_attributes carried(surface, std::move(attributes), plan_.texture_rule);
    carried.suit(surface, scheme_.scheme, input_, report_);
    rounds.attributes = &carried.table();
    if (plan_.chord)
      tessellate(surface, plan_, options_, scheme_, rounds, chord_, report_);
    else
      refine_surface(surface, scheme_, rounds);
    return carried.take(surface);
  }

  // Returns the control normals that are written beside others.
  Kept_normals put_limits(Surface& surface, const Refinement& rounds, Wedge_list& wedges)
  {
    Kept_normals control;
    if (!plan_.limit.is_used()) return control;
    if (!wedges.empty()) put_corner_normals(surface, std::exchange(wedges, {}));
    if (plan_.output_normals.with_control())
      control = control_normals_at_limits(surface, plan_, options_, scheme_, rounds.creases);
    move_to_limits(surface, plan_, options_, scheme_, rounds.creases, report_);
    return control;
  }

  // Subdivision need not stay on cones, nor beside faces of unknown surfaces. With other normals, control data or limit
  // points nobody has said that vertices are on surfaces.
  bool is_to_be_on_surfaces() const
  {
    return options_.levels > 0 && !plan_.limit.points && !options_.roundness &&
           plan_.normals.source == Normals_option::Source::automatic &&
           !are_tags_written(options_, plan_.output_normals);
  }

  void settle_planes(const Planes_of_part& planes, Surface& surface, Attributes& attributes,
                     bool has_rims)
  {
    if (!has_rims && (options_.levels > 0 || plan_.limit.points))
      planes.place_inside(surface, *segments_of(attributes), scheme_, options_.levels,
                          plan_.threads);
    table_->measure(surface, attributes);
    table_->set_crossed_planes(planes.number_of_crossed(surface, *segments_of(attributes)));
  }

  void put_rims(const Planes_from_rims& rims, const Linear_check::Rounds& compared)
  {
    table_->forget_folds([&](std::size_t segment) { return rims.replaces(segment); });
    rims.put_into(mesh_);
    if (check_) check_->compare(make_surface(mesh_), scheme_, compared);
    rims.report(output_, report_);
  }

  void print_measures()
  {
    std::FILE* const out = options_.output == "-" ? stderr : stdout;
    if (plan_.verification) plan_.verification->print(out);
    if (check_) check_->print(out);
  }

  // What the format does not hold is told and left out.
  void suit_output()
  {
    if (mesh_.number_of_faces() >= faces_worth_a_report)
      report_.progress("writing " + output_ + ": " + size_of(mesh_));
    if (part_) suit_segments(mesh_, plan_.output);
    warn_of_lost_normals(mesh_.has_corner_normals(), !seen_.is_taken, plan_, report_);
    split_seams(mesh_, plan_, options_, report_);
    warn_of_lost_attributes(not_held(plan_.output, mesh_, encoding()), plan_, report_);
    const std::string loss = lost_precision(plan_.output, mesh_, encoding());
    if (!loss.empty()) report_.warn(output_ + ": " + loss);
    take_types_of_format(plan_.output, mesh_.attributes);
    move_file_references(mesh_.attributes, plan_.input, plan_.output);
  }

  void write()
  {
    Side_file tags = tags_file(options_, mesh_.tags, report_),
              labels = labels_file(options_, part_ ? &*part_ : nullptr);
    suit_tags(mesh_, plan_.output, options_, plan_.output_normals, report_);
    write_mesh(plan_.output, mesh_, encoding());
    tags.commit();
    labels.commit();
  }

  void say_what_was_done()
  {
    report_.note(closing_line(mesh_, plan_, options_, scheme_, normals_, has_normals_, creases_,
                              turning_, report_));
    report_.print_warnings();
    report_.write_file({options_.input, options_.output, mesh_.points.size(),
                        mesh_.number_of_faces(), options_.levels});
    if (plan_.verification) plan_.verification->require_tolerance();
    report_.print_notes();
    report_.require_no_warnings();
  }

  Encoding encoding() const { return options_.ascii ? Encoding::text : Encoding::binary; }

  Surface_options options_;
  Report report_;
  Plan plan_;
  const std::string input_, output_; // for messages
  const bool in_pieces_;
  Mesh_data mesh_;
  Scheme_choice scheme_;
  Creases creases_;
  std::optional<Recognized_part> part_;
  Seen_part seen_;
  std::string normals_, turning_;                       // for the closing line
  bool has_file_normals_ = false, has_normals_ = false; // to refine with
  double chord_ = 0;                                    // the value of --chord as a length
  std::optional<Linear_check> check_;
  std::optional<Surface_table> table_;
  Pieces_job pieces_;
};

} // namespace

void run_surface_command(const Surface_options& options)
{
  Surface_run run(options);
  run();
}

} // namespace pn_subdivide
