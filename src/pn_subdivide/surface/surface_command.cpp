// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/surface_command.h"

#include "io/Error.h"
#include "io/mesh_io.h"
#include "io/soup_check.h"
#include "io/soup_repair.h"
#include "surface/control_normals.h"
#include "surface/vertex_curvature.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <new>
#include <thread>

namespace pn_subdivide {
namespace {

// Rounds with fewer faces are done before anybody could read about them.
constexpr std::size_t faces_worth_a_report = 100000;

void require_consistent(const Surface_options& options)
{
  require_readable_format(options.input);
  require_writable_format(options.output);
  require_surface_schemes(options.scheme);
  if (options.normals == "none" && options.scheme.normal_scheme)
    throw Usage_error("--normal-scheme and --normals none exclude each other: there are no normals "
                      "for it to average");
  if (!options.linear || (!options.normals && !options.scheme.normal_scheme)) return;
  throw Usage_error(std::string(options.normals ? "--normals" : "--normal-scheme") +
                    " and --linear exclude each other: in linear schemes normals take no part");
}

unsigned number_of_threads(const Surface_options& options)
{
  const unsigned threads =
    options.threads != 0 ? options.threads : (std::max)(1u, std::thread::hardware_concurrency());
  require_threads(threads);
  return threads;
}

Normals_option normals_option(const Surface_options& options)
{
  return parse_normals_option(options.linear ? "none" : options.normals.value_or("auto"));
}

void make_manifold(Mesh_data& mesh, const Surface_options& options)
{
  const Soup_defects defects = find_defects(mesh);
  if (defects.none()) return;
  if (!options.repair)
    throw Error(defects.description() + "; --repair orients the faces and duplicates such edges "
                                        "and vertices");

  const Soup_repair repair = repair_soup(mesh);
  std::fprintf(stderr, "%s: %s (%s)\n", options.input.c_str(), repair.description().c_str(),
               defects.description().c_str());
  const Soup_defects left = find_defects(mesh);
  if (!left.none()) throw Error("--repair did not mend everything: " + left.description());
}

Refinement refinement(const Surface_options& options, unsigned threads)
{
  using Clock = std::chrono::steady_clock;
  Refinement r;
  r.levels = options.levels;
  r.threads = threads;
  if (options.quiet) return r;
  r.round_done = [start = Clock::now(), levels = options.levels](unsigned k, std::size_t faces) {
    if (faces < faces_worth_a_report) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    std::fprintf(stderr, "round %u of %u: %zu faces, %.2f s\n", k, levels, faces, seconds);
  };
  return r;
}

void add_curvature(Mesh_data& mesh, Curvature_kind kind, const Surface_options& options,
                   unsigned threads)
{
  const Curvature_range range = set_curvature(mesh, kind, threads);
  if (!options.quiet) std::fprintf(stderr, "%s\n", range.description(kind).c_str());
}

} // namespace

void run_surface_command(const Surface_options& options)
{
  require_consistent(options);
  const Normals_option normals = normals_option(options);
  std::optional<Curvature_kind> curvature;
  if (options.curvature) curvature = parse_curvature_option(*options.curvature, options.output);
  const unsigned threads = number_of_threads(options);
  std::optional<Verification> verification;
  if (options.verify.shape) {
    verification.emplace(options.verify);
    verification->require_surface();
  }
  require_writable_place(options.output);

  Mesh_data mesh = read_mesh(options.input);
  try {
    require_sound_elements(mesh);
    make_manifold(mesh, options);
    set_control_normals(mesh, normals);
    if (options.levels > 0)
      mesh = refine_surface(mesh, options.scheme, refinement(options, threads));
    if (verification) verification->measure(mesh.points);
    if (curvature) add_curvature(mesh, *curvature, options, threads);
  } catch (const Usage_error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(options.input + ": not enough memory for " + std::to_string(options.levels) +
                " rounds");
  } catch (const std::exception& e) {
    throw Error(options.input + ": " + e.what());
  }
  if (verification) verification->print();
  write_mesh(options.output, mesh, options.ascii ? Encoding::text : Encoding::binary);
  if (verification) verification->require_tolerance();
}

} // namespace pn_subdivide
