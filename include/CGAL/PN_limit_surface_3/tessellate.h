// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_TESSELLATE_H
#define CGAL_PN_LIMIT_SURFACE_3_TESSELLATE_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Tessellation.h>
#include <CGAL/PN_limit_surface_3/tessellation/Tessellation_result.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

namespace internal {

// the table of attributes of a call, or null
template <class NamedParameters>
Attribute_table* attribute_table(const NamedParameters& np)
{
  if constexpr (!is_given_v<attributes_t, NamedParameters>)
    return nullptr;
  else {
    using Given = Parameter_type<attributes_t, NamedParameters, Not_given>;
    static_assert(std::is_same_v<Given, std::reference_wrapper<Attribute_table>>,
                  "PN_subdivision_3: tessellate() carries the arrays of an Attribute_table: give "
                  "parameters::attributes(table)");
    if constexpr (std::is_same_v<Given, std::reference_wrapper<Attribute_table>>)
      return &parameter_or<attributes_t>(np, 0).get();
    else
      return nullptr;
  }
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Limit

approximates the limit surface of a mesh by triangles, to a tolerance: large ones where the surface is flat,
small ones where it is curved, without cracks between them.

The vertices of the result are limit points, as from `limit_points()`, with normals of the surface. In each round only
the faces that are not flat enough are refined, with the rings of faces around them that the scheme reads, so that
time and memory are proportional to the result. Each vertex is moved to its limit once, when it is new. An edge is split
in the same way for the faces on both sides; if one of them is refined further, the triangles of the other one
include the vertices on the edge.

<b>The error.</b> The distance of the surface from the triangles of a face is estimated before they are refined, from
the limit points \f$ p_i \f$ and surface normals \f$ n_i \f$ at its corners. The height of the surface over the middle
of a chord is that of the point-normal average (`PN_average`) of its ends.
\f[ s_{ij} = \frac14\,(\tau_j-\tau_i)\cdot(p_j-p_i), \qquad \tau_i=\frac{n_i+n}{1+n_i\cdot n}, \quad
n=\frac{n_i+n_j}{|n_i+n_j|}, \f]
This height is exact on spheres and cylinders and of fourth order elsewhere. The height of a surface of second order
over a triangle is at most \f$ 4s_{12}s_{23}s_{31}/(\sum_{i<j} 2 s_is_j-\sum_i s_i^2) \f$ or the largest of the \f$
|s_{ij}| \f$. When a face is split, the distance of the new limit points from their expected places is measured; half
of it is added to the estimate of its children. At creases, corners, and where the ring has no tangent plane, there
are no surface normals. The estimate is then 0.27 to 0.45 of the distance that was measured on the parent, depending on the
limits of the control normals. On smooth surfaces a fourth of it remains. Faces of the control mesh, and children of
its polygons, always get a round, and their estimate is the measured distance. Edges on creases and borders must be as
close to their curve, which is estimated from the turns of the points of the level along it. Faces whose triangles,
with the vertices that finer neighbors put on their sides, turn out to miss the tolerance are split again. Everything
is multiplied by 1.1, at borders by 1.25. It is an estimate, not a proof.

<b>A proven bound.</b> With `parameters::proven_bound(true)` faces are split until a bound is within the tolerance.
The enclosure of `Limit_surface` bounds the distance from the limit of the linear scheme, after up to two more rounds
on the face. The linear limit lies in the hull of its Bezier points, next to an extraordinary vertex in that of
control points after up to 16 rounds. The distances of these points from the face's triangles and sides are known,
whatever vertices neighbors put on the sides. This is for coordinates in `double`, and for what
`Limit_surface::proven_bbox()` covers; it takes some milliseconds per face, and about twice as many triangles. Splits
are not undone.

<b>Surfaces bent in one direction.</b> Faces are split in both directions. In the end, a face gets the triangles with
only the vertices on its sides, if these are flat enough by the same estimate and by the distances of the vertices
inside. Sides that are straight lose their vertices, if both faces agree. So rulings of cylinders and cones stay
undivided, and planes within curved rims have few triangles, which may be long.

<b>Creases and borders</b> are those of `subdivide()`, of any sharpness. A plane stays as
coarse as the control mesh is, apart from faces with more than four corners, which are split once.

\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or `Parallel_if_available_tag`. The result is
  the same, bit for bit.
\tparam FaceGraph a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3` that splits edges and faces as Catmull-Clark or Loop do
\tparam OutputMesh a model of `MutableFaceGraph`

\param control an oriented 2-manifold with border; vertices without edges remain as they are
\param scheme the scheme
\param chord_error the largest distance between triangles and surface, in the unit of the coordinates
\param out an empty mesh, which becomes the result; the vertices of the control mesh come first
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" of the control mesh: `vertex_point_map`,
  `vertex_normal_map` with the control normals (without it they are estimated), `control_normal_estimate`, `vertex_roundness_map` or
  `roundness`, `edge_is_constrained_map`, `vertex_is_constrained_map`, `border`, `crease_tangent_map` and
  `geom_traits`, as in `subdivide()`. Further ones are `proven_bound` and `number_of_iterations`, the most rounds that
  are done about any vertex, 12 by default. The maps are read only. `attributes` of an `Attribute_table` are replaced
  by those of the result: numbers of vertices become their limits by the linear scheme. Numbers of corners are linear
  inside the control faces, as `Corner_rule::all` has them, and no other rule is known.
  `Attribute_table::face_parents` are the control faces that the triangles lie in
\param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" of the result: `vertex_point_map`
  and `vertex_normal_map`, which gets the unit normals of the surface. A map of half-edges gets those of the corners,
  which differ along creases; a map of vertices then has their mean. If the surface has no normal, the map gets the
  limit of the control normals

\returns what was reached. With as many rounds as are allowed faces that are not flat enough stay as they are. A
  tolerance for which more than \f$ 2^{31} \f$ triangles are foreseen, or that is less than \f$ 2^{-48} \f$ of the
  box, gives about 260,000 triangles. With more of them faces are split again only once. The result is complete,
  `Tessellation_result::reached` is false, and `Tessellation_result::obstacle` tells why

\throws std::invalid_argument as `limit_points()` does, and if
  - `chord_error` is not positive and finite, the scheme does not split edges, or `out` is not empty;
  - an array of attributes does not fit, belongs to edges, or to corners by another rule;
  - a bound is not proven: the message names the first vertex for which it is not, which may have coordinates so large
    that rounding alone takes more than the tolerance
\throws std::length_error,std::overflow_error,std::domain_error as `subdivide()` and `limit_points()` do; `out` stays
  empty
*/
template <class Concurrency_tag = Sequential_tag, class FaceGraph, class Scheme, class OutputMesh,
          class NamedParameters = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
Tessellation_result tessellate(const FaceGraph& control, const Scheme& scheme, double chord_error,
                               OutputMesh& out,
                               const NamedParameters& np = parameters::default_values(),
                               const NamedParametersOut& np_out = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh, internal::attributes_t,
                           internal::proven_bound_t>();
  internal::check_are_read<NamedParametersOut>();
  if constexpr (internal::adapts_scheme_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call(scheme, np, [&](const auto& s, const auto& others) {
      return tessellate<Concurrency_tag>(control, s, chord_error, out, others, np_out);
    });
  else if constexpr (internal::Is_any<Scheme>::value)
    return internal::on_host<Tessellation_result,
                             internal::Surface_call<FaceGraph, NamedParameters>>(
      scheme, [&](const auto& s) {
        return tessellate<Concurrency_tag>(control, s, chord_error, out, np, np_out);
      });
  else if constexpr (!internal::halves_edges_v<Scheme>)
    throw std::invalid_argument(internal::no_halves(scheme, "by which a tessellation is refined"));
  else {
    if (!(chord_error > 0) || !std::isfinite(chord_error))
      throw std::invalid_argument("PN_subdivision_3: the chord error is " +
                                  std::to_string(chord_error) + ": it must be positive and finite");
    if constexpr (internal::check_pieces_arguments<FaceGraph, Scheme, NamedParameters>() &&
                  internal::check_build_arguments<OutputMesh, NamedParametersOut, true>()) {
      return internal::with_mesh_access(control, [&](const auto& access) {
        return internal::with_mesh_access(out, [&](auto& out_access) {
          const internal::Tessellation<Concurrency_tag, FaceGraph, NamedParameters> tessellation(
            chord_error, np, internal::attribute_table(np));
          return tessellation(control, access, scheme, out, out_access, np_out);
        });
      });
    } else
      return {};
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_TESSELLATE_H
