// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_SAMPLES_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_SAMPLES_H

#include "analysis/Extraordinary_net.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

// Small control nets on a surface that is no quadric, with its exact points and normals, which shrink
// with a length h: for measuring the order with which their limit surfaces approximate it. Used by an
// example, a test and a benchmark.
namespace order_samples {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Normals = Mesh::Property_map<Mesh::Vertex_index, Vector>;
using Place = std::array<double, 2>; // in the plane, or in units of h

inline Vector unit(const Vector& v)
{
  return v / std::sqrt(v.squared_length());
}

// --- the surface: the graph of a product of sines ---

inline double height(double x, double y)
{
  return .3 * std::sin(1.5 * x + .4) * std::cos(1.3 * y - .2);
}

inline Vector steep_normal(double x, double y)
{
  const double a = 1.5 * x + .4, b = 1.3 * y - .2;
  return {-.45 * std::cos(a) * std::cos(b), .39 * std::sin(a) * std::sin(b), 1};
}

// the normals of the graph at the foot of p, and the signed distance of p from it
inline double distance(const Point& p, Vector* normal = nullptr)
{
  double x = p.x(), y = p.y();
  Vector n, off;
  for (int i = 0; i < 20; ++i) { // the foot of p on the tangent plane is the next guess
    n = steep_normal(x, y);
    off = p - Point(x, y, height(x, y));
    const Vector foot = off - (off * n / n.squared_length()) * n;
    x += foot.x();
    y += foot.y();
    if (foot.squared_length() < 1e-32) break;
  }
  if (normal != nullptr) *normal = unit(n);
  return off * unit(n);
}

// --- layouts in units of h ---

struct Layout
{
  std::vector<Place> places;
  std::vector<std::vector<std::size_t>> faces;
};

constexpr int cells = 6; // a net ends so many cells from its middle

// numbers from -1 to 1 that are the same everywhere
class Random
{
public:
  double operator()()
  {
    m_state = m_state * 6364136223846793005u + 1442695040888963407u;
    return double(m_state >> 11) * 0x1p-52 - 1;
  }

private:
  std::uint64_t m_state = 20221014;
};

// columns from -cells to cells, rows from `first_row` to cells; places moved at random by up to `off`
inline Layout grid(bool triangles, double off = 0, int first_row = -cells)
{
  Layout layout;
  Random random;
  for (int j = first_row; j <= cells; ++j)
    for (int i = -cells; i <= cells; ++i) {
      const double s = triangles ? i + j / 2. : i, t = triangles ? j * std::sqrt(.75) : j;
      layout.places.push_back({s + off * random(), t + off * random()});
    }
  const std::size_t n = 2 * cells + 1, rows = layout.places.size() / n;
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const std::size_t v = j * n + i;
      if (triangles) {
        layout.faces.push_back({v, v + 1, v + n});
        layout.faces.push_back({v + 1, v + n + 1, v + n});
      } else
        layout.faces.push_back({v, v + 1, v + n + 1, v + n});
    }
  return layout;
}

// n sectors of parallelograms, or of triangles, about a middle vertex of valence n
inline Layout sectors(bool triangles, unsigned n)
{
  using Net = CGAL::PN_subdivision_3::Extraordinary_net;
  const Net net(triangles ? 3 : 4, n, cells);
  Layout layout;
  for (Net::Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto& [s, i, j] = net.place(v);
    const double angle = 2 * std::acos(-1.) / n, a = .3 + s * angle, b = a + angle;
    layout.places.push_back({i * std::cos(a) + j * std::cos(b), i * std::sin(a) + j * std::sin(b)});
  }
  for (const auto& [s, corners] : net.faces()) {
    std::vector<std::size_t>& face = layout.faces.emplace_back();
    for (const auto& [i, j] : corners) face.push_back(net.vertex(s, i, j));
  }
  return layout;
}

// --- control meshes ---

// a smooth map of the plane, for layouts that are smooth but not even
inline Place warped(const Place& p)
{
  return {p[0] + .12 * std::sin(2 * p[0] + 1.1 * p[1] + .3),
          p[1] + .12 * std::cos(1.3 * p[0] - 1.7 * p[1])};
}

constexpr Place middle = {.31, .17};

// the layout over the graph, h times as large; with its normals in the map "v:normal"
inline Mesh control_mesh(const Layout& layout, double h)
{
  Mesh mesh;
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (const Place& p : layout.places) {
    const auto [x, y] = warped({middle[0] + h * p[0], middle[1] + h * p[1]});
    normals[mesh.add_vertex(Point(x, y, height(x, y)))] = unit(steep_normal(x, y));
  }
  for (const std::vector<std::size_t>& face : layout.faces) {
    std::vector<Mesh::Vertex_index> corners;
    for (std::size_t v : face) corners.emplace_back(Mesh::size_type(v));
    mesh.add_face(corners);
  }
  return mesh;
}

// whether p is over the middle cells of the net
inline bool is_measured(const Point& p, double h)
{
  const Place m = warped(middle);
  return (std::max)(std::abs(p.x() - m[0]), std::abs(p.y() - m[1])) <= h;
}

} // namespace order_samples

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_SAMPLES_H
