// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_IO_H
#define PN_SUBDIVIDE_CURVE_IO_H

#include "io/Output_file.h"

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <string>
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

// Reads lines `x y`, `x y nx ny`, `x y z` or `x y z nx ny nz`, all of the same form. Blank lines
// and what follows a # are skipped. Throws Error, which names the file and the line.
Curve_data read_curve(const std::string& file);

// Writes the same form with 17 significant digits, without normals if the curve has none.
void write_curve(Output_file& out, const Curve_data& curve);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_IO_H
