// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_LIMIT_POINTS_H
#define CGAL_PN_SUBDIVISION_3_LIMIT_POINTS_H

#include <CGAL/PN_subdivision_3/internal/limit/Face_limits.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_writer.h>
#include <CGAL/PN_subdivision_3/internal/limit/read_limit_level.h>
#include <CGAL/PN_subdivision_3/internal/limit/vertex_limits.h>
#include <CGAL/PN_subdivision_3/internal/meshes/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Limit

computes the points of the limit surface of a scheme that belong to the vertices of a control mesh:
where they would come to lie after infinitely many rounds. The mesh may be of any level; as far as the
tolerance goes, the result is the same for the vertices of all.

<b>Points.</b> The limit mask of the linear scheme is a left eigenvector of the matrix that maps the
neighborhood of a vertex to that of the next round. Its point-normal average L over the neighborhood
is exact on spheres and circular cylinders, for equal normals and for linear schemes, but not in
general. So the neighborhood of the vertex is refined by itself, round by round, and L taken anew; the
differences |L<sub>k+1</sub> - L<sub>k</sub>| fall by 1/16 a round at regular vertices, and are what the
error is estimated from. The refinement ends where the tolerance is met.

<b>Control normals.</b> Their limit is the normalized average of the limit mask. *It is not the normal of
the surface*, and the angle between the two does not vanish under refinement.

<b>Surface normals.</b> The left eigenvectors T of the subdominant eigenvalue &lambda; give the slope a of
the surface over the plane perpendicular to the limit control normal N, by T u a = T w with the
coordinates u of the neighbors in that plane and their point-normal heights w over it. The error falls as
&lambda;<sup>2</sup> a round. They exist at interior vertices of valence 3 and more; on the borders of
Catmull-Clark subdivision at valences 3 and 4, of Loop and &radic;3 subdivision at 3 to 6, of
Butterfly subdivision at 3 and 4 and of Kobbelt's at 2 and 3; on those of other schemes where the eigenvectors
of the border ring tell of a plane. They do not at other valences, where the surface is a cusp or folds along its
border, nor where the neighborhood collapses to a line. There the control normal stands in.

<b>Curvature.</b> It exists at regular interior vertices of Catmull-Clark and Loop subdivision and of their
modified forms, and at the extraordinary vertices of the latter, see `Limit_curvature`. Its error is not
estimated; at extraordinary vertices, where it falls as &lambda;<sup>2</sup> a round, eight rounds are done.

<b>Creases.</b> Of what is sharp, by the maps of `subdivide()` or by `border`, corners are their own limits; on
creases the limit mask is that of the curve, (1, 4, 1)/6, and `Crease_average` takes it, for the points, the tangents
and the normals of all wedges; where a crease ends and beside it, the ring has slots of both sides. Points of a vertex
are the same in all its wedges. At vertices on creases the control normals of the wedges stand in for surface
normals, with linear schemes the one-sided normals of the surface, where it has them. Limits continue the rounds
that made a mesh if it still has their normals by half-edges and their tangents, see `parameters::crease_tangent_map()`.
`Limit_point` has the mean of the normals of a vertex.

Interpolatory schemes keep the points. Weights are computed from the scheme's own masks, for each
valence once, to the precision of the number type. Surface normals, curvatures and errors are computed in `double`, from
differences in the number type; what the rounding of coordinates may do in the small rings of many rounds is part of
`Limit_point::normal_error`, and rounds in which it would grow are not used for normals. In exact number types
the limit masks sum to 1 exactly and are exact where they are rational, and one round is done at most,
so that the tolerance may be missed. Intervals contain the limits of linear and of interpolatory schemes; those of others
are estimated, and refused.

\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or
  `Parallel_if_available_tag`. The result is the same, bit for bit; maps are read and written by one
  thread.
\tparam PolygonMesh a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3` that keeps its vertices, or its `linear()` twin
\tparam LimitMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `Limit_point` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param limits the map to write
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
  `vertex_normal_map` with the control normals (without it they are estimated), `edge_is_constrained_map`,
  `vertex_is_constrained_map` and `geom_traits`, as in `subdivide()`, all of whose other parameters but `visitor` and `attributes` count, too; the maps are read only.
  What is computed, and how well, is said by `tolerance`, `normal_tolerance`, `max_depth`, `points`, `surface_normals`,
  `curvatures` and `rounds_done`, all of `CGAL::PN_subdivision_3::parameters`

\returns what was reached. A tolerance that cannot be met is no error.

\throws std::invalid_argument as `subdivide()` does, if a tolerance is negative or not a number, if the scheme has
  no limit masks, if an interval number type is to contain an estimate, and if the sharpness of an edge or vertex is finite: the message names it, and how many rounds
  use it up; nothing has been written then
\throws std::overflow_error if a limit point is out of the range of a floating point type
\throws std::domain_error if an interval number type leaves a comparison undecided
<br><b>Cost:</b> linear in the size of the mesh, for each round about its vertices

\sa `move_to_limit()`
\sa `subdivide_to_limit()`
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme, class LimitMap,
          class NamedParameters = parameters::Default_named_parameters>
Limit_report limit_points(const PolygonMesh& mesh, const Scheme& scheme, LimitMap limits,
                          const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::adapts_scheme_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call(scheme, np, [&](const auto& s, const auto& others) {
      return limit_points<Concurrency_tag>(mesh, s, limits, others);
    });
  else if constexpr (internal::Is_any<Scheme>::value)
    return internal::on_primal_host<Limit_report,
                                    internal::Surface_call<PolygonMesh, NamedParameters>>(
      scheme, [&](const auto& s) { return limit_points<Concurrency_tag>(mesh, s, limits, np); });
  else {
    static_assert(Scheme::Host::keeps_vertices,
                  "the limit points of a dual scheme belong to the faces: see face_limit_points()");
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    using FT = typename Parameters::FT;
    using Vertex = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
    Limit_report report;
    if constexpr (internal::check_limit_map<LimitMap, Vertex>() &&
                  internal::check_creased_limit_arguments<PolygonMesh, Scheme, NamedParameters>()) {
      using Limit = typename boost::property_traits<LimitMap>::value_type;
      const auto points = Parameters::const_point_map(mesh, np);
      const auto normals = Parameters::normal_map(np);
      internal::with_mesh_access(mesh, [&](const auto& access) {
        const auto put_all = [&](const auto& of_mesh, const auto&) {
          internal::put_mean_normals<Scheme>(of_mesh.creases, of_mesh.results);
          for (Level_connectivity::Index v = 0; v < of_mesh.level.number_of_vertices(); ++v)
            put(limits, access.vertex(v), internal::to_limit_point<Limit>(of_mesh.results[v]));
        };
        report =
          internal::with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
            return internal::vertex_limits<FT>(
              access, s, points, normals, Parameters::edge_constraint_map(np),
              Parameters::vertex_constraint_map(np), internal::limit_options(np),
              internal::For_chunks::with(Concurrency_tag()), put_all);
          });
      });
    }
    return report;
  }
}

/*!
\ingroup PkgPNSubdivision3Limit

computes the points of the limit surface of a dual scheme, such as `DooSabin_scheme`, that belong to the
faces of a control mesh: to where a face shrinks. The weights of the limit mask of Doo-Sabin subdivision
are equal. All else is as in `limit_points()`; surface normals exist at all faces that do not collapse,
and curvatures are not computed.

\tparam LimitMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%face_descriptor` as key type and `Limit_point` as value type
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme, class LimitMap,
          class NamedParameters = parameters::Default_named_parameters>
Limit_report face_limit_points(const PolygonMesh& mesh, const Scheme& scheme, LimitMap limits,
                               const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::adapts_scheme_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call(scheme, np, [&](const auto& s, const auto& others) {
      return face_limit_points<Concurrency_tag>(mesh, s, limits, others);
    });
  else if constexpr (internal::Is_any<Scheme>::value)
    return internal::on_dual_host<Limit_report,
                                  internal::Surface_call<PolygonMesh, NamedParameters>>(
      scheme,
      [&](const auto& s) { return face_limit_points<Concurrency_tag>(mesh, s, limits, np); });
  else {
    static_assert(!Scheme::Host::keeps_vertices,
                  "the limit points of a primal scheme belong to the vertices: see limit_points()");
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    using FT = typename Parameters::FT;
    using Face = typename boost::graph_traits<PolygonMesh>::face_descriptor;
    Limit_report report;
    if constexpr (internal::check_limit_map<LimitMap, Face>() &&
                  internal::check_is_point_map<PolygonMesh, NamedParameters>()) {
      using Limit = typename boost::property_traits<LimitMap>::value_type;
      internal::with_mesh_access(mesh, [&](const auto& access) {
        report =
          internal::with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
            using Scheme_of_call = std::decay_t<decltype(s)>;
            const auto level = internal::read_limit_level<Scheme_of_call, FT>(
              access, s, Parameters::const_point_map(mesh, np), Parameters::normal_map(np));
            internal::Limit_demand demand =
              internal::limit_demand<FT>(internal::limit_options(np), internal::box_size(level));
            demand.curvatures = false;
            demand.points = true;
            internal::Face_limits<Scheme_of_call, FT> evaluation(
              s, demand, internal::For_chunks::with(Concurrency_tag()));
            const auto results = evaluation(level);
            internal::check_limits<FT>(
              results, [](std::size_t f) { return "face number " + std::to_string(f); });
            std::size_t i = 0;
            for (auto f : faces(mesh))
              put(limits, f, internal::to_limit_point<Limit>(results[i++]));
            return internal::limit_report(results, demand);
          });
      });
    }
    return report;
  }
}

/*!
\ingroup PkgPNSubdivision3Limit

moves the vertices of a mesh to the limit surface. Called after `subdivide()` with the same scheme it
makes the result lie on the surface that further rounds would tend to; `subdivide_to_limit()` does both.

Points become the limit points. Normals, if there is a `vertex_normal_map`, become the surface normals if
`parameters::surface_normals()` is set, and otherwise the limit control normals. With a linear scheme normals
are written only as surface normals. With a map of half-edges the wedges
of creases have their own, and `crease_tangent_map` gets the tangents of the limit; with a map of
vertices the mean counts. *The mesh is no control mesh any more:* its points and normals are not meant to be
subdivided further.

<b>Strong guarantee.</b> If an exception leaves the function, the maps are as they were, but for maps of
the user's whose `put()` throws also while old values are put back.

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param np as in `limit_points()`; the maps are read and written

For all else see `limit_points()`.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Limit_report move_to_limit(PolygonMesh& mesh, const Scheme& scheme,
                           const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::adapts_scheme_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call(scheme, np, [&](const auto& s, const auto& others) {
      return move_to_limit<Concurrency_tag>(mesh, s, others);
    });
  else if constexpr (internal::Is_any<Scheme>::value)
    return internal::on_primal_host<Limit_report,
                                    internal::Surface_call<PolygonMesh, NamedParameters>>(
      scheme, [&](const auto& s) { return move_to_limit<Concurrency_tag>(mesh, s, np); });
  else {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    return internal::move_to_limit<Concurrency_tag, Parameters>(mesh, scheme, np);
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_LIMIT_POINTS_H
