// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/surface_command.h"

#include "io/Error.h"
#include "io/Held_attributes.h"
#include "io/Report.h"
#include "io/formats.h"
#include "io/mesh_io.h"
#include "io/normals_of_file.h"
#include "io/orient_outwards.h"
#include "pieces/Ranks.h"
#include "pieces/pieces_command.h"
#include "surface/Linear_check.h"
#include "surface/Output_normals.h"
#include "surface/Planes_from_rims.h"
#include "surface/Planes_of_part.h"
#include "surface/Recognized_part.h"
#include "surface/Surface_table.h"
#include "surface/attributes.h"
#include "surface/common_curves.h"
#include "surface/control_mesh.h"
#include "surface/control_normals.h"
#include "surface/interpolate_surface.h"
#include "surface/output_mesh.h"
#include "surface/output_tags.h"
#include "surface/part_borders.h"
#include "surface/part_choice.h"
#include "surface/refine_surface.h"
#include "surface/roundness.h"
#include "surface/tessellate_surface.h"
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

void require_consistent_check(const Surface_options& options)
{
  if (!options.check) return;
  if (options.linear)
    throw Usage_error("--check and --linear exclude each other: --check compares with the linear "
                      "result");
  if (options.levels == 0)
    throw Usage_error("--check and --levels 0 exclude each other: nothing is refined that could be "
                      "compared");
}

void require_consistent(const Surface_options& options)
{
  require_surface_schemes(options.scheme);
  require_consistent(options.limit);
  if (options.interpolate && !options.scheme.scheme.empty()) require_interpolation(options.scheme);
  if (options.format && options.input != "-" && options.output != "-")
    throw Usage_error(
      "--format is for standard input and output ('-'): the format of a file follows "
      "from its name");
  if (options.normals == "none" && options.scheme.normal_scheme)
    throw Usage_error("--normal-scheme and --normals none exclude each other: there are no normals "
                      "for it to average");
  if (options.roundness && (options.linear || options.normals == "none"))
    throw Usage_error(std::string("--roundness and ") +
                      (options.linear ? "--linear" : "--normals none") +
                      " exclude each other: without normals nothing is round");
  require_consistent_check(options);
  if (!options.linear || (!options.normals && !options.scheme.normal_scheme)) return;
  throw Usage_error(std::string(options.normals ? "--normals" : "--normal-scheme") +
                    " and --linear exclude each other: in linear schemes normals take no part");
}

void require_options_for_grids(const Surface_options& options, const Plan& plan)
{
  if (!is_grid_scheme(options.scheme.scheme)) return;
  const std::pair<bool, const char*> refused[] = {
    {options.limit.points, "--limit"},
    {plan.limit.normals, plan.limit.normals_option},
    {plan.interpolation.has_value(), "--interpolate"},
    {plan.chord.has_value(), "--chord"},
    {options.check, "--check"},
    {is_in_pieces(options, plan.output), "--pieces, --memory"}};
  for (const auto& [is_given, option] : refused)
    if (is_given)
      throw Usage_error(std::string(option) + ": " + options.scheme.scheme +
                        " has no rules for it; catmull-clark has");
}

Texture_rule texture_rule(const Surface_options& options)
{
  for (const auto& [option, is_given] : {std::pair("--nearest", options.nearest.has_value()),
                                         std::pair("--directions", options.directions.has_value())})
    if (is_given && options.drop_attributes)
      throw Usage_error(std::string(option) +
                        " and --drop-attributes exclude each other: no numbers of vertices are "
                        "read");
  if (!options.texture_rule) return options.chord ? Texture_rule::all : Texture_rule::corners_plus1;
  const Texture_rule rule = parse_texture_rule(*options.texture_rule);
  if (options.drop_attributes)
    throw Usage_error("--texture-rule and --drop-attributes exclude each other: no texture "
                      "coordinates are read");
  if (options.chord && rule != Texture_rule::all)
    throw Usage_error("--chord and --texture-rule " + *options.texture_rule +
                      " exclude each other: take all, which is linear inside the control faces");
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
  const bool is_control = options.output_normals == "control" || options.output_normals == "both";
  if (is_control || options.write_tags)
    throw Usage_error(
      "--split-seams and " +
      (is_control ? "--output-normals " + *options.output_normals : "--write-tags") +
      " exclude each other: with vertices that are doubled it is no mesh for further rounds");
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
  require_options_for_tessellation(options);
  plan.output_normals = Output_normals::make(options, plan.output);
  if (!plan.chord) plan.limit = limit_choice(options, plan.output_normals);
  require_options_for_grids(options, plan);
  if (!options.scheme.scheme.empty()) require_limit_of_vertices(options.scheme.scheme, plan.limit);
  if (options.merge_distance) parse_box_length(*options.merge_distance, "--merge-distance");
  if (is_in_pieces(options, plan.output)) require_options_for_pieces(options, plan.output);
  require_options_for_surfaces(options);
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
  require_report_place(options.report, {options.input, options.output, plan.creases.file});
  const std::string report = options.report.file.value_or("");
  require_tags_place(options, {options.input, options.output, plan.creases.file, report});
  require_labels_place(options,
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

// Those of the limit, beside those of the surface.
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

// Triangles within --chord; the rounds become those that were done.
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

// What the mesh becomes: refined, with curvatures, and with faces that the output can hold.
void process(Mesh_data& mesh, const Plan& plan, Surface_options& options,
             const Scheme_choice& scheme, const Creases& creases, bool has_file_normals,
             const std::optional<Recognized_part>& part, const Recognized_part* recognized,
             std::optional<Surface_table>& table, std::optional<Linear_check>& check,
             Report& report)
{
  const bool must_split = !holds_polygons(plan.output);
  const bool is_creased = creases.any() || creases.border != Border::surface;
  const bool has_tags = is_creased && are_tags_written(options, plan.output_normals);
  const double chord = plan.chord ? plan.chord->of(mesh) : 0;
  const bool has_rims =
    part && (plan.chord || takes_planes_from_rims(options, plan.output_normals));
  if (options.levels == 0 && !plan.limit.is_used() && !plan.interpolation && !plan.curvature &&
      !must_split && !has_tags && !has_rims) {
    mesh.tags = Crease_tags();
    put_control_normals(mesh, plan.output_normals);
    return suit_roundness(mesh);
  }
  Surface surface = make_surface(mesh);
  Attributes attributes = std::move(mesh.attributes);
  mesh = Mesh_data();
  if (table) table->number_faces(attributes);
  std::optional<Planes_of_part> planes;
  if (part) planes.emplace(surface, *part);
  if (!plan.chord) announce_long_work(surface, options, scheme, report);
  if (options.check)
    check.emplace(surface, creases,
                  choices(plan, options, scheme, creases, has_file_normals, recognized));
  Refinement rounds = refinement(options, plan.threads, report);
  Wedge_list wedges;
  rounds.wedges = &wedges;
  if (is_creased)
    rounds.creases = add_creases(surface, creases,
                                 plan.limit.is_used() || has_tags ||
                                   plan.interpolation.has_value() || plan.curvature.has_value());
  if (plan.interpolation)
    interpolate(surface, plan, scheme, has_file_normals, rounds.creases, report);
  if (check) check->set_net(surface, rounds.creases);
  if (options.levels > 0) {
    Carried_attributes carried(surface, std::move(attributes), plan.texture_rule);
    carried.suit(surface, scheme.scheme, plan.input.title("standard input"), report);
    rounds.attributes = &carried.table();
    if (plan.chord)
      tessellate(surface, plan, options, scheme, rounds, chord, report);
    else
      refine_surface(surface, scheme, rounds);
    attributes = carried.take(surface);
  }
  std::optional<Curvature_values> curvature;
  if (plan.curvature)
    curvature = curvature_of(surface, wedges, plan, options, scheme, rounds.creases, report);
  Kept_normals control;
  if (plan.limit.is_used()) {
    if (!wedges.empty()) put_corner_normals(surface, std::exchange(wedges, {}));
    if (plan.output_normals.with_control())
      control = control_normals_at_limits(surface, plan, options, scheme, rounds.creases);
    move_to_limits(surface, plan, options, scheme, rounds.creases, report);
  }
  if (planes && !has_rims && (options.levels > 0 || plan.limit.points))
    planes->place_inside(surface, *segments_of(attributes), scheme, options.levels, plan.threads);
  if (table) table->measure(surface, attributes);
  if (planes)
    table->set_crossed_planes(planes->number_of_crossed(surface, *segments_of(attributes)));
  Linear_check::Rounds compared{options.levels, plan.threads, plan.limit, std::nullopt};
  if (plan.chord) compared.chord = chord;
  if (check && !has_rims) check->compare(surface, scheme, compared);
  Crease_tags tags;
  if (has_tags) tags = tags_of(surface, *rounds.creases);
  if (must_split) split_for_output(surface, plan.output, attributes, report);
  std::optional<Planes_from_rims> rims;
  if (has_rims) rims.emplace(surface, *segments_of(attributes), *part);
  mesh = output_mesh(surface, rounds.creases, wedges, plan.output_normals, std::move(control));
  suit_roundness(mesh);
  mesh.attributes = std::move(attributes);
  mesh.tags = std::move(tags);
  if (curvature) add_curvature(mesh, plan, std::move(*curvature), report);
  if (rims) {
    table->forget_folds([&](std::size_t segment) { return rims->replaces(segment); });
    rims->put_into(mesh);
    if (check) check->compare(make_surface(mesh), scheme, compared);
    rims->report(plan.output.title("standard output"), report);
  }
}

// Limits are those of what is smooth or sharp forever.
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

// Control points slide on smooth surfaces only, and limits are those of what is smooth or sharp forever.
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

// A table of them if they were asked for.
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

} // namespace

void run_surface_command(const Surface_options& given_options)
{
  Surface_options options = with_part(given_options);
  Report report(options.report, ranks().rank() != 0);
  Plan plan = make_plan(options);
  const std::string input = plan.input.title("standard input");
  Mesh_data mesh;
  Scheme_choice scheme;
  std::string normals, turning;
  std::optional<Linear_check> check;
  std::optional<Recognized_part> part;
  Seen_part seen;
  std::optional<Surface_table> table;
  bool has_normals = false; // to refine with
  Creases creases;
  Pieces_job pieces;
  const bool in_pieces = is_in_pieces(options, plan.output);
  try {
    mesh = read_control_mesh(plan.input, options, report);
    set_rules(mesh.attributes, options.nearest, options.directions);
    scheme = chosen_scheme(mesh, options.scheme);
    if (options.levels > 0 || plan.limit.is_used() || plan.interpolation || in_pieces)
      require_faces_for_scheme(mesh, scheme);
    require_limit_of_vertices(scheme.scheme, plan.limit);
    if (plan.interpolation) require_interpolation(scheme);
    part = recognized_part(mesh, plan, report);
    creases = find_creases(mesh, plan.creases, scheme_without_creases(scheme),
                           part ? &*part : nullptr, input, report);
    if (options.part && !options.creases.border) put_part_borders(creases, mesh, *part);
    const bool can_be_sharp = scheme_without_creases(scheme).empty();
    const bool is_copy = plan.output_normals.copies && mesh.normal_kind != Normal_kind::control;
    if (is_copy) mesh.are_said_to_be_control = true; // they stay what the file says that they are
    settle_file_normals(mesh, plan.normals, creases, can_be_sharp, input, report);
    if (!part) seen = look_for_part(mesh, plan, options, scheme, creases);
    if (seen.is_taken) part = std::exchange(seen.part, std::nullopt);
    if (seen.is_taken)
      take_part(mesh, *part, plan, options.creases.border.has_value(), creases, report);
    require_limit_of_creases(creases, plan, options.levels);
    require_interpolation_of_creases(creases, plan);
    const bool keeps_curves = can_be_sharp && plan.interpolation != Interpolation_mode::slide;
    if (keeps_curves) put_common_curves(creases, mesh);
    if (in_pieces) require_mesh_for_pieces(mesh, creases, plan.output_normals, plan.output);
    const bool has_file_normals = mesh.has_normals();
    normals = takes_surface_normals(plan, part)
                ? set_surface_normals(mesh, plan, *part, creases, report)
                : set_normals(mesh, plan, creases, report);
    if (keeps_curves) share_roundness(mesh);
    has_normals = mesh.has_normals();
    plan.output_normals.suit(mesh);
    if (!part) turning = turning_edges(mesh, seen);
    if (in_pieces)
      pieces = make_pieces_job(std::move(mesh), creases, options, scheme, plan.input, plan.output,
                               plan.output_normals, plan.limit, plan.texture_rule, report);
    else {
      if (part) table.emplace(*part, make_surface(mesh));
      const Recognized_part* const recognized = part ? &*part : seen.part ? &*seen.part : nullptr;
      process(mesh, plan, options, scheme, creases, has_file_normals, part, recognized, table,
              check, report);
      if (table) report_surfaces(*table, !seen.is_taken, input, report);
      if (check) report.set_check(check->values());
      if (plan.verification) plan.verification->measure(mesh.points);
    }
  } catch (const Usage_error&) {
    throw;
  } catch (const Output_error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(input + ": not enough memory for " + std::to_string(options.levels) + " rounds");
  } catch (const std::exception& e) {
    const std::string what = message_of(e);
    throw Error(what.rfind(input + ": ", 0) == 0 ? what : input + ": " + what);
  }
  if (in_pieces)
    return write_in_pieces(pieces, plan, options, scheme, normals, creases, turning, report);
  if (plan.verification) plan.verification->print(options.output == "-" ? stderr : stdout);
  if (check) check->print(options.output == "-" ? stderr : stdout);
  if (mesh.number_of_faces() >= faces_worth_a_report)
    report.progress("writing " + plan.output.title("standard output") + ": " + size_of(mesh));
  if (part) suit_segments(mesh, plan.output);
  warn_of_lost_normals(mesh.has_corner_normals(), !seen.is_taken, plan, report);
  split_seams(mesh, plan, options, report);
  const Encoding encoding = options.ascii ? Encoding::text : Encoding::binary;
  warn_of_lost_attributes(not_held(plan.output, mesh, encoding), plan, report);
  const std::string loss = lost_precision(plan.output, mesh, encoding);
  if (!loss.empty()) report.warn(plan.output.title("standard output") + ": " + loss);
  take_types_of_format(plan.output, mesh.attributes);
  move_file_references(mesh.attributes, plan.input, plan.output);
  Tags_file tags(options, mesh.tags, report);
  Labels_file labels(options, part ? &*part : nullptr);
  suit_tags(mesh, plan.output, options, plan.output_normals, report);
  write_mesh(plan.output, mesh, encoding);
  tags.commit();
  labels.commit();
  report.note(
    closing_line(mesh, plan, options, scheme, normals, has_normals, creases, turning, report));
  report.print_warnings();
  report.write_file(
    {options.input, options.output, mesh.points.size(), mesh.number_of_faces(), options.levels});
  if (plan.verification) plan.verification->require_tolerance();
  report.print_notes();
  report.require_no_warnings();
}

} // namespace pn_subdivide
