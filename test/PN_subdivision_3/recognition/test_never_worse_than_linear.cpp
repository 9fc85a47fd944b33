// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Parts a few vertices of which have been moved off their surfaces: facets that nothing recognizes beside planes and rounds.
// After two rounds planes are where the linear scheme with the same tags has them, rounds no further off their surfaces than
// by it, nothing else is higher, nothing is folded; or the face is named.

#include "Random_parts.h"
#include "Refined_part.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace synthetic_parts;

namespace {

Part dented(std::uint32_t seed)
{
  Part part = Random_part(seed).part();
  Random random(seed * 31 + 7);
  const double most = 0.004 * diagonal(part.points);
  for (int i = 0; i < 3; ++i) {
    Vec& p = part.points[static_cast<std::size_t>(
      random.integer(0, static_cast<int>(part.points.size()) - 1))];
    p = p + Vec{random(-most, most), random(-most, most), random(-most, most)};
  }
  return part;
}

} // namespace

TEST(Never_worse_than_linear, what_is_high_is_named)
{
  for (std::uint32_t seed = 1000; seed < 1030; ++seed) {
    const Part part = dented(seed);
    if (part.faces.size() > 400) continue;
    const Refined_part refined(part);
    EXPECT_EQ(refined.broken_promises().not_named, 0u) << part.name;
    EXPECT_LE(refined.fallback.high_faces.size(), part.faces.size() / 20) << part.name;
  }
}

// Each of them needs rules: normals that are set back, those of rounds among them, corners, planes that are given up.
TEST(Never_worse_than_linear, nothing_is_left_high)
{
  for (const std::uint32_t seed : {1007u, 1011u, 1014u, 1017u, 1019u, 1023u, 1027u}) {
    const Part part = dented(seed);
    const Refined_part refined(part);
    EXPECT_EQ(refined.broken_promises().all(), 0u) << part.name;
    EXPECT_TRUE(refined.fallback.high_faces.empty()) << part.name;
  }
}

// What is estimated is refined as given later, with other tangents of creases: heights are those of that.
TEST(Never_worse_than_linear, estimated_normals_count_as_given)
{
  for (const std::uint32_t seed : {1336u, 2404u, 18880u, 23960u}) {
    const Part part = dented(seed);
    const Refined_part refined(part);
    EXPECT_EQ(refined.broken_promises().all(), 0u) << part.name;
    EXPECT_TRUE(refined.fallback.high_faces.empty()) << part.name;
  }
}

// All normals that could do harm are set back by then, and only corners help.
TEST(Never_worse_than_linear, corners_where_nothing_else_is_left)
{
  for (const std::uint32_t seed : {1241u, 1852u, 5023u}) {
    const Part part = dented(seed);
    const Refined_part refined(part);
    EXPECT_EQ(refined.broken_promises().all(), 0u) << part.name;
    EXPECT_TRUE(refined.fallback.high_faces.empty()) << part.name;
  }
}

// Of parts without rounds what is said of the volume is what is measured, of others nothing is said.
TEST(Never_worse_than_linear, volumes)
{
  int without_rounds = 0;
  for (std::uint32_t seed = 1000; seed < 1030; ++seed) {
    const Part part = dented(seed);
    if (part.faces.size() > 200) continue;
    const Refined_part refined(part);
    const auto is_round = [&](std::size_t f) { return refined.is_round(f); };
    std::vector<std::size_t> faces(part.faces.size());
    std::iota(faces.begin(), faces.end(), 0u);
    const double before = volume(part);
    const double excess =
      (std::abs(refined.volume - before) - std::abs(refined.linear_volume - before)) / before;
    if (std::any_of(faces.begin(), faces.end(), is_round))
      EXPECT_EQ(refined.fallback.excess_of_volume, 0) << part.name;
    else {
      ++without_rounds;
      EXPECT_NEAR(refined.fallback.excess_of_volume, (std::max)(excess, 0.), 1e-6) << part.name;
    }
  }
  EXPECT_GE(without_rounds, 3);
}

// What is entirely recognized has nothing that could be set back.
TEST(Never_worse_than_linear, parts_as_they_were_stay)
{
  for (const Part& part : {bolt(6, 24), shaft(24, 6)}) {
    const Refined_part refined(part);
    EXPECT_EQ(refined.broken_promises().all(), 0u) << part.name;
    EXPECT_EQ(refined.fallback.segments_given_up, 0u) << part.name;
    EXPECT_EQ(refined.fallback.wedges_set_back, 0u) << part.name;
    EXPECT_EQ(refined.surfaces.size(), part.surfaces.size()) << part.name;
  }
}
