// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SCHEME_H
#define PN_SUBDIVIDE_SCHEME_H

#include "surface/surface_schemes.h"

#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>

#include <string>
#include <type_traits>
#include <variant>

namespace pn_subdivide {

using Scheme = CGAL::PN_subdivision_3::Shipped_schemes::apply<std::variant>;

// The scheme of this name with the parameters of the choice. Throws Usage_error, which begins with the
// option, if there is none, or if a parameter is out of range.
Scheme make_scheme(const std::string& option, const std::string& name, const Scheme_choice& choice);

template <class S, class T>
constexpr bool have_same_host = std::is_same_v<typename S::Host, typename T::Host>;
template <class S, class = void>
struct Transfers_curvature : std::false_type
{};
template <class S>
struct Transfers_curvature<S, std::void_t<decltype(S::transfers_curvature)>>
  : std::bool_constant<S::transfers_curvature>
{};
// Can one give the normals of the other, which is another scheme?
template <class S, class T>
constexpr bool go_together = have_same_host<S, T> && !std::is_same_v<S, T> &&
                             !Transfers_curvature<S>::value && !Transfers_curvature<T>::value;

template <class S, class = void>
struct Can_crease : std::false_type
{};
template <class S>
struct Can_crease<S, std::void_t<decltype(S::has_crease_rules)>>
  : std::bool_constant<S::has_crease_rules>
{};
// Has it rules for creases?
template <class S>
constexpr bool can_crease = Can_crease<S>::value;

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SCHEME_H
