// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_EXTRAORDINARY_DATA_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_EXTRAORDINARY_DATA_H

#include "analysis/Extraordinary_net.h"
#include "analysis/extraordinary_curvature.h"

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

// Control data for nets with an extraordinary vertex in the middle, on which the curvature there is
// measured. Used by an example, the tests and a benchmark.
namespace extraordinary_data {

using CGAL::PN_subdivision_3::Extraordinary_net;
using Index = Extraordinary_net::Index;
using Vector = std::array<double, 3>;
using Value = CGAL::PN_subdivision_3::Point_normal<double, 3>;
using Values = std::vector<Value>;

constexpr double spacing = 0.12; // of the control points

inline double pi()
{
  return std::acos(-1.);
}

inline Vector unit(Vector v)
{
  const double length = std::hypot(v[0], v[1], v[2]);
  for (double& x : v) x /= length;
  return v;
}

// The point of the plane with the place of v: rows of even steps along the edges of the middle
// vertex, which leave it at equal angles from `turn` on.
inline std::array<double, 2> layout(const Extraordinary_net& net, Index v, double turn = 0.3)
{
  const auto& [s, i, j] = net.place(v);
  const double angle = 2 * pi() / net.valence(), a = turn + s * angle, b = a + angle;
  return {spacing * (i * std::cos(a) + j * std::cos(b)),
          spacing * (i * std::sin(a) + j * std::sin(b))};
}

// A height over the plane with its slopes.
struct Height
{
  double z, x, y;
};
using Graph = std::function<Height(double x, double y)>;

inline Height saddle(double x, double y)
{
  return {2 * x * y, 2 * y, 2 * x};
}
inline Height quadric(double x, double y)
{
  return {.6 * x * x + .5 * x * y + .25 * y * y, 1.2 * x + .5 * y, .5 * x + .5 * y};
}
inline Height cubic(double x, double y)
{
  return {.5 * x * x - .3 * x * y + .2 * y * y + .25 * x * x * x - .15 * x * x * y + .1 * y * y * y,
          x - .3 * y + .75 * x * x - .3 * x * y, -.3 * x + .4 * y - .15 * x * x + .3 * y * y};
}
inline Height ellipsoid(double x, double y)
{
  const double root = std::sqrt(1 - x * x / 4 - y * y / 6.25);
  return {1.5 * root, -1.5 * x / (4 * root), -1.5 * y / (6.25 * root)};
}
inline Height waves(double x, double y)
{
  const double a = 1.5 * x + .4, b = 1.3 * y - .2;
  return {.3 * std::sin(a) * std::cos(b), .45 * std::cos(a) * std::cos(b),
          -.39 * std::sin(a) * std::sin(b)};
}
constexpr double sphere_radius = 1.5;
inline Height sphere(double x, double y)
{
  const double z = std::sqrt(sphere_radius * sphere_radius - x * x - y * y);
  return {z, -x / z, -y / z};
}

inline Value on_graph(const Graph& graph, double x, double y)
{
  const Height h = graph(x, y);
  return {{x, y, h.z}, unit({-h.x, -h.y, 1})};
}

inline Values sampled(const Extraordinary_net& net, const Graph& graph)
{
  Values values;
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto p = layout(net, v);
    values.push_back(on_graph(graph, p[0], p[1]));
  }
  return values;
}

// the points of a graph with normals estimated from the faces of a net with one more ring
inline Values with_estimated_normals(const Extraordinary_net& net, const Graph& graph)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  const Extraordinary_net larger(net.degree(), net.valence(), net.rings() + 1);
  Mesh mesh;
  for (const Value& v : sampled(larger, graph))
    mesh.add_vertex(Kernel::Point_3(v.point[0], v.point[1], v.point[2]));
  for (const auto& [s, corners] : larger.faces()) {
    std::vector<Mesh::Vertex_index> face;
    for (const auto& [i, j] : corners) face.emplace_back(larger.vertex(s, i, j));
    mesh.add_face(face);
  }
  const auto normals = CGAL::PN_subdivision_3::estimate_control_normals(mesh);
  Values values = sampled(net, graph);
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto& [s, i, j] = net.place(v);
    const Kernel::Vector_3 n = normals[Mesh::Vertex_index(larger.vertex(s, i, j))];
    values[v].normal = {n.x(), n.y(), n.z()};
  }
  return values;
}

// The middle vertex lies over a cylinder whose upper border is ring 1.
inline Values cylinder_cap(const Extraordinary_net& net)
{
  const double radius = 15;
  Values values;
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto& [s, i, j] = net.place(v);
    const double r = net.norm(v);
    if (r == 0) {
      values.push_back({{0, 0, 12 / radius}, {0, 0, 1}});
      continue;
    }
    const double steps = net.degree() == 3 || i == r ? j : 2 * r - i; // along the ring, in a sector
    const double of = net.degree() == 3 ? r : 2 * r;
    const double angle = 0.3 + 2 * pi() * (s + steps / of) / net.valence();
    const Vector normal{std::cos(angle), std::sin(angle), 0};
    values.push_back({{normal[0], normal[1], (10 - 5 * (r - 1)) / radius}, normal});
  }
  return values;
}

// A graph whose layout, points and normals are disturbed at random. It has to be curved more than by
// the disturbances: relative to curvatures near zero any oscillation is large.
inline Values rough(const Extraordinary_net& net, const Graph& graph, unsigned seed)
{
  std::mt19937 generator(seed);
  const auto random = [&](double size) { return size * (generator() / 2147483648. - 1); };
  Values values;
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto p = layout(net, v);
    const double x = p[0] + random(.2 * spacing), y = p[1] + random(.2 * spacing);
    Value value = on_graph(graph, x, y);
    for (double& c : value.point) c += random(.05 * spacing);
    for (double& c : value.normal) c += random(.15);
    values.push_back({value.point, unit(value.normal)});
  }
  return values;
}

// Points of a graph or, without one, of the plane, and normals with the slopes g(x, y).
inline Values with_slopes(const Extraordinary_net& net, const Graph& graph,
                          const std::function<std::array<double, 2>(double x, double y)>& g)
{
  Values values = graph ? sampled(net, graph) : Values(net.number_of_vertices());
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto p = layout(net, v);
    if (!graph) values[v].point = {p[0], p[1], 0};
    const auto slope = g(p[0], p[1]);
    values[v].normal = unit({-slope[0], -slope[1], 1});
  }
  return values;
}

// turns the data, so that they are not aligned with the axes of space
inline Values turned(Values values)
{
  const Vector axis = unit({1, -2, 1.5});
  const double c = std::cos(0.8), s = std::sin(0.8);
  const auto turn = [&](Vector& v) {
    const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
    const Vector across{axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2],
                        axis[0] * v[1] - axis[1] * v[0]};
    for (int k = 0; k < 3; ++k) v[k] = c * v[k] + s * across[k] + (1 - c) * along * axis[k];
  };
  for (Value& v : values) {
    turn(v.point);
    turn(v.normal);
  }
  return values;
}

struct Data_set
{
  std::string name;
  std::function<Values(const Extraordinary_net&)> values;
  bool has_sampled_normals; // those of a curved surface
};

// curved data, on which curvature oscillates and tends to a limit that is not flat
inline std::vector<Data_set> curved()
{
  const auto sampled_from = [](const std::string& name, const Graph& graph) {
    const auto values = [=](const Extraordinary_net& net) { return turned(sampled(net, graph)); };
    return Data_set{name, values, true};
  };
  return {
    sampled_from("saddle", saddle),
    sampled_from("quad", quadric),
    sampled_from("cubic", cubic),
    sampled_from("ellipsoid", ellipsoid),
    sampled_from("bicubic", waves),
    {"estimated cubic",
     [](const Extraordinary_net& net) { return turned(with_estimated_normals(net, cubic)); },
     false},
    {"cylinder cap", [](const Extraordinary_net& net) { return turned(cylinder_cap(net)); }, false},
    {"rough", [](const Extraordinary_net& net) { return turned(rough(net, saddle, 1)); }, false}};
}

// data that come out flat from valence 5 on: slopes without a part of the frequency of the tangents,
// and slopes of a pure twist
inline std::vector<Data_set> flat()
{
  const auto frequency_2 = [](double x, double y) -> std::array<double, 2> {
    const double r = std::hypot(x, y);
    if (r == 0) return {0, 0};
    return {(x * x - y * y) / r, 2 * x * y / r};
  };
  const auto twist = [](double x, double y) -> std::array<double, 2> { return {-y, x}; };
  const auto constant = [](double, double) -> std::array<double, 2> { return {0, 0}; };
  return {
    {"frequency 2",
     [=](const Extraordinary_net& net) { return turned(with_slopes(net, nullptr, frequency_2)); },
     false},
    {"twist",
     [=](const Extraordinary_net& net) { return turned(with_slopes(net, nullptr, twist)); }, false},
    {"constant normals",
     [=](const Extraordinary_net& net) { return turned(with_slopes(net, cubic, constant)); },
     false}};
}

// --- figures ---

using Curvature = CGAL::PN_subdivision_3::Extraordinary_curvature<double>;

// What is not a number is the worst, and remains so.
inline void raise(double& x, double y)
{
  if (std::isnan(y) || y > x) x = y;
}
inline void lower(double& x, double y)
{
  if (std::isnan(y) || y < x) x = y;
}

// how much of the mean curvature on ring 0 is left on ring 19
inline double remaining_mean_curvature(const Curvature& c)
{
  const auto largest = [](const auto& ring) {
    return (std::max)(std::abs(ring.mean_min), std::abs(ring.mean_max));
  };
  return largest(c.rings[19]) / largest(c.rings[0]);
}

// The worst of each figure over the curved data.
struct Figures
{
  double oscillation_12 = 0, oscillation_16 = 0, oscillation_20 = 0; // on these rings
  double rate = 0, prediction_error = 0;
  // of normals sampled from the surface: the least |K| on ring 20, relative to the scale of the ring
  double least_gaussian = 1;
};

template <class Zoom>
Figures figures(const Zoom& zoom)
{
  Figures f;
  for (const Data_set& set : curved()) {
    const Curvature c = zoom.measure(set.values(zoom.net()));
    raise(f.oscillation_12, c.rings[12].oscillation());
    raise(f.oscillation_16, c.rings[16].oscillation());
    raise(f.oscillation_20, c.rings[20].oscillation());
    raise(f.rate, c.rate());
    raise(f.prediction_error, c.prediction_error());
    if (!set.has_sampled_normals) continue;
    const auto& last = c.rings[20];
    const bool changes_sign = last.gaussian_min * last.gaussian_max <= 0;
    const double least = (std::min)(std::abs(last.gaussian_min), std::abs(last.gaussian_max));
    lower(f.least_gaussian, changes_sign ? 0 : least / last.scale());
  }
  return f;
}

// The largest part of the mean curvature that is left, over data that come out flat.
template <class Zoom>
double remaining_mean_curvature(const Zoom& zoom, const std::vector<Data_set>& sets)
{
  double largest = 0;
  for (const Data_set& set : sets)
    raise(largest, remaining_mean_curvature(zoom.measure(set.values(zoom.net()))));
  return largest;
}

} // namespace extraordinary_data

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_EXTRAORDINARY_DATA_H
