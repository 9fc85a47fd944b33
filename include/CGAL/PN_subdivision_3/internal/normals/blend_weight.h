// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_BLEND_WEIGHT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_BLEND_WEIGHT_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/normals/Inverted_fan.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What share a reciprocal or border normal n, a unit vector, has beside the angle-weighted one: all
// if no corner of the fan with an area is turned more than 40 degrees away from n, nothing from 60
// degrees on or if no corner has an area.
template <class FT>
double blend_weight(const Coordinates<double, 3>& n, const Inverted_fan<FT>& fan)
{
  constexpr double cos_40 = 0.76604444311897803520, cos_60 = 0.5;
  double least = 2;
  for (const auto& corner : fan.corners()) {
    if (!corner.has_area) continue;
    const double d = dot<double, 3>(n, corner.normal);
    least = (std::min)(least, d > 0 && d * d >= cos_40 * cos_40 * corner.squared
                                ? 1
                                : d / std::sqrt(corner.squared));
  }
  if (least > 1) return 0;
  const double x = (std::min)(1., (std::max)(0., (least - cos_60) / (cos_40 - cos_60)));
  return x * x * (3 - 2 * x);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_BLEND_WEIGHT_H
