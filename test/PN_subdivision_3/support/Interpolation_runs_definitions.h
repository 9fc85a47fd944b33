// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The definitions of Interpolation_runs.h, for the sources that instantiate them.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_RUNS_DEFINITIONS_H
#define CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_RUNS_DEFINITIONS_H

#include "Interpolation_runs.h"
#include "Options.h"

#include <CGAL/PN_fitting_3/internal/Limit_distance.h>
#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>

namespace interpolation_cases {

using CGAL::parameters::vertex_normal_map;

template <class Scheme>
Report Interpolation_runs<Scheme>::interpolate(Surface_mesh& mesh, const Scheme& scheme,
                                               const Options& options)
{
  return PN::interpolate_limit_points(
    mesh, scheme, PN::parameters::join(options.pack(), vertex_normal_map(normal_map(mesh))));
}

template <class Scheme>
double Distance_runs<Scheme>::from_limit(Surface_mesh& mesh, const Scheme& scheme,
                                         const reference::Vector& point, std::size_t vertex)
{
  double distance = 0;
  PN::internal::with_mesh_access(mesh, [&](auto& access) {
    const auto level = PN::internal::checked_level(access);
    const auto control = PN::internal::read_points_and_normals<double>(
      access, scheme, level, mesh.points(), normal_map(mesh));
    using From_limit = PN::internal::Limit_distance<Scheme>;
    const auto net = PN::internal::to_values<3>(control.points, control.normals, control);
    const typename From_limit::Foot foot({double(point[0]), double(point[1]), double(point[2])},
                                         unsigned(vertex), unsigned(vertex));
    distance = From_limit(scheme, PN::internal::For_chunks())(level, net, {foot}, 1e-12).distance;
  });
  return distance;
}

template <class Scheme>
Report Further_interpolation_runs<Scheme>::some(
  Surface_mesh& mesh, const Scheme& scheme,
  const test_options::Limit_interpolation_options<Chosen>& options)
{
  return PN::interpolate_limit_points(
    mesh, scheme, PN::parameters::join(options.pack(), vertex_normal_map(normal_map(mesh))));
}

template <class Scheme>
Report Further_interpolation_runs<Scheme>::in_parallel(Surface_mesh& mesh, const Scheme& scheme,
                                                       const Options& options)
{
  return PN::interpolate_limit_points<CGAL::Parallel_if_available_tag>(
    mesh, scheme, PN::parameters::join(options.pack(), vertex_normal_map(normal_map(mesh))));
}

template <class Scheme>
void Further_interpolation_runs<Scheme>::natural_normals(Surface_mesh& mesh, const Scheme& scheme)
{
  PN::interpolate_limit_points(
    mesh, scheme,
    PN::parameters::interpolation_normals(PN::Limit_interpolation::Normals::natural)
      .vertex_normal_map(normal_map(mesh)));
}

} // namespace interpolation_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_RUNS_DEFINITIONS_H
