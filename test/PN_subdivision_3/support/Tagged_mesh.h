// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Meshes with sharp edges and vertices and normals of corners, and all that such a mesh has in a form
// that does not depend on its type.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_TAGGED_MESH_H
#define CGAL_PN_SUBDIVISION_3_TEST_TAGGED_MESH_H

#include "Crease_levels.h"
#include "Mesh_cases.h"

#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tagged_meshes {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;

using crease_levels::Control;
using crease_levels::Edge;
using crease_levels::Face;
using crease_levels::Triple;
using crease_levels::undirected;

using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;

template <class Tag, class Mesh>
using Dynamic_map = typename boost::property_map<Mesh, Tag>::type;

// a mesh with its tags and normals
template <class Mesh>
struct Tagged
{
  using Traits = boost::graph_traits<Mesh>;

  explicit Tagged(const Control& control)
  {
    mesh_cases::Soup soup;
    soup.points = control.points;
    for (const Face& f : control.faces) soup.faces.emplace_back(f.begin(), f.end());
    mesh_cases::build(soup, mesh);
    sharp = get(CGAL::dynamic_edge_property_t<double>(), mesh);
    corners = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    normals = get(CGAL::dynamic_halfedge_property_t<Vector_3>(), mesh);
    std::map<typename Traits::vertex_descriptor, int> index;
    for (auto v : vertices(mesh)) {
      const int i = int(index.size());
      index[v] = i;
      const auto it = control.sharp_vertices.find(i);
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
    PN::subdivide<Concurrency_tag>(mesh, scheme,
                                   np::number_of_iterations(rounds)
                                     .edge_is_constrained_map(sharp)
                                     .vertex_is_constrained_map(corners)
                                     .vertex_normal_map(normals));
  }

  Mesh mesh;
  Dynamic_map<CGAL::dynamic_edge_property_t<double>, Mesh> sharp;
  Dynamic_map<CGAL::dynamic_vertex_property_t<double>, Mesh> corners;
  Dynamic_map<CGAL::dynamic_halfedge_property_t<Vector_3>, Mesh> normals;
};

inline Triple triple(const Kernel::Point_3& p)
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

template <class Mesh>
State state(const Tagged<Mesh>& t)
{
  State s;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, int> index;
  const auto point = get(CGAL::vertex_point, t.mesh);
  for (auto v : vertices(t.mesh)) {
    index.emplace(v, int(index.size()));
    s.points.push_back(triple(get(point, v)));
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

// counts what is put and then fails
template <class Map>
struct Failing_map
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  Map map;
  int* left;

  friend value_type get(const Failing_map& m, const key_type& k)
  {
    using boost::get;
    return get(m.map, k);
  }
  friend void put(const Failing_map& m, const key_type& k, const value_type& v)
  {
    if ((*m.left)-- == 0) throw std::runtime_error("full");
    using boost::put;
    put(m.map, k, v);
  }
};

} // namespace tagged_meshes

#endif // CGAL_PN_SUBDIVISION_3_TEST_TAGGED_MESH_H
