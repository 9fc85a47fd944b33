// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Interpolation_choice.h"

#include "io/Error.h"

#include <cstdio>

namespace pn_subdivide {

std::optional<Interpolation_mode> parse_interpolation(const std::optional<std::string>& text)
{
  if (!text) return std::nullopt;
#if !__has_include(<Eigen/Core>)
  throw Usage_error("--interpolate: this program was built without Eigen");
#endif
  if (*text == "slide") return Interpolation_mode::slide;
  if (*text == "points") return Interpolation_mode::strict;
  throw Usage_error("--interpolate '" + *text + "': it takes slide or points");
}

std::string description(const Interpolation_report& report)
{
  char text[200];
  std::snprintf(text, sizeof text, "interpolation: residual %.2g, estimated error %.2g, %u %s",
                report.residual, report.error, report.steps, report.steps == 1 ? "step" : "steps");
  std::string s = text;
  if (report.fallback) s += ", by control normals in place of surface normals";
  return s;
}

std::string warning(const Interpolation_report& report)
{
  char text[200] = "";
  if (!report.is_within_tolerance())
    std::snprintf(text, sizeof text,
                  "the limit passes the points at a distance of up to %.2g (tolerance %.2g)",
                  report.residual, report.tolerance);
  else if (report.left_out > 0)
    std::snprintf(text, sizeof text,
                  "%zu %s left out of the interpolation: no normal is known there", report.left_out,
                  report.left_out == 1 ? "vertex is" : "vertices are");
  else if (report.slip_of_edge > 0.25)
    std::snprintf(text, sizeof text,
                  "the mesh is coarse for its normals: limit points are up to %.2f edges away from "
                  "theirs; --interpolate points keeps them",
                  report.slip_of_edge);
  else if (report.normal_angle > 60)
    std::snprintf(
      text, sizeof text,
      "the mesh is coarse for its normals: those of neighbors are up to %.0f degrees apart",
      report.normal_angle);
  return text;
}

} // namespace pn_subdivide
