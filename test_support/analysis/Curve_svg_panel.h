// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_PANEL_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_PANEL_H

#include "analysis/curve_analysis.h"

#include <CGAL/PN_curves/masks/curve_masks.h>

#include <CGAL/Simple_cartesian.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/// drawings of curves.
namespace curve_svg {

/// the kernel.
using Kernel = CGAL::Simple_cartesian<double>;
/// a point.
using Point = Kernel::Point_2;
/// a vector.
using Vector = Kernel::Vector_2;

/// points with normals, as `subdivide_curve()` takes and returns them.
using Curve = std::vector<std::pair<Point, Vector>>;

/*!
One curve of a drawing.
*/
struct Panel
{
  /// the line of text below.
  std::string caption;
  /// whether the curve and the control polygon are closed.
  bool closed = false;
  /// the points of the curve.
  std::vector<Point> curve;
  /// the control polygon.
  std::vector<Point> control_points;
  /// one for each control point or none at all; of unit length or, of a curve in space that is seen from
  /// the side, shorter.
  std::vector<Vector> control_normals;
  /// one for each point of the curve.
  std::vector<double> curvature;
  /// gives the ends of the comb's teeth, one for each point of the curve, if a curvature of 1 is to be a
  /// tooth of length `scale`; empty for a drawing without comb.
  std::function<std::vector<Point>(double scale)> comb;
};

/*!
returns the panel of a plane curve with its control polygon, control normals and curvature comb.
\param caption the line of text below
\param polygon the control points with their normals
\param curve the refined curve, as `subdivide_curve()` returns it
\param end how both end
*/
inline Panel panel(const std::string& caption, const Curve& polygon, const Curve& curve,
                   Curve_end end)
{
  Panel p;
  p.caption = caption;
  p.closed = end == Curve_end::closed;
  for (const auto& [point, normal] : polygon) {
    p.control_points.push_back(point);
    p.control_normals.push_back(normal);
  }
  for (const auto& point_and_normal : curve) p.curve.push_back(point_and_normal.first);
  p.curvature = discrete_curvature(p.curve, end);
  p.comb = [points = p.curve, end](double scale) { return curvature_comb(points, end, scale); };
  return p;
}

} // namespace curve_svg
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_PANEL_H
