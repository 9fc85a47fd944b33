// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/limit_surface.h"

#include "io/Error.h"
#include "surface/limit.h"

#include <cmath>
#include <cstdio>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace pn_subdivide {
namespace {

constexpr double degrees = 57.29577951308232; // a radian

Limit_report limits_of(Surface& surface, const Scheme_choice& choice, Limit_map limits,
                       const Limit_options& options)
{
  const Scheme scheme = make_scheme("--scheme", choice.scheme, choice);
  const std::optional<Normal_map> normals = normals_of(surface);
  if (!normals) return linear_limits(surface, scheme, limits, options);
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    return limits_with_normal_scheme(surface, *normals, scheme,
                                     make_scheme("--normal-scheme", *choice.normal_scheme, choice),
                                     limits, options);
  return limits_with_normals(surface, *normals, scheme, limits, options);
}

void write_limits(Surface& surface, Limit_map limits, const Limit_choice& choice)
{
  std::optional<Normal_map> normals = normals_of(surface);
  if (choice.normals && !normals) normals = add_normals(surface);
  for (const auto v : surface.vertices()) {
    if (choice.points) surface.point(v) = limits[v].point;
    if (normals)
      (*normals)[v] = choice.normals ? limits[v].surface_normal : limits[v].control_normal;
  }
}

} // namespace

void require_consistent(const Limit_choice& choice)
{
  if (!choice.tolerance) return;
  if (!choice.points) throw Usage_error("--limit-tolerance is for --limit, which is not given");
  if (!(*choice.tolerance > 0) || !std::isfinite(*choice.tolerance))
    throw Usage_error("--limit-tolerance must be greater than 0");
}

void require_limit_of_vertices(const std::string& scheme, const Limit_choice& choice)
{
  if (!choice.is_used()) return;
  const bool has_limits =
    std::visit([](const auto& s) { return std::decay_t<decltype(s)>::Host::keeps_vertices; },
               make_scheme("--scheme", scheme, {}));
  if (!has_limits)
    throw Usage_error(std::string(choice.points ? "--limit" : "--surface-normals") +
                      ": the limit points of " + scheme +
                      " belong to the faces, not to the vertices; take another scheme");
}

std::string Limit_summary::description(const Limit_choice& choice) const
{
  char text[200];
  const double of_box = box > 0 ? error / box : 0;
  std::snprintf(text, sizeof text, "limit points: estimated error %.2g (%.2g of the box), %u %s",
                error, of_box, depth, depth == 1 ? "round" : "rounds");
  std::string s = choice.points ? text : "";
  if (choice.normals) {
    std::snprintf(text, sizeof text, "surface normals: estimated error %.2g degrees",
                  normal_error * degrees);
    s += (s.empty() ? "" : "; ") + std::string(text);
    if (stand_ins > 0)
      s += ", control normals at " + std::to_string(stand_ins) +
           (stand_ins == 1 ? " vertex" : " vertices") + " where the scheme tells of none";
  }
  return s;
}

std::string Limit_summary::warning() const
{
  if (misses == 0) return {};
  char text[200];
  std::snprintf(
    text, sizeof text,
    "the tolerance of the limit is missed at %zu %s; estimated errors: points %.2g (%.2g "
    "of the box, tolerance %.2g), normals %.2g degrees",
    misses, misses == 1 ? "vertex" : "vertices", error, box > 0 ? error / box : 0,
    box > 0 ? tolerance / box : 0, normal_error * degrees);
  return text;
}

Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         unsigned levels, [[maybe_unused]] unsigned threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
  Limit_options options;
  if (choice.tolerance) options.tolerance = *choice.tolerance;
  options.surface_normals = choice.normals;
  options.rounds_done = levels;
  Limit_map limits = surface.add_property_map<Surface::Vertex_index, Limit_point>("v:limit").first;
  const Limit_report report = limits_of(surface, scheme, limits, options);
  write_limits(surface, limits, choice);
  surface.remove_property_map(limits);
  Limit_summary summary;
  summary.error = report.error;
  summary.tolerance = report.tolerance;
  summary.box = report.tolerance / options.tolerance;
  summary.normal_error = report.normal_error;
  summary.misses = report.number_of_misses;
  summary.stand_ins = report.number_of_stand_ins;
  summary.depth = report.depth;
  return summary;
}

} // namespace pn_subdivide
