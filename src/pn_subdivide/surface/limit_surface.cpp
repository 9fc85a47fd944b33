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
  return {report, report.tolerance / options.tolerance};
}

} // namespace pn_subdivide
