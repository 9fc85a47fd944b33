// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Bounding_box.h"

#include <algorithm>
#include <cmath>

namespace pn_subdivide {

Bounding_box::Bounding_box(const std::vector<Triple>& points)
  : low(points.front())
  , high(points.front())
{
  for (const Triple& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
}

double diagonal_of(const Bounding_box& box)
{
  return std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
}

} // namespace pn_subdivide
