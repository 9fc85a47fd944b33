// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How faces are divided into pieces, against a slow way to the same, and the order of the elements of a piece; a part
// of the program of test_pieces.cpp.

#include <CGAL/PN_limit_surface_3/internal/pieces/Divided_level.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace {

namespace in = CGAL::PN_subdivision_3::internal;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Level = CGAL::PN_subdivision_3::Level_connectivity;
using Index = Level::Index;
using Center = std::array<double, 3>;

// a grid of faces, many of whose centers have a coordinate in common
Mesh grid(int n, int m)
{
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) mesh.add_vertex({double(i), double(j), double(i * j % 3)});
  const auto at = [m](int i, int j) { return Mesh::Vertex_index(unsigned(i * (m + 1) + j)); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return mesh;
}

Level level_of(const Mesh& mesh)
{
  Level level;
  in::with_mesh_access(mesh, [&](const auto& access) { level = in::checked_level(access); });
  return level;
}

// Halves that are sorted in full, and shares that are counted face by face.
class Slow_division
{
public:
  Slow_division(const std::vector<Center>& centers, std::size_t number)
    : centers_(centers)
    , piece(centers.size())
  {
    std::vector<Index> faces(centers.size());
    for (Index f = 0; f < faces.size(); ++f) faces[f] = f;
    divide(faces, 0, number);
  }

private:
  const std::vector<Center>& centers_;

public:
  std::vector<std::size_t> piece;

private:
  double extent(const std::vector<Index>& faces, std::size_t axis) const
  {
    std::set<double> all;
    for (const Index f : faces) all.insert(centers_[f][axis]);
    return *all.rbegin() - *all.begin();
  }

  void divide(std::vector<Index> faces, std::size_t first, std::size_t number)
  {
    if (number == 1 || faces.empty()) {
      for (const Index f : faces) piece[f] = first;
      return;
    }
    std::size_t axis = 0;
    for (const std::size_t i : {1u, 2u})
      if (extent(faces, i) > extent(faces, axis)) axis = i;
    std::stable_sort(faces.begin(), faces.end(),
                     [&](Index f, Index g) { return centers_[f][axis] < centers_[g][axis]; });
    const std::size_t half = number / 2;
    // a face belongs to the half in which its middle is
    std::size_t middle = 0;
    while (middle < faces.size() &&
           double(middle) + 0.5 < double(faces.size()) * (double(half) / double(number)))
      ++middle;
    const auto end_of_half = faces.begin() + std::ptrdiff_t(middle);
    divide({faces.begin(), end_of_half}, first, half);
    divide({end_of_half, faces.end()}, first + half, number - half);
  }
};

} // namespace

TEST(Piece_division, EqualFacesAreHalvedByCount)
{
  for (const auto& [n, m] :
       {std::pair(1, 1), std::pair(7, 3), std::pair(12, 17), std::pair(20, 20)}) {
    const Mesh mesh = grid(n, m);
    const Level level = level_of(mesh);
    const auto point = [&](Index v) {
      const auto& p = mesh.point(Mesh::Vertex_index(v));
      return Center{p[0], p[1], p[2]};
    };
    std::vector<Center> centers;
    for (const auto f : mesh.faces()) {
      Center c{0, 0, 0};
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        for (std::size_t i = 0; i < 3; ++i) c[i] += point(Index(v))[i] / 4;
      centers.push_back(c);
    }
    for (const std::size_t number : {1u, 2u, 3u, 5u, 16u, 37u, 500u}) {
      const in::Face_division division(level, number, point);
      const Slow_division expected(centers, number);
      for (Index f = 0; f < level.number_of_faces(); ++f)
        EXPECT_EQ(division.piece_of_face(f), expected.piece[f]) << n << ' ' << number << ' ' << f;
    }
  }
}

TEST(Piece_division, LowestBits)
{
  for (unsigned i = 0; i < 64; ++i)
    for (const std::uint64_t above : {std::uint64_t(0), ~std::uint64_t(0), std::uint64_t(0xa5a5)}) {
      const std::uint64_t bit = std::uint64_t(1) << i;
      EXPECT_EQ(in::lowest_bit((above & ~(bit - 1)) | bit), i);
    }
}

TEST(Piece_division, NumbersComeInOrder)
{
  std::mt19937 random(1);
  for (const std::uint32_t bound : {1u, 2u, 63u, 64u, 65u, 4096u, 4097u, 300000u}) {
    in::Number_set set(bound);
    std::vector<std::uint32_t> numbers;
    for (int round = 0; round < 20; ++round) {
      std::set<std::uint32_t> expected;
      for (int i = 0; i < 10 * round; ++i) {
        const std::uint32_t x = random() % bound;
        expected.insert(x);
        set.add(x);
      }
      set.add(bound - 1);
      expected.insert(bound - 1);
      set.move_to(numbers);
      EXPECT_EQ(numbers, std::vector<std::uint32_t>(expected.begin(), expected.end()));
    }
  }
}

// One list after the other in the same table.
TEST(Piece_division, ListsKnowTheirPlaces)
{
  std::mt19937 random(2);
  in::Element_list list(1000);
  for (int round = 0; round < 50; ++round) {
    std::set<Index> expected;
    list.clear();
    for (int i = 0; i < 60; ++i) {
      const Index x = random() % 1000;
      expected.insert(x);
      list.add(x);
    }
    list.sort();
    ASSERT_EQ(list.elements(), std::vector<Index>(expected.begin(), expected.end()));
    for (Index x = 0; x < 1000; ++x) {
      ASSERT_EQ(list.contains(x), expected.count(x) != 0);
      if (list.contains(x)) {
        EXPECT_EQ(list.elements()[list.place(x)], x);
      }
    }
  }
}
