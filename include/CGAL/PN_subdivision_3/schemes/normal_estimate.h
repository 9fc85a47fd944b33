// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_NORMAL_ESTIMATE_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_NORMAL_ESTIMATE_H

#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Functions
/// How control normals are estimated from the points of a mesh, see `estimate_control_normals()`.
enum class Control_normal_estimate {
  coherent,   ///< the reciprocal ones where they fit, area-weighted ones elsewhere, and roundness
  reciprocal, ///< exact on spheres and on grids on cylinders, cones and tori, borders included
  angle       ///< the normals of the faces weighted by their angles
};

/*!
\ingroup PkgPNSubdivision3Schemes
A scheme with the estimate of control normals that it uses for meshes without any, made by
`with_normal_estimate()`.
*/
template <class Scheme>
struct Scheme_with_normal_estimate : Scheme_adaptor<Scheme>
{
  /// how normals are estimated.
  std::optional<Control_normal_estimate> normal_estimate() const { return estimate; }

  /// how normals are estimated.
  Control_normal_estimate estimate;
};

/*!
\ingroup PkgPNSubdivision3Schemes
returns the scheme with a choice of how control normals are estimated if the mesh comes without a
`vertex_normal_map`; without this adaptor it is `Control_normal_estimate::coherent`. The adaptors
can be nested in any order; of two nested choices the outer one counts. With `linear()` the choice
has no effect, since there are no normals.
*/
template <class Scheme, class = typename Scheme::Host>
Scheme_with_normal_estimate<Scheme> with_normal_estimate(const Scheme& scheme,
                                                         Control_normal_estimate estimate)
{
  return {{scheme}, estimate};
}

namespace internal {

template <class Scheme, class = void>
struct States_normal_estimate : std::false_type
{};
template <class Scheme>
struct States_normal_estimate<
  Scheme, std::void_t<decltype(std::declval<const Scheme&>().normal_estimate())>> : std::true_type
{};

template <class Scheme, class Normal_scheme>
std::optional<Control_normal_estimate>
stated_normal_estimate(const Scheme_with_normals<Scheme, Normal_scheme>& scheme);

// what a scheme or an adaptor says about the estimate, if anything
template <class Scheme>
std::optional<Control_normal_estimate> stated_normal_estimate(const Scheme& scheme)
{
  if constexpr (States_normal_estimate<Scheme>::value)
    return scheme.normal_estimate();
  else if constexpr (Is_adaptor<Scheme>::value)
    return stated_normal_estimate(scheme.scheme);
  else
    return std::nullopt;
}

// of the two schemes for points and normals the one for normals is asked first
template <class Scheme, class Normal_scheme>
std::optional<Control_normal_estimate>
stated_normal_estimate(const Scheme_with_normals<Scheme, Normal_scheme>& scheme)
{
  const auto stated = stated_normal_estimate(scheme.normal_scheme);
  return stated ? stated : stated_normal_estimate(scheme.scheme);
}

template <class Scheme>
Control_normal_estimate normal_estimate(const Scheme& scheme)
{
  return stated_normal_estimate(scheme).value_or(Control_normal_estimate::coherent);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_NORMAL_ESTIMATE_H
