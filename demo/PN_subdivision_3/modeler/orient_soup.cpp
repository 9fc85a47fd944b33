// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the command takes from a part of CGAL that is under the GPL.

#include "io/soup_repair.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pn_subdivide {
namespace {

using Index = Mesh_data::Index;

// A side of a face: it leaves the vertex of its corner.
struct Side
{
  std::size_t face, corner, next_corner; // corners are numbered through all faces
  bool goes_up;                          // to the vertex with the higher number
};

// Of each edge with two faces, the sides. At other edges the faces are not joined.
std::vector<std::pair<Side, Side>> joints_of(const Mesh_data& mesh)
{
  std::map<std::pair<Index, Index>, std::vector<Side>> sides;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Mesh_data::Face face = mesh.face(f);
    const std::size_t n = std::size_t(face.size()), first = mesh.first_corner(f);
    for (std::size_t i = 0; i < n; ++i) {
      const Index a = face.begin()[i], b = face.begin()[(i + 1) % n];
      sides[std::minmax(a, b)].push_back({f, first + i, first + (i + 1) % n, a < b});
    }
  }
  std::vector<std::pair<Side, Side>> joints;
  for (const auto& [edge, of_edge] : sides)
    if (of_edge.size() == 2) joints.emplace_back(of_edge[0], of_edge[1]);
  return joints;
}

// Each part as its first face. Joints at which this cannot be are taken away.
std::vector<bool> turned_faces(std::size_t faces, std::vector<std::pair<Side, Side>>& joints)
{
  std::vector<std::vector<const std::pair<Side, Side>*>> of_face(faces);
  for (const auto& joint : joints)
    for (const Side& side : {joint.first, joint.second}) of_face[side.face].push_back(&joint);
  std::vector<bool> is_turned(faces, false), is_known(faces, false);
  const auto must_differ = [](const auto& joint) {
    return joint.first.goes_up == joint.second.goes_up;
  };
  for (std::size_t first = 0; first < faces; ++first) {
    if (is_known[first]) continue;
    is_known[first] = true;
    std::vector<std::size_t> to_do{first};
    while (!to_do.empty()) {
      const std::size_t f = to_do.back();
      to_do.pop_back();
      for (const auto* joint : of_face[f]) {
        const std::size_t g = joint->first.face == f ? joint->second.face : joint->first.face;
        if (is_known[g]) continue;
        is_known[g] = true;
        is_turned[g] = is_turned[f] != must_differ(*joint);
        to_do.push_back(g);
      }
    }
  }
  joints.erase(std::remove_if(joints.begin(), joints.end(),
                              [&](const auto& joint) {
                                return must_differ(joint) != (is_turned[joint.first.face] !=
                                                              is_turned[joint.second.face]);
                              }),
               joints.end());
  return is_turned;
}

// Of each corner, the first one of its vertex that joints lead to.
std::vector<std::size_t> fans_of(const Mesh_data& mesh,
                                 const std::vector<std::pair<Side, Side>>& joints)
{
  std::vector<std::size_t> first(mesh.number_of_corners());
  std::iota(first.begin(), first.end(), std::size_t(0));
  const auto find = [&](std::size_t c) {
    while (first[c] != c) c = first[c] = first[first[c]];
    return c;
  };
  const auto join = [&](std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    first[(std::max)(a, b)] = (std::min)(a, b);
  };
  for (const auto& [s, t] : joints) {
    const bool are_opposite = s.goes_up != t.goes_up;
    join(s.corner, are_opposite ? t.next_corner : t.corner);
    join(s.next_corner, are_opposite ? t.corner : t.next_corner);
  }
  for (std::size_t c = 0; c < first.size(); ++c) first[c] = find(c);
  return first;
}

} // namespace

std::size_t orient_soup(Mesh_data& mesh, std::vector<bool>& is_reversed)
{
  auto joints = joints_of(mesh);
  const std::vector<bool> is_turned = turned_faces(mesh.number_of_faces(), joints);
  const std::vector<std::size_t> fan = fans_of(mesh, joints);
  const std::size_t old_size = mesh.points.size();
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> fan_of_vertex(old_size, none);
  std::vector<Index> vertex_of_fan(fan.size());
  std::vector<std::vector<Index>> faces;
  std::size_t c = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    faces.emplace_back();
    for (const Index v : mesh.face(f)) {
      if (fan_of_vertex[v] == none) {
        fan_of_vertex[v] = fan[c];
        vertex_of_fan[fan[c]] = v;
      } else if (fan[c] == c) { // another one
        vertex_of_fan[c] = Index(mesh.points.size());
        const auto point = mesh.points[v];
        mesh.points.push_back(point);
        add_values_of_copy(mesh, v);
      }
      faces.back().push_back(vertex_of_fan[fan[c++]]);
    }
    if (!is_turned[f]) continue;
    std::reverse(faces.back().begin(), faces.back().end());
    is_reversed[f] = !is_reversed[f];
  }
  mesh.clear_faces();
  for (const auto& face : faces) mesh.add_face(face);
  return mesh.points.size() - old_size;
}

} // namespace pn_subdivide
