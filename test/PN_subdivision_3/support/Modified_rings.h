// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The two modified schemes, and the weights that they give about an extraordinary vertex.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_MODIFIED_RINGS_H
#define CGAL_PN_SUBDIVISION_3_TEST_MODIFIED_RINGS_H

#include "Scheme_rows.h"
#include "Schemes.h"

namespace PN = CGAL::PN_subdivision_3;
using reference::Matrix;
using reference::Real;
using test_meshes::Cells;
using test_meshes::Control_mesh;
using test_meshes::star;

// What the two schemes have in common in these tests. A ring is the extraordinary vertex, its
// neighbors, then (quads) the vertices between them.
struct Quads
{
  using Modified = PN::CatmullClark_scheme::Tuned;
  static constexpr Cells cells = Cells::quads;
  static constexpr int regular_valence = 4;
  static constexpr int groups = 2;
  static PN::CatmullClark_scheme unmodified() { return {}; }
  static Matrix ring(int n, Real cap) { return reference::modified_catmull_clark_ring(n, cap); }
};

struct Triangles
{
  using Modified = PN::Loop_scheme::Tuned;
  static constexpr Cells cells = Cells::triangles;
  static constexpr int regular_valence = 6;
  static constexpr int groups = 1;
  static PN::Loop_scheme unmodified() { return {}; }
  static Matrix ring(int n, Real cap) { return reference::modified_loop_ring(n, cap); }
};

using Kinds_of_faces = testing::Types<Quads, Triangles>;

// The new vertices of the 1-ring about the vertex 0 of test_meshes::star(n, 1).
template <class Kind>
std::vector<std::size_t> ring_rows(const reference::Face_list& list)
{
  std::vector<std::size_t> rows{0};
  const std::vector<int> neighbors = list.ring(0);
  for (int u : neighbors) rows.push_back(reference::edge_point(list, 0, u));
  if (Kind::groups == 2)
    for (int u : neighbors) rows.push_back(reference::face_point(list, list.face(0, u)));
  return rows;
}
template <class Kind>
std::vector<int> ring_columns(const reference::Face_list& list)
{
  std::vector<int> columns{0};
  const std::vector<int> neighbors = list.ring(0);
  columns.insert(columns.end(), neighbors.begin(), neighbors.end());
  if (Kind::groups == 2)
    for (int u : neighbors) columns.push_back(list.after(0, u));
  return columns;
}

// The matrix that the scheme's mask gives from 1-ring to 1-ring, in the number type FT.
template <class FT, class Kind, class Scheme>
std::vector<std::vector<FT>> ring_of(int n, const Scheme& scheme)
{
  Surface_mesh mesh = to_surface_mesh(star(n, 1, Kind::cells));
  const reference::Face_list list = face_list(mesh);
  std::vector<std::vector<FT>> all;
  for_each_row<FT>(mesh, scheme, 1, [&](std::size_t, const auto* begin, const auto* end) {
    all.emplace_back(std::size_t(list.number_of_vertices()), FT(0));
    for (const auto* e = begin; e != end; ++e) all.back()[e->vertex] += e->weight;
  });
  std::vector<std::vector<FT>> ring;
  for (std::size_t r : ring_rows<Kind>(list)) {
    ring.emplace_back();
    for (int c : ring_columns<Kind>(list)) ring.back().push_back(all[r][std::size_t(c)]);
  }
  return ring;
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_MODIFIED_RINGS_H
