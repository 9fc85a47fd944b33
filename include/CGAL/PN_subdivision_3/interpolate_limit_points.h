// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERPOLATE_LIMIT_POINTS_H
#define CGAL_PN_SUBDIVISION_3_INTERPOLATE_LIMIT_POINTS_H

#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Control_normal_solution.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Interpolation_writer.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Mesh_limit_functionals.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Slide_interpolation.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Strict_interpolation.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/read_interpolation_data.h>
#include <CGAL/PN_subdivision_3/internal/meshes/concept_checks.h>
#include <CGAL/PN_subdivision_3/interpolation/Limit_interpolation_options.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class VertexMap>
void check_interpolation_options(const Limit_interpolation_options<VertexMap>& options)
{
  if (!(options.tolerance >= 0))
    throw std::invalid_argument("PN_subdivision_3: a tolerance must be a number that is not "
                                "negative");
}

template <class Access, class VertexMap>
bool is_interpolated([[maybe_unused]] const Access& access, [[maybe_unused]] const VertexMap& map,
                     [[maybe_unused]] Level_connectivity::Index v)
{
  if constexpr (std::is_same_v<VertexMap, All_vertices>)
    return true;
  else
    return static_cast<bool>(get(map, access.vertex(v)));
}

template <class Scheme>
Interpolation_result<3> interpolated_by_sliding(const Scheme& scheme,
                                                const Level_connectivity& level,
                                                const For_chunks& for_chunks,
                                                Interpolation_data<3>& data)
{
  estimate_missing_normals(level, normal_estimate(scheme), data);
  std::vector<Level_connectivity::Index> movable;
  for (const auto v : data.vertices)
    if (!data.normals[v].isZero(0)) movable.push_back(v);
  const std::size_t left_out = data.vertices.size() - movable.size();
  data.vertices = std::move(movable);
  using Source = Mesh_limit_functionals<Scheme, 2>;
  Source source(scheme, level, for_chunks);
  auto result = Slide_interpolation<3, Source>(data, source)();
  result.report.left_out = left_out;
  return result;
}

template <class Scheme>
Interpolation_result<3> interpolated_strictly(const Scheme& scheme, const Level_connectivity& level,
                                              const For_chunks& for_chunks,
                                              const Interpolation_data<3>& data,
                                              bool solves_normals)
{
  using Source = Mesh_limit_functionals<Scheme, 0>;
  Source source(scheme, level, for_chunks);
  if (!solves_normals || !data.takes_normals)
    return Strict_interpolation<3, Source>(data, source)(data.normals);
  Control_normal_solution<3, Source> solution(data, source);
  auto normals = solution(data.max_steps);
  auto result = Strict_interpolation<3, Source>(data, source)(std::move(normals));
  result.report.left_out = solution.left_out();
  result.report.steps += solution.steps();
  return result;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Interpolation
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class VertexMap = internal::All_vertices,
          class NamedParameters = parameters::Default_named_parameters>
Limit_interpolation_report interpolate_limit_points(
  PolygonMesh& mesh, const Scheme& scheme,
  const Limit_interpolation_options<VertexMap>& options = Limit_interpolation_options<VertexMap>(),
  const NamedParameters& np = parameters::default_values())
{
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  static_assert(internal::are_used_v<internal::Interpolation_parameters, NamedParameters>,
                "PN_subdivision_3: a named parameter is given that is not used here");
  static_assert(Scheme::Host::keeps_vertices &&
                  !std::is_same_v<typename Scheme::Host, Sqrt3_host>,
                "PN_subdivision_3: interpolation is not known for this scheme: take Catmull-Clark or "
                "Loop, or their modified forms");
  static_assert(internal::Is_linear<Scheme>::value ||
                  !std::is_same_v<typename Parameters::Normal_map, internal::No_normal_map>,
                "PN_subdivision_3: the control net has control normals: give a vertex_normal_map "
                "that takes them");
  internal::check_interpolation_options(options);
  const auto points = Parameters::point_map(mesh, np);
  const auto normals = Parameters::normal_map(np);
  const auto for_chunks = internal::For_chunks::with(Concurrency_tag());
  Limit_interpolation_report report;
  internal::with_mesh_access(mesh, [&](auto& access) {
    const Level_connectivity level = internal::checked_level(access);
    internal::check_scheme(scheme, level, access);
    internal::refuse_sharp_elements(scheme, access, level, Parameters::edge_constraint_map(np),
                                    Parameters::vertex_constraint_map(np));
    internal::Interpolation_data<3> data =
      internal::read_points_and_normals<FT>(access, scheme, level, points, normals);
    for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
      if (internal::is_interpolated(access, options.vertices, v)) data.vertices.push_back(v);
    internal::set_surroundings(level, data);
    data.takes_normals = internal::is_pn_v<Scheme>;
    data.tolerance = options.tolerance * internal::box_size(data.points);
    data.max_depth = options.max_depth;
    data.max_steps = options.max_steps;
    const internal::Vectors<3> old_normals = data.normals;
    const bool slides = options.mode == Limit_interpolation_mode::slide;
    const auto result =
      slides ? internal::interpolated_by_sliding(scheme, level, for_chunks, data)
             : internal::interpolated_strictly(scheme, level, for_chunks, data,
                                               options.normals ==
                                                 Limit_interpolation_normals::solved);
    report = result.report;
    report.normal_angle = internal::largest_normal_angle(level, data.normals);
    if constexpr (internal::is_pn_v<Scheme>)
      internal::write_control_net<FT>(access, points, normals, data.points, result.points,
                                      old_normals, result.normals);
    else
      internal::write_control_net<FT>(access, points, internal::No_normal_map(), data.points,
                                      result.points, old_normals, result.normals);
  });
  return report;
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERPOLATE_LIMIT_POINTS_H
