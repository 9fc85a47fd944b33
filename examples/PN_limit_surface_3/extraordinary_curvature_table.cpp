// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Measures how the curvature of the PN-modified schemes behaves near a vertex of any valence, with
// points and normals of the graph of a cubic polynomial, and draws it beside that of the plain PN
// schemes.
//
//   extraordinary_curvature_table [OUTPUT.svg]

#include "Extraordinary_data.h"
#include "Log_plot_svg.h"
#include "analysis/extraordinary_curvature.h"
#include "analysis/extraordinary_eigenvalues.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;

namespace {

template <class Scheme>
PN::Extraordinary_curvature<double> curvature(const Scheme& scheme, unsigned valence)
{
  const PN::Extraordinary_vertex_zoom<Scheme> zoom(scheme, valence);
  return zoom.measure(
    extraordinary_data::turned(extraordinary_data::sampled(zoom.net(), extraordinary_data::cubic)));
}

std::vector<double> oscillation(const PN::Extraordinary_curvature<double>& c)
{
  std::vector<double> values;
  for (const auto& ring : c.rings) values.push_back(ring.oscillation());
  return values;
}

template <class Plain, class Modified>
log_plot_svg::Panel table(const std::string& name, unsigned regular, const Plain& plain,
                          const Modified& modified)
{
  std::printf(
    "%s\n   n   lambda  lambda'  expected  rate   oscillation on ring 12, 16, 20      K of "
    "ring 20  predicted\n",
    name.c_str());
  log_plot_svg::Panel panel{name, {}};
  for (unsigned n = 3; n <= 12; ++n) {
    if (n == regular) continue; // there the two schemes are the same
    const auto eigenvalues = PN::extraordinary_eigenvalues(modified, n);
    const auto c = curvature(modified, n);
    std::printf("%4u %8.5f %8.5f  %6.3f  %6.3f   %9.1e %9.1e %9.1e   %12.6f %12.6f\n", n,
                PN::extraordinary_eigenvalues(plain, n).subdominant, eigenvalues.subdominant,
                eigenvalues.rate(), c.rate(), c.rings[12].oscillation(), c.rings[16].oscillation(),
                c.rings[20].oscillation(),
                (c.rings[20].gaussian_min + c.rings[20].gaussian_max) / 2, c.limit.gaussian);
    panel.lines.push_back({std::to_string(n), oscillation(curvature(plain, n)), true});
    panel.lines.push_back({std::to_string(n), oscillation(c), false});
  }
  return panel;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string output = argc > 1 ? argv[1] : "extraordinary_curvature.svg";
  log_plot_svg::Plot plot{"Oscillation of Gaussian curvature around extraordinary vertices",
                          "ring",
                          "(largest K - least K) / scale",
                          "valence",
                          -7,
                          0,
                          {}};
  plot.panels.push_back(table("Catmull-Clark: PN (dashed) and PN-modified", 4,
                              PN::CatmullClark_scheme(), PN::CatmullClark_scheme::Tuned()));
  plot.panels.push_back(
    table("Loop: PN (dashed) and PN-modified", 6, PN::Loop_scheme(), PN::Loop_scheme::Tuned()));
  return log_plot_svg::write(output, plot) ? EXIT_SUCCESS : EXIT_FAILURE;
}
