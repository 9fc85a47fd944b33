// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A mask of your own, written for CGAL's PQQ(), which knows nothing of normals, becomes a
// point-normal mask. The control mesh is a box inscribed in an ellipsoid, with the ellipsoid's
// normals.

#include <CGAL/PN_cgal_masks_3/PN_mask_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// Old vertices and edge midpoints move by `pull` towards the mean centroid of their faces.
// 0: bilinear subdivision; 1/2: Catmull-Clark's edge points.
template <class Graph,
          class PointMap = typename boost::property_map<Graph, CGAL::vertex_point_t>::type>
class Pull_mask_3
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<Graph>::halfedge_descriptor;
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;
  using Node = typename boost::property_traits<PointMap>::value_type;

public:
  Pull_mask_3(const Graph& graph, PointMap points, double pull)
    : graph_(&graph)
    , points_(points)
    , pull_(pull)
  {}

  void face_node(face_descriptor f, Node& node) const { node = centroid(f); }

  void edge_node(halfedge_descriptor h, Node& node) const
  {
    const Node faces =
      CGAL::midpoint(centroid(face(h, *graph_)), centroid(face(opposite(h, *graph_), *graph_)));
    node = CGAL::barycenter(edge_midpoint(h), 1 - pull_, faces, pull_);
  }

  void vertex_node(vertex_descriptor v, Node& node) const
  {
    Vector sum = CGAL::NULL_VECTOR;
    double n = 0;
    for (face_descriptor f : CGAL::faces_around_target(halfedge(v, *graph_), *graph_)) {
      sum = sum + (centroid(f) - CGAL::ORIGIN);
      ++n;
    }
    node = CGAL::barycenter(get(points_, v), 1 - pull_, CGAL::ORIGIN + sum / n, pull_);
  }

  void border_node(halfedge_descriptor h, Node& edge, Node& vertex) const
  {
    edge = edge_midpoint(h);
    vertex = get(points_, target(h, *graph_));
  }

private:
  Node edge_midpoint(halfedge_descriptor h) const
  {
    return CGAL::midpoint(get(points_, source(h, *graph_)), get(points_, target(h, *graph_)));
  }

  Node centroid(face_descriptor f) const
  {
    Vector sum = CGAL::NULL_VECTOR;
    double n = 0;
    for (vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, *graph_), *graph_)) {
      sum = sum + (get(points_, v) - CGAL::ORIGIN);
      ++n;
    }
    return CGAL::ORIGIN + sum / n;
  }

  const Graph* graph_;
  PointMap points_;
  double pull_;
};

// x^2/9 + y^2/4 + z^2
double ellipsoid(const Point& p)
{
  return p.x() * p.x() / 9 + p.y() * p.y() / 4 + p.z() * p.z();
}

double largest_deviation_from_ellipsoid(const Mesh& mesh)
{
  double deviation = 0;
  for (const Point& p : mesh.points())
    deviation = (std::max)(deviation, std::abs(std::sqrt(ellipsoid(p)) - 1));
  return deviation;
}

int main()
{
  const double s = 1 / std::sqrt(3.);
  const Point a(-3 * s, -2 * s, -s), b(3 * s, 2 * s, s);
  Mesh mesh;
  CGAL::make_hexahedron(a, Point(b.x(), a.y(), a.z()), Point(b.x(), b.y(), a.z()),
                        Point(a.x(), b.y(), a.z()), Point(a.x(), b.y(), b.z()),
                        Point(a.x(), a.y(), b.z()), Point(b.x(), a.y(), b.z()), b, mesh);
  Mesh linear = mesh;

  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    normals[v] = Vector(p.x() / 9, p.y() / 4, p.z()); // any length will do
  }

  const double pull = 0.5;
  const unsigned int rounds = 4;
  const auto point_normals = PN::Zipped_point_normal_map(mesh.points(), normals);
  CGAL::Subdivision_method_3::PQQ(
    mesh, PN::make_PN_mask_3<Pull_mask_3>(mesh, point_normals, pull),
    params::vertex_point_map(point_normals).number_of_iterations(rounds));
  CGAL::Subdivision_method_3::PQQ(linear, Pull_mask_3<Mesh>(linear, linear.points(), pull),
                                  params::number_of_iterations(rounds));

  std::cout << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces() << " faces\n"
            << "largest relative deviation from the ellipsoid\n"
            << "  linear: " << largest_deviation_from_ellipsoid(linear) << '\n'
            << "  PN:     " << largest_deviation_from_ellipsoid(mesh) << '\n';
  return EXIT_SUCCESS;
}
