// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/interpolate.h"

#include <CGAL/PN_subdivision_3/interpolate_limit_points.h>

namespace pn_subdivide {

// With one thread the result is the same as with several, bit for bit.
using Tag = CGAL::Parallel_if_available_tag;

Interpolation_report interpolate_linearly(Surface& surface, const Scheme& scheme,
                                          Interpolation_mode mode)
{
  CGAL::PN_subdivision_3::Limit_interpolation_options<> options;
  options.mode = mode;
  return std::visit(
    [&](const auto& s) -> Interpolation_report {
      if constexpr (can_interpolate<std::decay_t<decltype(s)>>)
        return CGAL::PN_subdivision_3::interpolate_limit_points<Tag>(
          surface, CGAL::PN_subdivision_3::linear(s), options);
      else
        return {};
    },
    scheme);
}

} // namespace pn_subdivide
