// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "options.h"

#include "io/Error.h"
#include "io/formats.h"
#include "io/mesh_io.h"
#include "io/mesh_normals.h"
#include "io/soup_repair.h"
#include "pieces/Ranks.h"
#include "pieces/pieces_command.h"
#include "surface/Linear_check.h"
#include "surface/Planes_of_part.h"
#include "surface/Recognized_part.h"
#include "surface/attributes.h"
#include "surface/control_mesh.h"
#include "surface/creases.h"
#include "surface/output_mesh.h"
#include "surface/refine_surface.h"
#include "surface/verification.h"
#include "surface/vertex_curvature.h"

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

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
  Texture_rule texture_rule = Texture_rule::corners_plus1;
  unsigned threads = 1;
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
  return parse_texture_rule(*options.texture_rule);
}

unsigned number_of_threads(const Surface_options& options)
{
  const unsigned threads =
    options.threads != 0 ? options.threads : (std::max)(1u, std::thread::hardware_concurrency());
#ifndef CGAL_LINKED_WITH_TBB
  if (threads > 1)
    throw Usage_error("--threads: this program was built without TBB and has one thread only");
#endif
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
  Plan plan;
  plan.input = input_mesh_file(options.input, options.format);
  plan.output = output_mesh_file(options.output, options.format);
  plan.chord = parse_chord(options);
  plan.interpolation = parse_interpolation(options.interpolate);
  plan.texture_rule = texture_rule(options);
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

// What --sharp auto makes of a mesh.
struct Seen_part
{
  std::optional<Recognized_part> part; // if the mesh looks like one
  bool is_taken = false;
  Turning_edges turning; // if they are to be told of
};

// So many threads of the library while it lives.
struct Threads
{
#ifdef CGAL_LINKED_WITH_TBB
  explicit Threads(unsigned number)
    : most(tbb::global_control::max_allowed_parallelism, number)
  {}
  tbb::global_control most;
#else
  explicit Threads(unsigned)
  {}
#endif
};

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
    limit_threads();
    naming_input([this] {
      read();
      find_creases_and_part();
      require_limit_of_creases();
      require_interpolation_of_creases();
      set_control_normals();
      if (in_pieces_)
        pieces_ =
          make_pieces_job(std::move(mesh_), creases_, options_, scheme_, plan_.input, plan_.output,
                          plan_.output_normals, plan_.limit, plan_.texture_rule, report_);
      else
        refine_and_measure();
    });
    if (in_pieces_) return write_in_pieces();
    print_measures();
    suit_output();
    write();
    say_what_was_done();
  }

private:
  using Source = Normals_option::Source;

  // Only where something is computed: TBB does not survive a failed allocation of its own.
  void limit_threads()
  {
    if (options_.levels > 0 || plan_.limit.is_used() || plan_.interpolation || plan_.chord ||
        plan_.curvature || in_pieces_)
      threads_.emplace(plan_.threads);
  }

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

  // --- the control mesh ---

  void read()
  {
    mesh_ = read_control_mesh(plan_.input, options_, report_);
    set_rules(mesh_.attributes, options_.nearest, options_.directions);
    scheme_ = chosen_scheme(mesh_, options_.scheme);
    has_crease_rules_ = scheme_without_creases(scheme_).empty();
    if (options_.levels > 0 || plan_.limit.is_used() || plan_.interpolation || in_pieces_)
      require_faces_for_scheme(mesh_, scheme_);
    require_limit_of_vertices(scheme_.scheme, plan_.limit);
    if (plan_.interpolation) require_interpolation(scheme_);
  }

  void find_creases_and_part()
  {
    if (plan_.creases.source == Crease_plan::Source::surfaces) recognize();
    creases_ = find_creases(mesh_, plan_.creases, scheme_without_creases(scheme_),
                            part_ ? &*part_ : nullptr, input_, report_);
    if (options_.part && !options_.creases.border) put_part_borders(creases_, mesh_, *part_);
    const bool is_copy = plan_.output_normals.copies && mesh_.normal_kind != Normal_kind::control;
    if (is_copy) mesh_.are_said_to_be_control = true; // they stay what the file says that they are
    settle_file_normals(mesh_, plan_.normals, creases_, has_crease_rules_, input_, report_);
    if (!part_) look_for_part();
    if (seen_.is_taken) take_part();
  }

  void recognize()
  {
    part_ = recognize_part(mesh_, plan_.creases.recognition);
    move_cut_vertices(mesh_, *part_);
    if (!part_->moved.empty())
      report_.remark(input_ + ": " + plural(part_->moved.size(), "vertex", "vertices") +
                     " that a cut left on chords moved onto the surfaces");
    const Inside_out inside_out = find_inside_out(mesh_);
    if (inside_out.number > 0) report_.warn(input_ + ": " + inside_out.description());
    add_segments(mesh_, *part_, input_, report_);
    if (!mesh_.has_normals() || plan_.normals.source != Source::automatic) return;
    report_.remark(input_ +
                   ": the normals in the file give way to those of the recognized surfaces "
                   "(--normals file takes them)");
    mesh_.drop_normals();
  }

  // Whether the user may be told of edges to be tagged: they could be sharp, and nobody has said which are.
  bool may_suggest_tags() const
  {
    return options_.creases.sharp.value_or("auto") == "auto" && may_suggest_creases();
  }
  bool may_suggest_creases() const { return !plan_.interpolation && has_crease_rules_; }
  bool has_shape_normals() const
  {
    return plan_.normals.source == Source::sphere || plan_.normals.source == Source::cylinder;
  }

  // To be called when it is settled which creases and normals of the file count.
  void look_for_part()
  {
    constexpr std::size_t few_faces = 5000; // whose surfaces --check may take the time to find
    if (!options_.report.quiet && options_.levels > 0 && plan_.normals.source != Source::none &&
        !has_shape_normals() && may_suggest_tags())
      seen_.turning = find_turning_edges(mesh_, creases_);
    if (in_pieces_) return;
    const bool is_open = may_be_part(options_, scheme_) && !mesh_.has_normals() && !creases_.any();
    if (!is_open && seen_.turning.number == 0 && !options_.check) return;
    const bool looks = looks_like_part(mesh_);
    if (!looks && !(options_.check && mesh_.number_of_faces() <= few_faces)) return;
    Recognition_plan recognition = plan_.creases.recognition;
    recognition.tries_tolerances = false;
    seen_.part = recognize_part(mesh_, recognition);
    seen_.is_taken = is_open && looks && seen_.part->is_sure();
  }

  void take_part()
  {
    part_ = std::exchange(seen_.part, std::nullopt);
    plan_.creases.source = Crease_plan::Source::surfaces;
    move_cut_vertices(mesh_, *part_);
    put_surface_creases(creases_, mesh_, *part_);
    if (!options_.creases.border) put_part_borders(creases_, mesh_, *part_);
    add_hidden_segments(mesh_, *part_);
    report_.remark(input_ + ": " + taken_for_part(*part_));
  }

  // Limits are known of edges that are smooth or sharp forever.
  void require_limit_of_creases() const
  {
    const Limit_choice& limit = plan_.limit;
    if (!limit.is_used() || creases_.number_of_edges == 0) return;
    double sharpness = 0; // the largest that is not for ever
    for (const double s : creases_.edges)
      if (!std::isinf(s)) sharpness = (std::max)(sharpness, s);
    if (sharpness <= options_.levels) return;
    throw Usage_error(std::string(limit.points ? "--limit" : limit.normals_option) +
                      ": limits are known only of edges that are smooth or sharp forever; with "
                      "this --sharpness take --levels " +
                      std::to_string(static_cast<unsigned long>(std::ceil(sharpness))) +
                      " or more");
  }

  // Control points slide on smooth surfaces only, and limits are known of edges that are smooth or sharp forever.
  void require_interpolation_of_creases() const
  {
    if (!plan_.interpolation) return;
    const bool slides = *plan_.interpolation == Interpolation_mode::slide;
    if (creases_.any() && slides)
      throw Error("--interpolate slide: control points slide on surfaces without sharp edges only; "
                  "take --interpolate points, or --sharp none");
    if (creases_.border != Border::surface && slides)
      throw Usage_error("--interpolate slide is known with --border surface only: take "
                        "--interpolate points");
    const auto is_finite = [](double s) { return s > 0 && !std::isinf(s); };
    if (std::any_of(creases_.edges.begin(), creases_.edges.end(), is_finite) ||
        std::any_of(creases_.vertices.begin(), creases_.vertices.end(), is_finite))
      throw Error("--interpolate points: limits are known only of edges that are smooth or sharp "
                  "for ever; leave out --sharpness, or take --sharp none");
  }

  // --- control normals ---

  void set_control_normals()
  {
    const bool keeps_curves = has_crease_rules_ && plan_.interpolation != Interpolation_mode::slide;
    if (keeps_curves) put_common_curves(creases_, mesh_);
    if (in_pieces_) require_mesh_for_pieces(mesh_, creases_, plan_.output_normals, plan_.output);
    has_file_normals_ = mesh_.has_normals();
    const Source source = plan_.normals.source;
    normals_ = part_ && (source == Source::automatic || source == Source::file)
                 ? set_surface_normals()
                 : set_normals();
    if (keeps_curves) share_roundness(mesh_);
    has_normals_ = mesh_.has_normals();
    plan_.output_normals.suit(mesh_);
    if (!part_) turning_ = turning_edges();
  }

  // How the mesh came to its normals, for the closing line: those of surfaces that have been recognized.
  std::string set_surface_normals()
  {
    const bool from_file = plan_.normals.source == Source::file;
    Normals_option given = plan_.normals;
    given.source = Source::file;
    if (from_file && !mesh_.has_normals())
      pn_subdivide::set_control_normals(mesh_, given); // throws
    Roundness_of_file roundness_of_file(mesh_);
    put_surface_normals(mesh_, *part_, from_file);
    pn_subdivide::set_control_normals(mesh_, given, creases_, input_, report_);
    if (!from_file) mesh_.roundness = part_->roundness;
    set_roundness(mesh_, plan_.roundness, std::move(roundness_of_file), from_file, creases_);
    if (from_file) warn_of_opposing_normals(find_opposing_normals(mesh_));
    if (from_file && !plan_.output_normals.copies) warn_of_other_normals();
    mesh_.normal_kind = Normal_kind::control;
    return std::string(from_file ? "normals of the file" : "normals of the surfaces") +
           roundness_description(mesh_.roundness);
  }

  std::string set_normals()
  {
    const Source source = plan_.normals.source;
    const bool from_file =
      source == Source::file || (source == Source::automatic && mesh_.has_normals());
    const Opposing_normals opposing = from_file ? find_opposing_normals(mesh_) : Opposing_normals();
    if (from_file && mesh_.vertices_with_several_normals > 0 && !creases_.any())
      report_.warn(input_ + ": " +
                   plural(mesh_.vertices_with_several_normals, "vertex has", "vertices have") +
                   " several normals; their normalized sum is taken");
    const bool has_other_normals = mesh_.normal_kind != Normal_kind::control;
    Roundness_of_file roundness_of_file(mesh_);
    const bool are_smoothed =
      pn_subdivide::set_control_normals(mesh_, plan_.normals, creases_, input_, report_);
    if (source != Source::none)
      set_roundness(mesh_, plan_.roundness, std::move(roundness_of_file),
                    from_file && !has_other_normals, creases_);
    const std::string round = roundness_description(mesh_.roundness);
    if (from_file) {
      if (are_all_zero(mesh_)) return "no normals, those of the file are zero";
      warn_of_opposing_normals(opposing);
      if (!plan_.output_normals.copies) {
        warn_of_other_normals();
        mesh_.normal_kind = Normal_kind::control;
      }
      return (are_smoothed ? "smoothed normals of the file" : "normals of the file") + round;
    }
    mesh_.normal_kind = Normal_kind::control;
    if (source == Source::none) return "no normals";
    return (has_shape_normals() ? "normals of the given shape" : "estimated normals") + round;
  }

  void warn_of_opposing_normals(const Opposing_normals& opposing)
  {
    if (opposing.number == 0) return;
    report_.warn(
      input_ + ": " + std::to_string(opposing.number) + " of " + std::to_string(opposing.of) +
      (opposing.number == 1 ? " normals points" : " normals point") +
      " against the faces (first: at vertex " + std::to_string(opposing.first_vertex) +
      (opposing.number == opposing.of
         ? "), as if these were inside out"
         : "), and the surface may tear there; --normals estimate takes none of the file") +
      turned_by_repair(opposing));
  }

  void warn_of_other_normals()
  {
    if (mesh_.normal_kind == Normal_kind::control) return;
    report_.warn(input_ + ": the " + comment_of(mesh_.normal_kind) +
                 " in the file are taken for control normals, which they are not; --output-normals "
                 "both writes a file with both, from which a further round takes the right ones");
  }

  // For the closing line: ", 12 edges turn ...", if somebody could want them sharp.
  std::string turning_edges() const
  {
    if (!mesh_.has_normals()) return {};
    const Turning_edges& turning = seen_.turning;
    switch (edge_advice(seen_.part ? &*seen_.part : nullptr, turning.number, turning.of)) {
    case Edge_advice::part:
      return ", " + turning_edges_text(turning.number) + ": --part";
    case Edge_advice::angle:
      return ", " + turning_edges_text(turning.number) + ": --sharp angle:40";
    case Edge_advice::none:
      break;
    }
    return {};
  }

  // --- what the mesh becomes ---

  void refine_and_measure()
  {
    if (part_) table_.emplace(*part_, make_surface(mesh_));
    process();
    if (table_ && plan_.chord) table_->report_chord(chord_, output_, report_);
    if (table_) {
      if (!seen_.is_taken) report_.note(table_->text());
      report_.set_surfaces(table_->rows());
      table_->warn(input_, report_);
    }
    if (check_) report_.set_check(check_->values());
    if (plan_.verification) plan_.verification->measure(mesh_.points);
  }

  // Refined, with curvatures, and with faces that the output can hold.
  void process()
  {
    const bool must_split = !held_by(plan_.output).polygons;
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
    Refinement rounds = refinement();
    rounds.wedges = &wedges;
    prepare(surface, rounds, is_creased, has_tags);
    if (options_.levels > 0) attributes = refine(surface, rounds, std::move(attributes));
    std::optional<Curvature_values> curvature;
    if (plan_.curvature) curvature = curvature_of(surface, wedges, rounds.creases);
    Kept_normals control = put_limits(surface, rounds, wedges);
    if (part_ && is_to_be_on_surfaces()) put_on_surfaces(surface, *segments_of(attributes), *part_);
    if (planes) settle_planes(*planes, surface, attributes, has_rims);
    Linear_check::Rounds compared{options_.levels, plan_.limit, std::nullopt};
    if (plan_.chord) compared.chord = chord_;
    if (check_ && !has_rims) check_->compare(surface, scheme_, compared);
    Crease_tags tags;
    if (has_tags) tags = tags_of(surface, *rounds.creases);
    if (must_split) split_for_output(surface, attributes);
    std::optional<Planes_from_rims> rims;
    if (has_rims) rims.emplace(surface, *segments_of(attributes), *part_);
    mesh_ = output_mesh(surface, rounds.creases, wedges, plan_.output_normals, std::move(control));
    suit_roundness(mesh_);
    mesh_.attributes = std::move(attributes);
    mesh_.tags = std::move(tags);
    if (curvature) add_curvature(std::move(*curvature));
    if (rims) put_rims(*rims, compared);
  }

  Refinement refinement() const
  {
    Refinement r;
    r.levels = options_.levels;
    if (report_.is_quiet()) return r;
    r.round_done = [this](unsigned k, std::size_t faces) {
      if (faces >= faces_worth_a_report)
        report_.progress("round " + std::to_string(k) + " of " + std::to_string(options_.levels) +
                         ": " + std::to_string(faces) + " faces");
    };
    return r;
  }

  // before the first round
  void prepare(Surface& surface, Refinement& rounds, bool is_creased, bool has_tags)
  {
    if (!plan_.chord) announce_long_work(surface);
    if (options_.check) check_.emplace(surface, creases_, choices());
    if (is_creased)
      rounds.creases =
        add_creases(surface, creases_,
                    plan_.limit.is_used() || has_tags || plan_.interpolation.has_value() ||
                      plan_.curvature.has_value());
    if (plan_.interpolation) interpolate(surface, rounds.creases);
    if (check_) check_->set_net(surface, rounds.creases);
  }

  // Said before the work begins, so that nobody waits for a result that takes a day.
  void announce_long_work(Surface& surface) const
  {
    constexpr double long_time = 10;
    if (report_.is_quiet() || options_.levels == 0) return;
    const double seconds = expected_seconds(surface, scheme_, options_.levels);
    if (seconds >= long_time)
      report_.progress(scheme_.scheme + formatted(" takes about %.0f s on one thread", seconds));
  }

  Linear_check::Choices choices() const
  {
    const bool is_smooth = !creases_.any() && creases_.border == Border::surface;
    const bool takes_file_normals =
      has_file_normals_ &&
      (plan_.normals.source == Source::file || plan_.normals.source == Source::automatic);
    const std::optional<Recognized_part>& recognized = part_ ? part_ : seen_.part;
    return {plan_.creases.source == Crease_plan::Source::automatic && may_suggest_tags(),
            plan_.creases.source != Crease_plan::Source::none &&
              !wants_surfaces(options_.creases) && may_suggest_creases(),
            has_shape_normals() || takes_file_normals,
            is_smooth && !plan_.interpolation && !plan_.chord && can_interpolate(scheme_),
            plan_.roundness.constant(),
            recognized ? &*recognized : nullptr};
  }

  // The mesh becomes a control net of the surface through its vertices.
  void interpolate(Surface& surface, const std::optional<Crease_maps>& creases)
  {
    const Interpolation_mode mode = *plan_.interpolation;
    const Source source = plan_.normals.source;
    const bool are_estimated =
      source == Source::estimate || (source == Source::automatic && !has_file_normals_);
    tell(interpolate_surface(surface, scheme_, mode,
                             mode == Interpolation_mode::slide && are_estimated, creases),
         mode, input_, report_);
  }

  Attributes refine(Surface& surface, Refinement& rounds, Attributes attributes)
  {
    Carried_attributes carried(surface, std::move(attributes), plan_.texture_rule);
    carried.suit(surface, scheme_.scheme, input_, report_);
    rounds.attributes = &carried.table();
    if (plan_.chord)
      tessellate(surface, rounds);
    else
      refine_surface(surface, scheme_, rounds);
    return carried.take(surface);
  }

  // Triangles within --chord; `rounds` gets the rounds that were done.
  void tessellate(Surface& surface, Refinement& rounds)
  {
    if (!rounds.attributes->corners.empty() && !options_.texture_rule)
      report_.remark(input_ + ": with --chord texture coordinates are linear inside the control "
                              "faces, as --texture-rule all has them");
    const bool is_proven = options_.chord_bound == "proven";
    const PN::Tessellation_result result =
      tessellate_surface(surface, scheme_, rounds.creases, chord_, is_proven, *rounds.attributes);
    options_.levels = result.depth;
    rounds.creases.reset(); // of the control mesh
    report_tessellation(result, chord_, is_proven, output_, report_);
  }

  // The control mesh is measured with its control normals, what has been refined with the normals of its limit.
  Curvature_values curvature_of(const Surface& surface, const Wedge_list& wedges,
                                const std::optional<Crease_maps>& creases) const
  {
    if (surface.number_of_faces() >= faces_worth_a_report)
      report_.progress("measuring the curvature at " +
                       std::to_string(surface.number_of_vertices()) + " vertices");
    if (options_.levels == 0 && !plan_.limit.is_used())
      return measure_curvature(surface, creases, *plan_.curvature);
    return measure_limit_curvature(surface, wedges, scheme_, creases, options_.levels,
                                   *plan_.curvature);
  }

  void add_curvature(Curvature_values values)
  {
    const Curvature_range range = set_curvature(mesh_, *plan_.curvature, std::move(values));
    report_.note(range.description(*plan_.curvature));
    if (range.replaces_attributes)
      report_.warn(output_ +
                   ": the file's colors or values of vertices give way to those of the curvature");
  }

  // Returns the control normals that are written beside others: those of the limit.
  Kept_normals put_limits(Surface& surface, const Refinement& rounds, Wedge_list& wedges)
  {
    Kept_normals control;
    if (!plan_.limit.is_used()) return control;
    if (!wedges.empty()) put_corner_normals(surface, std::exchange(wedges, {}));
    if (plan_.output_normals.with_control()) {
      Surface copy = surface;
      Limit_choice limit = plan_.limit;
      limit.normals = false;
      set_limits(copy, scheme_, limit, creases_of(copy, rounds.creases), options_.levels);
      control = kept_normals(copy);
    }
    set_limits(surface, scheme_, plan_.limit, rounds.creases, options_.levels)
      .tell(plan_.limit, output_, report_);
    return control;
  }

  // Subdivision need not stay on cones, nor beside faces of unknown surfaces. With other normals, control data or limit
  // points nobody has said that vertices are on surfaces.
  bool is_to_be_on_surfaces() const
  {
    return options_.levels > 0 && !plan_.limit.points && !options_.roundness &&
           plan_.normals.source == Source::automatic &&
           !are_tags_written(options_, plan_.output_normals);
  }

  void settle_planes(const Planes_of_part& planes, Surface& surface, Attributes& attributes,
                     bool has_rims)
  {
    if (!has_rims && (options_.levels > 0 || plan_.limit.points))
      planes.place_inside(surface, *segments_of(attributes), scheme_, options_.levels);
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

  void split_for_output(Surface& surface, Attributes& attributes)
  {
    const Old_elements old(surface);
    const Triangulation triangulation = triangulate(surface);
    if (triangulation.split_faces == 0) return;
    old.follow(surface, triangulation, attributes);
    report_.note(output_ + ": " + plural(triangulation.split_faces, "face", "faces") +
                 " split into triangles, as " + plan_.output.format + " files need them");
  }

  void print_measures() const
  {
    std::FILE* const out = options_.output == "-" ? stderr : stdout;
    if (plan_.verification) plan_.verification->print(out);
    if (check_) check_->print(out);
  }

  // --- what is written ---

  // What the format does not hold is told and left out.
  void suit_output()
  {
    if (mesh_.number_of_faces() >= faces_worth_a_report)
      report_.progress("writing " + output_ + ": " + size_of(mesh_));
    if (part_) suit_segments(mesh_, plan_.output);
    warn_of_lost_normals(mesh_.has_corner_normals(), !seen_.is_taken);
    split_seams();
    warn_of_lost_attributes(not_held(plan_.output, mesh_, encoding()));
    const std::string loss = lost_precision(plan_.output, mesh_, encoding());
    if (!loss.empty()) report_.warn(output_ + ": " + loss);
    take_types_of_format(plan_.output, mesh_.attributes);
    move_file_references(mesh_.attributes, plan_.input, plan_.output);
  }

  // Of creases that nobody has asked for no more than a note is made.
  void warn_of_lost_normals(bool has_corner_normals, bool are_asked_for)
  {
    if (!has_corner_normals || !held_by(plan_.output).normals ||
        held_by(plan_.output).corner_normals)
      return;
    const std::string text = output_ + ": vertices on creases have several normals, " +
                             plan_.output.format +
                             " files hold one, which is their normalized sum; .obj holds all";
    if (are_asked_for)
      report_.warn(text);
    else
      report_.note(text);
  }

  void warn_of_lost_attributes(const std::vector<std::string>& names)
  {
    if (!names.empty())
      report_.warn_of_dropped(output_ + ": not written, " + plan_.output.format +
                                " files cannot hold it: " + enumeration(names),
                              names);
  }

  // As .vtp has texture coordinates always, and .ply if it is asked for.
  void split_seams()
  {
    if (plan_.output.format != "vtp" && !options_.split_seams) return;
    const std::size_t without = split_at_seams(mesh_);
    if (options_.split_seams && plan_.output.format == "ply") move_texture_to_vertices(mesh_);
    if (without > 0)
      report_.warn(output_ + ": " + plural(without, "corner", "corners") +
                   " without texture coordinates have 0 0, since those of vertices are written");
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

  void write_in_pieces()
  {
    const unsigned number = ranks().number();
    const std::string pieces =
      plural(pieces_.pieces->number(), "piece", "pieces") +
      (number == 1 ? "" : ", shared by " + std::to_string(number) + " ranks");
    const Any_pieces::Size& size = pieces_.pieces->size();
    if (size.faces >= faces_worth_a_report)
      report_.progress("refining and writing " + output_ + ": " + std::to_string(size.faces) +
                       " faces, " + pieces);
    warn_of_lost_normals(pieces_.has_lost_normals, true);
    warn_of_lost_attributes(pieces_.lost_attributes);
    const Limit_summary reached = write_pieces(pieces_, output_, report_);
    if (plan_.limit.is_used()) reached.tell(plan_.limit, output_, report_);
    report_.note(output_ + ": " + std::to_string(size.vertices) + " vertices, " +
                 std::to_string(size.faces) + " faces, " + rounds_of(pieces_.has_normals) + ", " +
                 normals_ + creases_.description() + ", " + pieces + turning_ + time());
    report_.print_warnings();
    report_.write_file(
      {options_.input, options_.output, size.vertices, size.faces, options_.levels});
    report_.print_notes();
    ranks().wait_for_all(); // none ends the others before they have said all
    report_.require_no_warnings();
  }

  void say_what_was_done()
  {
    report_.note(closing_line());
    report_.print_warnings();
    report_.write_file({options_.input, options_.output, mesh_.points.size(),
                        mesh_.number_of_faces(), options_.levels});
    if (plan_.verification) plan_.verification->require_tolerance();
    report_.print_notes();
    report_.require_no_warnings();
  }

  std::string closing_line() const
  {
    std::string s = output_ + ": " + size_of(mesh_) + ", " + rounds_of(has_normals_) + ", " +
                    normals_ + creases_.description();
    if (has_normals_ && !held_by(plan_.output).normals)
      s += " (not written, " + plan_.output.format + " files hold none)";
    else if (has_normals_ && plan_.output.format == "off" && !plan_.output_normals.any() &&
             !options_.output_normals)
      s += " (not written; --output-normals writes some)";
    return s + turning_ + time();
  }
  std::string rounds_of(bool has_normals) const
  {
    const bool is_linear = !has_normals || plan_.normals.source == Source::none;
    return (plan_.chord ? "up to " : "") + plural(options_.levels, "round of ", "rounds of ") +
           (is_linear ? "linear " : "") + scheme_.scheme;
  }
  std::string time() const { return formatted(", %.2f s", report_.seconds()); }

  Encoding encoding() const { return options_.ascii ? Encoding::text : Encoding::binary; }

  Surface_options options_;
  Report report_;
  Plan plan_;
  std::optional<Threads> threads_;
  const std::string input_, output_; // for messages
  const bool in_pieces_;
  Mesh_data mesh_;
  Scheme_choice scheme_;
  bool has_crease_rules_ = false; // the scheme
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
