// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_BLEND_WEIGHT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_BLEND_WEIGHT_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/normals/Inverted_fan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What share a reciprocal or border normal n, a unit vector, has beside the angle-weighted one: all
// if no corner of the fan with an area is turned more than 40 degrees away from n, nothing from 60
// degrees on or if no corner has an area. A corner of nearly 180 degrees is turned far on a smooth
// shape, too; that of a polygon, up to 60 degrees, is turned no more than the polygon is. (From there
// to 90 degrees this fades out: reflex corners stay what they are.)
template <class FT, class Face_normal_of>
double blend_weight(const Coordinates<double, 3>& n, const Inverted_fan<FT>& fan,
                    Face_normal_of& face_normal)
{
  constexpr double cos_40 = 0.76604444311897803520, cos_60 = 0.5;
  const auto smoothstep = [](double x) {
    x = (std::min)(1., (std::max)(0., x));
    return x * x * (3 - 2 * x);
  };
  double least = 2;
  for (std::size_t i = 0; i < fan.corners().size(); ++i) {
    const auto& corner = fan.corners()[i];
    if (!corner.has_area) continue;
    const auto d = dot<double, 3>(n, corner.normal);
    double turn = 1; // its cosine
    if (!(d > 0 && d * d >= cos_40 * cos_40 * corner.squared)) {
      turn = d / std::sqrt(corner.squared);
      if (turn > 0) {
        const double gain = dot<double, 3>(n, face_normal(fan.rays()[i].halfedge)) - turn;
        turn += smoothstep(turn / cos_60) * (std::max)(gain, 0.);
      }
    }
    if (turn <= cos_60) return 0;
    least = (std::min)(least, turn);
  }
  if (least > 1) return 0;
  return smoothstep((least - cos_60) / (cos_40 - cos_60));
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_BLEND_WEIGHT_H
