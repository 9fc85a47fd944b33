// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_PARAMETERS_H
#define CGAL_PN_SUBDIVISION_3_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

struct roundness_t
{};
struct vertex_roundness_map_t
{};
struct min_facets_t
{};
struct surface_tolerance_t
{};
struct sharp_angle_t
{};
struct control_normal_estimate_t
{};
struct limit_points_t
{};
struct surface_normals_t
{};
struct limit_tolerance_t
{};

// the pack `np` with one parameter more
template <class Tag, class T, class Base>
Named_function_parameters<T, Tag, Base> with_parameter(const T& value, const Base& np)
{
  return Named_function_parameters<T, Tag, Base>(value, np);
}
template <class Tag, class T>
Named_function_parameters<T, Tag> with_parameter(const T& value)
{
  return Named_function_parameters<T, Tag>(value);
}

// the outermost value of a pack, which is a reference wrapper of the pack's own where it cannot be copied
template <class T, class Tag, class Base>
const T& value_of(const Named_function_parameters<T, Tag, Base>& np)
{
  if constexpr (std::is_copy_constructible_v<T>)
    return np.v;
  else
    return np.v.get();
}

} // namespace internal

/// \ingroup PkgPNSubdivision3Functions
/// The named parameters of \cgal, and those that are this package's own. Each of these begins a pack, which those of \cgal continue, or is added
/// to a pack that is given:
/// \code{.cpp}
/// subdivide(mesh, scheme, parameters::roundness(0.5).number_of_iterations(3));
/// subdivide(mesh, scheme, parameters::roundness(0.5, CGAL::parameters::number_of_iterations(3)));
/// \endcode
namespace parameters {

using namespace CGAL::parameters;

/*!
\ingroup PkgPNSubdivision3Functions
the roundness of all control vertices: 1 is the point-normal scheme, 0 gives the points of the linear one, and what is
between lies between, see `PN_average`.
\param x a number from 0 to 1
*/
template <class FT>
auto roundness(const FT& x)
{
  return internal::with_parameter<internal::roundness_t>(x);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class FT, class NamedParameters>
auto roundness(const FT& x, const NamedParameters& np)
{
  return internal::with_parameter<internal::roundness_t>(x, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
the roundness of each control vertex. A map that can be written gets that of the refined vertices, so that further calls go
on from there.
\param map a model of `ReadablePropertyMap` or `ReadWritePropertyMap` with the vertices of the mesh as keys and numbers from 0
  to 1 as values; up to 1/2 beyond is taken, since masks with negative weights refine 0 and 1 to what is a little beyond
*/
template <class VertexRoundnessMap>
auto vertex_roundness_map(const VertexRoundnessMap& map)
{
  return internal::with_parameter<internal::vertex_roundness_map_t>(map);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class VertexRoundnessMap, class NamedParameters>
auto vertex_roundness_map(const VertexRoundnessMap& map, const NamedParameters& np)
{
  return internal::with_parameter<internal::vertex_roundness_map_t>(map, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
the least number of facets a full turn for which `recognize_surfaces()` takes a prism for a round that nothing else about the
part tells to be one.
\param n at least 3
*/
template <class Number>
auto min_facets(const Number& n)
{
  return internal::with_parameter<internal::min_facets_t>(n);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class Number, class NamedParameters>
auto min_facets(const Number& n, const NamedParameters& np)
{
  return internal::with_parameter<internal::min_facets_t>(n, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
how far vertices may be from the surface that `recognize_surfaces()` takes them to be on.
\param x a positive length
*/
template <class FT>
auto surface_tolerance(const FT& x)
{
  return internal::with_parameter<internal::surface_tolerance_t>(x);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class FT, class NamedParameters>
auto surface_tolerance(const FT& x, const NamedParameters& np)
{
  return internal::with_parameter<internal::surface_tolerance_t>(x, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
the angle from which on edges between facets of no recognized surface are sharp.
\param degrees from 0 to 180
*/
template <class FT>
auto sharp_angle(const FT& degrees)
{
  return internal::with_parameter<internal::sharp_angle_t>(degrees);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class FT, class NamedParameters>
auto sharp_angle(const FT& degrees, const NamedParameters& np)
{
  return internal::with_parameter<internal::sharp_angle_t>(degrees, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
how control normals are estimated where none are given, in `subdivide()`, `Surface_pieces`, `estimate_control_normals()`, the functions for
limits and `compare_with_linear()`.
\param estimate a `Control_normal_estimate`; it counts before that of `with_normal_estimate()`
*/
template <class Estimate>
auto control_normal_estimate(const Estimate& estimate)
{
  return internal::with_parameter<internal::control_normal_estimate_t>(estimate);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class Estimate, class NamedParameters>
auto control_normal_estimate(const Estimate& estimate, const NamedParameters& np)
{
  return internal::with_parameter<internal::control_normal_estimate_t>(estimate, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
whether `Surface_pieces` puts the vertices on the limit surface, as `subdivide_to_limit()` does.
\param is_so a `bool`; what the pieces need for it is compiled if `limit_points` or `surface_normals` is given
*/
inline auto limit_points(bool is_so)
{
  return internal::with_parameter<internal::limit_points_t>(is_so);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class NamedParameters>
auto limit_points(bool is_so, const NamedParameters& np)
{
  return internal::with_parameter<internal::limit_points_t>(is_so, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
whether the normals of the vertices that `Surface_pieces` makes are those of the limit surface, as with
`Limit_options::surface_normals`.
\param is_so a `bool`
*/
inline auto surface_normals(bool is_so)
{
  return internal::with_parameter<internal::surface_normals_t>(is_so);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class NamedParameters>
auto surface_normals(bool is_so, const NamedParameters& np)
{
  return internal::with_parameter<internal::surface_normals_t>(is_so, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
the largest estimated error of limit points, as `Limit_options::tolerance`.
\param x a part of the largest side of the bounding box of the refined points
*/
inline auto limit_tolerance(double x)
{
  return internal::with_parameter<internal::limit_tolerance_t>(x);
}
/// \ingroup PkgPNSubdivision3Functions
/// adds it to a pack of named parameters.
template <class NamedParameters>
auto limit_tolerance(double x, const NamedParameters& np)
{
  return internal::with_parameter<internal::limit_tolerance_t>(x, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
returns one pack of the parameters of two, this package's and \cgal's in any order. Of a parameter that both have, that of the first one counts.
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

} // namespace parameters
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_PARAMETERS_H
