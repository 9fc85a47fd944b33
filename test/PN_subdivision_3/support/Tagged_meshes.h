// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Meshes of any type with sharp edges, sharp vertices and normals of corners, and all that they hold.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_TAGGED_MESHES_H
#define CGAL_PN_SUBDIVISION_3_TEST_TAGGED_MESHES_H

#include "Crease_shapes.h"
#include "Failing_map.h"
#include "Mesh_cases.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>

#include <set>

namespace tagged_meshes {

using namespace crease_shapes;
using crease_levels::Control;
using crease_levels::Crease_run;
using crease_levels::Index;
using crease_levels::triangulated;
using crease_levels::Triple;
using crease_levels::undirected;
namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

template <class Tag, class Mesh>
using Dynamic_map = typename boost::property_map<Mesh, Tag>::type;

template <class Mesh>
using Vertex_points = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
template <class Mesh>
using Dynamic_points = Dynamic_map<CGAL::dynamic_vertex_property_t<Point_3>, Mesh>;

template <class Mesh, class Point_map>
struct Make_points
{
  static Point_map make(Mesh& mesh)
  {
    if constexpr (std::is_same_v<Point_map, Vertex_points<Mesh>>)
      return get(CGAL::vertex_point, mesh);
    else
      return get(CGAL::dynamic_vertex_property_t<Point_3>(), mesh);
  }
};

// a mesh with its tags and normals
template <class Mesh, class Point_map = Vertex_points<Mesh>>
struct Tagged
{
  using Traits = boost::graph_traits<Mesh>;

  explicit Tagged(const Control& control)
    : points(Make_points<Mesh, Point_map>::make(mesh))
  {
    mesh_cases::build(control, mesh, points);
    sharp = get(CGAL::dynamic_edge_property_t<double>(), mesh);
    corners = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    normals = get(CGAL::dynamic_halfedge_property_t<Vector_3>(), mesh);
    roundness = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    std::map<typename Traits::vertex_descriptor, int> index;
    for (auto v : vertices(mesh)) {
      const int i = int(index.size());
      index[v] = i;
      const auto it = control.sharp_vertices.find(i);
      put(roundness, v, 1.);
      put(corners, v, it == control.sharp_vertices.end() ? 0. : it->second);
    }
    for (auto e : edges(mesh)) {
      const auto it =
        control.sharp_edges.find(undirected(index[source(e, mesh)], index[target(e, mesh)]));
      put(sharp, e, it == control.sharp_edges.end() ? 0. : it->second);
    }
    int f = 0;
    for (auto face : faces(mesh)) {
      for (auto h : CGAL::halfedges_around_face(halfedge(face, mesh), mesh)) {
        const auto it = control.normals.find({f, index[target(h, mesh)]});
        const Triple n = it == control.normals.end() ? Triple{0, 0, 0} : it->second;
        put(normals, h, Vector_3(n[0], n[1], n[2]));
      }
      ++f;
    }
  }

  template <class Scheme, class Concurrency_tag = CGAL::Sequential_tag>
  void subdivide(const Scheme& scheme, unsigned rounds)
  {
    PN::subdivide<Concurrency_tag>(
      mesh, scheme,
      PN::parameters::join(PN::parameters::vertex_roundness_map(roundness),
                           np::number_of_iterations(rounds)
                             .vertex_point_map(points)
                             .edge_is_constrained_map(sharp)
                             .vertex_is_constrained_map(corners)
                             .vertex_normal_map(normals)));
  }

  Mesh mesh;
  Point_map points;
  Dynamic_map<CGAL::dynamic_edge_property_t<double>, Mesh> sharp;
  Dynamic_map<CGAL::dynamic_vertex_property_t<double>, Mesh> corners;
  Dynamic_map<CGAL::dynamic_halfedge_property_t<Vector_3>, Mesh> normals;
  Dynamic_map<CGAL::dynamic_vertex_property_t<double>, Mesh> roundness;
};

inline Triple triple(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}
inline Triple triple(const Vector_3& p)
{
  return {p.x(), p.y(), p.z()};
}

// all that a tagged mesh has: points, normals of (face as the set of its vertices, vertex), sharp edges
struct State
{
  std::vector<Triple> points;
  std::map<std::pair<std::set<int>, int>, Triple> normals;
  std::map<Edge, double> sharp;
  std::vector<double> corners;

  bool operator==(const State& s) const
  {
    return points == s.points && normals == s.normals && corners == s.corners &&
           std::equal(sharp.begin(), sharp.end(), s.sharp.begin(), s.sharp.end(),
                      [](const auto& a, const auto& b) {
                        const bool are_nan = std::isnan(a.second) && std::isnan(b.second);
                        return a.first == b.first && (a.second == b.second || are_nan);
                      });
  }
};

template <class Mesh, class Point_map>
State state(const Tagged<Mesh, Point_map>& t)
{
  State s;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, int> index;
  for (auto v : vertices(t.mesh)) {
    index.emplace(v, int(index.size()));
    s.points.push_back(triple(get(t.points, v)));
    s.corners.push_back(get(t.corners, v));
  }
  for (auto e : edges(t.mesh))
    s.sharp[undirected(index[source(e, t.mesh)], index[target(e, t.mesh)])] = get(t.sharp, e);
  for (auto f : faces(t.mesh)) {
    std::set<int> around;
    for (auto v : CGAL::vertices_around_face(halfedge(f, t.mesh), t.mesh)) around.insert(index[v]);
    for (auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh))
      s.normals[{around, index[target(h, t.mesh)]}] = triple(get(t.normals, h));
  }
  return s;
}

// the same by rounds on levels
template <class Scheme>
State state(const Control& control, const Scheme& scheme, int rounds)
{
  Crease_run<double, Scheme> run(control, scheme);
  run.refine(rounds);
  State s;
  const auto& level = run.level();
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    s.points.push_back(run.point(v));
    s.corners.push_back(0);
  }
  for (const auto& star : run.creases().stars) s.corners[star.vertex] = star.sharpness;
  for (Index e = 0; e < level.number_of_edges(); ++e)
    s.sharp[undirected(int(level.source(2 * e)), int(level.target(2 * e)))] = 0;
  for (const auto& e : run.creases().edges)
    s.sharp[undirected(int(level.source(2 * e.edge)), int(level.target(2 * e.edge)))] = e.sharpness;
  std::vector<std::set<int>> around(level.number_of_faces());
  run.for_each_corner([&](Index f, Index v, Index) { around[f].insert(int(v)); });
  run.for_each_corner([&](Index f, Index v, Index slot) {
    s.normals[{around[f], int(v)}] = run.normal(slot);
  });
  return s;
}

// a washer with sharp and semi-sharp edges and a corner
inline Control tagged_washer()
{
  Part part = washer();
  part.place();
  Control c = part.control();
  int k = 0;
  for (auto& edge : c.sharp_edges)
    if (++k % 5 == 0) edge.second = 0.4 * (k % 7);
  c.sharp_vertices[3] = 1.5;
  c.sharp_vertices[5] = infinity;
  return c;
}

} // namespace tagged_meshes

#endif // CGAL_PN_SUBDIVISION_3_TEST_TAGGED_MESHES_H
