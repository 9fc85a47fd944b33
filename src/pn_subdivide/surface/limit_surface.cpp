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

#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace pn_subdivide {
namespace {

Limit_report limits_of(const Surface& surface, const std::optional<Normal_map>& normals,
                       const Scheme_choice& choice, const Limit_map& limits,
                       const Limit_options& options)
{
  const Scheme scheme = make_scheme("--scheme", choice.scheme, choice);
  if (!normals) return linear_limits(surface, scheme, limits, options);
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    return limits_with_normal_scheme(surface, *normals, scheme,
                                     make_scheme("--normal-scheme", *choice.normal_scheme, choice),
                                     limits, options);
  return limits_with_normals(surface, *normals, scheme, limits, options);
}

Limit_report move_to_limits_of(Surface& surface, const Scheme_choice& choice,
                               const Crease_maps& creases, const Limit_options& options)
{
  const Scheme scheme = make_scheme("--scheme", choice.scheme, choice);
  const bool is_linear = !normals_of(surface);
  if (is_linear && !options.surface_normals) {
    Corner_normal_map unused =
      surface.add_property_map<Surface::Halfedge_index, Vector_3>("h:unused").first;
    const Limit_report report = move_to_linear_limits(surface, unused, scheme, creases, options);
    surface.remove_property_map(unused);
    return report;
  }
  if (is_linear) add_normals(surface);
  std::optional<Corner_normal_map> normals = corner_normals_of(surface);
  if (!normals) normals = add_corner_normals(surface);
  if (is_linear) return move_to_linear_limits(surface, *normals, scheme, creases, options);
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    return move_to_limits_with_normal_scheme(
      surface, *normals, scheme, make_scheme("--normal-scheme", *choice.normal_scheme, choice),
      creases, options);
  return move_to_limits_with_normals(surface, *normals, scheme, creases, options);
}

// Writes over the points and the normals, whichever are asked for.
Limit_map write_limits(Surface& surface, std::optional<Normal_map> normals,
                       const Limit_choice& choice)
{
  return Limit_map([&surface, normals, &choice](Surface::Vertex_index v, const Limit_point& limit) {
    if (choice.points) surface.point(v) = limit.point;
    if (!normals) return;
    Normal_map written = *normals;
    written[v] = choice.normals ? limit.surface_normal : limit.control_normal;
  });
}

Limit_options make_options(const Limit_choice& choice, unsigned levels)
{
  Limit_options options;
  if (choice.tolerance) options.tolerance = *choice.tolerance;
  options.points = choice.points;
  options.surface_normals = choice.normals;
  options.rounds_done = levels;
  return options;
}

} // namespace

void require_limit_of_vertices(const std::string& scheme, const Limit_choice& choice)
{
  if (!choice.is_used()) return;
  const bool has_limits =
    std::visit([](const auto& s) { return std::decay_t<decltype(s)>::Host::keeps_vertices; },
               make_scheme("--scheme", scheme, {}));
  if (!has_limits)
    throw Usage_error(std::string(choice.points ? "--limit" : choice.normals_option) +
                      ": the limit points of " + scheme +
                      " belong to the faces, not to the vertices; take another scheme");
}

Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         unsigned levels, [[maybe_unused]] unsigned threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
  const Limit_options options = make_options(choice, levels);
  const std::optional<Normal_map> control = normals_of(surface);
  std::optional<Normal_map> written = control;
  if (choice.normals && !control) written = add_normals(surface);
  const Limit_report report =
    limits_of(surface, control, scheme, write_limits(surface, written, choice), options);
  return {report, report.tolerance / options.tolerance};
}

Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         const Crease_maps& creases, unsigned levels,
                         [[maybe_unused]] unsigned threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
  const Limit_options options = make_options(choice, levels);
  const Limit_report report = move_to_limits_of(surface, scheme, creases, options);
  return {report, report.tolerance / options.tolerance};
}

} // namespace pn_subdivide
