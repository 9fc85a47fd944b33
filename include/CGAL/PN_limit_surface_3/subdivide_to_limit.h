// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_SUBDIVIDE_TO_LIMIT_H
#define CGAL_PN_LIMIT_SURFACE_3_SUBDIVIDE_TO_LIMIT_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_subdivision.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Call_attributes.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>

#include <stdexcept>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Limit

subdivides a mesh and puts its vertices on the limit surface. With 0 rounds, after `subdivide()` with the same scheme, the
result is the same. Limits are computed before the mesh is touched, so that the strong guarantee is that of one
call.

Points become the limit points. `limit_normal_map` gets the normals for shading. Normals, if there is a `vertex_normal_map`, become the surface normals if
`parameters::surface_normals()` asks for them, and otherwise the limit control normals. With a linear scheme normals
are written only as surface normals. With a map of half-edges the wedges
of creases have their own, and `crease_tangent_map` gets the tangents of the limit; with a map of
vertices the mean counts. *The mesh is no control mesh any more:* its points and normals are not meant to be
subdivided further.

<b>Creases.</b> With `edge_is_constrained_map`, `vertex_is_constrained_map`, `border` and `crease_tangent_map` the
mesh has creases as in `subdivide()`, and the limits are those of `limit_points()`. An edge that is sharp for a finite
number of rounds has to be smooth after those of the call. The maps are written as by `subdivide()`; the tangents are
those of the limit.

<b>Attributes</b> are those that `subdivide()` leaves after as many rounds, bit for bit: values of vertices and corners are
not moved to their limits. With 0 rounds they stay as they are, and the visitor is not called. It may cancel the call by
an exception of `round_done()`, also of the last round, after which limits are computed.

<b>Strong guarantee.</b> If an exception leaves the function, the maps are as they were, except for maps of
the user's whose `put()` throws also while old values are put back, or which cannot be read.

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `number_of_iterations`,
  `vertex_point_map`, `vertex_normal_map` with the control normals (without it they are estimated), `control_normal_estimate`,
  `vertex_roundness_map` or `roundness`, `edge_is_constrained_map`, `vertex_is_constrained_map`, `border`,
  `crease_tangent_map`, `attributes`, `visitor` and `geom_traits` as in `subdivide()`. As in `limit_points()` are
  `tolerance`, `normal_tolerance`, `max_depth`, `points`, `surface_normals`, `limit_point_map`, `limit_normal_map` and
  `limit_error_map` (of the vertices of the result). With 0 rounds `rounds_done` counts, too; otherwise the call
  counts its rounds itself

\returns what was reached

\throws std::invalid_argument as `subdivide()` and `limit_points()` do, and if `rounds_done` is not 0 where there are rounds
\throws std::length_error,std::overflow_error,std::domain_error as `subdivide()` and `limit_points()` do
<br><b>Cost:</b> that of both functions; the refined level is kept in memory besides the mesh
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Limit_report subdivide_to_limit(PolygonMesh& mesh, const Scheme& scheme,
                                const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh, internal::attributes_t,
                           internal::tolerance_t, internal::normal_tolerance_t,
                           internal::max_depth_t, internal::points_t, internal::surface_normals_t,
                           internal::rounds_done_t, internal::limit_point_map_t,
                           internal::limit_normal_map_t, internal::limit_error_map_t>();
  if constexpr (internal::adapts_scheme_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call(scheme, np, [&](const auto& s, const auto& others) {
      return subdivide_to_limit<Concurrency_tag>(mesh, s, others);
    });
  else if constexpr (internal::Is_any<Scheme>::value)
    return internal::on_host_of_limits<true, Limit_report,
                                       internal::Surface_call<PolygonMesh, NamedParameters>>(
      scheme, [&](const auto& s) { return subdivide_to_limit<Concurrency_tag>(mesh, s, np); });
  else {
    static_assert(Scheme::Host::keeps_vertices,
                  "the limit points of a dual scheme belong to the faces: see limit_points()");
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    const internal::Limit_options options = internal::limit_options(np);
    const unsigned rounds = Parameters::number_of_iterations(np);
    if (rounds == 0) return internal::move_to_limit<Concurrency_tag, Parameters>(mesh, scheme, np);
    if (options.rounds_done != 0)
      throw std::invalid_argument(
        "PN_subdivision_3: subdivide_to_limit() counts its rounds itself: "
        "leave rounds_done 0");
    Limit_report report;
    if constexpr (internal::check_subdivision_arguments<PolygonMesh, Scheme, NamedParameters>() &&
                  internal::check_attributes<PolygonMesh, NamedParameters>()) {
      auto visitor = Parameters::visitor(np);
      auto& unwrapped = internal::unwrapped(visitor);
      using Visitor = std::remove_reference_t<decltype(unwrapped)>;
      const internal::Call_round_done<Visitor> round_done{unwrapped};
      if constexpr (!internal::check_visitor<Visitor, PolygonMesh>()) return report;
      auto attributes = Parameters::attributes(np);
      auto& carried = internal::unwrapped(attributes);
      const internal::Call_attributes<PolygonMesh, Visitor,
                                      std::remove_reference_t<decltype(carried)>>
        attributes_of_call{unwrapped, carried};
      const internal::Limit_maps_of_call<typename Parameters::Geom_traits, NamedParameters> maps{
        np};
      internal::with_mesh_access(mesh, [&](auto& access) {
        report =
          internal::with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
            const internal::Limit_subdivision<Concurrency_tag, std::decay_t<decltype(s)>,
                                              typename Parameters::FT>
              subdivision(s, rounds, options, round_done);
            return subdivision(access, Parameters::point_map(mesh, np), Parameters::normal_map(np),
                               Parameters::edge_constraint_map(np),
                               Parameters::vertex_constraint_map(np), attributes_of_call, maps);
          });
      });
    }
    return report;
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_SUBDIVIDE_TO_LIMIT_H
