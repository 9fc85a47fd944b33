// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// What other methods make of the same points and normals: patches over triangles, and curves through or near points.
// Distance, normals, joins, curvature, what noise and a reversed normal do, and the cost. Prints the tables of
// the manual's page "When the Linear Scheme Is Better" (scripts/fill_tables.py puts them there).
//
//   compare_methods

#include "Measured_limits.h"
#include "peers/by_method/Circle_averages.h"
#include "peers/by_method/Curves.h"
#include "peers/by_method/Patches.h"

#include <CGAL/PN_curves/curve_limit_points.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using namespace measured;
using by_method::Barycentric;
using by_method::Triangle;

// --- patches ---

// in nanoseconds; the first times are those of a cold memory, and others those of a busy machine
template <class Work>
double least_time(const Work& work)
{
  double least = 1e99;
  for (int repeat = 0; repeat < 7; ++repeat) {
    CGAL::Timer timer;
    timer.start();
    work();
    timer.stop();
    least = (std::min)(least, timer.time() * 1e9);
  }
  return least;
}

// point, normal and mean curvature of a patch, by differences
template <class Patch>
Sample sampled(const Patch& patch, const Barycentric& b, const Vector& side)
{
  constexpr double h = 1e-3;
  const auto at = [&](double i, double j) {
    return patch({b[0] - (i + j) * h, b[1] + i * h, b[2] + j * h});
  };
  const Vector p = at(0, 0), x = (at(1, 0) - at(-1, 0)) / (2 * h),
               y = (at(0, 1) - at(0, -1)) / (2 * h);
  const Vector xx = (at(1, 0) + at(-1, 0) - 2 * p) / (h * h),
               yy = (at(0, 1) + at(0, -1) - 2 * p) / (h * h),
               xy = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h);
  Vector n = order_samples::unit(CGAL::cross_product(x, y));
  if (n * side < 0) n = -n;
  const double e = x * x, f = x * y, g = y * y;
  Sample s{CGAL::ORIGIN + p, n};
  s.mean = -(g * (xx * n) - 2 * f * (xy * n) + e * (yy * n)) / (2 * (e * g - f * f));
  s.has_curvature = true;
  return s;
}

struct Surface
{
  Samples samples;
  double join = 0;        // the largest angle between two patches along their edge, in degrees
  double nanoseconds = 0; // for the point alone
};

template <class Make>
Surface patches(const Mesh& control, const Make& make)
{
  Mesh mesh = control;
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const auto patch_of = [&](Mesh::Halfedge_index h) { // its first corner is the source of h
    Triangle t;
    for (auto& corner : t) {
      const auto v = mesh.source(h);
      corner = {mesh.point(v) - CGAL::ORIGIN, normals[v]};
      h = mesh.next(h);
    }
    return make(t);
  };
  Surface surface;
  constexpr int steps = 8;
  for (const auto f : mesh.faces()) {
    const auto patch = patch_of(mesh.halfedge(f));
    const Vector side = normals[mesh.source(mesh.halfedge(f))];
    for (int i = 0; i < steps; ++i) // edges count, corners do not
      for (int j = i == 0; i + j <= steps && j < steps; ++j)
        surface.samples.push_back(
          sampled(patch, {1 - double(i + j) / steps, double(i) / steps, double(j) / steps}, side));
  }
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    const Vector side = normals[mesh.source(h)];
    const auto here = patch_of(h), there = patch_of(o);
    for (const double t : {.25, .5, .75}) {
      const Sample a = sampled(here, {1 - t, t, 0}, side), b = sampled(there, {t, 1 - t, 0}, side);
      surface.join = (std::max)(surface.join, degrees(angle(a.normal, b.normal)));
    }
  }
  std::size_t n = 0;
  double sum = 0;
  surface.nanoseconds = least_time([&] {
    n = 0;
    for (const auto f : mesh.faces()) {
      const auto patch = patch_of(mesh.halfedge(f));
      for (int i = 0; i <= 8; ++i)
        for (int j = 0; i + j <= 8; ++j, ++n) sum += patch({1 - (i + j) / 8., i / 8., j / 8.}).x();
    }
  });
  surface.nanoseconds = sum == .5 ? 0 : surface.nanoseconds / double(n);
  return surface;
}

// --- subdivision ---

enum class Way { linear, linear_solved, plain, slide };

// the control mesh, which moves where it is solved for
void solve(Mesh& mesh, Way way, const Normals& normals)
{
  const auto np = PN::parameters::tolerance(1e-9).vertex_normal_map(normals);
  if (way == Way::linear_solved)
    PN::interpolate_limit_points(
      mesh, PN::linear(PN::Loop_scheme::Tuned()),
      PN::parameters::join(
        PN::parameters::interpolation_mode(PN::Limit_interpolation::Mode::strict), np));
  else if (way == Way::slide)
    PN::interpolate_limit_points(mesh, PN::Loop_scheme::Tuned(), np);
}

Surface subdivided(Mesh mesh, Way way)
{
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const bool is_linear = way == Way::linear || way == Way::linear_solved;
  if (is_linear)
    for (const auto v : mesh.vertices()) normals[v] = CGAL::NULL_VECTOR;
  std::size_t n = 0;
  Surface surface;
  surface.nanoseconds = least_time([&] {
    Mesh refined = mesh;
    const Normals map = refined.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
    solve(refined, way, map);
    const auto np = params::number_of_iterations(3).vertex_normal_map(map);
    if (is_linear)
      PN::subdivide(refined, PN::linear(PN::Loop_scheme::Tuned()), np);
    else
      PN::subdivide(refined, PN::Loop_scheme::Tuned(), np);
    n = refined.number_of_vertices();
  });
  surface.nanoseconds /= double(n);
  solve(mesh, way, normals);
  surface.samples = limits(mesh, PN::Loop_scheme::Tuned(), is_linear);
  return surface;
}

// The normals are those of the fine mesh; curvature is not measured.
Surface by_circle_averages(const Mesh& control)
{
  using Loop = by_method::Circle_average_Loop<Mesh>;
  Surface surface;
  std::size_t n = 0;
  surface.nanoseconds = least_time([&] {
    Mesh refined = control;
    Loop loop(refined, refined.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first);
    for (int round = 0; round < 3; ++round) loop.round();
    n = refined.number_of_vertices();
  });
  surface.nanoseconds /= double(n);
  Mesh fine = control;
  Loop loop(fine, fine.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first);
  for (int round = 0; round < 2; ++round) loop.round();
  const std::size_t sampled = fine.number_of_vertices();
  for (int round = 0; round < 3; ++round) loop.round();
  loop.move_to_limit();
  for (Mesh::size_type i = 0; i < sampled; ++i) {
    const Mesh::Vertex_index v(i);
    Vector sum = CGAL::NULL_VECTOR;
    for (const auto h : fine.halfedges_around_target(fine.halfedge(v)))
      sum = sum + CGAL::cross_product(fine.point(fine.target(fine.next(h))) - fine.point(v),
                                      fine.point(fine.source(h)) - fine.point(v));
    surface.samples.push_back({fine.point(v), order_samples::unit(sum)});
  }
  return surface;
}

Mesh with_reversed_normal(Mesh mesh)
{
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const Mesh::Vertex_index v(Mesh::size_type(mesh.number_of_vertices() / 2));
  normals[v] = -normals[v];
  return mesh;
}

void print_surface(const char* name, const std::function<Surface(const Mesh&)>& make)
{
  const Mesh exact = closed_samples::scattered(896);
  const Surface surface = make(exact);
  Mesh noisy = exact;
  disturb(noisy, 5);
  const Errors e = errors(surface.samples), n = errors(make(noisy).samples),
               r = errors(make(with_reversed_normal(exact)).samples),
               coarse = errors(make(closed_samples::scattered(224)).samples);
  const std::string curvature = surface.samples.front().has_curvature
                                  ? std::to_string(std::lround(100 * e.curvature)) + " %"
                                  : "";
  std::printf("<tr><td>%s</td><td>%.1e</td><td>%.1f</td><td>%.2f</td><td>%.2f</td><td>%s</td>"
              "<td>%.1f</td><td>%.1e</td><td>%.1f</td><td>%.1e</td><td>%.0f</td></tr>\n",
              name, e.largest_distance, std::log2(coarse.largest_distance / e.largest_distance),
              e.angle, surface.join, curvature.c_str(), e.largest_angle, n.distance, n.angle,
              r.largest_distance, surface.nanoseconds);
  std::fflush(stdout);
}

void print_surfaces()
{
  std::puts("#table methods");
  print_surface("the triangles", [](const Mesh& m) {
    return patches(m, [](const Triangle& t) { return by_method::Flat(t); });
  });
  print_surface("Phong tessellation, 3/4", [](const Mesh& m) {
    return patches(m, [](const Triangle& t) { return by_method::Phong_tessellation(t, .75); });
  });
  print_surface("Phong tessellation, 1/2", [](const Mesh& m) {
    return patches(m, [](const Triangle& t) { return by_method::Phong_tessellation(t, .5); });
  });
  print_surface("PN triangles", [](const Mesh& m) {
    return patches(m, [](const Triangle& t) { return by_method::PN_triangle(t); });
  });
  print_surface("matrix weighted average", [](const Mesh& m) {
    return patches(m, [](const Triangle& t) { return by_method::Matrix_weighted_patch(t); });
  });
  print_surface("Nagata", [](const Mesh& m) {
    return patches(m, [](const Triangle& t) { return by_method::Nagata_patch(t); });
  });
  print_surface("Walton and Meek", [](const Mesh& m) {
    return patches(m, [](const Triangle& t) { return by_method::Walton_Meek_patch(t); });
  });
  print_surface("linear modified Loop", [](const Mesh& m) { return subdivided(m, Way::linear); });
  print_surface("the same, solved",
                [](const Mesh& m) { return subdivided(m, Way::linear_solved); });
  print_surface("Loop by circle averages", by_circle_averages);
  print_surface("PN-modified Loop", [](const Mesh& m) { return subdivided(m, Way::plain); });
  print_surface("the same, `slide`", [](const Mesh& m) { return subdivided(m, Way::slide); });
}

// --- even grids ---

Mesh torus_of_triangles(int n)
{
  Mesh mesh;
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const double turn = 2 * std::acos(-1.);
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = turn * i / (2 * n), v = turn * j / n, r = 2 + .8 * std::cos(v);
      const auto w = mesh.add_vertex(Point(r * std::cos(u), r * std::sin(u), .8 * std::sin(v)));
      normals[w] = Vector(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    }
  const auto at = [n](int i, int j) {
    return Mesh::Vertex_index(Mesh::size_type(i % (2 * n) * n + j % n));
  };
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < n; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

void print_even_grids()
{
  std::puts("#table even_grids");
  for (const auto& [name, way] :
       {std::pair("linear Loop", Way::linear), std::pair("the same, solved", Way::linear_solved),
        std::pair("PN-Loop", Way::plain), std::pair("the same, `slide`", Way::slide)}) {
    std::printf("<tr><td>%s</td>", name);
    for (const int n : {8, 16, 32}) {
      double worst = 0;
      for (const Sample& s : subdivided(torus_of_triangles(n), way).samples) {
        const double across = std::hypot(s.point.x(), s.point.y()) - 2;
        worst = (std::max)(worst, std::abs(std::hypot(across, s.point.z()) - .8));
      }
      std::printf("<td>%.1e</td>", worst);
    }
    std::puts("</tr>");
  }
}

// --- curves ---

using by_method::Curve_point;
using Plane_polygon = std::vector<std::pair<Kernel::Point_2, Kernel::Vector_2>>;

struct Shape
{
  const char* name;
  std::function<Curve_point(double)> at; // t from 0 to 1
  bool is_closed;
};

Plane_polygon polygon_of(const std::vector<Curve_point>& points, bool is_linear)
{
  Plane_polygon polygon;
  for (const Curve_point& p : points)
    polygon.emplace_back(Kernel::Point_2(p.point.x(), p.point.y()),
                         is_linear ? Kernel::Vector_2(0, 0)
                                   : Kernel::Vector_2(p.normal.x(), p.normal.y()));
  return polygon;
}

template <class Mask>
std::vector<Kernel::Point_2> limit_curve(const std::vector<Curve_point>& points, const Mask& mask,
                                         bool is_linear, bool is_closed)
{
  const PN::Curve_end end = is_closed ? PN::Curve_end::closed : PN::Curve_end::reflect;
  const auto fine =
    PN::subdivide_curve(polygon_of(points, is_linear), mask, end, params::number_of_iterations(4));
  std::vector<Kernel::Point_2> curve;
  for (const auto& l : PN::curve_limit_points(fine, mask, end).first) curve.push_back(l.point);
  return curve;
}

double curve_distance(const Shape& shape, const Kernel::Point_2& p)
{
  double best = 1e9, at = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double d = (shape.at(i / 2000.).point - p).squared_length();
    if (d < best) {
      best = d;
      at = i / 2000.;
    }
  }
  for (int i = 0; i < 4; ++i) { // to the foot, along the tangent
    const Curve_point c = shape.at(at), d = shape.at(at + 1e-6);
    const Kernel::Vector_2 t = (d.point - c.point) / 1e-6;
    at += (p - c.point) * t / t.squared_length();
  }
  const Curve_point c = shape.at(at);
  return std::abs((p - c.point) * c.normal);
}

using Make_curve =
  std::function<std::vector<Kernel::Point_2>(const std::vector<Curve_point>&, bool)>;

// the largest distance, with normals that are off by an angle of this standard deviation, in degrees
double curve_error(const Make_curve& make, const Shape& shape, int n, double noise)
{
  std::mt19937 random(1);
  std::vector<Curve_point> points;
  for (int i = 0; i < n + !shape.is_closed; ++i) {
    points.push_back(shape.at(double(i) / n));
    double sum = -6; // of twelve, for the same numbers everywhere
    for (int k = 0; k < 12; ++k) sum += double(random()) / 4294967296.;
    points.back().normal =
      by_method::turned(points.back().normal, noise * sum * std::acos(-1.) / 180);
  }
  double largest = 0;
  const auto curve = make(points, shape.is_closed);
  const std::size_t skipped = shape.is_closed ? 0 : curve.size() / 4; // the ends are other rules
  for (std::size_t i = skipped; i < curve.size() - skipped; ++i)
    largest = (std::max)(largest, curve_distance(shape, curve[i]));
  return largest;
}

void print_curve(const std::string& name, const Make_curve& make, const std::vector<Shape>& shapes)
{
  std::printf("<tr><td>%s</td>", name.c_str());
  for (const Shape& shape : shapes)
    for (const int n : {16, 32}) std::printf("<td>%.1e</td>", curve_error(make, shape, n, 0));
  for (const Shape& shape : shapes) std::printf("<td>%.1e</td>", curve_error(make, shape, 32, 5));
  std::puts("</tr>");
  std::fflush(stdout);
}

void print_curves()
{
  const double pi = std::acos(-1.);
  const auto ellipse = [pi](double t) {
    const double x = std::cos(2 * pi * t), y = std::sin(2 * pi * t);
    const Kernel::Vector_2 n(x, 2 * y);
    return Curve_point{Kernel::Point_2(x, y / 2), n / std::sqrt(n.squared_length())};
  };
  const auto spiral = [pi](double t) { // of exponential growth
    const double a = 2 * pi * t, r = std::exp(.3 * a);
    const Kernel::Vector_2 n(std::cos(a) + .3 * std::sin(a), std::sin(a) - .3 * std::cos(a));
    return Curve_point{Kernel::Point_2(r * std::cos(a), r * std::sin(a)),
                       n / std::sqrt(n.squared_length())};
  };
  const std::vector<Shape> shapes = {{"ellipse", ellipse, true}, {"spiral", spiral, false}};
  using Points = std::vector<Curve_point>;
  std::puts("#table curve_methods");
  print_curve(
    "linear cubic",
    [](const Points& p, bool c) { return limit_curve(p, PN::B_spline_mask(3), true, c); }, shapes);
  print_curve(
    "linear 4-point",
    [](const Points& p, bool c) { return limit_curve(p, PN::Dubuc_Deslauriers_mask(4), true, c); },
    shapes);
  print_curve(
    "PN-cubic",
    [](const Points& p, bool c) { return limit_curve(p, PN::B_spline_mask(3), false, c); }, shapes);
  print_curve(
    "PN-4-point",
    [](const Points& p, bool c) { return limit_curve(p, PN::Dubuc_Deslauriers_mask(4), false, c); },
    shapes);
  using Average = Curve_point (*)(const Curve_point&, const Curve_point&, double);
  const std::pair<const char*, Average> averages[] = {
    {"circle average", by_method::circle_average},
    {"Hermite average", by_method::hermite_average},
    {"clothoid average", by_method::clothoid_average}};
  for (const auto& entry : averages) {
    const Average average = entry.second;
    print_curve(
      entry.first + std::string(", cubic"),
      [average](const Points& p, bool c) { return by_method::cubic_by(average, p, c); }, shapes);
    print_curve(
      entry.first + std::string(", 4-point"),
      [average](const Points& p, bool c) { return by_method::four_point_by(average, p, c); },
      shapes);
  }
  print_curve(
    "exponential 4-point",
    [pi](const Points& p, bool c) {
      return by_method::exponential_four_point(p, c, 2 * pi / double(p.size() - !c));
    },
    shapes);
  print_curve("cubic Hermite", by_method::hermite, shapes);
}

} // namespace

int main()
{
  print_surfaces();
  print_even_grids();
  print_curves();
}
