// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Where the linear scheme is better than its point-normal twin, and what roundness does about it: noise of given normals,
// interpolating masks, interpolation of points, convexity, folds. Prints the tables of the manual's page
// "When the Linear Scheme Is Better" (scripts/fill_tables.py puts them there).
//
//   when_linear [FOLDER_OF_MESHES]

#include "Measured_limits.h"

#include <CGAL/PN_certificates_3/compare_with_linear.h>
#include <CGAL/PN_curves/curve_limit_points.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_fitting_3/smooth_control_normals.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/PN_subdivision_curve.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using namespace measured;

// --- noise of the given normals ---

template <class Scheme>
void print_noise(const char* layout, const Mesh& exact, const Scheme& scheme)
{
  const auto print = [layout](const char* way, double noise, const Errors& e) {
    std::printf(
      "<tr><td>%s</td><td>%s</td><td>%.1f</td><td>%.1e</td><td>%.2f</td><td>%.1f %%</td></tr>\n",
      layout, way, noise, e.distance, e.angle, 100 * e.curvature);
  };
  print("linear", 0, errors(limits(exact, scheme, true)));
  for (const double noise : {0., .5, 1., 2., 5.}) {
    Mesh mesh = exact;
    disturb(mesh, noise);
    print("PN", noise, errors(limits(mesh, scheme, false, 1)));
    if (noise > .5) print("PN, roundness 1/2", noise, errors(limits(mesh, scheme, false, .5)));
  }
}

// --- normals that are smoothed ---

// over a closed or open grid; f(s, t) gives a point and a normal of any length
template <class Function>
Mesh grid(int m, int n, bool closed, bool triangles, const Function& f)
{
  Mesh mesh;
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const int columns = closed ? m : m + 1, rows = closed ? n : n + 1;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const std::pair<Point, Vector> sample = f(double(i) / m, double(j) / n);
      normals[mesh.add_vertex(sample.first)] = order_samples::unit(sample.second);
    }
  const auto at = [&](int i, int j) {
    return Mesh::Vertex_index(std::uint32_t((i % columns) * rows + j % rows));
  };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      if (triangles) {
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      } else
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return mesh;
}

std::pair<Point, Vector> on_torus(double s, double t)
{
  const double u = 2 * std::acos(-1.) * s, v = 2 * std::acos(-1.) * t;
  const Vector out(std::cos(u), std::sin(u), 0);
  const Vector n = std::cos(v) * out + Vector(0, 0, std::sin(v));
  return {CGAL::ORIGIN + 2 * out + .8 * n, n};
}

std::pair<Point, Vector> on_graph(double s, double t)
{
  const double x = 4 * s - 2, y = 4 * t - 2, a = std::sin(1.5 * x), b = std::cos(1.2 * y);
  return {Point(x, y, .4 * a * b + .1 * x * y),
          Vector(-.6 * std::cos(1.5 * x) * b - .1 * y, .48 * a * std::sin(1.2 * y) - .1 * x, 1)};
}

// the mean of |grad H| over the limit surface
template <class Scheme>
double change_of_curvature(Mesh mesh, const Scheme& scheme)
{
  const Samples samples = limits(mesh, scheme, false);
  PN::subdivide(mesh, scheme, params::number_of_iterations(2)); // the same faces
  double sum = 0, area = 0;
  for (const auto f : mesh.faces()) {
    std::vector<const Sample*> c;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      c.push_back(&samples[std::size_t(v)]);
    for (std::size_t i = 2; i < c.size(); ++i) {
      if (!c[0]->has_curvature || !c[i - 1]->has_curvature || !c[i]->has_curvature) continue;
      const Vector u = c[i - 1]->point - c[0]->point, v = c[i]->point - c[0]->point;
      const Vector w = (c[i]->mean - c[0]->mean) * u - (c[i - 1]->mean - c[0]->mean) * v;
      sum += std::sqrt(w.squared_length());
      area += std::sqrt(CGAL::cross_product(u, v).squared_length());
    }
  }
  return sum / area;
}

template <class Scheme>
void print_smoothing(const char* name, const Mesh& exact, const Scheme& scheme)
{
  for (const double noise : {0., 1., 2., 5.}) {
    Mesh mesh = exact;
    const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
    std::vector<Vector> true_ones;
    for (const auto v : mesh.vertices()) true_ones.push_back(normals[v]);
    disturb(mesh, noise);
    double error[2], change[2];
    for (const int i : {0, 1}) {
      if (i == 1) PN::smooth_control_normals(mesh, normals);
      double sum = 0;
      for (const auto v : mesh.vertices()) {
        const double a = degrees(angle(normals[v], true_ones[std::size_t(v)]));
        sum += a * a;
      }
      error[i] = std::sqrt(sum / double(true_ones.size()));
      change[i] = change_of_curvature(mesh, scheme);
    }
    std::printf(
      "<tr><td>%s</td><td>%.0f</td><td>%.2f</td><td>%.2f</td><td>%.3f</td><td>%.3f</td></tr>\n",
      name, noise, error[0], error[1], change[0], change[1]);
  }
}

void print_smoothing()
{
  std::puts("#table smooth");
  Mesh sphere = closed_samples::scattered(400);
  const Normals normals = sphere.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (const auto v : sphere.vertices()) {
    normals[v] = order_samples::unit(sphere.point(v) - CGAL::ORIGIN);
    sphere.point(v) = CGAL::ORIGIN + normals[v];
  }
  const PN::Loop_scheme::Tuned loop;
  const PN::CatmullClark_scheme::Tuned catmull_clark;
  print_smoothing("a", sphere, loop);
  print_smoothing("b", grid(32, 16, true, false, on_torus), catmull_clark);
  print_smoothing("c", grid(32, 16, true, true, on_torus), loop);
  print_smoothing("d", grid(20, 20, false, false, on_graph), catmull_clark);
  print_smoothing("e", grid(20, 20, false, true, on_graph), loop);
}

// --- masks on an ellipse ---

template <class Mask>
double ellipse_error(const Mask& mask, int n, bool is_linear, double a, double b)
{
  std::vector<std::pair<Kernel::Point_2, Kernel::Vector_2>> polygon;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::acos(-1.) * (i + .3) / n, x = std::cos(t), y = std::sin(t);
    polygon.emplace_back(Kernel::Point_2(a * x, b * y),
                         is_linear ? Kernel::Vector_2(0, 0) : Kernel::Vector_2(x / a, y / b));
  }
  polygon =
    PN::subdivide_curve(polygon, mask, PN::Curve_end::closed, params::number_of_iterations(4));
  double largest = 0;
  for (const auto& l : PN::curve_limit_points(polygon, mask, PN::Curve_end::closed).first) {
    const double x = l.point.x() / a, y = l.point.y() / b;
    largest = (std::max)(largest, std::abs(x * x + y * y - 1) / (2 * std::hypot(x / a, y / b)));
  }
  return largest;
}

template <class Mask>
void print_ellipse(const std::string& name, const Mask& mask)
{
  for (const bool is_linear : {true, false}) {
    std::printf("<tr><td>%s%s</td>", is_linear ? "linear " : "PN-", name.c_str());
    for (const double b : {.5, .8})
      for (const int n : {16, 32, 64})
        std::printf("<td>%.1e</td>", ellipse_error(mask, n, is_linear, 1, b));
    std::puts("</tr>");
  }
}

// --- interpolation of points, with exact normals ---

double interpolation_error(Mesh mesh, const std::string& way)
{
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const bool is_linear = way == "linear";
  if (is_linear)
    for (const auto v : mesh.vertices()) normals[v] = CGAL::NULL_VECTOR;
  const auto np = PN::parameters::tolerance(1e-9)
                    .interpolation_mode(way == "slide" ? PN::Limit_interpolation::Mode::slide
                                                       : PN::Limit_interpolation::Mode::strict)
                    .vertex_normal_map(normals);
  if (way == "linear")
    PN::interpolate_limit_points(mesh, PN::linear(PN::Loop_scheme()), np);
  else if (way != "nothing solved")
    PN::interpolate_limit_points(mesh, PN::Loop_scheme(), np);
  return errors(limits(mesh, PN::Loop_scheme(), is_linear)).largest_distance;
}

void print_interpolation()
{
  std::puts("#table interpolation");
  for (const char* way : {"linear", "points", "slide", "nothing solved"}) {
    std::printf("<tr><td>%s</td>", way);
    double before = 0, error = 0;
    for (const std::size_t n : {224, 896, 3584}) {
      before = error;
      error = interpolation_error(closed_samples::scattered(n), way);
      std::printf("<td>%.1e</td>", error);
    }
    std::printf("<td>%.1f</td></tr>\n", std::log2(before / error));
  }
}

// --- convexity ---

// the share of the points at which the surface of a thin ellipsoid is a saddle
void print_convexity()
{
  std::puts("#table convexity");
  const PN::CatmullClark_scheme::Tuned scheme;
  for (const double thickness : {1., .5, .2, .1}) {
    Mesh mesh = closed_samples::cube(4);
    const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
    for (const auto v : mesh.vertices()) {
      const Vector d = order_samples::unit(mesh.point(v) - CGAL::ORIGIN);
      mesh.point(v) = Point(d.x(), .8 * d.y(), thickness * d.z());
      normals[v] = order_samples::unit(Vector(d.x(), d.y() / .8, d.z() / thickness));
    }
    std::printf("<tr><td>%.1f</td>", thickness);
    for (const double roundness : {0., .5, 1.}) {
      double saddles = 0, all = 0;
      for (const Sample& s : limits(mesh, scheme, roundness == 0, roundness)) {
        all += s.has_curvature;
        saddles += s.has_curvature && s.gaussian < -1e-6;
      }
      std::printf("<td>%.1f %%</td>", 100 * saddles / all);
    }
    std::puts("</tr>");
  }
}

// how far the sphere about a cube leaves the hull, relative to its diagonal
void print_hull()
{
  std::puts("#table hull");
  const PN::CatmullClark_scheme scheme;
  Mesh mesh = closed_samples::cube(1);
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (const auto v : mesh.vertices()) {
    const Vector d = order_samples::unit(mesh.point(v) - CGAL::ORIGIN);
    const auto sign = [](double x) { return x < 0 ? -1. : 1.; };
    mesh.point(v) = Point(sign(d.x()), sign(d.y()), sign(d.z()));
    normals[v] = d;
  }
  for (const double roundness : {0., .25, .5, 1.}) {
    double out = 0;
    for (const Sample& s : limits(mesh, scheme, roundness == 0, roundness))
      out = (std::max)(
        {out, std::abs(s.point.x()) - 1, std::abs(s.point.y()) - 1, std::abs(s.point.z()) - 1});
    std::printf("<tr><td>%.2g</td><td>%.0f %%</td></tr>\n", roundness, 100 * out / std::sqrt(12.));
  }
}

// --- folds: normals that are far off ---

void print_folds()
{
  std::puts("#table folds");
  for (const double noise : {0., 10., 20., 40., 60., -1.}) {
    Mesh mesh = closed_samples::scattered(224);
    const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
    if (noise < 0) { // one reversed normal
      const Mesh::Vertex_index v(100);
      normals[v] = -normals[v];
      std::printf("<tr><td>one reversed</td>");
    } else {
      disturb(mesh, noise);
      std::printf("<tr><td>%.0f</td>", noise);
    }
    for (const double roundness : {1., .5, 0.}) {
      const auto c = PN::compare_with_linear(
        mesh, PN::Loop_scheme(),
        PN::parameters::roundness(roundness).number_of_iterations(3).vertex_normal_map(normals));
      std::printf("<td>%u</td><td>%.1f</td>", unsigned(c.folded_edges), c.largest_distance / 8);
    }
    std::puts("</tr>");
  }
}

// --- swelling of models without normals ---

template <class Estimate>
void print_model(const std::string& name, const Mesh& mesh, const std::string& way,
                 Estimate estimate, double roundness)
{
  const auto scheme = PN::internal::with_normal_estimate(PN::CatmullClark_scheme(), estimate);
  const auto rounds = params::number_of_iterations(3);
  const auto c =
    roundness < 0
      ? PN::compare_with_linear(mesh, scheme, rounds)
      : PN::compare_with_linear(mesh, scheme,
                                PN::parameters::join(PN::parameters::roundness(roundness), rounds));
  std::printf("<tr><td>%s</td><td>%s</td>", name.c_str(), way.c_str());
  std::printf("<td>%.2f</td><td>%.2f</td>", c.linear_volume_ratio, c.volume_ratio);
  std::printf("<td>%.2f</td></tr>\n", c.largest_distance);
}

void print_models(const std::string& folder)
{
  std::puts("#table models");
  for (const char* file : {"creature.obj", "spoon.obj", "wheel.off"}) {
    Mesh mesh;
    if (!CGAL::IO::read_polygon_mesh(folder + "/" + file, mesh)) {
      std::fprintf(stderr, "Cannot read %s/%s\n", folder.c_str(), file);
      std::exit(EXIT_FAILURE);
    }
    using Estimate = PN::Control_normal_estimate;
    print_model(file, mesh, "angle, roundness 1", Estimate::angle, 1);
    print_model(file, mesh, "coherent, roundness 1", Estimate::coherent, 1);
    print_model(file, mesh, "coherent, roundness of the points", Estimate::coherent, -1);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::puts("#table noise");
  print_noise("even quads", closed_samples::cube(12), PN::CatmullClark_scheme::Tuned());
  print_noise("scattered triangles", closed_samples::scattered(896), PN::Loop_scheme::Tuned());
  print_smoothing();
  std::puts("#table ellipse");
  print_ellipse("cubic", PN::B_spline_mask(3));
  print_ellipse("4-point", PN::Dubuc_Deslauriers_mask(4));
  print_ellipse("6-point", PN::Dubuc_Deslauriers_mask(6));
  print_interpolation();
  print_convexity();
  print_hull();
  print_folds();
  print_models(argc > 1 ? argv[1] : "data/meshes");
}
