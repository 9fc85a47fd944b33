// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_SMOOTH_CONTROL_NORMALS_H
#define CGAL_PN_FITTING_3_SMOOTH_CONTROL_NORMALS_H

#include <CGAL/PN_subdivision_3/internal/needs_eigen.h>

#include <CGAL/PN_fitting_3/internal/interpolate_mesh.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Functions
/// What `smooth_control_normals()` has found and done. Angles are in degrees.
struct Normal_smoothing_report
{
  /// the noise of the given normals: the root mean square of their angles to the true ones, as it is estimated.
  double noise = 0;
  /// the root mean square of what the arcs along the edges lack, (n<sub>i</sub> + n<sub>j</sub>) &middot; e / |e|, of the
  /// given normals: that of noise and that of the shape.
  double arc_defect = 0;
  /// &lambda;; 0 if nothing has been changed.
  double strength = 0;
  /// the largest angle by which a normal has been turned.
  double largest_turn = 0;
  /// how many normals have been changed; a vertex between creases has one for each wedge.
  std::size_t changed_normals = 0;
  /// the roundness of all vertices with which the surface becomes fairest, less than 1 if the points have noise: to be given
  /// to `subdivide()` by `parameters::roundness()`.
  double roundness = 1;
  /// if nothing has been changed, the mean angle between neighboring faces of the surface after the two rounds.
  double mean_turn = 0;
  /// the same of the linear one.
  double linear_mean_turn = 0;
};

namespace internal {

template <class Mesh, class Normal_map, class NamedParameters>
constexpr bool check_smoothing_arguments()
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  using Edge_map = typename Parameters::Edge_constraint_map;
  constexpr bool has_wedges =
    !is_there_v<Edge_map> ||
    is_property_map_of_v<Normal_map, typename boost::graph_traits<Mesh>::halfedge_descriptor>;
  static_assert(has_wedges,
                "PN_subdivision_3: a mesh with creases has several normals at a vertex: "
                "give a map of the corners, whose keys are half-edges");
  if constexpr (has_wedges)
    return check_estimation_arguments<Mesh, Normal_map, NamedParameters,
                                      boost::read_write_property_map_tag>();
  else
    return false;
}

template <int dimension>
Normal_smoothing_report smooth(const Level_connectivity& level,
                               const Interpolation_data<dimension>& data,
                               Vectors<dimension>& smooth_normals);

} // namespace internal
} // namespace CGAL::PN_subdivision_3

#ifndef CGAL_PN_SUBDIVISION_3_FITTING // the library has it
#  include <CGAL/PN_fitting_3/internal/Normal_smoothing.h>

namespace CGAL::PN_subdivision_3::internal {

template <int dimension>
Normal_smoothing_report smooth(const Level_connectivity& level,
                               const Interpolation_data<dimension>& data,
                               Vectors<dimension>& smooth_normals)
{
  Normal_smoothing<dimension> smoothing(level, data.points, data.normals);
  smooth_normals = smoothing();
  Normal_smoothing_report report;
  report.noise = in_degrees(smoothing.noise());
  report.arc_defect = in_degrees(smoothing.defect());
  report.strength = smoothing.strength();
  report.roundness = smoothing.roundness();
  for (std::size_t v = 0; v < smooth_normals.size(); ++v) {
    const Eigen_vector<3>&a = data.normals[v], &b = smooth_normals[v];
    if (a == b) continue;
    ++report.changed_normals;
    const double turn = in_degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
    report.largest_turn = (std::max)(report.largest_turn, turn);
  }
  if (report.changed_normals == 0 && report.roundness == 1) {
    const auto turn = [&](double roundness) {
      return in_degrees(fairness(level, data.points, data.normals, roundness).mean_turn);
    };
    report.mean_turn = turn(1);
    report.linear_mean_turn = turn(0);
  }
  return report;
}

} // namespace CGAL::PN_subdivision_3::internal
#endif

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

smooths given control normals against the points of a mesh. Measured normals have noise, those of a scan a degree or
more, which shows in the curvature of the surface, while the points often have far less noise.

The arc of points i and j with an edge e between them exists if \f$ (n_i + n_j) \cdot e = 0 \f$. Spheres, cylinders
and the lines of curvature of tori fulfil this condition, smooth surfaces up to terms of second order in the edges.
With the given normals m, a share A of the area at each vertex, relative to the mean, and a strength &lambda;,

\f[ \sum_v A_v |n_v - m_v|^2 + \lambda \sum_e \left( (n_i + n_j) \cdot e \right)^2 / |e|^2 \f]

is minimized, which takes one sparse linear solve. Its solution, made of unit length, is the result.

<b>Strength.</b> On a smooth surface with exact normals the defects \f$ r = (n_i + n_j) \cdot e / |e| \f$ about a vertex are
a cubic form of the edges over their lengths, up to terms of third order. Such a form is fitted to the edges of the
faces of each vertex, and the rest is noise. The mean square \f$ \sigma^2 \f$ of the noise comes from the median over
the N vertices that have enough edges, as does that of r, \f$ \rho^2 \f$. Then, with \f$ \epsilon = \min(2/\sqrt N,
1/5) \f$ for what both may be off by chance,

\f[ \lambda = \frac{\sigma^2 - \rho^2 / 10}{2 \max(\rho^2 - (1 + \epsilon) \sigma^2, \sigma^2/1000)}, \f]

the ratio of the variances of a normal in a direction and of the defects that the shape itself has. If noise is less
than a tenth of \f$ \rho^2 \f$, as with exact normals, nothing is changed.

<b>Noise of points</b> shows in the arcs, too, and no normals take it off. It is measured by the mean of \f$ |\nabla
H| \f$, the change of the mean curvature, over the surface after two rounds of Catmull-Clark or, for triangles, Loop
subdivision. If the new normals do not lessen this mean, smaller values of the roundness are tried with them, down to
0, the linear scheme, for which normals do not count and stay. If the mean is no less then either, it is due to the
shape and not to noise, as on triangles with long edges in all directions, and nothing is changed; the report
then has the mean angles between the faces of both surfaces.

Normals all of whose arcs have defects of at most 10<sup>-9</sup> are not changed by a bit, nor are those without arcs and
zero ones. There is no arc between normals that are 90 degrees or more apart, so that a reversed one stays and does nothing to its
neighbors. Unchanged normals are not written. On creases every wedge has arcs
and a normal of its own.

<b>Strong guarantee.</b> If an exception leaves the function, the normals are as they were, except for maps of the user's
whose `put()` throws also while old values are put back.

Computed in `double`, whatever the number type. Not part of the header `CGAL/PN_subdivision_3.h`, since it needs
\ref thirdpartyEigen "Eigen".

\tparam PolygonMesh a model of `FaceListGraph`
\tparam NormalMap a model of `ReadWritePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%vertex_descriptor`, or for a mesh with creases `halfedge_descriptor`, as key type and a
  `Vector_3` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param normals the control normals, of vertices or of the corners at the targets of half-edges as in `subdivide()`; zero ones stay
  zero
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` and `geom_traits` as in
  `subdivide()`, and for normals of corners `edge_is_constrained_map`, which gives the creases

\returns what has been found and done
\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border, a point or a normal is not finite, or a
  sharpness is negative or not a number; nothing has been written then
\throws std::length_error if the matrix is too large for Eigen
<br><b>Cost:</b> that of a sparse factorization with three rows a vertex

\sa `estimate_control_normals()`
*/
template <class PolygonMesh, class NormalMap,
          class NamedParameters = parameters::Default_named_parameters>
Normal_smoothing_report
smooth_control_normals(const PolygonMesh& mesh, NormalMap normals,
                       const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  Normal_smoothing_report report;
  if constexpr (internal::check_smoothing_arguments<PolygonMesh, NormalMap, NamedParameters>()) {
    using FT = typename Parameters::FT;
    using Index = Level_connectivity::Index;
    const auto points = Parameters::const_point_map(mesh, np);
    internal::with_mesh_access(mesh, [&](const auto& access) {
      using Access = std::decay_t<decltype(access)>;
      using Average = PN_average<FT, 3>;
      const Level_connectivity level = internal::checked_level(access);
      internal::Vectors<3> smooth;
      const auto write = [&](const auto& for_each_normal, auto element, const auto& data) {
        const auto alone = internal::normals_of<false>(normals);
        internal::Undoable_map<Access, std::decay_t<decltype(alone)>, decltype(element)> changed(
          access, alone);
        for_each_normal([&](Index i, Index slot) {
          if (smooth[slot] != data.normals[slot])
            changed.change_vector(i, internal::coordinates_of<FT>(smooth[slot]));
        });
        changed.commit();
      };
      if constexpr (!internal::has_corner_normals_v<Access, NormalMap>) {
        const auto data = internal::data_in_double<FT>(internal::read_given_values<Average>(
          access, points, normals, level.number_of_vertices()));
        report = internal::smooth<3>(level, data, smooth);
        write(
          [&](const auto& f) {
            for (Index v = 0; v < level.number_of_vertices(); ++v) f(v, v);
          },
          internal::Vertex_of_mesh(), data);
      } else {
        const internal::Creases<FT> creases = internal::Make_creases<FT>(level, Border::surface)(
          [&](Index e) {
            if constexpr (internal::is_there_v<typename Parameters::Edge_constraint_map>)
              return internal::checked_sharpness(
                internal::sharpness_in(Parameters::edge_constraint_map(np), access.edge_at(e)),
                [&] { return internal::Edge_of_mesh::name(access, e); });
            else
              return 0.;
          },
          [](Index) { return 0.; });
        auto values = internal::read_given_values<Average>(access, points, internal::Not_given(),
                                                           level.number_of_vertices());
        for (const Index v : internal::vertices_of_extra_slots(creases, level.number_of_vertices()))
          values.push_back(values[v]);
        internal::read_corner_normals<FT>(access, level, creases, normals, values);
        const auto data = internal::data_in_double<FT>(values);
        const internal::Cut_copy<FT> cut(level, creases);
        report = internal::smooth<3>(cut.connectivity(), data, smooth);
        write([&](const auto& f) { internal::for_each_corner(level, cut.connectivity(), f); },
              internal::Halfedge_of_mesh(), data);
      }
    });
  }
  return report;
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_FITTING_3_SMOOTH_CONTROL_NORMALS_H
