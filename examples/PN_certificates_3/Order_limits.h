// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_LIMITS_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_LIMITS_H

#include "Order_samples.h"

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Points of limit surfaces, and how far they are from what was sampled.
namespace order_samples {

using Any_scheme = CGAL::PN_subdivision_3::Any_scheme<>;

// Points of the limit surface that belong to the mesh after some rounds. Without normals, which zero
// vectors stand for, it is that of the linear twin.
inline std::vector<Point> limits(Mesh mesh, const Any_scheme& scheme, unsigned rounds,
                                 bool is_linear)
{
  namespace PN = CGAL::PN_subdivision_3;
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  if (is_linear)
    for (const auto v : mesh.vertices()) normals[v] = CGAL::NULL_VECTOR;
  PN::subdivide(mesh, scheme,
                CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normals));
  const auto np =
    PN::parameters::tolerance(1e-12).max_depth(6).rounds_done(rounds).vertex_normal_map(normals);
  using Limit = PN::Limit_point<Kernel>;
  std::vector<Point> points;
  if (scheme.keeps_vertices()) {
    const auto found = mesh.add_property_map<Mesh::Vertex_index, Limit>("v:limit").first;
    PN::limit_points(mesh, scheme, found, np);
    for (const auto v : mesh.vertices()) points.push_back(found[v].point);
  } else { // those of a dual scheme belong to the faces
    const auto found = mesh.add_property_map<Mesh::Face_index, Limit>("f:limit").first;
    PN::limit_points(mesh, scheme, found, np);
    for (const auto f : mesh.faces()) points.push_back(found[f].point);
  }
  return points;
}

template <class Distance>
double largest(const std::vector<Point>& points, const Distance& distance)
{
  double d = 0;
  for (const Point& p : points) d = (std::max)(d, std::abs(distance(p)));
  return d;
}

// The largest distance from the graph in the middle of a layout, for each length h.
inline std::vector<double> errors(const Layout& layout, const Any_scheme& scheme, bool is_linear,
                                  const std::vector<double>& lengths)
{
  std::vector<double> all;
  for (const double h : lengths) {
    const Mesh mesh = control_mesh(layout, h);
    all.push_back(largest(limits(mesh, scheme, 2, is_linear),
                          [h](const Point& p) { return is_measured(p, h) ? distance(p) : 0; }));
  }
  return all;
}

// the order of the last halving of h
inline double order(const std::vector<double>& errors)
{
  const std::size_t n = errors.size();
  return std::log2(errors[n - 2] / errors[n - 1]);
}

} // namespace order_samples

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_ORDER_LIMITS_H
