// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_PICTURE_H
#define PN_SUBDIVIDE_CURVE_PICTURE_H

#include "curve/Curve_data.h"

#include <CGAL/PN_subdivision_curve.h>

#include <string>
#include <vector>

namespace pn_subdivide {

// The text of an SVG file: a curve with its control polygon, control normals and curvature comb.
// Curves in space are seen along the direction in which their control points extend least; their
// curvatures are those in space. With corners the parts are the open curves between them,
// else there is one.
std::string curve_picture(const std::string& caption, const Curve_data& polygon,
                          const std::vector<Curve_data>& parts,
                          CGAL::PN_subdivision_3::Curve_end end, bool has_corners);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_PICTURE_H
