// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/creases/Wedge_estimation.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/parameters/Estimated_control_normals.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3 {

namespace internal {

template <class Map, class Key, class FT>
void put_roundness(const Map& map, const Key& key, const FT& w)
{
  if constexpr (is_there_v<Map>)
    put(map, key, roundness_as<std::decay_t<typename boost::property_traits<Map>::value_type>>(w));
}

// estimate_control_normals() of a map of half-edges; that of the roundness is of vertices or, as an estimate has it, of half-edges
template <class Access, class PolygonMesh, class HalfedgeNormalMap, class Roundness_map,
          class NamedParameters>
void estimate_corner_normals(const Access& access, const PolygonMesh& mesh,
                             const HalfedgeNormalMap& normals, const Roundness_map& roundness,
                             const NamedParameters& np)
{
  using Halfedge = typename boost::graph_traits<PolygonMesh>::halfedge_descriptor;
  constexpr bool is_of_corners = std::is_same_v<Key_of_map<Roundness_map>, Halfedge>;
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  using Index = Level_connectivity::Index;
  using Normal = typename boost::property_traits<HalfedgeNormalMap>::value_type;
  const auto points = Parameters::const_point_map(mesh, np);
  const Control_normal_estimate estimate =
    parameter_or<control_normal_estimate_t>(np, Control_normal_estimate::coherent);
  const Level_connectivity level = checked_level(access);
  const Index n = level.number_of_vertices();
  const Edge_constraints<Access, typename Parameters::Edge_constraint_map> edges(
    access, Parameters::edge_constraint_map(np), level.number_of_edges());
  const Vertex_constraints<Access, typename Parameters::Vertex_constraint_map> vertices(
    access, Parameters::vertex_constraint_map(np), n);
  Creases<FT> creases = Make_creases<FT>(level, parameter_or<border_t>(np, Border::surface))(
    [&](Index e) { return edges.sharpness(e); }, [&](Index v) { return vertices.sharpness(v); });
  using Value = Point_normal<FT, 3>;
  std::vector<Value> values(creases.number_of_slots);
  const std::vector<Index> extra = vertices_of_extra_slots(creases, n);
  for (Index slot = 0; slot < values.size(); ++slot)
    point_of(values[slot]) = checked_point<FT>(access, points, slot < n ? slot : extra[slot - n]);
  estimate_wedges<FT>(level, creases, values, std::vector<bool>(values.size(), false), estimate);
  const Cut_copy<FT> cut(level, creases);
  for_each_corner(level, cut.connectivity(), [&](Index h, Index slot) {
    const Coordinates<FT, 3>& m = values[slot].normal;
    put(normals, access.halfedge_at(h), Normal(m[0], m[1], m[2]));
    if constexpr (is_of_corners)
      put_roundness(roundness, access.halfedge_at(h), values[slot].roundness);
  });
  if constexpr (!is_of_corners) {
    for (Index slot = n; slot < values.size(); ++slot) {
      FT& of_vertex = values[extra[slot - n]].roundness; // no wedge is rounder than it is
      of_vertex = (CGAL::min)(of_vertex, values[slot].roundness);
    }
    for (Index v = 0; v < n; ++v) put_roundness(roundness, access.vertex(v), values[v].roundness);
  }
}

// puts normals and roundness of vertices into maps
template <class Access, class PolygonMesh, class Normal_map, class Roundness_map,
          class NamedParameters>
void estimate_vertex_normals(const Access& access, const PolygonMesh& mesh,
                             const Normal_map& normals, const Roundness_map& roundness,
                             const NamedParameters& np)
{
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  using Normal = typename boost::property_traits<Normal_map>::value_type;
  const Level_connectivity level = checked_level(access);
  const Control_normal_estimate estimate =
    parameter_or<control_normal_estimate_t>(np, Control_normal_estimate::coherent);
  const auto values = read_values<PN_average<FT, 3>>(
    access, level, Parameters::const_point_map(mesh, np), Not_given(), estimate);
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v) {
    const Coordinates<FT, 3>& n = values[v].normal;
    put(normals, access.vertex(v), Normal(n[0], n[1], n[2]));
    put_roundness(roundness, access.vertex(v), values[v].roundness);
  }
}

// puts normals, and the roundness of an estimate, into maps of vertices or of half-edges
template <class PolygonMesh, class Normal_map, class Roundness_map, class NamedParameters>
void estimate_into(const PolygonMesh& mesh, const Normal_map& normals,
                   const Roundness_map& roundness, const NamedParameters& np)
{
  if constexpr (check_estimation_arguments<PolygonMesh, Normal_map, NamedParameters>())
    with_mesh_access(mesh, [&](const auto& access) {
      if constexpr (has_corner_normals_v<std::decay_t<decltype(access)>, Normal_map>)
        estimate_corner_normals(access, mesh, normals, roundness, np);
      else
        estimate_vertex_normals(access, mesh, normals, roundness, np);
    });
}

// the estimate of a call: of corners where it tells what is sharp
template <class PolygonMesh, class NamedParameters>
using Estimate_of_call = Estimated_control_normals<
  std::conditional_t<is_given_v<internal_np::edge_is_constrained_t, NamedParameters> ||
                       is_given_v<internal_np::vertex_is_constrained_t, NamedParameters> ||
                       is_given_v<border_t, NamedParameters>,
                     typename boost::graph_traits<PolygonMesh>::halfedge_descriptor,
                     typename boost::graph_traits<PolygonMesh>::vertex_descriptor>,
  typename Surface_parameters<PolygonMesh, NamedParameters>::Geom_traits>;

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

estimates control normals from the points of a mesh, and the roundness at each of its vertices. Passed on unchanged,
they give the surface without a `vertex_normal_map`. A normal that is put in the place of an estimate changes the
surface there.
\code{.cpp}
auto normals = PN::estimate_control_normals(mesh);
put(normals, v, Vector(0, 0, 1));
PN::subdivide(mesh, scheme, params::vertex_normal_map(normals));
\endcode
The normals are exact, up to rounding, for points on a sphere in any arrangement that turns by less than 36 degrees
from vertex to face. They are exact, too, for points on a cylinder, a cone or a torus at the crossings of parallels
and straight or circular meridians, as quads or triangulated. \ref PN_subdivision_3_control_normals "The manual"
compares the estimates.

<b>Coherent.</b> Two normals are at hand: at an interior vertex r, the reciprocal one (below), which fits a
sphere, and a, the unit sum of the area vectors of its faces, which fits a box. With the edges \f$ e_j \f$ of the
vertex, the reciprocal normals \f$ r_j \f$ of its neighbors and S the smoothstep function, 0 below 0 and 1 above 1,

\f[ E(n) = \sum_j \left( \frac{(n + r_j) \cdot e_j}{|e_j|^2} \right)^2, \quad x = \frac{E(a)}{E(r) + E(a)}, \quad
t = S \left( \frac{x - 0.2}{0.3} \right) \f]

says which of the two is on arcs with the neighbors: on spheres and cylinders E(r) = 0 and t = 1, where a plane joins
a bend t = 0. Let c(n) be the smallest cosine of the angles between n and the cross products of neighboring edges,
g(n) the largest \f$ |(n + n_j) \cdot e_j| / |e_j| \f$, and

\f[ f(n) = S \left( \frac{c(n) - \cos 45^\circ}{\cos 36^\circ - \cos 45^\circ} \right), \quad
\rho = \left( 1 - S \left( \frac{|r - a| - 0.1}{0.2} \right) \right) \left( 1 - S \left( \frac{g(r) - 0.1}{0.2}
\right) \right) S ( 12 q - 1 ) \f]

with the length q of the shortest edge over that of the longest one,
1 if the vertex turns no more than a regular pentagon and 0 if it turns as two planes at a right angle do. It is also
1 if a coarse mesh is regular, as a cube is. The normal is the unit vector of s r + (1 - s) a with s = t (f(r) + (1 -
f(r)) &rho;), the reciprocal one itself where s = 1. The roundness is

\f[ w' = \left( f(n) + (1 - f(n)) \rho \right) \left( 1 - S \left( \frac{d}{8} - 1 \right) \right), \quad
d = \frac{\max_j |n \cdot e_j|}{\min_j |e_j|}, \f]

since a plane that ends in a short chamfer looks like a cap of a large sphere. Moreover, a
vertex without an arc to a neighbor that is not round is not round either:

\f[ w = w' \min_j \left( 1 - (1 - w'_j) \, S \left( \frac{g_j - 0.3}{0.3} \right) \right), \quad g_j = |(n + n_j)
\cdot e_j| \left( \frac{1 - u_j}{|e_j|} + \frac{u_j}{s_j} \right) \f]

with \f$ s_j \f$ and \f$ l_j \f$, the lengths of the shortest and the longest edge of the neighbor, and \f$ u_j = \min(1,
\max(0, l_j / s_j - 6)) \f$; where two points coincide \f$ g_j = 1 \f$.

Next, where a large plane ends in short bevels the point of an interior vertex must not be lifted off the plane. The
vertex has m edges, s and l are the lengths of the shortest and the longest one, and the weights are 3/8 for the
neighbors and 5/8 for the vertex. Let \f$ q = \frac{3}{8m} \sum_j e_j \f$ be the way of the linear point, u the unit
vector of \f$ \frac{5}{8} n + \frac{3}{8m} \sum_j n_j \f$, and

\f[ h = n \cdot (q + H u), \quad H = \frac{3}{8m} \sum_j \frac{(n_j + u) \cdot (e_j - q)}{1 + n_j \cdot u} -
\frac{5}{8} \, \frac{(n + u) \cdot q}{1 + n \cdot u} \f]

the height of the new point over the tangent plane (negative cosines in the denominators count as 0). By o, what it lies above this plane
and all neighbors, or below them all, the roundness is multiplied by \f$ 1 - S(2 o \, (l - 4s) / s^2 - 1) \f$ where l > 4s. On spheres and
cylinders o = 0.

Last, new points are not to fold long and narrow faces. Over the mean q of the m corners of a face, with the unit vector u of
\f$ \sum_i n_i \f$, the lengths s (taken as at least l/1024) and l of its shortest and its longest edge,

\f[ h_i = \frac{(n_i + u) \cdot (p_i - q)}{1 + \max(0, n_i \cdot u)}, \quad x = \frac{\min(1, \max(0, l / s - 6))}{m s}
\sum_i |h_i - \bar h| \f]

tells how far the arcs from the corners miss each other there: not at all on spheres and cylinders. The roundness of the
corners is multiplied by \f$ 1 - S(5 x - 1) \f$, with the largest x of the faces of a vertex.

At a border vertex r and n are the normal of the reciprocal estimate. If one of r and a vanishes the other one is
taken for both; if E(r) is no more than rounding, t = 1. The roundness is 0 where the normal vanishes and 1 at
vertices without edges. The other estimates find everything round, w = 1.

<b>Reciprocal.</b> At an interior vertex, with its edges \f$ e_i \f$ in order and \f$ W_i =
e_i/|e_i|^2 \f$, the unit vector of \f$ \sum_i W_i \times W_{i+1} \f$ (N. Max, <em>Weights for
computing vertex normals from facet normals</em>, 1999). At a border vertex it is a unit vector orthogonal to the
circle through the vertex and its two neighbors on the border. It best fulfils \f$ (n + n_j) \cdot e_j = 0 \f$, the
condition that an arc joins the two points, for the neighbors whose normals are known. These are the interior ones, or
else those on the border that have interior ones themselves. A normal may not be determined so: there is no such
neighbor, the border folds back, or the result is turned by more than 73 degrees. Then it is the unit vector of \f$
\sum_i W_i \times W_{i+1} \f$ over the faces of the vertex.

Those of `Control_normal_estimate::reciprocal` fit a curved surface, and a box only with a ball around it. Hence let
\f$ \alpha \f$ be the largest angle between the normal and the cross product of two neighboring edges, zero products
left out. If this is below 60 degrees, the area vector of the face between the edges counts if it is closer. Up to 40
degrees the normal is as above. From 60 degrees on it is the angle-weighted one, and so it is if the sum vanishes: if
it is shorter than 2<sup>12</sup> times the machine epsilon times the sum of the lengths of its terms. In between both
are mixed, smoothly in \f$ \cos\alpha \f$. Edges of length zero are left out.

<b>Angle.</b> (Yang, <em>Point-Normal Subdivision Curves and Surfaces</em>, Section 6.) The unit vector of the sum of the normals of the faces, weighted by the angles of the
faces at the vertex. The normal of a polygon that is not planar is that of its area vector; the angle
at a corner is the angle between its two edges. Faces without area add nothing, nor do those that
would have none if their coordinates were not rounded.

A vertex without faces, or one at which the sum vanishes, gets the zero vector, "no control normal".

<b>Corners.</b> For meshes with creases there is a normal for every corner of a face: those that `subdivide()`
takes for the wedges of vertices between sharp edges where none are given. The normals of a wedge are estimated from its
faces alone, then made orthogonal to the tangents of the creases beside it, which come from the points along the creases.
Corners of one wedge get the same normal. With all edges of a straight prism sharp but those along its sides, the normals
are those of the cylinder through its points, and of its flat ends. A wedge is at most as round as the creases beside it.

<b>Number types.</b> In exact number types the reciprocal normals of interior vertices have their exact direction if s
= 1 or \f$ \alpha \f$ is at most 40 degrees. In multiprecision types they are as precise as the type. So are
angle-weighted normals if the type has its own `atan2()` (`Gmpfr`, Boost's floats). Everything else (the choice
between the two, its weights, borders, areas, angles, roundness) is computed in `double` from the differences of the
points; `float` is widened to `double`.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `geom_traits`,
  `edge_is_constrained_map`, `vertex_is_constrained_map` and `border` as in `subdivide()`, and `control_normal_estimate`

\returns an `Estimated_control_normals`, a property map that `vertex_normal_map` takes and that carries the roundness: of vertices or,
  if one of the parameters that tell what is sharp is given, of half-edges

\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border, a point is
  not finite, or a sharpness is negative or not a number
<br><b>Cost:</b> linear in the size of the mesh
*/
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::are_named_parameters_v<NamedParameters>, int> = 0>
auto estimate_control_normals(const PolygonMesh& mesh,
                              const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::control_normal_estimate_t,
                           internal::border_t>();
  if constexpr (internal::check_is_point_map<PolygonMesh, NamedParameters>()) {
    internal::Estimate_of_call<PolygonMesh, NamedParameters> estimate;
    internal::estimate_into(mesh, internal::normals_of<false, true>(estimate),
                            estimate.roundness_map(), np);
    return estimate;
  }
}

/*!
\ingroup PkgPNSubdivision3Functions

writes estimated control normals, as `estimate_control_normals()` returns them, into a map of one's own. *They do not know how round the
surface is:* where such a map is given to `subdivide()`, and no roundness beside it, that is 1.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam VertexNormalMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%vertex_descriptor` or `%halfedge_descriptor` as key type and a `Vector_3` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param normals the map to write, of vertices or of half-edges. A half-edge with a face gets the normal of the corner
  of that face at the target. If the map throws, some normals may have been written
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as of the other form, and
  `parameters::vertex_roundness_map()` with a model of `WritablePropertyMap` whose values are numbers: the roundness is written into it

\throws std::invalid_argument as the other form; nothing has been written then
*/
template <class PolygonMesh, class VertexNormalMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::are_named_parameters_v<VertexNormalMap>, int> = 0>
void estimate_control_normals(const PolygonMesh& mesh, VertexNormalMap normals,
                              const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::control_normal_estimate_t, internal::border_t,
                           internal::vertex_roundness_map_t>();
  using Given = internal::Parameter_type<internal::vertex_roundness_map_t, NamedParameters>;
  const auto written = internal::normals_of<false, true>(normals);
  if constexpr (internal::Check_map<internal::vertex_roundness_map_t>::check<
                  Given, PolygonMesh, NamedParameters, internal::Writable>()) {
    if constexpr (internal::is_there_v<Given>)
      internal::estimate_into(
        mesh, written, parameters::get_parameter(np, internal::vertex_roundness_map_t()), np);
    else
      internal::estimate_into(mesh, written, internal::roundness_of<true>(normals), np);
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H
