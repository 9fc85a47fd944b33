// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Prescription_cases.h"

#include <CGAL/PN_fitting_3/internal/Mesh_limit_functionals.h>
#include <CGAL/PN_fitting_3/prescribe_limit_data.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

namespace interpolation_cases {

using CGAL::parameters::vertex_normal_map;

template <class Scheme>
Report Prescription_runs<Scheme>::solve(Prescription& p, const Scheme& scheme)
{
  return PN::prescribe_limit_data(
    p.mesh, scheme,
    PN::parameters::join(
      PN::parameters::prescribed_point_map(p.points).prescribed_normal_map(p.normals),
      p.options.pack(), vertex_normal_map(normal_map(p.mesh))));
}

template <class Scheme>
Report Curvature_runs<Scheme>::solve(Prescription& p, const Scheme& scheme)
{
  return PN::prescribe_limit_data(
    p.mesh, scheme,
    PN::parameters::join(PN::parameters::prescribed_point_map(p.points)
                           .prescribed_normal_map(p.normals)
                           .prescribed_curvature_map(p.curvatures),
                         p.options.pack(), vertex_normal_map(normal_map(p.mesh))));
}

template <class Scheme>
std::pair<Eigen::Matrix3d, Eigen::Vector3d>
Curvature_runs<Scheme>::form(Surface_mesh& mesh, const Scheme& scheme, unsigned vertex)
{
  std::pair<Eigen::Matrix3d, Eigen::Vector3d> result;
  PN::internal::with_mesh_access(mesh, [&](auto& access) {
    const auto level = PN::internal::checked_level(access);
    const auto data = PN::internal::read_points_and_normals<double>(
      access, scheme, level, mesh.points(), normal_map(mesh));
    PN::internal::Mesh_limit_functionals<Scheme> source(scheme, level, PN::internal::For_chunks());
    PN::internal::Limit_precision precision;
    precision.max_depth = 24;
    precision.second_forms = 1e-7;
    const auto f =
      source(PN::internal::to_values<3>(data.points, data.normals, data), {vertex}, precision);
    result = {f[0].second_form, f[0].surface_normal(data.points, f[0].control_normal)};
  });
  return result;
}

template struct Prescription_runs<PN::CatmullClark_scheme>;
template struct Prescription_runs<PN::Loop_scheme>;
template struct Prescription_runs<PN::CatmullClark_scheme::Tuned>;
template struct Prescription_runs<PN::Loop_scheme::Tuned>;
template struct Prescription_runs<PN::Linear_scheme<PN::CatmullClark_scheme>>;
template struct Curvature_runs<PN::CatmullClark_scheme>;
template struct Curvature_runs<PN::Loop_scheme>;
template struct Curvature_runs<PN::CatmullClark_scheme::Tuned>;
template struct Curvature_runs<PN::Loop_scheme::Tuned>;

} // namespace interpolation_cases
