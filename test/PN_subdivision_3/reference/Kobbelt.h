// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_KOBBELT_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_KOBBELT_H

#include "Quadrisection.h"

namespace reference {

class Kobbelt
{
public:
  Kobbelt(const Face_list& mesh, Real w)
    : mesh_(mesh)
    , alpha_(-w)
    , beta_(Real(0.5) + w)
  {}

  Row edge(int a, int b) const
  {
    return four_points(beyond(b, a), mesh_.point(a), mesh_.point(b), beyond(a, b));
  }

  Row face(const Face& f) const
  {
    const int first = spokes_across(f[0], f[1], f[2], f[3]);
    const int second = spokes_across(f[1], f[2], f[3], f[0]);
    if (first < second) return across(f[0], f[1], f[2], f[3]);
    if (second < first) return across(f[1], f[2], f[3], f[0]);
    return (across(f[0], f[1], f[2], f[3]) + across(f[1], f[2], f[3], f[0])) / 2;
  }

  // The point of the face abcd from the edge points of ab, cd and of the edges beyond them.
  Row across(int a, int b, int c, int d) const
  {
    const Row ab = edge(a, b), cd = edge(c, d);
    return four_points(edge_beyond(a, b, ab, cd), ab, cd, edge_beyond(c, d, cd, ab));
  }

private:
  Row four_points(const Row& p, const Row& q, const Row& r, const Row& s) const
  {
    return alpha_ * (p + s) + beta_ * (q + r);
  }

  // The point that continues the line from u through v.
  Row beyond(int u, int v) const
  {
    const std::vector<int> ring = mesh_.ring(v);
    if (mesh_.is_border(v)) {
      if (mesh_.is_border(u, v) && ring.size() > 2) return mesh_.point(mesh_.next_on_border(u, v));
      return 2 * mesh_.point(v) - mesh_.point(u);
    }
    const std::size_t i = std::size_t(std::find(ring.begin(), ring.end(), u) - ring.begin());
    if (ring.size() == 4) return mesh_.point(ring[(i + 2) % 4]);
    return virtual_points(v, ring)[i];
  }

  // Both directions agree on the faces at v: this gives the differences of the virtual points
  // X_i, step by step around v; their mean is that of the neighbors.
  std::vector<Row> virtual_points(int v, const std::vector<int>& ring) const
  {
    const int n = int(ring.size());
    const auto l = [&](int i) { return mesh_.point(ring[std::size_t((i + 2 * n) % n)]); };
    const auto p = [&](int i) { // opposite v in the quad between l_i and l_(i+1)
      return mesh_.point(mesh_.after(v, ring[std::size_t((i + 2 * n) % n)]));
    };
    std::vector<Row> x{mesh_.zero()};
    for (int i = 0; i + 1 < n; ++i)
      x.push_back(x.back() + l(i - 1) - l(i + 2) + (alpha_ / beta_) * (p(i - 2) - p(i + 2)));
    Row mean = mesh_.zero();
    for (const Row& row : x) mean += row / n;
    const Row shift = mesh_.mean(ring) - mean;
    for (Row& row : x) row += shift;
    return x;
  }

  Row edge_beyond(int a, int b, const Row& ab, const Row& cd) const
  {
    if (mesh_.face(b, a) < 0) return 2 * ab - cd;
    return edge(mesh_.after(b, a), mesh_.before(b, a));
  }

  int spokes_across(int a, int b, int c, int d) const
  {
    return is_spoke(a, b) + is_spoke(c, d) + is_spoke_beyond(a, b) + is_spoke_beyond(c, d);
  }
  int is_spoke_beyond(int a, int b) const
  {
    return mesh_.face(b, a) < 0 ? 0 : is_spoke(mesh_.after(b, a), mesh_.before(b, a));
  }
  int is_spoke(int a, int b) const
  {
    return mesh_.is_interior_of_valence_other_than(4, a) ||
           mesh_.is_interior_of_valence_other_than(4, b);
  }

  const Face_list& mesh_;
  Real alpha_, beta_;
};

inline Refined kobbelt(const Face_list& mesh, Real w)
{
  const Kobbelt rules(mesh, w);
  Refined result;
  const auto on_edge = add_vertices_and_edges(
    mesh, result, [&](int v) { return mesh.point(v); },
    [&](int a, int b) { return rules.edge(a, b); });
  std::vector<int> on_face;
  for (const Face& face : mesh.faces()) on_face.push_back(result.add(rules.face(face)));
  add_corner_quads(mesh, on_edge, on_face, result);
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_KOBBELT_H
