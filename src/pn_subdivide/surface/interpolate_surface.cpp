// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/interpolate_surface.h"

#include "io/Error.h"
#include "surface/interpolate.h"

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace pn_subdivide {

void require_interpolation(const Scheme_choice& choice)
{
  const bool is_known = std::visit(
    [](const auto& s) {
      using S = std::decay_t<decltype(s)>;
      return can_interpolate<S> || interpolates<S>;
    },
    make_scheme("--scheme", choice.scheme, choice));
  if (!is_known)
    throw Usage_error("--interpolate: surfaces of " + choice.scheme +
                      " cannot be made to pass through points; take catmull-clark, loop or their "
                      "modified forms");
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    throw Usage_error(
      "--interpolate and --normal-scheme exclude each other: interpolation is for one "
      "scheme of points and normals");
}

#if __has_include(<Eigen/Core>)
Interpolation_report interpolate_surface(Surface& surface, const Scheme_choice& choice,
                                         const Interpolation& interpolation)
{
#  ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  interpolation.threads);
#  endif
  const Scheme scheme = make_scheme("--scheme", choice.scheme, choice);
  const std::optional<Normal_map> normals = normals_of(surface);
  return std::visit(
    [&](const auto& s) -> Interpolation_report {
      using S = std::decay_t<decltype(s)>;
      if constexpr (can_interpolate<S>)
        return normals ? Interpolating_scheme<S>::with_normals(surface, *normals, s, interpolation)
                       : Interpolating_scheme<S>::linearly(surface, s, interpolation.mode);
      else
        return {}; // the net is the data
    },
    scheme);
}
#else // parse_interpolation() has refused
Interpolation_report interpolate_surface(Surface&, const Scheme_choice&, const Interpolation&)
{
  return {};
}
#endif

} // namespace pn_subdivide
