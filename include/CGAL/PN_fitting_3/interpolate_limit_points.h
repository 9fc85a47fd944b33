// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERPOLATE_LIMIT_POINTS_H
#define CGAL_PN_FITTING_3_INTERPOLATE_LIMIT_POINTS_H

#include <CGAL/PN_subdivision_3/internal/needs_eigen.h>

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/interpolate_mesh.h>
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// Reads a mesh on which nothing is sharp, interpolates, and writes the control points and normals.
template <class FT, class Access, class Scheme, class Mesh, class NamedParameters,
          class Is_interpolated>
Limit_interpolation
interpolate_without_creases(const Access& access, const Scheme& scheme,
                            const Level_connectivity& level, Mesh& mesh, const NamedParameters& np,
                            const Interpolation_options& options, const For_chunks& for_chunks,
                            const Is_interpolated& is_interpolated)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  using Normal_map = typename Parameters::Normal_map;
  constexpr bool has_normal_map = is_there_v<Normal_map>;
  constexpr bool finds_normals = is_pn_v<Scheme> && has_normal_map;
  // a way that the call does not name is not compiled
  constexpr bool may_be_strict =
    is_linked_to_fitting || is_given_v<interpolation_mode_t, NamedParameters>;
  const auto normal_map = Parameters::normal_map(np);
  const auto read = [&](const auto& normals) {
    return read_interpolation_data<FT>(access, scheme, level, mesh, np, normals);
  };
  const auto surface = fitted_surface(scheme, level, for_chunks);
  Undoable_vertices<Access, Normal_map> natural(access, normal_map);
  if (options.normals == Limit_interpolation::Normals::natural) {
    if constexpr (finds_normals) {
      Interpolation_data<3> estimated = read(Not_given());
      find_natural_normals(surface, estimated);
      for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
        natural.change_vector(v, coordinates_of<FT>(estimated.normals[v]));
    } else
      throw std::invalid_argument("PN_subdivision_3: natural normals need a "
                                  "vertex_normal_map, and a scheme that is not linear");
  }
  Interpolation_data<3> data = read(normal_map);
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
    if (is_interpolated(v)) data.vertices.push_back(v);
  set_demand(options, data);
  const Vectors<3> old_normals = data.normals;
  auto result = find_control_net < is_pn_v<Scheme> && !has_normal_map,
       may_be_strict > (surface, options, normal_estimate(scheme), data);
  multiply_by_size<FT>(data, result);
  write_control_net<FT, finds_normals>(access, Parameters::point_map(mesh, np), normal_map,
                                       data.points, old_normals, result);
  natural.commit();
  return result.report;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Interpolation

replaces the points of a mesh by control points of a surface that passes through them. For fixed control
normals the limit points of point-normal subdivision are linear in the control points.

<b>`Limit_interpolation::Mode::slide`.</b> The normals of the data become the control normals, and the
control point of a vertex moves along its normal, until the data point lies on the limit surface. This
is one unknown a vertex. The data point is not the limit point of the vertex then: the limit point has slipped along
the surface, by a tenth of an edge or so. Between the two the surface is taken to be the circular arc with their
normals. Samples of spheres and circular cylinders with exact normals are their own control net: nothing is solved. On
borders the limit control normal stands for the surface normal. Each component is solved on its own (D. G. Anderson,
<em>Iterative procedures for nonlinear integral equations</em>, 1965), no control point moves by more than the mean
edge at it, and the best control net is kept. The report has the distance of the points from the surface.

<b>`Limit_interpolation::Mode::strict`.</b> The limit point of each vertex is the data point, up to the tolerance.
Control normals are the given ones, or with `Limit_interpolation::Normals::solved` those whose limits are the given
ones; vertices where these cannot be found keep the given ones and are counted in `left_out`.

With `linear()` schemes the same code does classic linear interpolation; `slide` then moves points along
the given normals, or estimated ones. Schemes that interpolate return the net as it is.

<b>Normals.</b> The `vertex_normal_map` holds normals of the data, and control normals afterwards. For a zero vector
`slide` estimates a normal, and `strict` does as linear subdivision does.

<b>Only points.</b> With `Limit_interpolation::Normals::natural` the map of normals is written only: its normals become those that the surface has at the points
along which it slides. The estimate of `estimate_control_normals()` comes first, then the normals at the points of the
surface that slides along it, up to ten times, as long as the change falls by a fifth. If no solve is needed, for
spheres, and cylinders in grids, the estimate is kept. On borders the estimate stays. Modified schemes have curvature
everywhere, and are the better choice. On uneven samples of smooth surfaces the errors are a tenth to a fiftieth of
those of the estimate.

<b>Without a map of normals</b> the control normals, and the roundness if it is not given, are those that further calls without
a map estimate from the control points. In either mode the limit point of each vertex is the data point. An iteration
of at most `max_steps` evaluations, by Anderson's method too, finds the points. Smoother surfaces are those with a map
and `Limit_interpolation::Normals::natural`.

<b>Roundness.</b> It is 1 unless it is given or there is no map of normals, and stays as it is: pass it to the calls that
refine the result. `estimate_control_normals()` returns it.

<b>Creases</b> that are sharp forever are for `Limit_interpolation::Mode::strict` with given normals. The normals of
the wedges and the tangents of the creases are made from the data once, as `subdivide()` makes them, so that the limit
points stay linear in the control points. Corners are their own limit points. Normals and tangents have to reach the
calls that refine the result: a point-normal scheme takes them in a `vertex_normal_map` of half-edges, where vertices
have several wedges, and in a `crease_tangent_map`, which are written.

Everything is computed in `double`, whatever the number type of the mesh; what does not change is not
written. Weights of PN averages that fade, and vanishing normals, are treated as in `PN_average`.

<b>Strong guarantee.</b> If an exception leaves the function, the maps are as they were, except for maps of
the user's whose `put()` throws also while old values are put back.

\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or
  `Parallel_if_available_tag`: how limits are evaluated. The result is the same, bit for bit.
\tparam PolygonMesh a model of `FaceListGraph`
\tparam Scheme a built-in scheme that keeps its vertices, except \f$ \sqrt{3} \f$, or its `linear()` twin
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
  `vertex_normal_map`, `parameters::control_normal_estimate()` if there is none, `vertex_roundness_map`, which is only
  read, `roundness` and `geom_traits` as in `subdivide()`. Creases are given by `edge_is_constrained_map` and
  `vertex_is_constrained_map`, in which sharpness is infinite, `border` and `crease_tangent_map`. The method is set by
  `interpolation_mode`, `interpolation_normals`, `free_vertices`, `vertex_is_interpolated_map`, `tolerance`,
  `max_depth` and `max_steps` of `CGAL::PN_subdivision_3::parameters`

\returns what was reached. A tolerance that cannot be met is not an error: the best control net is the result.

\throws std::invalid_argument as `subdivide()` does, with nothing written, and if
  - the tolerance is negative or not a number;
  - an edge, a vertex or the border is sharp in mode `slide`, with natural normals or by a finite sharpness;
  - it is sharp without a map that takes its normals and tangents (the message names it);
  - `Limit_interpolation::Free::smooth` is asked for in mode `slide` or without a map of normals;
  - natural normals are asked for with a linear scheme or without a map
<br><b>Cost:</b> Linear in the size of the mesh a step, of which there are ten to fifty. It takes about 8 kB of memory
  per vertex

\sa `prescribe_limit_data()`, `interpolate_curve()`
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Limit_interpolation
interpolate_limit_points(PolygonMesh& mesh, const Scheme& scheme,
                         const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh,
                           internal::interpolation_mode_t, internal::interpolation_normals_t,
                           internal::free_vertices_t, internal::vertex_is_interpolated_map_t,
                           internal::tolerance_t, internal::max_depth_t, internal::max_steps_t>();
  if constexpr (internal::is_open_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call<Limit_interpolation,
                                         internal::Surface_call<PolygonMesh, NamedParameters>,
                                         internal::Hosts::of_interpolation>(
      scheme, np, [&](const auto& s, const auto& others) {
        return interpolate_limit_points<Concurrency_tag>(mesh, s, others);
      });
  else {
    internal::check_interpolation_arguments<Scheme>();
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    using FT = typename Parameters::FT;
    const internal::Interpolation_options options = internal::interpolation_options(np);
    internal::check_interpolation_options(options);
    const auto vertices =
      internal::parameter_or<internal::vertex_is_interpolated_map_t>(np, internal::All_vertices());
    const auto for_chunks = internal::For_chunks::with(Concurrency_tag());
    return internal::with_mesh_access(mesh, [&](auto& access) {
      const Level_connectivity level = internal::checked_level(access);
      using Access = std::decay_t<decltype(access)>;
      const auto is_interpolated = [&](Level_connectivity::Index v) {
        return static_cast<bool>(get(vertices, access.vertex(v)));
      };
      if constexpr (internal::may_have_creases_v<Scheme, Access, typename Parameters::Normal_map,
                                                 typename Parameters::Edge_constraint_map,
                                                 typename Parameters::Vertex_constraint_map>)
        if (const std::string what = internal::what_is_sharp(
              scheme, access, level, Parameters::normal_map(np),
              Parameters::edge_constraint_map(np), Parameters::vertex_constraint_map(np));
            !what.empty())
          return internal::interpolate_with_creases<FT>(access, scheme, level, mesh, np, options,
                                                        what, for_chunks, is_interpolated);
      if constexpr (internal::has_corner_normals_v<Access, typename Parameters::Normal_map>)
        return Limit_interpolation(); // what_is_sharp() has told of the normals of corners
      else
        return internal::interpolate_without_creases<FT>(access, scheme, level, mesh, np, options,
                                                         for_chunks, is_interpolated);
    });
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_FITTING_3_INTERPOLATE_LIMIT_POINTS_H
