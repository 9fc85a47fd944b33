// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SURFACE_REFINER_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_SURFACE_REFINER_CASES_H

#include "Mesh_cases.h"

#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <limits>
#include <memory>
#include <random>
#include <stdexcept>

namespace surface_refiner_cases {

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

// n x n unit quads over the plane, wavy
inline Mesh grid(std::size_t n)
{
  Soup soup;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      soup.points.push_back(
        {double(i), double(j), 0.3 * std::sin(1.3 * double(i)) * std::cos(double(j))});
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t v = j * (n + 1) + i;
      soup.faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  Mesh mesh;
  build(soup, mesh, mesh.points());
  return mesh;
}

inline Soup united(Soup a, const Soup& b)
{
  const std::size_t n = a.points.size();
  for (const Triple& p : b.points) a.points.push_back({p[0] + 9, p[1], p[2]});
  for (Polygon f : b.faces) {
    for (std::size_t& v : f) v += n;
    a.faces.push_back(f);
  }
  return a;
}

// a component with a border, a closed one, and a vertex without edges
inline Soup quads_and_others()
{
  Soup soup = united(mixed_with_border(), cube());
  soup.points.push_back({0, 0, 20});
  return soup;
}
inline Soup triangles()
{
  Soup soup = united(triangles_with_border(), tetrahedron());
  soup.points.push_back({0, 0, 20});
  return soup;
}

// uneven ones, one of them missing
inline auto add_normals(Mesh& mesh)
{
  auto normals = mesh.add_property_map<Vertex, Vector>("n").first;
  for (Vertex v : mesh.vertices())
    normals[v] = v.idx() == 5 ? Vector(0, 0, 0)
                              : Vector(0.3 * std::sin(double(v.idx())), 0.1 * (v.idx() % 3), 1);
  return normals;
}

// a control mesh with edges and vertices that are sharp, for ever or for some rounds; with the seed 0 nothing is
struct Creased
{
  using Edge_map = Mesh::Property_map<Mesh::Edge_index, double>;
  using Vertex_map = Mesh::Property_map<Vertex, double>;
  using Normal_map = Mesh::Property_map<Vertex, Vector>;

  explicit Creased(const Soup& soup, unsigned seed)
  {
    build(soup, mesh, mesh.points());
    add_normals(mesh);
    find_maps();
    if (seed == 0) return;
    std::mt19937 generator(seed);
    const double sharpness[] = {std::numeric_limits<double>::infinity(), 0.5, 1, 1.7, 2};
    for (auto e : mesh.edges())
      if (generator() % 3 == 0) edges[e] = sharpness[generator() % 5];
    for (Vertex v : mesh.vertices())
      if (generator() % 9 == 0) vertices[v] = sharpness[generator() % 5];
  }
  Creased(const Creased& other)
    : mesh(other.mesh)
  {
    find_maps();
  }
  Creased& operator=(const Creased&) = delete;

  void find_maps()
  {
    edges = mesh.add_property_map<Mesh::Edge_index, double>("e", 0).first;
    vertices = mesh.add_property_map<Vertex, double>("v", 0).first;
    normals = mesh.add_property_map<Vertex, Vector>("n").first;
  }

  // calls f with named parameters
  template <class Function>
  void with_parameters(unsigned rounds, bool has_normals, const Function& f) const
  {
    const auto np =
      params::number_of_iterations(rounds).edge_is_constrained_map(edges).vertex_is_constrained_map(
        vertices);
    if (has_normals)
      f(np.vertex_normal_map(normals));
    else
      f(np);
  }

  Mesh mesh;
  Edge_map edges;
  Vertex_map vertices;
  Normal_map normals;
};

// Moves points and turns normals at random, one, several and all, and compares points and normals with those of
// subdivide(), bit by bit. Where there are no control normals, those of the result are not compared, since subdivide() drops
// them.
template <class Concurrency_tag = CGAL::Sequential_tag, class Scheme>
void expect_as_subdivide(const Soup& soup, const Scheme& scheme, unsigned rounds, unsigned seed = 0,
                         bool has_normals = true)
{
  constexpr bool is_linear = PN::internal::Is_linear<Scheme>::value;
  Creased control(soup, seed);
  using Refiner = PN::Surface_refiner<Mesh, Scheme, Kernel, Concurrency_tag>;
  std::unique_ptr<Refiner> refiner;
  control.with_parameters(rounds, has_normals, [&](const auto& np) {
    refiner = std::make_unique<Refiner>(control.mesh, scheme, np);
  });
  std::mt19937 generator(seed);
  std::uniform_real_distribution<> number(-0.3, 0.3);
  const std::size_t n = control.mesh.number_of_vertices();
  for (const std::size_t changes : {std::size_t(0), std::size_t(1), std::size_t(2), n}) {
    const std::vector<Point> old_points = refiner->points();
    for (std::size_t i = 0; i < changes; ++i) {
      const Vertex v(static_cast<unsigned>(changes == n ? i : generator() % n));
      control.mesh.point(v) += Vector(number(generator), number(generator), number(generator));
      refiner->set_point(v, control.mesh.point(v));
      if constexpr (!is_linear)
        if (has_normals) {
          const Vector normal(number(generator), 0.2, 1 + number(generator));
          try {
            refiner->set_normal(v, normal);
            control.normals[v] = normal;
          } catch (const std::invalid_argument&) { // between creases
          }
        }
    }
    const auto changed = refiner->update();
    Creased refined = control;
    refined.with_parameters(rounds, has_normals, [&](const auto& np) {
      PN::subdivide<Concurrency_tag>(refined.mesh, scheme, np);
    });
    EXPECT_EQ(refiner->number_of_faces(), refined.mesh.number_of_faces());
    EXPECT_EQ(refiner->points(),
              std::vector<Point>(refined.mesh.points().begin(), refined.mesh.points().end()));
    EXPECT_EQ(refiner->normals().empty(), is_linear);
    if (has_normals && !is_linear)
      for (Vertex v : refined.mesh.vertices()) {
        EXPECT_EQ(refiner->normals()[v], refined.normals[v]) << v << " after " << changes;
      }
    EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end()));
    EXPECT_EQ(std::adjacent_find(changed.begin(), changed.end()), changed.end());
    for (std::size_t v = 0; v < old_points.size(); ++v)
      if (!std::binary_search(changed.begin(), changed.end(), v)) {
        EXPECT_EQ(refiner->points()[v], old_points[v]) << v << " after " << changes;
      }
  }
}

} // namespace surface_refiner_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_SURFACE_REFINER_CASES_H
