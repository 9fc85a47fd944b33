// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What any scheme can do: point-normal and linear subdivision, several threads, exact numbers and
// eigenvalues. For the examples with schemes of your own.

#ifndef TRY_SCHEME_H
#define TRY_SCHEME_H

#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#if __has_include(<Eigen/Eigenvalues>)
#  include <Eigen/Eigenvalues>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Exact_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Exact_mesh = CGAL::Surface_mesh<Exact_kernel::Point_3>;

using Normals = PN::Estimated_control_normals<Mesh::Vertex_index, Kernel>;

template <class M>
double largest_distance(const Mesh& a, const M& b)
{
  double squared = 0;
  for (Mesh::Vertex_index v : a.vertices()) {
    const auto& q = b.point(v);
    const Kernel::Point_3 p(CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z()));
    squared = (std::max)(squared, CGAL::squared_distance(a.point(v), p));
  }
  return std::sqrt(squared);
}

template <class Tag, class Scheme>
Mesh refined(Mesh mesh, const Normals& normals, const Scheme& scheme, unsigned rounds)
{
  PN::subdivide<Tag>(mesh, scheme,
                     params::number_of_iterations(rounds).vertex_normal_map(normals.clone()));
  return mesh;
}

// The largest distance between one round with double and one with exact numbers.
template <class Scheme>
double rounding_error(const Mesh& control, const Normals& normals, const Scheme& scheme)
{
  // with the same numbers of all elements
  Exact_mesh exact;
  for (const Kernel::Point_3& p : control.points())
    exact.add_vertex(Exact_kernel::Point_3(p.x(), p.y(), p.z()));
  for (Mesh::Face_index f : control.faces())
    exact.add_face(CGAL::vertices_around_face(control.halfedge(f), control));
  PN::Estimated_control_normals<Exact_mesh::Vertex_index, Exact_kernel> exact_normals;
  for (Mesh::Vertex_index v : control.vertices()) {
    const Kernel::Vector_3 n = normals[v];
    put(exact_normals, v, Exact_kernel::Vector_3(n.x(), n.y(), n.z()));
    put(exact_normals.roundness_map(), v, get(normals.roundness_map(), v));
  }
  PN::subdivide(exact, scheme, params::vertex_normal_map(exact_normals));
  return largest_distance(refined<CGAL::Sequential_tag>(control, normals, scheme, 1), exact);
}

#if __has_include(<Eigen/Eigenvalues>)
// The moduli, largest first, of the eigenvalues of the matrix that takes an interior vertex among
// triangles or quads and its neighborhood to their successors: the ends of its edges and, with quads,
// the corners opposite to it. Column by column: what a round makes of 1 at a vertex and 0 elsewhere.
template <class Scheme>
std::vector<double> eigenvalues_at(Mesh::Vertex_index v, const Mesh& mesh, const Scheme& scheme)
{
  const auto child = [](std::size_t i) { return Mesh::Vertex_index(Mesh::size_type(i)); };
  const std::size_t first_edge = mesh.number_of_vertices();
  const std::size_t first_face = first_edge + mesh.number_of_edges();
  std::vector<Mesh::Vertex_index> olds{v}, news{v};
  for (Mesh::Halfedge_index h : CGAL::halfedges_around_target(v, mesh)) {
    olds.push_back(mesh.source(h));
    news.push_back(child(first_edge + mesh.edge(h)));
    if (mesh.degree(mesh.face(h)) == 3) continue;
    olds.push_back(mesh.target(mesh.next(mesh.next(h))));
    news.push_back(child(first_face + mesh.face(h)));
  }
  const auto size = Eigen::Index(olds.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    Mesh unit = mesh;
    for (Mesh::Vertex_index u : unit.vertices())
      unit.point(u) = Kernel::Point_3(u == olds[std::size_t(j)] ? 1 : 0, 0, 0);
    PN::subdivide(unit, PN::linear(scheme));
    for (Eigen::Index i = 0; i < size; ++i) matrix(i, j) = unit.point(news[std::size_t(i)]).x();
  }
  std::vector<double> values;
  for (const auto& z : matrix.eigenvalues()) values.push_back(std::abs(z));
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

// After one round a Catmull-Clark-like scheme has quads only, and the extraordinary vertices are
// apart from each other.
template <class Scheme>
void print_eigenvalues(Mesh mesh, const Scheme& scheme)
{
  PN::subdivide(mesh, PN::linear(scheme));
  const std::size_t regular = CGAL::is_triangle_mesh(mesh) ? 6 : 4;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    if (mesh.is_isolated(v) || mesh.is_border(v) || mesh.degree(v) == regular) continue;
    std::cout << "Eigenvalues at a vertex of valence " << mesh.degree(v) << ':';
    const std::vector<double> values = eigenvalues_at(v, mesh, scheme);
    for (std::size_t i = 0; i < (std::min<std::size_t>)(6, values.size()); ++i)
      std::cout << ' ' << values[i];
    std::cout << std::endl;
    return;
  }
}
#endif

// Reads a mesh, refines it in all ways, writes the refined one; whether the results agree.
template <class Scheme>
bool try_scheme(const std::string& filename, const Scheme& scheme, const std::string& output)
{
  Mesh control;
  if (!CGAL::IO::read_polygon_mesh(filename, control) || control.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return false;
  }
  const Normals normals = PN::estimate_control_normals(control);
  std::cout << "Input: " << num_vertices(control) << " vertices, " << num_faces(control) << " faces"
            << std::endl;

  CGAL::Real_timer timer;
  timer.start();
  const Mesh mesh = refined<CGAL::Sequential_tag>(control, normals, scheme, 3);
  timer.stop();
  std::cout << "Output: " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces in "
            << timer.time() << " s" << std::endl;

  Mesh linear = control;
  PN::subdivide(linear, PN::linear(scheme), params::number_of_iterations(3));
  std::cout << "Largest distance to the linear scheme: " << largest_distance(mesh, linear)
            << std::endl;

  const double error = rounding_error(control, normals, scheme);
  std::cout << "Largest distance of one round to an exact one: " << error << std::endl;
  bool agree = error < 1e-13;

#ifdef CGAL_LINKED_WITH_TBB
  const double difference =
    largest_distance(mesh, refined<CGAL::Parallel_tag>(control, normals, scheme, 3));
  std::cout << "Largest distance to the result of several threads: " << difference << std::endl;
  agree = agree && difference == 0;
#endif
#if __has_include(<Eigen/Eigenvalues>)
  print_eigenvalues(control, scheme);
#endif
  return CGAL::IO::write_polygon_mesh(output, mesh, params::stream_precision(17)) && agree;
}

#endif // TRY_SCHEME_H
