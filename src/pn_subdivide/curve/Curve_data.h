// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_DATA_H
#define PN_SUBDIVIDE_CURVE_DATA_H

#include "io/Output_file.h"

#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;

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

// Reads the numbers of the vertices that are corners, from 0 on, in any number of lines. Throws Error
// if there are none or one is not below `size`.
std::vector<std::size_t> read_corners(const std::string& file, std::size_t size);

// The open parts of a polygon between its corners, with their estimated normals where the file gave
// none and `estimate` is set.
std::vector<Curve_data> split_curve(const Curve_data& polygon, PN::Curve_end end,
                                    const std::vector<std::size_t>& corners, bool estimate);

// Lines and arcs of a polygon: its parts as of split_curve(), their first vertices, and what was found. No corners: the polygon
// is one piece.
struct Arc_parts
{
  std::vector<Curve_data> parts;
  std::vector<std::size_t> corners;
  std::string summary;
  bool found_any = false;
};
Arc_parts split_into_arcs(const Curve_data& polygon, PN::Curve_end end, bool linear);

// The parts as one curve; if it is closed, it begins with point `first`.
Curve_data joined_curve(const std::vector<Curve_data>& parts, PN::Curve_end end, std::size_t first);

// The text of an SVG file: a curve with its control polygon, control normals and curvature comb.
// Curves in space are seen along the direction in which their control points extend least; their
// curvatures are those in space. With corners the parts are the open curves between them,
// else there is one.
std::string curve_picture(const std::string& caption, const Curve_data& polygon,
                          const std::vector<Curve_data>& parts, PN::Curve_end end,
                          bool has_corners);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_DATA_H
