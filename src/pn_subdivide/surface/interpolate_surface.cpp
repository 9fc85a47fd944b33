// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/refine_surface.h"

#include "io/Error.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#if __has_include(<Eigen/Core>)
#  include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#endif

namespace pn_subdivide {
namespace {

// Are there control points for which surfaces pass through given ones?
bool can_interpolate(const Scheme& scheme)
{
  return scheme.splits_edges() && !scheme.transfers_curvature();
}

} // namespace

bool can_interpolate(const Scheme_choice& choice)
{
  const Scheme scheme = scheme_of(choice);
  return !scheme.interpolates() && can_interpolate(scheme);
}

void require_interpolation(const Scheme_choice& choice)
{
  const Scheme scheme = scheme_of(choice);
  if (!scheme.interpolates() && !can_interpolate(scheme))
    throw Usage_error("--interpolate: surfaces of " + choice.scheme +
                      " cannot be made to pass through points; take catmull-clark, loop or their "
                      "modified forms");
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    throw Usage_error(
      "--interpolate and --normal-scheme exclude each other: interpolation is for one "
      "scheme of points and normals");
}

#if __has_include(<Eigen/Core>)
namespace {

using Tag = CGAL::Parallel_if_available_tag;

Interpolation_report interpolate_with_creases(Surface& surface, const Scheme& scheme,
                                              Interpolation_mode mode, const Crease_maps& creases)
{
  const auto np = PN::parameters::border(creases.border)
                    .interpolation_mode(mode)
                    .edge_is_constrained_map(creases.edges)
                    .vertex_is_constrained_map(creases.vertices);
  if (!normals_of(surface))
    return PN::interpolate_limit_points<Tag>(surface, PN::linear(scheme), np);
  return PN::interpolate_limit_points<Tag>(
    surface, scheme,
    PN::parameters::join(PN::parameters::crease_tangent_map(creases.tangents),
                         np.vertex_normal_map(corner_normals_or_added(surface))));
}

} // namespace

Interpolation_report interpolate_surface(Surface& surface, const Scheme_choice& choice,
                                         Interpolation_mode mode, bool improves_normals,
                                         const std::optional<Crease_maps>& creases)
{
  const Scheme scheme = scheme_of(choice);
  if (scheme.interpolates()) return {}; // the net is the data
  if (creases) return interpolate_with_creases(surface, scheme, mode, *creases);
  const auto how = PN::parameters::interpolation_mode(mode);
  const std::optional<Normal_map> normals = normals_of(surface);
  if (!normals) return PN::interpolate_limit_points<Tag>(surface, PN::linear(scheme), how);
  const bool has_roundness = roundness_of(surface).has_value();
  Roundness_map roundness = roundness_or_added(surface);
  using Normals = PN::Limit_interpolation::Normals;
  auto report = PN::interpolate_limit_points<Tag>(
    surface, scheme,
    how.interpolation_normals(improves_normals ? Normals::natural : Normals::given)
      .vertex_roundness_map(roundness)
      .vertex_normal_map(*normals));
  if (!has_roundness) surface.remove_property_map(roundness);
  return report;
}
#else // parse_interpolation() has refused
Interpolation_report interpolate_surface(Surface&, const Scheme_choice&, Interpolation_mode, bool,
                                         const std::optional<Crease_maps>&)
{
  return {};
}
#endif

} // namespace pn_subdivide
