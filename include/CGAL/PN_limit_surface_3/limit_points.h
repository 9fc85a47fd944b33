// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_LIMIT_POINTS_H
#define CGAL_PN_LIMIT_SURFACE_3_LIMIT_POINTS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_writer.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL::PN_subdivision_3 {

namespace internal {

// limit_points() at the faces of a dual scheme
template <class Concurrency_tag, class PolygonMesh, class Scheme, class LimitMap,
          class NamedParameters>
Limit_report face_limit_points(const PolygonMesh& mesh, const Scheme& scheme, LimitMap limits,
                               const NamedParameters& np)
{
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  using Face = typename boost::graph_traits<PolygonMesh>::face_descriptor;
  if constexpr (Check_map<Map_of_limits>::check<LimitMap, Face, Parameters, Writable>() &&
                check_is_point_map<PolygonMesh, NamedParameters>()) {
    using Limit = typename boost::property_traits<LimitMap>::value_type;
    return with_mesh_access(mesh, [&](const auto& access) {
      return with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
        using Scheme_of_call = std::decay_t<decltype(s)>;
        const auto level = read_limit_level<Scheme_of_call, FT>(
          access, s, Parameters::const_point_map(mesh, np), Parameters::normal_map(np));
        Limit_demand demand = limit_demand<FT>(limit_options(np), box_size(level));
        demand.curvatures = false;
        demand.points = true;
        const Scheme_of_rounds<Scheme_of_call>& round_scheme = scheme_of_rounds(s);
        Face_limits<Scheme_of_rounds<Scheme_of_call>, FT> evaluation(
          round_scheme, demand, For_chunks::with(Concurrency_tag()));
        const auto results = evaluation(level);
        check_limits<FT>(results, [](std::size_t f) { return "face number " + std::to_string(f); });
        std::size_t i = 0;
        for (auto f : faces(mesh)) put(limits, f, to_limit_point<Limit>(results[i++]));
        return limit_report(results, demand);
      });
    });
  } else
    return {};
}

// limit_points() at the vertices of a scheme that is not dual
template <class Concurrency_tag, class PolygonMesh, class Scheme, class LimitMap,
          class NamedParameters>
Limit_report vertex_limit_points(const PolygonMesh& mesh, const Scheme& scheme, LimitMap limits,
                                 const NamedParameters& np)
{
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  using Vertex = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
  if constexpr (Check_map<Map_of_limits>::check<LimitMap, Vertex, Parameters, Writable>() &&
                check_creased_limit_arguments<PolygonMesh, Scheme, NamedParameters>()) {
    using Limit = typename boost::property_traits<LimitMap>::value_type;
    const auto put_all = [&](const auto& access, const auto& level, const auto& creases,
                             auto& results, const auto&) {
      put_mean_normals(creases, results);
      for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
        put(limits, access.vertex(v), to_limit_point<Limit>(results[v]));
    };
    return vertex_limits<Concurrency_tag, Parameters>(
      mesh, scheme, Parameters::const_point_map(mesh, np), np, put_all);
  } else
    return {};
}

// whether a map of limits has faces as keys
template <class PolygonMesh, class LimitMap>
constexpr bool is_of_faces_v =
  std::is_same_v<typename boost::property_traits<LimitMap>::key_type,
                 typename boost::graph_traits<PolygonMesh>::face_descriptor>;

template <class Concurrency_tag, class PolygonMesh, class Scheme, class LimitMap,
          class NamedParameters>
Limit_report limits_of_call(const PolygonMesh& mesh, const Scheme& scheme, LimitMap limits,
                            const NamedParameters& np)
{
  constexpr Hosts hosts =
    is_of_faces_v<PolygonMesh, LimitMap> ? Hosts::of_face_limits : Hosts::of_vertex_limits;
  return with_scheme_of_call<Limit_report, Surface_call<PolygonMesh, NamedParameters>, hosts>(
    scheme, np, [&](const auto& s, const auto& others) -> Limit_report {
      using Hosted_scheme = std::decay_t<decltype(s)>;
      if constexpr (Has_grid_rows<Hosted_scheme>::value) {
        check_no_grid_rows<Hosted_scheme>(); // nothing below, of which compilers would say more
        return {};
      } else if constexpr (Hosted_scheme::Host::keeps_vertices)
        return vertex_limit_points<Concurrency_tag>(mesh, s, limits, others);
      else
        return face_limit_points<Concurrency_tag>(mesh, s, limits, others);
    });
}

// the keys of elements that have limits, by the map of points, normals or errors that is given
template <class PolygonMesh, class NamedParameters>
struct Key_of_limits
{
  struct Nothing
  {
    using key_type = void;
    using value_type = void;
    using reference = void;
    using category = boost::writable_property_map_tag;
  };
  using Errors = Parameter_type<limit_error_map_t, NamedParameters, Nothing>;
  using Normals = Parameter_type<limit_normal_map_t, NamedParameters, Errors>;
  using Points = Parameter_type<limit_point_map_t, NamedParameters, Normals>;
  using type = typename boost::property_traits<Points>::key_type;
  static constexpr bool is_given = !std::is_same_v<Points, Nothing>;
};

// moves the vertices of a mesh to the limit, see subdivide_to_limit() with 0 rounds
template <class Concurrency_tag, class PolygonMesh, class Scheme, class NamedParameters>
Limit_report move_to_limit_of_call(PolygonMesh& mesh, const Scheme& scheme,
                                   const NamedParameters& np)
{
  return with_scheme_of_call<Limit_report, Surface_call<PolygonMesh, NamedParameters>,
                             Hosts::of_vertex_limits>(
    scheme, np, [&](const auto& s, const auto& others) {
      using Parameters = Surface_parameters<PolygonMesh, std::decay_t<decltype(others)>>;
      return move_to_limit<Concurrency_tag, Parameters>(mesh, s, others);
    });
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Limit

computes the points of the limit surface of a scheme that belong to the vertices of a control mesh:
where they would come to lie after infinitely many rounds. The mesh may be of any level; as far as the
tolerance goes, the result is the same for the vertices of all. With a dual scheme, such as `DooSabin_scheme`, limit
points belong to the faces, which shrink to them. The weights of the limit mask of Doo-Sabin subdivision are equal.
Surface normals exist at all faces that do not collapse, and curvatures are not computed.

<b>Points.</b> The limit mask of the linear scheme is a left eigenvector of the matrix that maps the
neighborhood of a vertex to that of the next round. Its point-normal average L over the neighborhood
is exact on spheres and circular cylinders, for equal normals and for linear schemes, but not in
general. So only the neighborhood of the vertex is refined, round by round, and L is computed again. The differences
|L<sub>k+1</sub> - L<sub>k</sub>| decrease to 1/16 in each round at regular vertices, and the error is estimated from
them. The refinement ends when the tolerance is met.

<b>Control normals.</b> Their limit is the normalized average of the limit mask. *It is not the normal of
the surface*, and the angle between the two does not vanish under refinement.

<b>Surface normals.</b> The left eigenvectors T of the subdominant eigenvalue &lambda; give the slope a of the surface
over the plane perpendicular to the limit control normal N, by T u a = T w. Here u are the coordinates of the
neighbors in that plane, and w their point-normal heights over it. Each round reduces the error by
&lambda;<sup>2</sup>. They exist at interior vertices of valence 3 and more. On borders they exist at the valences 3
and 4 of Catmull-Clark and Butterfly subdivision, 3 to 6 of Loop and &radic;3 subdivision, 2 and 3 of Kobbelt's; with
other schemes if the eigenvectors of the border ring determine a plane. They do not exist at other valences, where the
surface is a cusp or folds along its border, nor where the neighborhood collapses to a line. There the control normal
stands in.

<b>Curvature.</b> It exists at regular interior vertices of Catmull-Clark and Loop subdivision and of their
modified forms, and at the extraordinary vertices of the latter (\ref PNSubdivision_curvature). Its error is not
estimated; at extraordinary vertices, where a round reduces it by &lambda;<sup>2</sup>, eight rounds are done.

<b>Creases.</b> Sharp edges and vertices are given as to `subdivide()`. Corners are their own limits. On creases the
limit mask is that of the curve, (1, 4, 1)/6, by which `Crease_average` averages the points, the tangents and the
normals of all wedges. At the end of a crease and beside it, the ring has slots of both sides. Points of a vertex are
the same in all its wedges. At vertices on creases the control normals of the wedges stand in for surface normals,
with linear schemes the one-sided normals of the surface, where it has them. Limits continue the rounds that made a
mesh if it still has their normals by half-edges and their tangents, see `parameters::crease_tangent_map()`.
`Limit_point` has the mean of the normals of a vertex.

Interpolatory schemes keep the points. Weights are computed from the scheme's own masks, for each valence once, to the
precision of the number type. Surface normals, curvatures and errors are computed in `double`, from differences in the
number type. `Limit_point::normal_error` includes the effect of rounded coordinates in the small rings of many rounds,
and rounds in which it would grow are not used for normals. In exact number types the limit masks sum to 1 exactly and
are exact where they are rational, and one round is done at most, so that the tolerance may be missed. Intervals
contain the limits of linear and of interpolatory schemes; those of others are estimated, and refused.

\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or
  `Parallel_if_available_tag`. The result is the same, bit for bit; maps are read and written by one
  thread.
\tparam PolygonMesh a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3`, or its `linear()` twin
\tparam LimitMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%vertex_descriptor` (of a dual scheme `face_descriptor`) as key type and `Limit_point` as
  value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param limits the map to write; it may be left out where `limit_point_map`, `limit_normal_map` or `limit_error_map` of
  `CGAL::PN_subdivision_3::parameters` are given, which are then written
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_normal_map`
  with the control normals (without it they are estimated), `edge_is_constrained_map`, `vertex_is_constrained_map` and
  `geom_traits`, as in `subdivide()`. All its other parameters but `visitor` and `attributes` count, too. The maps are
  read only. Precision and kinds of results are set by `tolerance`, `normal_tolerance`, `max_depth`, `points`,
  `surface_normals`, `curvatures` and `rounds_done`, all of `CGAL::PN_subdivision_3::parameters`

\returns what was reached. A tolerance that cannot be met is not an error.

\throws std::invalid_argument as `subdivide()` does, with nothing written, if a tolerance is negative or not a number,
  the scheme has no limit masks, or an interval number type is to contain an estimate. If the sharpness of an edge or
  vertex is finite, the message names it, and how many rounds use it up
\throws std::overflow_error if a limit point is out of the range of a floating point type
\throws std::domain_error if an interval number type leaves a comparison undecided
<br><b>Cost:</b> linear in the size of the mesh, for each round about its vertices

\sa `subdivide_to_limit()`
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme, class LimitMap,
          class NamedParameters = parameters::Default_named_parameters>
Limit_report limit_points(const PolygonMesh& mesh, const Scheme& scheme, LimitMap limits,
                          const NamedParameters& np = parameters::default_values())
{
  constexpr bool has_parameters_alone = internal::are_named_parameters_v<LimitMap>;
  internal::check_are_read<std::conditional_t<has_parameters_alone, LimitMap, NamedParameters>,
                           internal::Read_of_control_mesh, internal::tolerance_t,
                           internal::normal_tolerance_t, internal::max_depth_t, internal::points_t,
                           internal::surface_normals_t, internal::curvatures_t,
                           internal::rounds_done_t, internal::limit_point_map_t,
                           internal::limit_normal_map_t, internal::limit_error_map_t>();
  if constexpr (has_parameters_alone) {
    using Keys = internal::Key_of_limits<PolygonMesh, LimitMap>;
    using Kernel = typename internal::Surface_parameters<PolygonMesh, LimitMap>::Geom_traits;
    static_assert(Keys::is_given,
                  "PN_subdivision_3: limit_points() has nothing to write: give it a "
                  "map of Limit_point, or limit_point_map, limit_normal_map or "
                  "limit_error_map");
    if constexpr (Keys::is_given)
      return internal::limits_of_call<Concurrency_tag>(
        mesh, scheme, internal::Limit_maps<typename Keys::type, Kernel, LimitMap>{limits}, limits);
    else
      return {};
  } else {
    static_assert(
      !internal::is_given_v<internal::limit_point_map_t, NamedParameters> &&
        !internal::is_given_v<internal::limit_normal_map_t, NamedParameters> &&
        !internal::is_given_v<internal::limit_error_map_t, NamedParameters>,
      "PN_subdivision_3: limit_points() writes a map of Limit_point, or limit_point_map, "
      "limit_normal_map and limit_error_map, not both");
    return internal::limits_of_call<Concurrency_tag>(mesh, scheme, limits, np);
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_LIMIT_POINTS_H
