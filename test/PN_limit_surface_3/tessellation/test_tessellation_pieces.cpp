// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Tessellations in pieces: the vertices and triangles of the whole, to the last bit, each once.

#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "Tessellation_piece_cases.h"

#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using tessellation_piece_cases::expect_same;
using test_meshes::Cells;
using test_meshes::Control_mesh;

template <class Scheme>
void expect_same(Control_mesh shape, const Scheme& scheme, double eps)
{
  SCOPED_TRACE(shape.name);
  if (shape.normals.empty()) test_meshes::set_uneven_normals(shape, 8);
  Surface_mesh mesh = to_surface_mesh(shape);
  expect_same(mesh, scheme, eps, params::vertex_normal_map(normal_map(mesh)), true, {1, 2, 7});
}

TEST(TessellationPieces, CatmullClark)
{
  expect_same(test_meshes::grid(5, 4, false, false, Cells::quads), PN::CatmullClark_scheme(), 0.01);
  expect_same(test_meshes::grid(7, 5, true, true, Cells::quads), PN::CatmullClark_scheme(), 0.01);
  expect_same(named_shapes::prism(5), PN::CatmullClark_scheme(), 0.01);
}

TEST(TessellationPieces, Loop)
{
  expect_same(test_meshes::grid(4, 4, false, false, Cells::triangles), PN::Loop_scheme(), 0.01);
  expect_same(test_meshes::bipyramid(7), PN::Loop_scheme(), 0.01);
}

// Beside irregular vertices and other faces limits read more.
TEST(TessellationPieces, ALongIrregularStrip)
{
  const Control_mesh mixed = test_meshes::grid(24, 2, false, false, Cells::mixed);
  expect_same(mixed, PN::CatmullClark_scheme(), 0.05);
  expect_same(test_meshes::grid(16, 2, false, false, Cells::triangles), PN::Loop_scheme::Tuned(),
              0.05);
}

// Splits are taken back along rulings.
TEST(TessellationPieces, ACylinder)
{
  Control_mesh shape = test_meshes::grid(8, 4, true, false, Cells::quads);
  for (int i = 0; i < 40; ++i) {
    const double s = 0.78539816339744831 * (i % 8);
    shape.points[std::size_t(i)] = {std::cos(s), std::sin(s), 0.5 * (i / 8)};
    shape.normals.push_back({std::cos(s), std::sin(s), 0});
  }
  for (const double eps : {0.03, 0.003}) expect_same(shape, PN::CatmullClark_scheme(), eps);
}

TEST(TessellationPieces, WhatIsOutOfReachIsRefused)
{
  Control_mesh shape = test_meshes::grid(5, 4, false, false, Cells::quads);
  test_meshes::set_uneven_normals(shape, 8);
  Surface_mesh mesh = to_surface_mesh(shape);
  const auto pieces = PN::internal::tessellate_in_pieces<CGAL::Sequential_tag>(
    mesh, PN::CatmullClark_scheme(), 1e-15, params::vertex_normal_map(normal_map(mesh)));
  pieces->divide(2, pieces->expected_triangles());
  EXPECT_THROW(pieces->piece(0, {}), std::length_error);
}

} // namespace
