// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// A cylinder that is cut by an oblique plane, with its exact normals and the cut as a crease: how far wall and crease of
// the limit surface are off the cylinder, if sides and rows are doubled and if the sides alone are. Prints rows of
// the manual's page "Approximation Order".
//
//   oblique_crease

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh cut_cylinder(int sides, int rows)
{
  Mesh mesh;
  const auto normals =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  const auto add_vertex = [&](int i, int j) {
    const double a = 2 * std::acos(-1.) * i / sides, x = std::cos(a), y = std::sin(a);
    normals[mesh.add_vertex(Kernel::Point_3(x, y, (1.2 + .5 * x) * j / rows))] = {x, y, 0};
  };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < sides; ++i) add_vertex(i, j);
  const auto vertex = [&](int i, int j) {
    return Mesh::Vertex_index(Mesh::size_type(j * sides + i % sides));
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < sides; ++i)
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  return mesh;
}

struct Off
{
  double wall = 0, crease = 0;
};

Off measure(int sides, int rows)
{
  Mesh mesh = cut_cylinder(sides, rows);
  const auto normals =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  const auto scheme = PN::CatmullClark_scheme();
  PN::subdivide(mesh, scheme, CGAL::parameters::number_of_iterations(2).vertex_normal_map(normals));
  const auto limits =
    mesh.add_property_map<Mesh::Vertex_index, PN::Limit_point<Kernel>>("v:limit").first;
  PN::limit_points(
    mesh, scheme, limits,
    PN::parameters::tolerance(1e-11).border(PN::Border::curve).vertex_normal_map(normals));
  Off off;
  for (const auto v : mesh.vertices()) {
    double& largest = mesh.is_border(v) ? off.crease : off.wall;
    const Kernel::Point_3& p = limits[v].point;
    largest = (std::max)(largest, std::abs(std::hypot(p.x(), p.y()) - 1));
  }
  return off;
}

void print(int rows, bool rows_double)
{
  Off before;
  for (int sides = 8; sides <= 64; sides *= 2, rows *= rows_double ? 2 : 1) {
    const Off off = measure(sides, rows);
    std::printf("<tr><td>%d, %d</td><td>%.1e</td><td>", sides, rows, off.wall);
    if (sides > 8) std::printf("%.1f", std::log2(before.wall / off.wall));
    std::printf("</td><td>%.1e</td><td>", off.crease);
    if (sides > 8) std::printf("%.1f", std::log2(before.crease / off.crease));
    std::puts("</td></tr>");
    before = off;
  }
}

} // namespace

int main()
{
  std::puts("#table oblique_crease");
  print(2, true);
  print(4, false);
}
