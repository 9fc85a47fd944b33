// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_SHIPPED_SCHEMES_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_SHIPPED_SCHEMES_H

#include <CGAL/PN_subdivision_3/schemes/Bilinear_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Midpoint_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
A list of scheme types.
*/
template <class... Schemes>
struct Scheme_list
{
  /// the number of schemes.
  static constexpr std::size_t size = sizeof...(Schemes);

  /// `Template` of the schemes, for instance `%apply<std::variant>`.
  template <template <class...> class Template>
  using apply = Template<Schemes...>;

  /// calls `f(scheme)` with an object of each scheme, in the order of the list. It has the default
  /// parameters.
  template <class Function>
  static void for_each(const Function& f)
  {
    (f(Schemes()), ...);
  }
};

/*!
\ingroup PkgPNSubdivision3Schemes
The schemes that the package provides, each with its `name()`. A scheme that is added here is known to the
command `pn_subdivide` and to the tests.
*/
using Shipped_schemes =
  Scheme_list<CatmullClark_scheme, Kobbelt_scheme, Loop_scheme, Butterfly_scheme, DooSabin_scheme,
              Sqrt3_scheme, CatmullClark_scheme::Tuned, Loop_scheme::Tuned,
              CatmullClark_scheme::Transfer, Loop_scheme::Transfer, Midpoint_scheme,
              Bilinear_scheme>;

/// \ingroup PkgPNSubdivision3Schemes
/// calls `f(scheme)` with an object of each of the `Shipped_schemes`. It has the default parameters.
template <class Function>
void for_each_shipped_scheme(const Function& f)
{
  Shipped_schemes::for_each(f);
}

/// \ingroup PkgPNSubdivision3Schemes
/// whether a scheme has a parameter, a number that its constructor takes. Such a scheme has a
/// `parameter_name()` and a `default_parameter()`; its constructor throws `std::invalid_argument` with the
/// range of the parameter if the number is out of it.
template <class Scheme>
constexpr bool has_parameter_v = std::is_constructible_v<Scheme, double>;

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_SHIPPED_SCHEMES_H
