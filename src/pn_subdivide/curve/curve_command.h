// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_COMMAND_H
#define PN_SUBDIVIDE_CURVE_COMMAND_H

#include "io/Limit_choice.h"
#include "io/Report.h"

#include <optional>
#include <string>

namespace pn_subdivide {

struct Curve_options
{
  std::string input, output; // "-": standard input, output
  std::string scheme = "bspline:3";
  std::optional<std::string> normal_scheme, normals, end, comb, sharp, interpolate, roundness;
  Limit_choice limit{"curve", false, false, std::nullopt};
  Verify_options verify;
  unsigned levels = 1;
  bool closed = false, linear = false;
  Report_options report;
};

// The command `pn_subdivide curve`. Throws Usage_error, Error or what the library throws; the files
// to be written are then as they were. Throws Tolerance_error after writing them.
void run_curve_command(const Curve_options& options);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_COMMAND_H
