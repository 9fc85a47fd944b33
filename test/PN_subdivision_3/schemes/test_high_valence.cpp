// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Modified Loop subdivision at vertices of large valence: the weights, which have a closed form there, against
// sums of cosines, and the rows, which are not found by walking, against a walk.

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace in = PN::internal;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Index = PN::Level_connectivity::Index;
using Real = long double;

const Real pi = std::acos(Real(-1));

// a vertex of valence n in the middle of a disk: number 0, the others counterclockwise
Mesh disk(int n)
{
  Mesh mesh;
  mesh.add_vertex({0, 0, 1});
  for (int i = 0; i < n; ++i) {
    const double a = double(2 * pi) * i / n;
    mesh.add_vertex({std::cos(a), std::sin(a), 0.2 * std::cos(2 * a) + 0.1 * std::sin(5 * a)});
  }
  for (int i = 0; i < n; ++i)
    mesh.add_face(Mesh::Vertex_index(0), Mesh::Vertex_index(1 + i),
                  Mesh::Vertex_index(1 + (i + 1) % n));
  return mesh;
}

PN::Level_connectivity level_of(const Mesh& mesh)
{
  PN::Level_connectivity level;
  in::with_mesh_access(mesh, [&](const auto& access) { level = in::checked_level(access); });
  return level;
}

// The rule of the manual: eigenvalues of frequencies, and a sum of n terms for each weight.
struct Rule
{
  Real vertex_to_neighbor, edge_to_vertex;
  std::vector<Real> edge_to_neighbor;

  Rule(int n, Real cap, bool keeps_quadratic)
  {
    std::vector<Real> cosine;
    for (int k = 0; k < n; ++k) cosine.push_back(std::cos(2 * pi * k / n));
    const Real lambda = Real(3) / 8 + cosine[1] / 4, bound = cap * lambda * lambda;
    const Real mean =
      keeps_quadratic ? lambda * lambda : (std::min)(lambda * lambda, cap * lambda * lambda);
    const Real kappa = (1 - mean) / (1 - lambda * lambda);
    std::vector<Real> eigenvalue;
    for (int k = 0; k < n; ++k) {
      const bool is_quadratic = k == 2 || k == n - 2;
      const Real old = Real(3) / 8 + cosine[std::size_t(k)] / 4;
      eigenvalue.push_back(k == 1 || k == n - 1              ? lambda
                           : is_quadratic && keeps_quadratic ? lambda * lambda
                                                             : (std::min)(old, bound));
    }
    vertex_to_neighbor = (Real(5) / 8 - lambda * lambda) * kappa / n;
    edge_to_vertex = kappa * 3 / 8;
    for (int d = 0; d < n; ++d) {
      Real sum = 1 - kappa * 3 / 8;
      for (int k = 1; k < n; ++k)
        sum += eigenvalue[std::size_t(k)] * cosine[std::size_t(std::int64_t(k) * d % n)];
      edge_to_neighbor.push_back(sum / n);
    }
  }
};

using Row = std::vector<in::Stencil_block<double>::Entry>;

// what write(stencil) writes
template <class Write>
Row row_of(const Write& write)
{
  in::Stencil_block<double> block;
  write(block.row());
  block.close_row();
  return Row(block.begin(0), block.end(0));
}

// the neighbors of the middle, clockwise from the source of h
std::vector<Index> ring(const PN::Level_connectivity& level, Index h)
{
  std::vector<Index> result;
  Index g = h;
  do {
    result.push_back(level.source(g));
    g = PN::Level_connectivity::opposite(level.next(g));
  } while (g != h);
  return result;
}

template <class Mask>
void expect_rule(const Mask& mask, const PN::Level_connectivity& level, const Rule& rule)
{
  const Index n = level.valence(0);
  const double tolerance = 4e-16;
  for (const auto& e : row_of([&](auto& s) { mask.vertex(0, s); }))
    if (e.vertex != 0) {
      EXPECT_NEAR(e.weight, double(rule.vertex_to_neighbor), tolerance);
    }
  for (Index h = 0; h < level.number_of_halfedges(); h += n / 7) {
    const Index g = level.target(h) == 0 ? h : PN::Level_connectivity::opposite(h);
    if (level.target(g) != 0) continue;
    std::map<Index, double> row;
    for (const auto& e : row_of([&](auto& s) { mask.edge(PN::Level_connectivity::edge(g), s); }))
      row[e.vertex] += e.weight;
    ASSERT_EQ(row.size(), std::size_t(n) + 1);
    EXPECT_NEAR(row.at(0), double(rule.edge_to_vertex), tolerance * n);
    const std::vector<Index> neighbors = ring(level, g);
    for (std::size_t d = 0; d < n; ++d)
      EXPECT_NEAR(row.at(neighbors[d]), double(rule.edge_to_neighbor[d]), tolerance);
  }
}

} // namespace

TEST(High_valence, ClosedSumsAreThoseThatAreAdded)
{
  using Number = in::Double_double;
  for (const int n : {5, 6, 7, 8, 9, 12, 17, 64, 65, 100, 257, 400})
    for (const double cap : {1., 0.7, 0.5, 0.41, 0.33, 0.2, 0.01})
      for (const bool keeps_quadratic : {false, true}) {
        in::Ring_tuning tuning(cap, 1, PN::Tuned_valences::all);
        tuning.keeps_quadratic = keeps_quadratic;
        const in::Tuned_Loop_frequencies<Number> frequencies(n, tuning);
        const auto closed = frequencies.closed_sums(Number(2));
        const auto added = frequencies.added_sums(Number(2));
        ASSERT_EQ(closed.size(), added.size());
        for (std::size_t d = 0; d < closed.size(); ++d)
          EXPECT_NEAR(double(closed[d] - added[d]), 0, 1e-26 * n) << n << ' ' << cap << ' ' << d;
      }
}

TEST(High_valence, WeightsAreThoseOfTheRule)
{
  for (const int n : {63, 65, 200, 1001}) {
    const PN::Level_connectivity level = level_of(disk(n));
    for (const double cap : {1., 0.5, 0.37, 0.05}) {
      SCOPED_TRACE(std::to_string(n) + ' ' + std::to_string(cap));
      expect_rule(PN::Loop_scheme::Tuned(cap).mask<double>(level, 1), level,
                  Rule(n, Real(cap), false));
    }
    expect_rule(PN::Loop_scheme::Transfer().mask<double>(level, 1), level,
                Rule(n, Real(0.5), true));
  }
}

// Rows are copied from lists of neighbors; every edge has its own place there.
TEST(High_valence, RowsBeginWithTheirOwnNeighbor)
{
  const PN::Level_connectivity level = level_of(disk(130));
  const auto mask = PN::Loop_scheme::Tuned().mask<double>(level, 1);
  Index edges = 0;
  for (Index h = 0; h < level.number_of_halfedges(); ++h) {
    if (level.target(h) != 0) continue;
    ++edges;
    std::vector<Index> vertices = ring(level, h);
    vertices.push_back(0);
    std::vector<Index> row;
    for (const auto& e : row_of([&](auto& s) { mask.edge(PN::Level_connectivity::edge(h), s); }))
      row.push_back(e.vertex);
    EXPECT_EQ(row, vertices);
  }
  EXPECT_EQ(edges, 130u);
}

// Blocks of long rows are shorter: new points are the PN averages of the rows all the same.
TEST(High_valence, PointsAreAveragesOfRows)
{
  using Average = PN::PN_average<double, 3>;
  const int n = 900;
  Mesh mesh = disk(n);
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("n").first;
  std::vector<Average::Value> old;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const Kernel::Vector_3 m(0.3 * p.x(), 0.2 * p.y() + 0.1 * p.z(), 1);
    normals[v] = m / std::sqrt(m.squared_length());
    old.push_back({{p.x(), p.y(), p.z()}, {normals[v].x(), normals[v].y(), normals[v].z()}});
  }
  const PN::Level_connectivity level = level_of(mesh);
  const auto mask = PN::Loop_scheme::Tuned().mask<double>(level, 1);
  std::vector<Average::Value> expected;
  const auto add = [&](const auto& write) {
    const Row entries = row_of(write);
    expected.push_back(Average()(entries.data(), entries.data() + entries.size(), old.data()));
  };
  for (Index v = 0; v < level.number_of_vertices(); ++v) add([&](auto& s) { mask.vertex(v, s); });
  for (Index e = 0; e < level.number_of_edges(); ++e) add([&](auto& s) { mask.edge(e, s); });
  PN::subdivide(mesh, PN::Loop_scheme::Tuned(),
                CGAL::parameters::number_of_iterations(1).vertex_normal_map(normals));
  ASSERT_EQ(mesh.number_of_vertices(), expected.size());
  for (const auto v : mesh.vertices())
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(mesh.point(v)[c], expected[v].point[std::size_t(c)], 1e-14);
      EXPECT_NEAR(normals[v][c], expected[v].normal[std::size_t(c)], 1e-14);
    }
}
