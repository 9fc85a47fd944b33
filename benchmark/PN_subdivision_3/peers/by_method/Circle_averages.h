// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_CIRCLE_AVERAGES_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_CIRCLE_AVERAGES_H

#include "Curves.h"
#include "Patches.h"

#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

// Loop subdivision of closed triangle meshes by circle averages (the paper is named in Curves.h): each mean of several
// points and normals is made of means of two.
namespace by_method {

// In the plane of both normals it is that of curves; across that plane points are averaged linearly.
inline Corner circle_average(const Corner& a, const Corner& b, double weight)
{
  const Vector axis = CGAL::cross_product(a.normal, b.normal), d = b.point - a.point;
  const double sine = length(axis);
  if (sine < 1e-12) return {a.point + weight * d, a.normal};
  const Vector up = axis / sine, x = a.normal, y = CGAL::cross_product(up, x);
  const Curve_point from{{0, 0}, {1, 0}}, to{{d * x, d * y}, {b.normal * x, b.normal * y}};
  const Curve_point c = circle_average(from, to, weight);
  return {a.point + c.point.x() * x + c.point.y() * y + weight * (d * up) * up,
          c.normal.x() * x + c.normal.y() * y};
}

template <class Mesh>
class Circle_average_Loop
{
public:
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Point = typename Mesh::Point;

  template <class Normals>
  Circle_average_Loop(Mesh& mesh, const Normals& normals)
    : m_mesh(mesh)
  {
    for (const auto v : mesh.vertices())
      m_corners.push_back({mesh.point(v) - CGAL::ORIGIN, normals[v]});
  }

  void round()
  {
    std::vector<Corner> refined(m_corners.size());
    CGAL::Subdivision_method_3::PTQ(m_mesh, Mask{*this, refined},
                                    CGAL::parameters::number_of_iterations(1));
    m_corners.swap(refined);
    for (const auto v : m_mesh.vertices())
      if (m_mesh.point(v) != CGAL::ORIGIN + corner(v).point)
        throw std::logic_error("PTQ has another order of vertices");
  }

  // by the weights of limit points
  void move_to_limit()
  {
    std::vector<Corner> limits;
    for (const auto v : m_mesh.vertices())
      limits.push_back(circle_average(corner(v), ring(v), 1 / (1 + 3 / (8 * weight_of_ring(v)))));
    m_corners.swap(limits);
    for (const auto v : m_mesh.vertices()) m_mesh.point(v) = CGAL::ORIGIN + corner(v).point;
  }

private:
  // PTQ asks for the new vertices of edges in the order in which it adds them
  struct Mask
  {
    void edge_node(Halfedge h, Point& p)
    {
      const Mesh& m = loop.m_mesh;
      const auto opposite = [&](Halfedge g) { return loop.corner(m.target(m.next(g))); };
      const Corner ends = circle_average(loop.corner(m.source(h)), loop.corner(m.target(h)), .5);
      const Corner sides = circle_average(opposite(h), opposite(m.opposite(h)), .5);
      refined.push_back(circle_average(ends, sides, .25));
      p = CGAL::ORIGIN + refined.back().point;
    }
    void vertex_node(Vertex v, Point& p)
    {
      Corner& c = refined[v.idx()];
      c = circle_average(loop.corner(v), loop.ring(v), loop.weight_of_ring(v));
      p = CGAL::ORIGIN + c.point;
    }
    void border_node(Halfedge, Point&, Point&) { throw std::logic_error("the mesh is not closed"); }

    const Circle_average_Loop& loop;
    std::vector<Corner>& refined;
  };

  const Corner& corner(Vertex v) const { return m_corners[v.idx()]; }

  // the mean of the neighbors, one after the other
  Corner ring(Vertex v) const
  {
    Corner mean{};
    double n = 0;
    for (const auto w : CGAL::vertices_around_target(v, m_mesh)) {
      mean = n == 0 ? corner(w) : circle_average(mean, corner(w), 1 / (n + 1));
      ++n;
    }
    return mean;
  }

  double weight_of_ring(Vertex v) const
  {
    const double c = .375 + std::cos(2 * std::acos(-1.) / double(m_mesh.degree(v))) / 4;
    return .625 - c * c;
  }

  Mesh& m_mesh;
  std::vector<Corner> m_corners;
};

} // namespace by_method

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_CIRCLE_AVERAGES_H
