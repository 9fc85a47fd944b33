// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_DATA_H
#define PN_SUBDIVIDE_CURVE_DATA_H

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace pn_subdivide {

using Curve_kernel = CGAL::Simple_cartesian<double>;
using Curve_2 = std::vector<std::pair<Curve_kernel::Point_2, Curve_kernel::Vector_2>>;
using Curve_3 = std::vector<std::pair<Curve_kernel::Point_3, Curve_kernel::Vector_3>>;

// A polygon or curve as the files hold it. Normals are zero where there are none.
struct Curve_data
{
  std::variant<Curve_2, Curve_3> points;
  bool has_normals = false; // in the file

  std::size_t size() const
  {
    return std::visit([](const auto& p) { return p.size(); }, points);
  }
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_DATA_H
