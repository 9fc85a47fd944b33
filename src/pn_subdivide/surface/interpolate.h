// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_INTERPOLATE_H
#define PN_SUBDIVIDE_INTERPOLATE_H

#include "surface/Scheme.h"
#include "surface/Surface.h"
#include "surface/interpolate_surface.h"

#include <CGAL/PN_subdivision_3.h>

#include <type_traits>

namespace pn_subdivide {

template <class S, class... Schemes>
constexpr bool is_one_of = (std::is_same_v<S, Schemes> || ...);

// Do surfaces of the scheme pass through the control points anyway?
template <class S>
constexpr bool interpolates =
  is_one_of<S, CGAL::PN_subdivision_3::Butterfly_scheme, CGAL::PN_subdivision_3::Kobbelt_scheme>;

// Are there control points for which they do?
template <class S>
constexpr bool can_interpolate =
  is_one_of<S, CGAL::PN_subdivision_3::CatmullClark_scheme, CGAL::PN_subdivision_3::Loop_scheme,
            CGAL::PN_subdivision_3::modified_CatmullClark_scheme,
            CGAL::PN_subdivision_3::modified_Loop_scheme>;

// Compiled scheme by scheme, in interpolate_SCHEME.cpp. Both with a number of threads for which the result
// is the same as with one, bit for bit.
template <class S>
struct Interpolating_scheme
{
  static Interpolation_report with_normals(Surface& surface, Normal_map normals, const S& scheme,
                                           const Interpolation& interpolation);
  static Interpolation_report linearly(Surface& surface, const S& scheme, Interpolation_mode mode);
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_INTERPOLATE_H
