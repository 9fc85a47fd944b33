// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SPLIT_POLYGON_H
#define PN_SUBDIVIDE_SPLIT_POLYGON_H

#include "surface/Surface.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace pn_subdivide {

// the numbers of three corners of a polygon, ascending
using Corner_triangle = std::array<std::uint32_t, 3>;
// whether two corners of the polygon are joined by an edge elsewhere
using Is_edge = std::function<bool(std::uint32_t, std::uint32_t)>;

// Splits a polygon of n >= 3 corners at finite points into n - 2 triangles, whatever the points are: in a line,
// equal, in no plane, of a polygon that crosses itself. Where its projection to the plane of its area vector can be
// split without a fold, the triangles have no fold, and are those of Delaunay's condition. Diagonals are no edges
// elsewhere, if that is possible. Each triangle cuts off its middle corner from what those before it have left.
std::vector<Corner_triangle> split_polygon(const std::vector<Point_3>& points,
                                           const Is_edge& is_edge);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SPLIT_POLYGON_H
