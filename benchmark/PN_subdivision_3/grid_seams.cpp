// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// How smooth `CatmullClark_scheme::Grid` is where its grid lines meet the rules of Catmull-Clark subdivision about an irregular
// vertex: n sectors of 4 x 4 quads, without and with noise of points and normals. The page "Rules of the Schemes" has a summary.
//
//   grid_seams

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

constexpr int quads = 4; // of a sector, along each ray

Vector unit(const Vector& v)
{
  return v / std::sqrt(v.squared_length());
}

Mesh star(int n, double largest_noise)
{
  Mesh mesh;
  std::mt19937 random(5);
  const auto noise = [&] { return largest_noise * (double(random()) / 2147483648. - 1); };
  const auto normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
  const auto add_vertex = [&](double x, double y) {
    const Vertex v = mesh.add_vertex(
      Point(x + noise(), y + noise(), .1 * x * x - .05 * y * y + .06 * x * y + noise()));
    normals[v] = unit(Vector(-.2 * x - .06 * y + noise(), .1 * y - .06 * x + noise(), 1 + noise()));
  };
  // after the center the sectors, each with one of its rays
  add_vertex(0, 0);
  const double pi = std::acos(-1.);
  for (int s = 0; s < n; ++s)
    for (int i = 1; i <= quads; ++i)
      for (int j = 0; j <= quads; ++j) {
        const double a = 2 * pi * s / n, b = 2 * pi * (s + 1) / n;
        add_vertex(i * std::cos(a) + j * std::cos(b), i * std::sin(a) + j * std::sin(b));
      }
  const auto vertex = [&](int s, int i, int j) {
    if (i == 0 && j == 0) return Vertex(0);
    if (i == 0) return Vertex(Mesh::size_type(1 + ((s + 1) % n * quads + j - 1) * (quads + 1)));
    return Vertex(Mesh::size_type(1 + (s * quads + i - 1) * (quads + 1) + j));
  };
  for (int s = 0; s < n; ++s)
    for (int i = 0; i < quads; ++i)
      for (int j = 0; j < quads; ++j)
        mesh.add_face(vertex(s, i, j), vertex(s, i + 1, j), vertex(s, i + 1, j + 1),
                      vertex(s, i, j + 1));
  return mesh;
}

// The refined points of two sectors that share a ray: rows along it, columns across it.
class Strip
{
public:
  Strip(const Mesh& mesh, Halfedge ray, int rounds)
    : rounds_(rounds)
    , side_(quads << rounds)
    , points_(std::size_t(side_ + 1) * std::size_t(2 * side_ + 1))
  {
    for (int i = 0; i <= side_; ++i) {
      Halfedge h = ray; // from (i, 0) to (i + 1, 0), or from (side - 1, 0) to (side, 0)
      const bool is_end = i == side_;
      for (int j = 0; j <= side_; ++j, h = next_row(mesh, h))
        put(i, j, mesh.point(is_end ? mesh.target(h) : mesh.source(h)));
      h = mesh.opposite(ray);
      for (int j = 0; j <= side_; ++j, h = next_row(mesh, h))
        put(i, -j, mesh.point(is_end ? mesh.source(h) : mesh.target(h)));
      if (i < side_ - 1) ray = mesh.next(mesh.opposite(mesh.next(ray)));
    }
  }

  // of the second divided differences where the distance to the irregular vertex, in control quads, is from `inner` to `outer`:
  // the largest one, and the largest jump from one vertex to the next
  std::pair<double, double> second_differences(double inner, double outer) const
  {
    double largest = 0, jump = 0;
    for_ring(inner, outer, [&](int i, int j) {
      for (const auto& [di, dj] : {std::pair(1, 0), {0, 1}}) {
        if (i + 2 * di > side_ || i - di < 0 || std::abs(j) + 2 * dj > side_) continue;
        const Vector second = difference(i, j, di, dj);
        largest = (std::max)(largest, second.squared_length());
        jump = (std::max)(jump, (difference(i + di, j + dj, di, dj) - second).squared_length());
      }
    });
    const double unit = std::ldexp(1., 2 * rounds_);
    return {unit * std::sqrt(largest), unit * std::sqrt(jump)};
  }

private:
  static Halfedge next_row(const Mesh& mesh, Halfedge h)
  {
    return mesh.is_border(h) ? h : mesh.opposite(mesh.next(mesh.next(h)));
  }

  std::size_t place(int i, int j) const
  {
    return std::size_t(i) * std::size_t(2 * side_ + 1) + std::size_t(j + side_);
  }
  const Point& at(int i, int j) const { return points_[place(i, j)]; }
  void put(int i, int j, const Point& p) { points_[place(i, j)] = p; }

  Vector difference(int i, int j, int di, int dj) const
  {
    return (at(i + di, j + dj) - at(i, j)) - (at(i, j) - at(i - di, j - dj));
  }

  template <class Function>
  void for_ring(double inner, double outer, const Function& f) const
  {
    const double unit = 1 << rounds_;
    for (int i = 1; i < side_; ++i)
      for (int j = 1 - side_; j < side_; ++j) {
        const double distance = (std::max)(i, std::abs(j)) / unit;
        if (inner <= distance && distance <= outer) f(i, j);
      }
  }

  int rounds_, side_;
  std::vector<Point> points_;
};

template <class Scheme>
void print(const std::string& name, int n, double noise, const Scheme& scheme)
{
  std::printf("<tr><td>%d</td><td>%.2g</td><td>%s</td>", n, noise, name.c_str());
  for (const unsigned rounds : {2u, 4u, 6u}) {
    Mesh mesh = star(n, noise);
    const auto normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
    PN::subdivide(mesh, scheme,
                  CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normals));
    double largest = 0, jump = 0;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(Vertex(0)))) {
      const auto [l, j] = Strip(mesh, mesh.opposite(h), int(rounds)).second_differences(.5, 2.5);
      largest = (std::max)(largest, l);
      jump = (std::max)(jump, j);
    }
    std::printf("<td>%.2f</td><td>%.2g</td>", largest, jump);
  }
  std::printf("</tr>\n");
}

} // namespace

int main()
{
  std::printf("#table grid_seams\n");
  for (const double noise : {0., .1})
    for (const int n : {4, 5}) {
      print("grid lines", n, noise, PN::CatmullClark_scheme::Grid());
      print("Catmull-Clark", n, noise, PN::CatmullClark_scheme());
    }
  return 0;
}
