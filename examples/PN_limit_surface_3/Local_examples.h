// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_LOCAL_EXAMPLES_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_LOCAL_EXAMPLES_H

#include "analysis/Extraordinary_net.h"
#include "analysis/extraordinary_curvature.h"

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// The meshes of data/ that sample a surface around one extraordinary vertex, which is the first. Used by
// an example and a test.
namespace local_examples {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Values = std::vector<PN::Point_normal<double, 3>>;

// z = sum of heights[i][j] B_i(x / 3) B_j(y / 3) with the cubic Bernstein polynomials B; x = 3 u,
// because the control points have the even abscissas 0, 1, 2, 3.
constexpr double bezier_heights[4][4] = {
  {0, .5, .25, -.25}, {.75, 2, 1.5, .25}, {.25, 2.25, 1.5, .75}, {-.5, .5, 1, -.25}};

// in the middle of the patch, from its derivatives
inline double gaussian_curvature_of_bezier()
{
  constexpr double b[3][4] = {
    {1. / 8, 3. / 8, 3. / 8, 1. / 8}, // B and its derivatives at 1/2, by x
    {-1. / 4, -1. / 4, 1. / 4, 1. / 4},
    {1. / 3, -1. / 3, -1. / 3, 1. / 3}};
  const auto z = [&](int by_x, int by_y) {
    double sum = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) sum += b[by_x][i] * b[by_y][j] * bezier_heights[i][j];
    return sum;
  };
  const double s = 1 + z(1, 0) * z(1, 0) + z(0, 1) * z(0, 1);
  return (z(2, 0) * z(0, 2) - z(1, 1) * z(1, 1)) / (s * s);
}

struct Local_example
{
  std::string file;
  std::optional<double> gaussian_curvature; // of the sampled surface at the vertex
};

inline std::vector<Local_example> all()
{
  const double bezier = gaussian_curvature_of_bezier();
  return {{"saddle_3.ply", -4.},
          {"saddle_5.ply", -4.},
          {"bezier_6.ply", bezier},
          {"bezier_7.ply", bezier},
          {"cylinder_cap_8.ply", std::nullopt}};
}

inline Mesh read(const std::string& file)
{
  Mesh mesh;
  std::ifstream in(file, std::ios::binary);
  if (!CGAL::IO::read_PLY(in, mesh)) throw std::runtime_error("cannot read " + file);
  return mesh;
}

inline auto normal_map(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
}

// The points and normals of the vertices around a vertex: each is some edges straight on from it, and
// some to the left of these. The mesh must have more rings of regular vertices than the net.
inline Values values_around(Mesh& mesh, Mesh::Vertex_index middle, const PN::Extraordinary_net& net)
{
  const auto normals = normal_map(mesh);
  const auto straight_on = [&](Mesh::Halfedge_index h) {
    return mesh.next(mesh.opposite(mesh.next(h)));
  };
  std::vector<Mesh::Halfedge_index> edges{mesh.opposite(mesh.halfedge(middle))};
  while (edges.size() < net.valence()) edges.push_back(mesh.opposite(mesh.prev(edges.back())));
  Values values;
  for (unsigned k = 0; k < net.number_of_vertices(); ++k) {
    const auto& [sector, i, j] = net.place(k);
    Mesh::Halfedge_index h = mesh.opposite(edges[0]);
    if (k > 0) {
      h = edges[sector];
      for (unsigned step = 1; step < i; ++step) h = straight_on(h);
      if (j > 0) h = mesh.next(h);
      for (unsigned step = 1; step < j; ++step) h = straight_on(h);
    }
    const auto v = mesh.target(h);
    const auto& p = mesh.point(v);
    const auto& n = normals[v];
    values.push_back({{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}});
  }
  return values;
}

// The curvatures around the first vertex. The first round makes five rings of three, and a border.
template <class Scheme>
PN::Extraordinary_curvature<double> curvature(Mesh mesh, const Scheme& scheme)
{
  const PN::Extraordinary_vertex_zoom<Scheme> zoom(scheme, mesh.degree(Mesh::Vertex_index(0)));
  const auto normals = normal_map(mesh);
  PN::subdivide(mesh, scheme, CGAL::parameters::vertex_normal_map(normals));
  return zoom.measure(values_around(mesh, Mesh::Vertex_index(0), zoom.net()), 12);
}

} // namespace local_examples

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_LOCAL_EXAMPLES_H
