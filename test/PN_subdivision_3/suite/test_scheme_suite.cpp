// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// The named shapes are what their names say, and all of them meet a scheme.

#include "Named_shapes.h"

#include <gtest/gtest.h>

#include <set>

namespace named_shapes {
namespace {

TEST(Shapes, AreManifoldsOfAllKinds)
{
  std::size_t closed = 0, bordered = 0, isolated = 0, creased = 0, triangles = 0, quads = 0;
  std::set<int> valences;
  std::set<std::size_t> degrees;
  for (const Shape& shape : all()) {
    const Control_mesh& mesh = shape.mesh;
    EXPECT_TRUE(is_without_bow_tie(mesh)) << mesh.name;
    ++(is_closed(mesh) ? closed : bordered);
    isolated += has_isolated_vertex(mesh);
    creased += !shape.creases.empty();
    triangles += all_faces_have_degree(mesh, 3);
    quads += all_faces_have_degree(mesh, 4);
    for (int n : interior_valences(mesh)) valences.insert(n);
    for (const reference::Face& f : mesh.faces) degrees.insert(f.size());
  }
  for (std::size_t n : {closed, bordered, triangles, quads}) EXPECT_GE(n, 20u);
  EXPECT_GE(isolated, 2u);
  EXPECT_GE(creased, 8u);
  for (int n : {2, 3, 4, 5, 6, 7, 8, 12, 64, 360}) EXPECT_EQ(valences.count(n), 1u) << n;
  for (std::size_t n : {3u, 4u, 5u, 6u, 7u, 8u, 9u, 12u}) EXPECT_EQ(degrees.count(n), 1u) << n;
}

} // namespace
} // namespace named_shapes
