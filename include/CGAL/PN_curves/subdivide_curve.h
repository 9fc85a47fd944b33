// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_SUBDIVIDE_CURVE_H
#define CGAL_PN_CURVES_SUBDIVIDE_CURVE_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_curves/curve_control_normals.h>
#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_curves/internal/Curve_subdivision.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>

#include <string>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// the vectors of the normals that are given, or those of the points, which are not looked at otherwise
template <class Points, class Normal_map>
struct Curve_vector
{
  using type = typename boost::property_traits<Normal_map>::value_type;
};
template <class Points>
struct Curve_vector<Points, Not_given>
{
  using type = typename Points::Vector;
};

// The named parameters of the curve functions.
template <class Range, class NamedParameters>
struct Curve_parameters : Curve_maps<Range, NamedParameters>
{
  using Points = Curve_points<Range, NamedParameters>;
  using typename Curve_maps<Range, NamedParameters>::Normal_map;
  using typename Curve_maps<Range, NamedParameters>::Point;
  using Vector = typename Curve_vector<Points, Normal_map>::type;
  using Geom_traits =
    typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                 typename CGAL::Kernel_traits<Point>::Kernel>::type;
  using FT = typename Geom_traits::FT;

  using Roundness = Parameter_type<roundness_t, NamedParameters>;

  static constexpr int dimension = CGAL::Ambient_dimension<Point>::value;
  static constexpr bool has_roundness = is_there_v<Roundness>;

  static FT roundness([[maybe_unused]] const NamedParameters& np)
  {
    if constexpr (has_roundness)
      return checked_roundness<FT>(FT(parameters::get_parameter(np, roundness_t())), false,
                                   [] { return std::string("all points"); });
    else
      return FT(1);
  }

  static unsigned number_of_iterations(const NamedParameters& np)
  {
    return static_cast<unsigned>(parameter_or<internal_np::number_of_iterations_t>(np, 1u));
  }
};

// Calls f(point, normal) for the points of a range, with the normals that it has or, if it has none, estimated ones. Whoever
// needs no normals gets what is there, or zero.
template <class Parameters, bool needs_normals, class Range, class NamedParameters, class Function>
void for_each_point_and_normal(const Range& polygon, [[maybe_unused]] Curve_end end,
                               const NamedParameters& np, const Function& f)
{
  const auto point_map = Parameters::point_map(np);
  if constexpr (Parameters::Points::has_normals) {
    const auto normal_map = Parameters::normal_map(np);
    for (const auto& item : polygon) f(get(point_map, item), get(normal_map, item));
  } else if constexpr (needs_normals) {
    const auto shared = PN_subdivision_3::parameters::shared(np);
    for (const auto& [point, normal] : estimate_control_normals(polygon, end, shared))
      f(point, normal);
  } else
    for (const auto& item : polygon)
      f(get(point_map, item), typename Parameters::Vector(NULL_VECTOR));
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Curves

refines a control polygon with control normals, in the plane or in space, by the point-normal form
of a univariate mask.

Points and normals sampled from a circle stay on it up to rounding, as do samples of a circular
cylinder; points on a line with equal normals stay on it. A zero vector means "no control normal
here"; vectors of other lengths are normalized once.

\tparam Range a model of `ConstRange` whose items hold a point and a normal; without property maps a
  range of `std::pair<Point, Vector>`, or of points, whose normals are estimated
\tparam Mask a model of `PNSubdivisionCurveMask`, or what `linear()` or `with_normal_mask()` makes
  of one, or a `level_dependent_mask()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param polygon the control polygon; an empty one gives an empty curve
\param mask the mask
\param end whether the polygon is closed, and if not, what happens at its ends. `Curve_end::reflect`
  is the usual choice for primal masks, `Curve_end::none` for dual ones.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the number of rounds; with 0 the result is the control polygon, with
                          normalized normals}
    \cgalParamType{unsigned int}
    \cgalParamDefault{`1`}
  \cgalParamNEnd
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map from the items of `polygon` to points}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `Point_2` or `Point_3`}
    \cgalParamDefault{`CGAL::First_of_pair_property_map`, or the items themselves}
  \cgalParamNEnd
  \cgalParamNBegin{normal_map}
    \cgalParamDescription{a property map from the items of `polygon` to control normals}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `Vector_2` or `Vector_3`}
    \cgalParamDefault{`CGAL::Second_of_pair_property_map`; if the items are no pairs, the normals of
                      `estimate_control_normals()`}
  \cgalParamNEnd
  \cgalParamNBegin{roundness}
    \cgalParamDescription{how round the curve is, see `PN_average`: 1 is the point-normal curve, 0 has the points of the
                          linear one. It is the same in all rounds; the normals do not depend on it.}
    \cgalParamType{a number from 0 to 1; `parameters::roundness()` makes the parameter}
    \cgalParamDefault{1}
    \cgalParamExtra{A linear mask ignores it.}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class; its `FT` is the number type of
                          all computations}
    \cgalParamType{a model of `Kernel`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the points and normals of the curve. From n points one round makes 2n points if the polygon is closed,
  and 2n - 1 (primal masks) or 2n - 2 (dual masks) with `Curve_end::reflect`. With `Curve_end::none` it makes as many as have
  a whole stencil, 2n - m for B-splines of degree m and 2n - 4k + 3 for 2k-point masks. Primal masks on a closed
  polygon begin with the new point of the first vertex, dual ones with the first new point on the first edge.

\throws std::invalid_argument if a point or normal is not finite (the message gives its position), the roundness is
  not from 0 to 1, or an open polygon is too short for `Curve_end::none`. Masks are refused if their coefficients do
  not sum to 1 for each parity, or if those of points and normals are not both primal or both dual with the same
  center
\throws std::length_error if a round would make more than 2<sup>32</sup> - 2 points, before the first one
\throws std::overflow_error if a new point is out of the range of a floating point type
\throws std::domain_error if an interval number type leaves a comparison undecided

<br><b>Cost:</b> linear in the size of the curve, in time and memory
*/
template <class Range, class Mask, class NamedParameters = parameters::Default_named_parameters>
auto subdivide_curve(const Range& polygon, const Mask& mask, Curve_end end,
                     const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::roundness_t>();
  using Parameters = internal::Curve_parameters<Range, NamedParameters>;
  if constexpr (internal::check_kernel<typename Parameters::Geom_traits>()) {
    internal::Curve_subdivision<typename Parameters::FT, Parameters::dimension, Mask> curve(
      mask, end, Parameters::roundness(np));
    internal::for_each_point_and_normal<Parameters,
                                        !internal::is_linear_mask_v<internal::Mask_in_round<Mask>>>(
      polygon, end, np, [&](const auto& point, const auto& normal) { curve.add(point, normal); });
    return curve.template result<typename Parameters::Point, typename Parameters::Vector>(
      Parameters::number_of_iterations(np));
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CURVES_SUBDIVIDE_CURVE_H
