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
#include <CGAL/PN_subdivision_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_writer.h>
#include <CGAL/PN_subdivision_3/internal/limit/creased_vertex_limits.h>
#include <CGAL/PN_subdivision_3/internal/limit/read_limit_level.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Creased_control.h>
#include <CGAL/PN_subdivision_3/internal/meshes/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/refuse_creases.h>
#include <CGAL/PN_subdivision_3/limit/Limit_report.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Limit

The point of the limit surface that belongs to a vertex of a control mesh, see `limit_points()`.

\tparam GeomTraits a model of `Kernel`
*/
template <class GeomTraits>
struct Limit_point
{
  /// the limit of the points of the vertex.
  typename GeomTraits::Point_3 point{0, 0, 0};
  /// an estimate of the distance of `point` from the limit; it is not a bound that is proved.
  double error = 0;
  /// the limit of the control normals of the vertex, a unit vector; zero if there is none, and with
  /// linear schemes. *It is not the normal of the surface.*
  typename GeomTraits::Vector_3 control_normal{0, 0, 0};
  /// the unit normal of the limit surface, if it was asked for and `has_surface_normal`; otherwise
  /// `control_normal`.
  typename GeomTraits::Vector_3 surface_normal{0, 0, 0};
  /// an estimate of the error of `surface_normal`, in radians.
  double normal_error = 0;
  /// whether the surface has a tangent plane that its ring matrix tells of.
  bool has_surface_normal = false;
  /// \name Curvature
  /// if it was asked for and `has_curvature`; signs are those of `Vertex_curvature`.
  /// @{

  /// the Gaussian curvature.
  double gaussian = 0;
  /// the mean curvature.
  double mean = 0;
  /// whether the surface has curvatures there.
  bool has_curvature = false;
  /// @}
};

/// \ingroup PkgPNSubdivision3Limit
/// What `limit_points()` shall compute, and how well.
struct Limit_options
{
  /// the largest estimated error of a limit point, as a part of the largest side of the bounding box of
  /// the points.
  double tolerance = 1e-9;
  /// the largest estimated error of a surface normal, in radians.
  double normal_tolerance = 1e-3;
  /// the most rounds of refinement about a vertex.
  unsigned max_depth = 12;
  /// whether surface normals are computed.
  bool surface_normals = false;
  /// whether curvatures are computed, where they exist.
  bool curvatures = false;
  /// how many rounds the call has done that made the mesh: the borders of \f$ \sqrt{3} \f$ depend on
  /// whether that is even, and modified schemes on whether it is before their first round; others do not.
  unsigned rounds_done = 0;
};

namespace internal {

template <class FT>
Limit_demand limit_demand(const Limit_options& options, double box)
{
  if (!(options.tolerance >= 0) || !(options.normal_tolerance >= 0))
    throw std::invalid_argument(
      "PN_subdivision_3: a tolerance must be a number that is not negative");
  Limit_demand demand;
  demand.tolerance = options.tolerance * box;
  demand.normal_tolerance = options.normal_tolerance;
  // exact numbers grow too long; the estimate needs one round
  demand.max_depth = is_exact_v<FT> ? 1 : (std::max)(1u, options.max_depth);
  demand.surface_normals = options.surface_normals;
  demand.curvatures = options.curvatures;
  return demand;
}

template <class Limit, class Average>
Limit to_limit_point(const Limit_result<Average>& result)
{
  using FT = typename Average::FT;
  using Point = std::decay_t<decltype(std::declval<Limit>().point)>;
  using Vector = std::decay_t<decltype(std::declval<Limit>().control_normal)>;
  Limit l;
  const Coordinates<FT, 3>& p = point_of(result.value);
  l.point = Point(p[0], p[1], p[2]);
  if constexpr (std::is_same_v<typename Average::Value, Point_normal<FT, 3>>) {
    const Coordinates<FT, 3>& m = result.value.normal;
    l.control_normal = Vector(m[0], m[1], m[2]);
  }
  const Coordinates<double, 3>& n = result.surface_normal;
  l.surface_normal =
    result.has_surface_normal ? Vector(FT(n[0]), FT(n[1]), FT(n[2])) : l.control_normal;
  l.error = result.error;
  l.normal_error = result.normal_error;
  l.has_surface_normal = result.has_surface_normal;
  l.gaussian = result.gaussian;
  l.mean = result.mean;
  l.has_curvature = result.has_curvature;
  return l;
}

template <class Result>
Limit_report limit_report(const std::vector<Result>& results, const Limit_demand& demand)
{
  Limit_report report;
  report.tolerance = demand.tolerance;
  for (const Result& r : results) {
    report.error = (std::max)(report.error, r.error);
    report.normal_error = (std::max)(report.normal_error, r.normal_error);
    report.depth = (std::max)(report.depth, r.depth);
    if (!(r.error <= demand.tolerance) || !(r.normal_error <= demand.normal_tolerance))
      ++report.number_of_misses;
    if (demand.surface_normals && !r.has_surface_normal) ++report.number_of_stand_ins;
  }
  return report;
}

template <class FT, class Results, class Name>
void check_limits(const Results& results, const Name& name)
{
  for (std::size_t i = 0; i < results.size(); ++i)
    check_in_range<FT, 3>(point_of(results[i].value),
                          [&] { return "the limit point of " + name(i); });
}

// Calls sink(results) with the limits of a mesh at its vertices.
template <class FT, class Access, class Scheme, class Point_map, class Normal_map, class Sink>
Limit_report vertex_limits(const Access& access, const Scheme& scheme, Point_map points,
                           Normal_map normals, const Limit_options& options,
                           const For_chunks& for_chunks, const Sink& sink)
{
  const auto level = read_limit_level<Scheme, FT>(access, scheme, points, normals);
  const Limit_demand demand = limit_demand<FT>(options, box_size(level));
  Limit_evaluation<Scheme, FT> evaluation(scheme, demand, for_chunks);
  const auto results = evaluation(level, options.rounds_done + 1);
  const auto name = [&](std::size_t v) {
    return access.vertex_name(static_cast<Level_connectivity::Index>(v));
  };
  check_limits<FT>(results, name);
  sink(results);
  return limit_report(results, demand);
}

// whether creases are looked for
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
constexpr bool has_creased_limits_v = Has_crease_rules<Scheme>::value&&
  may_be_creased_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>;

// Refuses what is sharp if the scheme has no rules for it.
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
void require_crease_rules([[maybe_unused]] const Scheme& scheme,
                          [[maybe_unused]] const Access& access, const Normal_map&,
                          [[maybe_unused]] Edge_map edge_map,
                          [[maybe_unused]] Vertex_map vertex_map)
{
  static_assert(Has_crease_rules<Scheme>::value || !is_of_halfedges_v<Access, Normal_map>,
                "PN_subdivision_3: the scheme has no rules for creases and takes a normal per "
                "vertex, not per half-edge");
  if constexpr (!Has_crease_rules<Scheme>::value &&
                may_be_creased_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>)
    refuse_creases(scheme, access, edge_map, vertex_map);
}

// The same of a mesh that may have creases. Calls sink(limits, tangents): the limits of the slots, and the
// tangents of the map.
template <class FT, class Access, class Scheme, class Point_map, class Normal_map, class Edge_map,
          class Vertex_map, class Sink>
Limit_report creased_vertex_limits(const Access& access, const Scheme& scheme, Point_map points,
                                   Normal_map normals, Edge_map edge_map, Vertex_map vertex_map,
                                   const Limit_options& options, const For_chunks& for_chunks,
                                   const Sink& sink)
{
  using Control = Creased_control<Scheme, FT>;
  Level_connectivity level = checked_level(access);
  check_scheme(scheme, level, access);
  const Edge_constraints<Access, Edge_map> edges(access, edge_map, level.number_of_edges());
  const Vertex_constraints<Access, Vertex_map> vertices(access, vertex_map,
                                                        level.number_of_vertices());
  typename Control::template Tangents<Access> tangents(access, level, Control::tangent_map(scheme));
  Creased_vertex_limits<Scheme, FT> limits(
    access, std::move(level), tangents, scheme, points, normals, edges, vertices,
    options.rounds_done, [&](double box) { return limit_demand<FT>(options, box); }, for_chunks);
  check_limits<FT>(limits.results, [&](std::size_t v) {
    return access.vertex_name(static_cast<Level_connectivity::Index>(v));
  });
  const Level_connectivity::Index n = limits.level.number_of_vertices();
  sink(limits, tangents);
  limits.results.resize(n);
  return limit_report(limits.results, limits.demand);
}

// Puts limits into the maps of a mesh with creases, and the old values back if that fails.
template <class Scheme, class FT, class Access, class Tangents, class Point_map, class Normal_map>
void put_creased_limits(const Access& access, Creased_vertex_limits<Scheme, FT>& limits,
                        Tangents& tangents, Point_map points, Normal_map normals,
                        bool surface_normals)
{
  constexpr bool has_corner_normals = is_of_halfedges_v<Access, Normal_map>;
  using Control = Creased_control<Scheme, FT>;
  typename Control::template Corner_writer<Access, Normal_map> corners(access, limits.level,
                                                                       normals);
  if constexpr (has_corner_normals) {
    if (is_pn_v<Scheme> || surface_normals)
      corners.put_all(limits.level, limits.creases,
                      slot_values<Scheme, FT>(limits.results, surface_normals));
  } else
    put_mean_normals<Scheme>(limits.creases, limits.results);
  tangents.put_refined(limits.creases, limits.level.number_of_edges());
  limits.results.resize(limits.level.number_of_vertices());
  using Vertex_normal_map = typename Control::template Vertex_normal_map<Access, Normal_map>;
  Limit_writer<Access, Scheme, Point_map, Vertex_normal_map>(
    access, points, Control::template make_vertex_normal_map<Access>(normals))
    .write(limits.results, surface_normals);
  corners.keep();
  tangents.keep();
}

template <class Concurrency_tag, class Parameters, class Mesh, class Scheme, class NamedParameters>
Limit_report move_to_limit(Mesh& mesh, const Scheme& scheme, const Limit_options& options,
                           const NamedParameters& np)
{
  static_assert(Scheme::Host::keeps_vertices,
                "the limit points of a dual scheme belong to the faces: see face_limit_points()");
  Limit_report report;
  if constexpr (check_creased_limit_arguments<Mesh, Scheme, NamedParameters>()) {
    using FT = typename Parameters::FT;
    const auto points = Parameters::point_map(mesh, np);
    const auto normals = Parameters::normal_map(np);
    using Normal_map = std::decay_t<decltype(normals)>;
    const auto for_chunks = For_chunks::with(Concurrency_tag());
    with_mesh_access(mesh, [&](const auto& access) {
      using Access = std::decay_t<decltype(access)>;
      const auto edge_map = Parameters::edge_constraint_map(np);
      const auto vertex_map = Parameters::vertex_constraint_map(np);
      require_crease_rules(scheme, access, normals, edge_map, vertex_map);
      if constexpr (has_creased_limits_v<Scheme, Access, Normal_map,
                                         std::decay_t<decltype(edge_map)>,
                                         std::decay_t<decltype(vertex_map)>>)
        report = creased_vertex_limits<FT>(access, scheme, points, normals, edge_map, vertex_map,
                                           options, for_chunks, [&](auto& limits, auto& tangents) {
                                             put_creased_limits(access, limits, tangents, points,
                                                                normals, options.surface_normals);
                                           });
      else
        report = vertex_limits<FT>(
          access, scheme, points, normals, options, for_chunks, [&](const auto& results) {
            Limit_writer<Access, Scheme, std::decay_t<decltype(points)>, Normal_map>(access, points,
                                                                                     normals)
              .write(results, options.surface_normals);
          });
    });
  }
  return report;
}

} // namespace internal

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

<b>Creases.</b> Of what is sharp, by the maps of `subdivide()` or by `with_border()`, corners are their own limits; on
creases the limit mask is that of the curve, (1, 4, 1)/6, and `Crease_average` takes it, for the points, the tangents
and the normals of all wedges; where a crease ends and beside it, the ring has slots of both sides. Points of a vertex
are the same in all its wedges. At vertices on creases the control normals of the wedges stand in for surface
normals, with linear schemes the one-sided normals of the surface, where it has them. Limits continue the rounds
that made a mesh if it still has their normals by half-edges and their tangents, see `with_crease_tangents()`.
`Limit_point` has the mean of the normals of a vertex.

Interpolatory schemes keep the points. Weights are computed from the scheme's own masks, for each
valence once. Surface normals, curvatures and errors are computed in `double`; in exact number types
the limit masks sum to 1 exactly and are exact where they are rational, and one round is done at most,
so that the tolerance may be missed.

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
\param options what is computed, and how well
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
  `vertex_normal_map` with the control normals (without it they are estimated), `edge_is_constrained_map`,
  `vertex_is_constrained_map` and `geom_traits`, as in `subdivide()`; the maps are read only

\returns what was reached. A tolerance that cannot be met is no error.

\throws std::invalid_argument as `subdivide()` does, if a tolerance is negative or not a number, if the scheme has
  no limit masks, and if the sharpness of an edge or vertex is finite: the message names it, and how many rounds
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
                          const Limit_options& options = Limit_options(),
                          const NamedParameters& np = parameters::default_values())
{
  static_assert(Scheme::Host::keeps_vertices,
                "the limit points of a dual scheme belong to the faces: see face_limit_points()");
  static_assert(internal::are_used_v<internal::Creased_limit_parameters, NamedParameters>,
                "PN_subdivision_3: a named parameter is given that is not used here");
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  using Limit = typename boost::property_traits<LimitMap>::value_type;
  Limit_report report;
  if constexpr (internal::check_creased_limit_arguments<PolygonMesh, Scheme, NamedParameters>()) {
    const auto points = Parameters::const_point_map(mesh, np);
    const auto normals = Parameters::normal_map(np);
    const auto for_chunks = internal::For_chunks::with(Concurrency_tag());
    internal::with_mesh_access(mesh, [&](const auto& access) {
      using Access = std::decay_t<decltype(access)>;
      const auto edge_map = Parameters::edge_constraint_map(np);
      const auto vertex_map = Parameters::vertex_constraint_map(np);
      const auto put_limits = [&](const auto& results, Level_connectivity::Index n) {
        for (Level_connectivity::Index v = 0; v < n; ++v)
          put(limits, access.vertex(v), internal::to_limit_point<Limit>(results[v]));
      };
      internal::require_crease_rules(scheme, access, normals, edge_map, vertex_map);
      if constexpr (internal::has_creased_limits_v<Scheme, Access, std::decay_t<decltype(normals)>,
                                                   std::decay_t<decltype(edge_map)>,
                                                   std::decay_t<decltype(vertex_map)>>)
        report = internal::creased_vertex_limits<FT>(
          access, scheme, points, normals, edge_map, vertex_map, options, for_chunks,
          [&](auto& of_slots, auto&) {
            internal::put_mean_normals<Scheme>(of_slots.creases, of_slots.results);
            put_limits(of_slots.results, of_slots.level.number_of_vertices());
          });
      else
        report = internal::vertex_limits<FT>(
          access, scheme, points, normals, options, for_chunks, [&](const auto& results) {
            put_limits(results, static_cast<Level_connectivity::Index>(results.size()));
          });
    });
  }
  return report;
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
                               const Limit_options& options = Limit_options(),
                               const NamedParameters& np = parameters::default_values())
{
  static_assert(!Scheme::Host::keeps_vertices,
                "the limit points of a primal scheme belong to the vertices: see limit_points()");
  static_assert(internal::are_used_v<internal::Limit_parameters, NamedParameters>,
                "PN_subdivision_3: a named parameter is given that is not used here");
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  using Limit = typename boost::property_traits<LimitMap>::value_type;
  Limit_report report;
  internal::with_mesh_access(mesh, [&](const auto& access) {
    const auto level = internal::read_limit_level<Scheme, FT>(
      access, scheme, Parameters::const_point_map(mesh, np), Parameters::normal_map(np));
    internal::Limit_demand demand = internal::limit_demand<FT>(options, internal::box_size(level));
    demand.curvatures = false;
    internal::Face_limits<Scheme, FT> evaluation(scheme, demand,
                                                 internal::For_chunks::with(Concurrency_tag()));
    const auto results = evaluation(level);
    internal::check_limits<FT>(results,
                               [](std::size_t f) { return "face number " + std::to_string(f); });
    std::size_t i = 0;
    for (auto f : faces(mesh)) put(limits, f, internal::to_limit_point<Limit>(results[i++]));
    report = internal::limit_report(results, demand);
  });
  return report;
}

/*!
\ingroup PkgPNSubdivision3Limit

moves the vertices of a mesh to the limit surface. Called after `subdivide()` with the same scheme it
makes the result lie on the surface that further rounds would tend to; `subdivide_to_limit()` does both.

Points become the limit points. Normals, if there is a `vertex_normal_map`, become the surface normals if
`options.surface_normals` is set, and otherwise the limit control normals. With a linear scheme normals
are written only as surface normals. With a map of half-edges the wedges
of creases have their own, and the map of `with_crease_tangents()` gets the tangents of the limit; with a map of
vertices the mean counts. *The mesh is no control mesh any more:* its points and normals are not meant to be
subdivided further.

<b>Strong guarantee.</b> If an exception leaves the function, the maps are as they were, but for maps of
the user's whose `put()` throws also while old values are put back.

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param options what is computed, and how well
\param np as in `limit_points()`; the maps are read and written

For all else see `limit_points()`.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Limit_report move_to_limit(PolygonMesh& mesh, const Scheme& scheme,
                           const Limit_options& options = Limit_options(),
                           const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_used_v<internal::Creased_limit_parameters, NamedParameters>,
                "PN_subdivision_3: a named parameter is given that is not used here");
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  return internal::move_to_limit<Concurrency_tag, Parameters>(mesh, scheme, options, np);
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_LIMIT_POINTS_H
