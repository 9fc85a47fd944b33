// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_PARAMETERS_PARAMETERS_H
#define CGAL_PN_SUBDIVISION_3_PARAMETERS_PARAMETERS_H

#include <CGAL/PN_subdivision_3/internal/package_parameters.h>

#include <functional>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Schemes
/// what becomes of the border of a surface.
enum class Border {
  /// the border belongs to the surface: its points stay on a sphere or cylinder on which the data
  /// lie. A circular border does not stay a circle.
  surface,
  /// the border is a crease with the surface on one side: circles stay circles.
  curve,
  /// as `curve`, and border vertices with a single face are corners.
  corners,
  /// all border vertices stay where they are, and border edges are split in their midpoints.
  fixed
};

/// \ingroup PkgPNSubdivision3Functions
/// How control normals are estimated from the points of a mesh, see `estimate_control_normals()`.
enum class Control_normal_estimate {
  coherent,   ///< the reciprocal ones where they fit, area-weighted ones elsewhere, and roundness
  reciprocal, ///< exact on spheres and on grids on cylinders, cones and tori, borders included
  angle       ///< the normals of the faces weighted by their angles
};

/// \ingroup PkgPNSubdivision3Functions
/// The named parameters of \cgal, and those of this package. Each of the latter begins a pack, to which others of them and
/// those of \cgal can be appended; `join()` joins packs.
/// \code{.cpp}
/// subdivide(mesh, scheme, parameters::roundness(0.5).border(Border::curve).number_of_iterations(3));
/// \endcode
namespace parameters {

using namespace CGAL::parameters;

/// \addtogroup PkgPNSubdivision3Functions
/// @{

/*!
the roundness of all control vertices: 1 is the point-normal scheme, 0 gives the points of the linear one, with a
continuous transition, see `PN_average`.
\param x a number from 0 to 1
*/
template <class FT>
auto roundness(const FT& x);

/*!
the roundness of each control vertex. A map that can be written gets that of the refined vertices, so that further calls continue
from there.
\param map a model of `ReadablePropertyMap` or `ReadWritePropertyMap` with the vertices of the mesh as keys and
  numbers from 0 to 1 as values. Values up to 1/2 beyond are accepted, since masks with negative weights refine 0 and
  1 to values slightly beyond
*/
template <class VertexRoundnessMap>
auto vertex_roundness_map(const VertexRoundnessMap& map);

/*!
how control normals are estimated where none are given, by default `Control_normal_estimate::coherent`.
\param estimate a `Control_normal_estimate`
*/
template <class Estimate>
auto control_normal_estimate(const Estimate& estimate);

/*!
how the border of the surface is treated, by default `Border::surface`. Anything else needs a scheme with rules for creases.
\param rule a `Border`
*/
template <class BorderRule>
auto border(const BorderRule& rule);

/*!
a map of the tangents of creases. The map has zero vectors but for both half-edges of a sharp edge, also for the one
on the border. It holds the unit tangent of the crease at the source of the half-edge, in the direction of the
half-edge.

`subdivide()` reads the nonzero tangents and computes missing ones from the points and the
given normals. Afterwards the map, if it can be written, holds the tangents of the refined creases. A
call with k rounds is then the same, bit for bit, as k calls with one round if they are given the normals
by half-edges, too.

At a vertex on a crease (two sharp edges, no corner) both tangents have opposite directions. A missing one is the
opposite of the other one. If two are given that are not opposite, the crease takes the direction of their difference.
Tangents are taken as they are, whatever the normals beside them: a tangent that is not orthogonal to these tilts
them. Vectors shorter than 1 are allowed and are not normalized, since `subdivide()` leaves such vectors if the
control data hardly define a tangent. If they define none, or one shorter than 10<sup>-6</sup>, it leaves zero, and
the next call makes the tangent anew. With `Border::fixed` the tangents of the border are zero. A linear scheme
neither reads nor writes tangents.

Tangents that are not finite, longer than 1 by more than rounding, or shorter than 10<sup>-6</sup> but not zero are refused:
the values of a map that has not been set are of this kind.
\param map a model of `ReadablePropertyMap` with `boost::graph_traits<PolygonMesh>::%halfedge_descriptor` as key type and
  `geom_traits::Vector_3` as value type; if it is a `ReadWritePropertyMap` the refined tangents are put
*/
template <class HalfedgeVectorMap>
auto crease_tangent_map(const HalfedgeVectorMap& map);

/*!
into how many pieces `Surface_pieces` divides a surface, by default 1.
\param n at least 1
*/
template <class Number>
auto number_of_pieces(const Number& n);

/*!
the largest error of a limit point, as a part of the largest side of the bounding box of the points. The default is
10<sup>-9</sup> for limits, where it is estimated, and 10<sup>-12</sup> for interpolation and prescribed data.
\param x a `double` that is not negative
*/
template <class Real>
auto tolerance(const Real& x);

/*!
the largest estimated error of a surface normal or of the tangent of a curve, in radians, by default 10<sup>-3</sup>.
\param x a `double` that is not negative
*/
template <class Real>
auto normal_tolerance(const Real& x);

/*!
the most rounds of refinement about a vertex that a limit takes, by default 12.
\param n an `unsigned`
*/
template <class Number>
auto max_depth(const Number& n);

/*!
a map that gets the limit points that `limit_points()` computes.
\param map a model of `WritablePropertyMap` from vertices (of a dual scheme, faces) to points
*/
template <class Map>
auto limit_point_map(const Map& map);

/*!
a map that gets the normals that `limit_points()` computes: `Limit_point::surface_normal`, which are the limits of the control normals
unless `surface_normals()` asks for others.
\param map a model of `WritablePropertyMap` from vertices (of a dual scheme, faces) to vectors
*/
template <class Map>
auto limit_normal_map(const Map& map);

/*!
a map that gets the estimated errors of the limit points that `limit_points()` computes.
\param map a model of `WritablePropertyMap` from vertices (of a dual scheme, faces) to `double`
*/
template <class Map>
auto limit_error_map(const Map& map);

/*!
whether limit points of surfaces are computed, by default `true`. Without them, surface normals take much less time. A
vertex with a surface normal may then have the first averages of the limit mask as `Limit_point::point` and
`Limit_point::control_normal`. Its `Limit_point::error` is infinite, and neither counts in the report. The normal is
on the side of the faces of the control mesh. Functions that move a mesh then leave the points where they are.
\param yes a `bool`
*/
template <class Yes>
auto points(const Yes& yes);

/*!
whether limits have the normals of the surface; by default they have the limits of the control normals.
\param yes a `bool`
*/
template <class Yes>
auto surface_normals(const Yes& yes);

/*!
whether the limits of a curve have its tangents and normals; by default they have not.
\param yes a `bool`
*/
template <class Yes>
auto curve_normals(const Yes& yes);

/*!
whether limits have curvatures, where they exist; by default they have not.
\param yes a `bool`
*/
template <class Yes>
auto curvatures(const Yes& yes);

/*!
how many rounds the call that made the mesh has done, by default 0. The borders of \f$ \sqrt{3} \f$ depend on whether
that is even, and modified schemes on whether it is before their first round; others do not.
\param n an `unsigned`
*/
template <class Number>
auto rounds_done(const Number& n);

/*!
whether the vertices of `Surface_pieces` are moved to the limit surface, as by `subdivide_to_limit()`, by default not. Then
`points`, `surface_normals`, `tolerance`, `normal_tolerance` and `max_depth` say what is computed, and how accurately.
\param yes a `bool`; what limits need is compiled if the parameter is given
*/
template <class Yes>
auto to_limit(const Yes& yes);

/*!
whether the distance of the triangles of `tessellate()` from the surface is proved, by default not.
\param yes a `bool`; code for proofs is compiled if the parameter is given
*/
template <class Yes>
auto proven_bound(const Yes& yes);

/*!
how vertices are interpolated, by default `Limit_interpolation::Mode::slide`.
\param mode a `Limit_interpolation::Mode`
*/
template <class Mode>
auto interpolation_mode(const Mode& mode);

/*!
where the control normals of an interpolating surface or curve come from, by default `Limit_interpolation::Normals::given`.
\param normals a `Limit_interpolation::Normals`
*/
template <class Normals>
auto interpolation_normals(const Normals& normals);

/*!
what becomes of vertices that are not interpolated, by default `Limit_interpolation::Free::fixed`.
\param free a `Limit_interpolation::Free`
*/
template <class Free>
auto free_vertices(const Free& free);

/*!
which vertices `interpolate_limit_points()` interpolates; by default all.
\param map a model of `ReadablePropertyMap` from vertices to `bool`
*/
template <class VertexMap>
auto vertex_is_interpolated_map(const VertexMap& map);

/*!
the most steps of an interpolation, of which each moves the points once, by default 100.
\param n an `unsigned`
*/
template <class Number>
auto max_steps(const Number& n);

/*!
the limit points that `prescribe_limit_data()` prescribes; by default none.
\param map a model of `ReadablePropertyMap` from vertices to `std::optional` of a point
*/
template <class VertexMap>
auto prescribed_point_map(const VertexMap& map);

/*!
the surface normals that `prescribe_limit_data()` prescribes; by default none.
\param map a model of `ReadablePropertyMap` from vertices to `std::optional` of a vector of any length
*/
template <class VertexMap>
auto prescribed_normal_map(const VertexMap& map);

/*!
the curvatures that `prescribe_limit_data()` prescribes; by default none.
\param map a model of `ReadablePropertyMap` from vertices to `std::optional` of a `Prescribed_curvature`
*/
template <class VertexMap>
auto prescribed_curvature_map(const VertexMap& map);

/*!
within how many rings of faces about the vertices with prescribed data control points move, by default 2.
\param n an `unsigned`
*/
template <class Number>
auto rings(const Number& n);

/*!
by how much curvatures may miss the prescribed ones, times the largest side of the bounding box of the points, by
default 10<sup>-6</sup>.
\param x a `double` that is not negative
*/
template <class Real>
auto curvature_tolerance(const Real& x);

/*!
the most steps towards prescribed curvatures, by default 12.
\param n an `unsigned`
*/
template <class Number>
auto max_curvature_steps(const Number& n);

/*!
whether `CatmullClark_subdivision()` and `Loop_subdivision()` are the modified schemes, with other eigenvalues at separated extraordinary vertices,
where curvature is then bounded. By default they are not.
\param yes a `bool`
*/
template <class Yes>
auto tuned(const Yes& yes);

/*!
whether `CatmullClark_subdivision()` and `Loop_subdivision()` transfer curvature to the normals at extraordinary vertices, on top of what
`tuned()` does. By default they do not.
\param yes a `bool`
*/
template <class Yes>
auto curvature_transfer(const Yes& yes);

/*!
the least number of facets a full turn for which `recognize_surfaces()` takes a prism for round if nothing else in the
part indicates it, by default 8.
\param n at least 3
*/
template <class Number>
auto min_facets(const Number& n);

/*!
how far vertices may be from the surface that `recognize_surfaces()` takes them to be on, by default what the rounding of the
coordinates and the size of the mesh make of it, see there.
\param x a positive length
*/
template <class FT>
auto surface_tolerance(const FT& x);

/*!
the angle in degrees from which on `surface_creases()` makes edges between facets of no recognized surface sharp, by default 30.
\param degrees from 0 to 180
*/
template <class FT>
auto sharp_angle(const FT& degrees);

/// @}

// all of the above
#define CGAL_PN_SUBDIVISION_3_FUNCTION(X)                                                          \
  template <class T>                                                                               \
  auto X(const T& value)                                                                           \
  {                                                                                                \
    return internal::with_parameter<internal::X##_t>(value);                                       \
  }
CGAL_PN_SUBDIVISION_3_OWN_PARAMETERS(CGAL_PN_SUBDIVISION_3_FUNCTION)
#undef CGAL_PN_SUBDIVISION_3_FUNCTION

/*!
\ingroup PkgPNSubdivision3Attributes
the attributes to be refined: any number of the results of `vertex_attribute()` and the other functions of `attributes.h`.
*/
template <class... Items>
auto attributes(const Items&... items)
{
  return internal::with_parameter<internal::attributes_t>(
    internal::Attributes<Items...>{{items...}});
}
/// \cond SKIP_IN_MANUAL
template <class... Items>
auto attributes(const internal::Attributes<Items...>& items)
{
  return internal::with_parameter<internal::attributes_t>(items);
}
/// \endcond
/// \ingroup PkgPNSubdivision3Attributes
/// a table that is only read, by a `Surface_refiner`.
inline auto attributes(const Attribute_table& table)
{
  return internal::with_parameter<internal::attributes_t>(std::cref(table));
}
/// \ingroup PkgPNSubdivision3Attributes
/// a table of attributes, which is read and changed.
inline auto attributes(Attribute_table& table)
{
  return internal::with_parameter<internal::attributes_t>(std::ref(table));
}

/*!
\ingroup PkgPNSubdivision3Functions
marks a pack whose parameters are for several functions, each of which reads some of them. Otherwise a function refuses, when it is
compiled, parameters of this package that it does not read.
\code{.cpp}
const auto np = parameters::shared(parameters::border(Border::curve).tolerance(1e-9));
subdivide(mesh, scheme, np); // without the tolerance
limit_points(mesh, scheme, limits, np);
\endcode
*/
template <class NamedParameters>
auto shared(const NamedParameters& np)
{
  return internal::with_parameter<internal::is_shared_t>(true, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
returns one pack of the parameters of several, this package's and \cgal's in any order. If two packs have a parameter,
the first one counts.
\code{.cpp}
const auto np = parameters::join(CGAL::parameters::number_of_iterations(3), parameters::roundness(0.5));
\endcode
*/
template <class T, class Tag, class Base, class NamedParameters>
auto join(const Named_function_parameters<T, Tag, Base>& first, const NamedParameters& second)
{
  const T& value = internal::value_of(first);
  if constexpr (std::is_same_v<Base, internal_np::No_property>)
    return internal::with_parameter<Tag>(value, second);
  else
    return internal::with_parameter<Tag>(value,
                                         parameters::join(static_cast<const Base&>(first), second));
}
/// \ingroup PkgPNSubdivision3Functions
/// joins more than two.
template <class First, class Second, class Third, class... NamedParameters>
auto join(const First& first, const Second& second, const Third& third,
          const NamedParameters&... others)
{
  return parameters::join(first, parameters::join(second, third, others...));
}

} // namespace parameters
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_PARAMETERS_PARAMETERS_H
