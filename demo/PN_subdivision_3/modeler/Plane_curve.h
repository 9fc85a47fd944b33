// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_PLANE_CURVE_H
#define PN_SUBDIVISION_3_DEMO_PLANE_CURVE_H

#include <string>
#include <vector>

namespace pn_demo {

struct Plane_curve
{
  std::vector<double> points, normals; // x y
  std::vector<double> curvature;       // positive where it bends away from the left
  std::vector<double> comb;            // x y, with a scale of 1
};

// Points and normals are x y each; of masks such as bspline:3 and 4-point. Throws std::exception.
Plane_curve refine_plane_curve(const std::vector<double>& points,
                               const std::vector<double>& normals, const std::string& mask,
                               bool is_linear, bool is_closed, unsigned rounds, double roundness);

std::vector<double> estimate_plane_normals(const std::vector<double>& points, bool is_closed);

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_PLANE_CURVE_H
