// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How good the curvature of the PN-modified schemes is at extraordinary vertices: for each valence the
// worst figures over all data, and the rate of the plain PN scheme, as the table of the manual.
//
//   benchmark_quality [--csv]

#include "../../examples/PN_limit_surface_3/Extraordinary_data.h"
#include "analysis/extraordinary_curvature.h"
#include "analysis/extraordinary_eigenvalues.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/Timer.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace data = extraordinary_data;

const std::vector<std::string> columns = {"scheme",
                                          "valence",
                                          "lambda'",
                                          "rate expected",
                                          "rate",
                                          "oscillation on ring 12",
                                          "on ring 16",
                                          "on ring 20",
                                          "prediction off by",
                                          "least abs(K) / scale",
                                          "flat data",
                                          "linear scheme",
                                          "rate of plain PN",
                                          "ms per measurement"};

void print_row(bool csv, const std::vector<std::string>& cells)
{
  std::string row = csv ? "" : "| ";
  for (std::size_t i = 0; i < cells.size(); ++i)
    row += (i == 0 ? "" : csv ? "," : " | ") + cells[i];
  std::puts((row + (csv ? "" : " |")).c_str());
}

std::string number(const char* format, double x)
{
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

// the data that come out flat at this valence: the frequencies 2 and -1 are the same at 3, 2 and -2
// at 4
std::vector<data::Data_set> flat_data(unsigned valence)
{
  std::vector<data::Data_set> sets = data::flat();
  if (valence < 5) sets.erase(sets.begin());
  return sets;
}

template <class Plain, class Modified>
void print_rows(bool csv, const std::string& name, const std::vector<unsigned>& valences,
                const Plain& plain, const Modified& modified)
{
  const auto twin = PN::linear(modified);
  for (const unsigned n : valences) {
    const PN::Extraordinary_vertex_zoom<Modified> zoom(modified, n);
    const PN::Extraordinary_vertex_zoom<decltype(PN::linear(modified))> linear_zoom(twin, n);
    const auto eigenvalues = PN::extraordinary_eigenvalues(modified, n);
    CGAL::Timer timer;
    timer.start();
    const data::Figures f = data::figures(zoom);
    timer.stop();
    const data::Figures of_plain = data::figures(PN::Extraordinary_vertex_zoom<Plain>(plain, n));
    print_row(csv, {name, std::to_string(n), number("%.4f", eigenvalues.subdominant),
                    number("%.3f", eigenvalues.rate()), number("%.3f", f.rate),
                    number("%.1e", f.oscillation_12), number("%.1e", f.oscillation_16),
                    number("%.1e", f.oscillation_20), number("%.1e", f.prediction_error),
                    number("%.2f", f.least_gaussian),
                    number("%.1e", data::remaining_mean_curvature(zoom, flat_data(n))),
                    number("%.1e", data::remaining_mean_curvature(linear_zoom, data::curved())),
                    number("%.2f", of_plain.rate),
                    number("%.1f", 1000 * timer.time() / double(data::curved().size()))});
  }
}

} // namespace

int main(int argc, char** argv)
{
  const bool csv = argc > 1 && std::string(argv[1]) == "--csv";
  print_row(csv, columns);
  if (!csv) print_row(csv, std::vector<std::string>(columns.size(), "---"));
  print_rows(csv, "PN-modified Catmull-Clark", {3, 5, 6, 7, 8, 10, 12}, PN::CatmullClark_scheme(),
             PN::CatmullClark_scheme::Tuned());
  print_rows(csv, "PN-modified Loop", {3, 4, 5, 7, 8, 9, 12}, PN::Loop_scheme(),
             PN::Loop_scheme::Tuned());
  return EXIT_SUCCESS;
}
