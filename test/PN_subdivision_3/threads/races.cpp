// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Parallel_tag under the thread sanitizer, with the TBB of this folder: every scheme on a Surface_mesh with property
// maps of the user's, which grows while it is refined. Also tells whether the result is that of one thread.
// scripts/sanitize.sh threads

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdio>
#include <type_traits>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vector = Kernel::Vector_3;

enum class Way { linear, normals, creases };

struct Case
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Vector> normals;
  Mesh::Property_map<Mesh::Edge_index, double> creases;
  Mesh::Property_map<Mesh::Face_index, int> faces;
};

// large enough for several pieces of work
Case grid(bool triangles)
{
  Case c;
  CGAL::make_grid(
    24, 24, c.mesh,
    [](auto i, auto j) {
      const double x = int(i) - 10, y = int(j) - 9;
      return Kernel::Point_3(x, y, (x * x + x * y) / 97);
    },
    triangles);
  c.normals =
    c.mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal", Vector(0, 0, 1)).first;
  c.creases = c.mesh.add_property_map<Mesh::Edge_index, double>("e:crease", 0.).first;
  c.faces = c.mesh.add_property_map<Mesh::Face_index, int>("f:id", 7).first;
  int k = 0;
  for (auto e : c.mesh.edges()) c.creases[e] = k++ % 5 == 0 ? 1.5 : 0;
  return c;
}

template <class Tag, class Scheme>
Case refined(const Scheme& scheme, bool triangles, unsigned rounds, Way way)
{
  Case c = grid(triangles);
  const auto np = CGAL::parameters::number_of_iterations(rounds);
  if (way == Way::linear)
    PN::subdivide<Tag>(c.mesh, PN::linear(scheme), np);
  else if (way == Way::normals)
    PN::subdivide<Tag>(c.mesh, scheme, np.vertex_normal_map(c.normals));
  else if constexpr (PN::internal::Has_crease_rules<Scheme>::value)
    PN::subdivide<Tag>(c.mesh, scheme,
                       np.vertex_normal_map(c.normals).edge_is_constrained_map(c.creases));
  return c;
}

bool is_same(const Case& a, const Case& b)
{
  bool same = a.mesh.number_of_vertices() == b.mesh.number_of_vertices() &&
              a.mesh.number_of_halfedges() == b.mesh.number_of_halfedges() &&
              a.mesh.number_of_faces() == b.mesh.number_of_faces() && a.mesh.is_valid(false);
  if (!same) return false;
  for (auto v : a.mesh.vertices())
    same = same && a.mesh.point(v) == b.mesh.point(v) && a.normals[v] == b.normals[v];
  for (auto h : a.mesh.halfedges())
    same = same && a.mesh.next(h) == b.mesh.next(h) && a.mesh.target(h) == b.mesh.target(h) &&
           a.mesh.face(h) == b.mesh.face(h);
  for (auto e : a.mesh.edges()) same = same && a.creases[e] == b.creases[e];
  for (auto f : a.mesh.faces()) same = same && a.faces[f] == b.faces[f];
  return same;
}

} // namespace

int main()
{
  int different = 0;
  PN::for_each_shipped_scheme([&](auto scheme) {
    using Scheme = decltype(scheme);
    const bool triangles = std::is_same_v<typename Scheme::Host, PN::PTQ_host> ||
                           std::is_same_v<typename Scheme::Host, PN::Sqrt3_host>;
    for (unsigned rounds : {1u, 2u})
      for (Way way : {Way::linear, Way::normals, Way::creases})
        if (!is_same(refined<CGAL::Parallel_tag>(scheme, triangles, rounds, way),
                     refined<CGAL::Sequential_tag>(scheme, triangles, rounds, way))) {
          std::printf("%s, %u rounds: threads give another result\n", Scheme::name(), rounds);
          ++different;
        }
  });
  return different == 0 ? 0 : 1;
}
