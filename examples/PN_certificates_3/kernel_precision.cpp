// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What a kernel gives and what it costs: samples of a circle (four-point scheme), a sphere and a
// cylinder (Catmull-Clark) are refined round by round in several kernels, about the origin and at a
// distance of 100 radii from it. Printed are the largest deviation of a point from the shape, divided
// by the radius, after each round (0: the control data); that of the last round in units of 2^-52 and
// in those of the kernel's number type; for the last round the heap memory of the result in bytes a
// vertex, and in microseconds a vertex the time of the round and of measuring it, which is when lazy
// numbers are computed. Deviations are measured without rounding; for intervals they are bounds.
//
//   kernel_precision [OUTPUT.csv [OUTPUT.svg]] [--with-sqrt]
//
// --with-sqrt adds the surfaces in Exact_predicates_exact_constructions_kernel_with_sqrt, which takes
// minutes.

#include "Log_plot_svg.h"
#include "Sampled_shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_curves/subdivide_curve.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/sqrt_extension_normals.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>

#ifdef CGAL_USE_GMP
#  include <CGAL/Gmpq.h>
#  ifdef CGAL_USE_MPFR
#    include <CGAL/Gmpfr.h>
#  endif
#endif
#ifdef CGAL_USE_CORE
#  include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#endif
#ifdef __GLIBC__
#  include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;

namespace {

struct Row
{
  std::string kernel, shape;
  int distance; // of the center from the origin
  double unit;  // the distance of 1 to the next number, 0 for exact types
  unsigned rounds;
  std::size_t vertices;
  double deviation, bytes, seconds, seconds_measuring;

  double microseconds(double t) const { return t / double(vertices) * 1e6; }
};

constexpr unsigned most_rounds = 5;
// Below, what the allocator keeps for itself is more than the result.
constexpr std::size_t vertices_worth_counting_bytes = 90;

struct Table
{
  std::vector<Row> rows;
  bool with_sqrt = false;
};

std::string number(double x, int width)
{
  std::ostringstream out;
  out.precision(2);
  out << std::setw(width) << x;
  return out.str();
}

// one line for the rows of all rounds
void print(const std::vector<Row>& rounds)
{
  const Row& last = rounds.back();
  std::cout << std::left << std::setw(17) << last.kernel << std::setw(9) << last.shape << std::right
            << std::setw(3) << last.distance << ' ';
  for (unsigned k = 0; k <= most_rounds; ++k)
    std::cout << (k < rounds.size() ? number(rounds[k].deviation, 9) : std::string(9, ' '));
  std::cout << number(last.deviation * 0x1p52, 9)
            << (last.unit > 0 ? number(last.deviation / last.unit, 9) : "        -")
            << std::setw(7);
  if (last.vertices < vertices_worth_counting_bytes)
    std::cout << '-';
  else
    std::cout << std::lround(last.bytes);
  std::cout << number(last.microseconds(last.seconds), 9)
            << number(last.microseconds(last.seconds_measuring), 9) << std::endl;
}

// bytes on the heap, 0 where the C library does not tell
double heap()
{
#if defined(__GLIBC__) && defined(__GLIBC_PREREQ)
#  if __GLIBC_PREREQ(2, 33)
  const auto info = mallinfo2();
  return double(info.uordblks) + double(info.hblkhd);
#  endif
#endif
  return 0;
}

// Refines round by round, measuring.
void measure_rounds(Table& table, Row row, unsigned rounds, double heap_before,
                    const std::function<void()>& refine, const std::function<double()>& deviation,
                    const std::function<std::size_t()>& size)
{
  std::vector<Row> rows;
  for (row.rounds = 0; row.rounds <= rounds; ++row.rounds) {
    CGAL::Real_timer timer;
    timer.start();
    if (row.rounds > 0) refine();
    row.seconds = timer.time();
    row.deviation = deviation(); // the radius is 1
    row.seconds_measuring = timer.time() - row.seconds;
    row.vertices = size();
    row.bytes = (heap() - heap_before) / double(row.vertices);
    rows.push_back(row);
  }
  print(rows);
  table.rows.insert(table.rows.end(), rows.begin(), rows.end());
}

template <class K>
void measure_circle(Table& table, Row row, unsigned rounds)
{
  const typename K::Point_2 center(row.distance * 3 / 5, -row.distance * 4 / 5);
  const double before = heap();
  auto curve = sampled_shapes::circle<K>(center);
  row.shape = "circle";
  measure_rounds(
    table, row, rounds, before,
    [&] {
      curve = PN::subdivide_curve(curve, PN::Dubuc_Deslauriers_mask(4), PN::Curve_end::closed);
    },
    [&] { return PN::curve_deviation(curve, typename K::Circle_2(center, 1)).distance.sup(); },
    [&] { return curve.size(); });
}

template <class K, class Make, class Shape>
void measure_surface(Table& table, const Row& row, unsigned rounds, const Make& make,
                     const Shape& shape)
{
  const double before = heap();
  sampled_shapes::Mesh<K> mesh;
  const auto normals = make(mesh);
  measure_rounds(
    table, row, rounds, before,
    [&] {
      PN::subdivide(mesh, PN::CatmullClark_scheme(), CGAL::parameters::vertex_normal_map(normals));
    },
    [&] { return PN::mesh_deviation(mesh, shape).distance.sup(); },
    [&] { return mesh.number_of_vertices(); });
}

template <class K>
void measure_surfaces(Table& table, Row row, unsigned rounds)
{
  // (9, -12, 20) has the length 25
  const typename K::Point_3 center(row.distance * 9 / 25, -row.distance * 12 / 25,
                                   row.distance * 20 / 25);
  row.shape = "sphere";
  measure_surface<K>(
    table, row, rounds, [&](auto& mesh) { return sampled_shapes::make_sphere<K>(mesh, center); },
    typename K::Sphere_3(center, 1));
  row.shape = "cylinder";
  const typename K::Line_3 axis(center, typename K::Vector_3(0, 0, 1));
  measure_surface<K>(
    table, row, rounds, [&](auto& mesh) { return sampled_shapes::make_cylinder<K>(mesh, center); },
    PN::Cylinder_3<K>(axis, 1));
}

template <class K>
void measure(Table& table, const std::string& kernel, double unit, unsigned curve_rounds,
             unsigned surface_rounds)
{
  for (const int distance : {0, 100}) {
    const Row row{kernel, "", distance, unit, 0, 0, 0, 0, 0, 0};
    measure_circle<K>(table, row, curve_rounds);
    if (surface_rounds > 0) measure_surfaces<K>(table, row, surface_rounds);
  }
}

void measure_kernels(Table& table)
{
  using Double = std::numeric_limits<double>;
  using Long_double = std::numeric_limits<long double>;
  measure<CGAL::Simple_cartesian<float>>(table, "float", std::numeric_limits<float>::epsilon(), 5,
                                         5);
  measure<CGAL::Simple_cartesian<double>>(table, "double", Double::epsilon(), 5, 5);
  measure<CGAL::Exact_predicates_inexact_constructions_kernel>(table, "EPICK", Double::epsilon(), 5,
                                                               5);
  measure<CGAL::Simple_cartesian<long double>>(table, "long double",
                                               static_cast<double>(Long_double::epsilon()), 5, 5);
  measure<CGAL::Simple_cartesian<CGAL::Interval_nt<>>>(table, "Interval_nt", Double::epsilon(), 5,
                                                       5);
#ifdef CGAL_USE_MPFR
  // what an integer is converted to, and so the least precision of results that it takes part in
  const int bits = static_cast<int>(CGAL::Gmpfr(1).get_precision());
  measure<CGAL::Simple_cartesian<CGAL::Gmpfr>>(table, "Gmpfr, " + std::to_string(bits) + " bits",
                                               std::ldexp(1., 1 - bits), 5, 3);
#endif
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  measure<Epeck>(table, "EPECK", 0, 2, 2);
#ifdef CGAL_USE_GMP
  // a + b sqrt(r) with rational a, b and r; the next round would mix two roots
  using One_root = CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq, CGAL::Tag_true>;
  measure<CGAL::Simple_cartesian<One_root>>(table, "Sqrt_extension", 0, 1, 1);
#endif
#ifdef CGAL_USE_CORE
  using Epeck_with_sqrt = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt;
  measure<Epeck_with_sqrt>(table, "EPECK_with_sqrt", 0, 1, table.with_sqrt ? 1 : 0);
#endif
}

bool write_csv(const std::string& file, const Table& table)
{
  std::ofstream out(file);
  out << "kernel,shape,distance,rounds,vertices,deviation,units of 2^-52,units of the type,bytes a "
         "vertex,seconds,seconds for measuring\n";
  for (const Row& r : table.rows) {
    out << '"' << r.kernel << "\"," << r.shape << ',' << r.distance << ',' << r.rounds << ','
        << r.vertices << ',' << r.deviation << ',' << r.deviation * 0x1p52 << ',';
    if (r.unit > 0) out << r.deviation / r.unit;
    out << ',';
    if (r.vertices >= vertices_worth_counting_bytes) out << std::lround(r.bytes);
    out << ',' << r.seconds << ',' << r.seconds_measuring << '\n';
  }
  return bool(out.flush());
}

// the largest deviations of the kernels over the shapes, by rounds
log_plot_svg::Panel panel(const Table& table, int distance, const std::string& caption)
{
  log_plot_svg::Panel panel{caption, {}};
  for (const Row& r : table.rows) {
    if (r.distance != distance) continue;
    auto line = std::find_if(panel.lines.begin(), panel.lines.end(),
                             [&r](const auto& l) { return l.label == r.kernel; });
    if (line == panel.lines.end())
      line = panel.lines.insert(line, {r.kernel, {}, r.kernel == "EPICK"}); // else over double
    line->values.resize((std::max)(line->values.size(), std::size_t(r.rounds + 1)));
    line->values[r.rounds] = (std::max)(line->values[r.rounds], r.deviation);
  }
  return panel;
}

bool write_svg(const std::string& file, const Table& table)
{
  log_plot_svg::Plot plot{"What kernels keep of circles, spheres and cylinders",
                          "rounds",
                          "largest deviation / radius",
                          "kernel",
                          -22,
                          -4,
                          {},
                          1,
                          false,
                          190};
  plot.panels = {panel(table, 0, "about the origin"),
                 panel(table, 100, "100 radii from the origin")};
  return log_plot_svg::write(file, plot);
}

} // namespace

int main(int argc, char** argv)
{
  Table table;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--with-sqrt")
      table.with_sqrt = true;
    else
      files.push_back(argv[i]);

  std::cout
    << "                                deviation / R after rounds                          "
       "   the last: in units of  bytes  us a vertex\n"
       "kernel           shape    |c|/R    0        1        2        3        4        5    "
       " 2^-52   its own a vertex   round  measure\n";
  measure_kernels(table);
  const bool written = write_csv(files.empty() ? "kernel_precision.csv" : files[0], table) &&
                       write_svg(files.size() < 2 ? "kernel_precision.svg" : files[1], table);
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
