// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How fast limit surfaces and curves approach the one that control points and normals are sampled from:
// for all schemes, point-normal beside linear, on several layouts. Prints the tables of manual and preprint
// (scripts/fill_tables.py puts them there), and draws the error against the number of control points of a
// closed surface.
//
//   approximation_order [OUTPUT.svg]

#include "Closed_samples.h"
#include "Log_plot_svg.h"
#include "Order_curves.h"
#include "Order_limits.h"
#include "Order_samples.h"

#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
using namespace order_samples;

namespace {

// --- tables ---

const std::vector<double> lengths = {.16, .08, .04, .02, .01};

struct Case
{
  std::string name;
  Layout layout;
};

void print_numbers(const std::vector<double>& errors)
{
  std::printf("<td>%.1e</td><td>%.1e</td><td>%.1f</td>", errors[2], errors.back(), order(errors));
}

void print_schemes(const std::vector<std::string>& schemes, const std::vector<Case>& cases)
{
  for (const std::string& name : schemes)
    for (const Case& c : cases) {
      const PN::Any_scheme<> scheme = PN::any_scheme(name);
      std::printf("<tr><td>%s</td><td>%s</td>", name.c_str(), c.name.c_str());
      for (const bool is_linear : {false, true})
        print_numbers(errors(c.layout, scheme, is_linear, lengths));
      std::puts("</tr>");
    }
}

// the Delaunay triangulation of scattered places
Layout delaunay()
{
  using Plane = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Plane>;
  using Data = CGAL::Triangulation_data_structure_2<Vertex>;
  Layout layout = grid(false, .5);
  layout.faces.clear();
  std::vector<std::pair<Plane::Point_2, std::size_t>> places;
  for (const Place& p : layout.places)
    places.emplace_back(Plane::Point_2(p[0], p[1]), places.size());
  const CGAL::Delaunay_triangulation_2<Plane, Data> triangles(places.begin(), places.end());
  for (const auto f : triangles.finite_face_handles())
    layout.faces.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return layout;
}

template <class Mask>
void print_curve(const std::string& name, const Mask& mask)
{
  for (const bool smooth : {true, false}) {
    std::printf("<tr><td>%s</td><td>%s</td>", name.c_str(), smooth ? "smooth" : "uneven");
    for (const bool is_linear : {false, true})
      print_numbers(curve_errors(mask, lengths, smooth, is_linear));
    std::puts("</tr>");
  }
}

void print_tables()
{
  std::puts("#table orders_quads");
  print_schemes(
    {"catmull-clark", "modified-catmull-clark", "ct-catmull-clark", "kobbelt", "doo-sabin"},
    {{"smooth", grid(false)},
     {"uneven", grid(false, .3)},
     {"valence 3", sectors(false, 3)},
     {"valence 5", sectors(false, 5)}});
  std::puts("#table orders_triangles");
  print_schemes({"loop", "modified-loop", "ct-loop", "butterfly", "sqrt3"},
                {{"smooth", grid(true)},
                 {"scattered, Delaunay", delaunay()},
                 {"valence 4", sectors(true, 4)},
                 {"valence 5", sectors(true, 5)}});
  std::puts("#table orders_borders");
  print_schemes({"catmull-clark"}, {{"border", grid(false, 0, 0)}});
  print_schemes({"loop"}, {{"border", grid(true, 0, 0)}});
  std::puts("#table orders_curves");
  print_curve("quadratic B-spline", PN::B_spline_mask(2));
  print_curve("cubic B-spline", PN::B_spline_mask(3));
  print_curve("B-spline of degree 5", PN::B_spline_mask(5));
  print_curve("4-point", PN::Dubuc_Deslauriers_mask(4));
  print_curve("6-point", PN::Dubuc_Deslauriers_mask(6));
  print_curve("cubic, normals by 4-point",
              PN::with_normal_mask(PN::B_spline_mask(3), PN::Dubuc_Deslauriers_mask(4)));
}

// --- the drawing ---

struct Series
{
  std::string label;
  bool is_linear;
  std::vector<std::pair<std::size_t, double>> errors; // by number of control points
};

// of a closed surface, by control meshes with 4 times as many points from each to the next
Series measure(const std::string& title, const PN::Any_scheme<>& scheme, bool is_linear, bool quads)
{
  Series series{title, is_linear, {}};
  for (int k = 0; k < 5; ++k) {
    const Mesh mesh =
      quads ? closed_samples::cube(3 << k) : closed_samples::scattered(std::size_t(56) << (2 * k));
    const double error = largest(limits(mesh, scheme, 1, is_linear),
                                 [](const Point& p) { return closed_samples::distance(p); });
    series.errors.emplace_back(mesh.number_of_vertices(), error);
  }
  return series;
}

// how many control points reach an error, between or beyond those that were measured
double points_for(double error, const Series& series)
{
  std::size_t k = 1;
  while (k + 1 < series.errors.size() && series.errors[k].second > error) ++k;
  const auto& [n0, e0] = series.errors[k - 1];
  const auto& [n1, e1] = series.errors[k];
  return double(n0) * std::pow(double(n1) / double(n0), std::log(error / e0) / std::log(e1 / e0));
}

void print_series(const Series& series)
{
  std::printf("<tr><td>%s, %s</td>", series.label.c_str(),
              series.is_linear ? "linear" : "point-normal");
  for (const auto& [n, error] : series.errors) std::printf("<td>%.1e</td>", error);
  const double n = points_for(1e-4, series), unit = std::pow(10., std::floor(std::log10(n)) - 1);
  std::printf("<td>%.0f</td></tr>\n", std::round(n / unit) * unit);
}

} // namespace

int main(int argc, char** argv)
{
  print_tables();
  std::puts("#table control_points");
  log_plot_svg::Plot plot{"Error against the number of control points",
                          "control points",
                          "largest distance from the surface",
                          "",
                          -6,
                          0,
                          {},
                          1,
                          false,
                          150,
                          {"56", "220", "880", "3.5k", "14k"},
                          3};
  for (const bool quads : {true, false}) {
    log_plot_svg::Panel panel{quads ? "Even quads: linear (dashed), point-normal"
                                    : "Scattered triangles: linear (dashed), point-normal",
                              {}};
    const std::vector<std::pair<std::string, PN::Any_scheme<>>> schemes = {
      quads ? std::pair("Catmull-Clark", PN::any_scheme("catmull-clark"))
            : std::pair("Loop", PN::any_scheme("loop")),
      quads ? std::pair("Kobbelt", PN::any_scheme("kobbelt"))
            : std::pair("Butterfly", PN::any_scheme("butterfly"))};
    for (const auto& [title, scheme] : schemes)
      for (const bool is_linear : {true, false}) {
        const Series series = measure(title, scheme, is_linear, quads);
        print_series(series);
        panel.lines.push_back({title, {}, is_linear});
        for (const auto& [n, error] : series.errors) panel.lines.back().values.push_back(error);
      }
    plot.panels.push_back(panel);
  }
  return log_plot_svg::write(argc > 1 ? argv[1] : "approximation_order.svg", plot) ? EXIT_SUCCESS
                                                                                   : EXIT_FAILURE;
}
