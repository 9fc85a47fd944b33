// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_REFUSE_INTERVALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_REFUSE_INTERVALS_H

#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>

#include <stdexcept>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// of limits that are estimated
template <class FT>
void refuse_intervals()
{
  if constexpr (is_interval_v<FT>)
    throw std::invalid_argument(
      "PN_subdivision_3: limits of point-normal schemes are estimated, so that intervals around "
      "them "
      "need not contain them: take linear() of the scheme, or a number type that is no interval");
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_REFUSE_INTERVALS_H
