// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_SAMPLED_SHAPES_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_SAMPLED_SHAPES_H

#include <CGAL/PN_certificates_3/reproduction.h>

#include <CGAL/Surface_mesh.h>

#include <array>
#include <utility>
#include <vector>

// Uneven samples of a circle, a sphere and a cylinder with radius 1, with the shapes' normals. All
// coordinates are rational: exact kernels hold them exactly, the others round them once.
namespace sampled_shapes {

template <class K>
using Curve = std::vector<std::pair<typename K::Point_2, typename K::Vector_2>>;

template <class K>
using Mesh = CGAL::Surface_mesh<typename K::Point_3>;
template <class K>
using Normals =
  typename Mesh<K>::template Property_map<typename Mesh<K>::Vertex_index, typename K::Vector_3>;

// (cos, sin) of an angle with the tangent b/a of its half
template <class FT>
std::array<FT, 2> unit_vector(int a, int b)
{
  const FT length(a * a + b * b);
  return {FT(a * a - b * b) / length, FT(2 * a * b) / length};
}

// seven directions, 30 to 76 degrees from one another
template <class FT>
std::vector<std::array<FT, 2>> directions()
{
  std::vector<std::array<FT, 2>> result;
  for (const auto& [a, b] : {std::pair(5, 1), std::pair(3, 2), std::pair(3, 4), std::pair(2, 5),
                             std::pair(-1, 4), std::pair(-2, 3), std::pair(-2, 1)})
    result.push_back(unit_vector<FT>(a, b));
  return result;
}

template <class K>
Curve<K> circle(const typename K::Point_2& center)
{
  Curve<K> polygon;
  for (const auto& [x, y] : directions<typename K::FT>()) {
    const typename K::Vector_2 n(x, y);
    polygon.emplace_back(center + n, n);
  }
  return polygon;
}

template <class K>
Normals<K> add_normal_map(Mesh<K>& mesh)
{
  return mesh
    .template add_property_map<typename Mesh<K>::Vertex_index, typename K::Vector_3>(
      "v:normal", typename K::Vector_3(0, 0, 0))
    .first;
}

// quadrilaterals between rings of seven vertices
template <class Mesh>
void add_rings_of_faces(Mesh& mesh, unsigned number)
{
  using Vertex = typename Mesh::Vertex_index;
  for (unsigned ring = 0; ring < number; ++ring)
    for (unsigned i = 0; i < 7; ++i) {
      const unsigned v = 7 * ring + i, next = 7 * ring + (i + 1) % 7;
      mesh.add_face(Vertex(v), Vertex(next), Vertex(next + 7), Vertex(v + 7));
    }
}

// Three rings and two poles: quadrilaterals and triangles, poles of valence 7. Returns the normals.
template <class K>
Normals<K> make_sphere(Mesh<K>& mesh, const typename K::Point_3& center)
{
  using FT = typename K::FT;
  using Vertex = typename Mesh<K>::Vertex_index;
  const Normals<K> normals = add_normal_map<K>(mesh);
  const auto add = [&](const typename K::Vector_3& n) { normals[mesh.add_vertex(center + n)] = n; };
  for (const auto& [a, b] : {std::pair(7, -3), std::pair(9, 1), std::pair(5, 2)}) {
    const auto ring = unit_vector<FT>(a, b);
    for (const auto& d : directions<FT>())
      add(typename K::Vector_3(ring[0] * d[0], ring[0] * d[1], ring[1]));
  }
  add(typename K::Vector_3(0, 0, -1));
  add(typename K::Vector_3(0, 0, 1));
  add_rings_of_faces(mesh, 2);
  for (unsigned i = 0; i < 7; ++i) {
    const unsigned next = (i + 1) % 7;
    mesh.add_face(Vertex(21), Vertex(next), Vertex(i));
    mesh.add_face(Vertex(22), Vertex(14 + i), Vertex(14 + next));
  }
  return normals;
}

// A tube with two borders about the axis through `center` in the direction of z. Returns the normals.
template <class K>
Normals<K> make_cylinder(Mesh<K>& mesh, const typename K::Point_3& center)
{
  using FT = typename K::FT;
  const Normals<K> normals = add_normal_map<K>(mesh);
  for (const int twice_z : {-3, -1, 0, 2})
    for (const auto& d : directions<FT>())
      normals[mesh.add_vertex(center + typename K::Vector_3(d[0], d[1], FT(twice_z) / FT(2)))] =
        typename K::Vector_3(d[0], d[1], 0);
  add_rings_of_faces(mesh, 3);
  return normals;
}

} // namespace sampled_shapes

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_SAMPLED_SHAPES_H
