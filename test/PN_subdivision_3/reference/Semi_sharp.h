// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Rounds in which creases end, in long double: a round in which less than 1 of an edge is left is the blend of two
// whole ones, one in which these edges are sharp and one in which they are gone. What ends is not round.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_SEMI_SHARP_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_SEMI_SHARP_H

#include "Creases.h"

namespace reference {

inline bool is_fraction(Real s)
{
  return s > 0 && s < 1;
}

// less than 1 becomes s
inline Creased_mesh with_fractions(const Creased_mesh& old, Real s)
{
  Creased_mesh mesh = old;
  for (auto& edge : mesh.sharp_edges)
    if (is_fraction(edge.second)) edge.second = s;
  for (auto& vertex : mesh.sharp_vertices)
    if (is_fraction(vertex.second)) vertex.second = s;
  return mesh;
}

// calls f(face, v, least): at v the face touches edges of which less than 1 is left, the least of them `least`
template <class Function>
void for_each_touching_corner(const Creased_mesh& old, const Creased_mesh& gone, const Function& f)
{
  const Face_list& mesh = old.mesh;
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    const std::map<int, int> large = wedges_at(gone, v);
    for (const int u : mesh.ring(v))
      for_each_touching_face(
        mesh, v, large, [&](int w) { return w == u && is_fraction(old.sharpness(v, u)); },
        [&](int face) { f(face, v, old.sharpness(v, u)); });
  }
}

// the mesh of which the edges of less than 1 are gone: their wedges are joined, and the faces that touch them are
// not round
inline Creased_mesh gone_mesh(const Creased_mesh& old)
{
  Creased_mesh gone = with_fractions(old, 0);
  for (int v = 0; v < old.mesh.number_of_vertices(); ++v) {
    const std::map<int, int> small = wedges_at(old, v), large = wedges_at(gone, v);
    std::map<int, std::map<int, Vector>> parts;
    for (const auto& [face, wedge] : small) parts[large.at(face)][wedge] = old.normal({face, v});
    for (const auto& [face, wedge] : large)
      if (parts[wedge].size() > 1) gone.normals[{face, v}] = mean_direction(parts[wedge]);
    if (is_crease_vertex(old, v) || !is_crease_vertex(gone, v)) continue;
    const std::vector<int> along = sharp_neighbors(gone, v);
    const Vector t = unit_vector(old.tangent(v, along[1]) - old.tangent(v, along[0]));
    gone.tangents[{v, along[1]}] = t;
    gone.tangents[{v, along[0]}] = -t;
  }
  std::set<Corner> corners;
  for_each_touching_corner(old, gone, [&](int face, int, Real) {
    for (const int u : old.mesh.faces()[std::size_t(face)]) corners.insert({face, u});
  });
  set_roundness(gone, corners, 0);
  return gone;
}

// One round. `gone` stands for the mesh without the edges of less than 1 where it is not joined.
class Semi_sharp_round
{
public:
  Semi_sharp_round(const Creased_mesh& old, bool is_loop, bool is_modified = false)
    : Semi_sharp_round(old, gone_mesh(old), is_loop, is_modified)
  {}
  Semi_sharp_round(const Creased_mesh& old, const Creased_mesh& gone, bool is_loop,
                   bool is_modified = false)
    : old_(old)
  {
    const Creased_mesh whole = with_fractions(old, 1);
    const Crease_round sharp_round(whole, is_loop, is_modified);
    result_ = sharp_round.result();
    if (std::none_of(old.sharp_edges.begin(), old.sharp_edges.end(),
                     [](const auto& e) { return is_fraction(e.second); }) &&
        std::none_of(old.sharp_vertices.begin(), old.sharp_vertices.end(),
                     [](const auto& v) { return is_fraction(v.second); }))
      return;
    const Crease_round gone_round(gone, is_loop, is_modified);
    find_reach(gone);
    for (int v = 0; v < int(result_.points.size()); ++v)
      blend(v, part(v, gone_round.reads(v)), gone_round.result());
  }

  const Creased_mesh& result() const { return result_; }

private:
  // of the wedges at corners of faces that touch edges of less than 1, the least of these
  void find_reach(const Creased_mesh& gone)
  {
    for_each_touching_corner(old_, gone, [&](int face, int, Real s) {
      for (const int u : old_.mesh.faces()[std::size_t(face)]) {
        const std::map<int, int> wedge = wedges_at(gone, u);
        for (const auto& [other, number] : wedge)
          if (number == wedge.at(face)) {
            Real& least = reach_.try_emplace({other, u}, s).first->second;
            least = (std::min)(least, s);
          }
      }
    });
  }

  // the part of the sharp round in the value of a new vertex, which reads these corners
  Real part(int v, const std::set<Corner>& corners) const
  {
    const int n = old_.mesh.number_of_vertices();
    if (v < n) {
      Real sum = 0;
      int number = 0;
      const auto add = [&](Real s) {
        if (!is_fraction(s)) return;
        sum += s;
        ++number;
      };
      add(old_.sharpness(v));
      for (const int u : old_.mesh.ring(v)) add(old_.sharpness(v, u));
      if (number != 0) return sum / number;
    } else if (v < n + int(old_.mesh.edges().size())) {
      const auto& [a, b] = old_.mesh.edges()[std::size_t(v - n)];
      if (is_fraction(old_.sharpness(a, b))) return old_.sharpness(a, b);
    }
    Real least = 1;
    for (const Corner& c : corners) {
      const auto it = reach_.find(c);
      if (it != reach_.end()) least = (std::min)(least, it->second);
    }
    return least;
  }

  void blend(int v, Real part, const Creased_mesh& gone)
  {
    if (part == 1) return;
    const auto mix = [&](auto& x, const auto& y) { x = part * x + (1 - part) * y; };
    mix(result_.points[std::size_t(v)], gone.point(v));
    for (const int u : result_.mesh.ring(v)) {
      const Corner corner{result_.mesh.face(v, u), v};
      if (corner.first >= 0) {
        mix(result_.normals.at(corner), gone.normal(corner));
        result_.normals.at(corner) = unit_vector(result_.normals.at(corner));
        mix(result_.roundness[corner], gone.round(corner));
      }
      const auto tangent = result_.tangents.find({v, u});
      if (tangent == result_.tangents.end()) continue;
      mix(tangent->second, gone.tangent(v, u));
      tangent->second = unit_vector(tangent->second);
    }
  }

  const Creased_mesh& old_;
  Creased_mesh result_;
  std::map<Corner, Real> reach_;
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_SEMI_SHARP_H
