// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Points without faces, which are all joined that are near each other or have near ones between them: as a comparison of
// all pairs finds them.

#include "io/Error.h"
#include "io/soup_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

using namespace pn_subdivide;

namespace {

using Index = Mesh_data::Index;

// the first of those that each point is joined with
std::vector<Index> by_all_pairs(const std::vector<Triple>& points, double distance)
{
  std::vector<Index> first(points.size());
  for (Index i = 0; i < first.size(); ++i) first[i] = i;
  for (Index i = 0; i < first.size(); ++i)
    for (Index j = 0; j < i; ++j) {
      const Triple &p = points[i], &q = points[j];
      if (!(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= distance)) continue;
      const Index low = (std::min)(first[i], first[j]), high = (std::max)(first[i], first[j]);
      std::replace(first.begin(), first.end(), high, low);
    }
  return first;
}

Mesh_data points_alone(const std::vector<Triple>& points)
{
  Mesh_data mesh;
  mesh.points = points;
  return mesh;
}

std::size_t number_joined(const std::vector<Index>& first)
{
  std::size_t n = 0;
  for (Index i = 0; i < first.size(); ++i) n += first[i] != i;
  return n;
}

// Points of a unit box, beside `center`, of which each third one is near the one before.
std::vector<Triple> scattered(unsigned seed, const Triple& center, double size, double distance)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Triple> points;
  for (int i = 0; i < 120; ++i) {
    Triple p = center;
    for (double& x : p) x += size * uniform(random);
    if (i % 3 == 2) {
      p = points.back();
      p[i % 9 / 3] += distance * (i % 2 ? 1 : -1) * (i % 5 ? 0.9 : 1.1);
    }
    points.push_back(p);
  }
  return points;
}

} // namespace

TEST(Near_points, AreThoseOfAllPairs)
{
  for (const double distance : {0.02, 0.2, 1e-9})
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(std::to_string(distance) + " " + std::to_string(seed));
      const auto points = scattered(seed, {0.3, -0.2, 0}, 1, distance);
      const auto expected = by_all_pairs(points, distance);
      EXPECT_GT(number_joined(expected), 10u);
      EXPECT_EQ(first_near(points_alone(points), distance), expected);
    }
}

// multiples of the distance and of its half, which are ends of cells
TEST(Near_points, AreThoseOfAllPairsOnAGrid)
{
  const double distance = 0.25;
  std::mt19937 random(5);
  std::vector<Triple> points;
  for (int i = 0; i < 150; ++i) {
    Triple p;
    for (double& x : p) x = 0.125 * (int(random() % 16) - 8);
    points.push_back(p);
  }
  for (const double d : {distance, std::nextafter(distance, 0.), 0.125, 0.})
    EXPECT_EQ(first_near(points_alone(points), d), by_all_pairs(points, d)) << d;
}

// where the distance is a few of the last digits of a coordinate, one of them, and less
TEST(Near_points, AreThoseOfAllPairsFarAway)
{
  for (const double distance : {1e-6, 1.2e-7, 6e-8, 1e-9, 1e-30, 5e-324, 0.}) {
    SCOPED_TRACE(distance);
    std::vector<Triple> points;
    for (int i = 0; i < 60; ++i) // 6e-8 is half of the last digit
      points.push_back({std::ldexp(1, 29) + (i % 7) * std::ldexp(1, -23), -1e9, i % 3 * 1e-7});
    points.push_back({0, 0, 0});
    points.push_back({distance, 0, 0});
    points.push_back({-distance, -1e-320, 0});
    points.push_back({1e300, 1e300, 1e300});
    points.push_back({1e300, 1e300, 1e300});
    EXPECT_EQ(first_near(points_alone(points), distance), by_all_pairs(points, distance));
  }
}

TEST(Near_points, AreRefusedWhereAllAreNear)
{
  std::vector<Triple> points;
  for (int i = 0; i < 300; ++i) points.push_back({i * 1e-3, 0, 0});
  EXPECT_THROW(first_near(points_alone(points), 1), Error);
}
