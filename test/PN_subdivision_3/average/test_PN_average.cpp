// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The PN rule on single rows: closed forms, vanishing sums, the fade of opposite normals.

#include "reference/PN_rule.h"

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <gtest/gtest.h>

#include <random>

namespace {

namespace PN = CGAL::PN_subdivision_3;

template <class FT>
struct Rule
{
  using Value = PN::Point_normal<FT, 3>;
  using Entry = typename PN::Stencil<FT>::Entry;

  std::vector<Value> old;

  void add(PN::Coordinates<FT, 3> point, PN::Coordinates<FT, 3> normal)
  {
    old.push_back({point, normal});
  }

  static std::vector<Entry> row(const std::vector<FT>& weights)
  {
    std::vector<Entry> result;
    for (std::size_t i = 0; i < weights.size(); ++i)
      result.push_back({typename PN::Stencil<FT>::Index(i), weights[i]});
    return result;
  }
  Value operator()(const std::vector<FT>& a) const
  {
    const auto r = row(a);
    return PN::PN_average<FT, 3>()(r.data(), r.data() + r.size(), old.data());
  }
  Value operator()(const std::vector<FT>& a, const std::vector<FT>& b) const
  {
    const auto ra = row(a), rb = row(b);
    return PN::PN_average<FT, 3>()(ra.data(), ra.data() + ra.size(), rb.data(),
                                   rb.data() + rb.size(), old.data());
  }
};

template <class FT>
class PN_average_of : public testing::Test
{
public:
  static constexpr FT epsilon = std::numeric_limits<FT>::epsilon();
};
using Number_types = testing::Types<double, float, long double>;
TYPED_TEST_SUITE(PN_average_of, Number_types, );

// --- closed forms ---

// The mean of the ends of an arc is its middle.
TYPED_TEST(PN_average_of, TwoPointsOfACircleIsTheMiddleOfTheArc)
{
  using FT = TypeParam;
  for (FT half : {FT(0.1), FT(0.7), FT(1.3)}) {
    const FT c = std::cos(half), s = std::sin(half);
    Rule<FT> rule;
    rule.add({3 * s, 0, 3 * c}, {s, 0, c});
    rule.add({-3 * s, 0, 3 * c}, {-s, 0, c});
    const auto middle = rule({FT(0.5), FT(0.5)});
    EXPECT_NEAR(middle.point[0], 0, 4 * this->epsilon);
    EXPECT_NEAR(middle.point[2], 3, 8 * this->epsilon);
    EXPECT_NEAR(middle.normal[2], 1, this->epsilon);
  }
}

// Two points of a helix about the z axis: the middle keeps the distance from the axis.
TYPED_TEST(PN_average_of, TwoPointsOfACylinderIsTheMiddleOfTheHelix)
{
  using FT = TypeParam;
  const FT c = std::cos(FT(0.6)), s = std::sin(FT(0.6));
  Rule<FT> rule;
  rule.add({2 * c, 2 * s, 1}, {c, s, 0});
  rule.add({2 * c, -2 * s, 4}, {c, -s, 0});
  const auto middle = rule({FT(0.5), FT(0.5)});
  EXPECT_NEAR(middle.point[0], 2, 8 * this->epsilon);
  EXPECT_NEAR(middle.point[1], 0, 8 * this->epsilon);
  EXPECT_NEAR(middle.point[2], 2.5, 8 * this->epsilon);
}

// In the plane, any weights that sum to 1, negative ones too.
TEST(PN_average_2, KeepsCircles)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<> angle(-1, 1), weight(-0.2, 0.6);
  for (int repetition = 0; repetition < 200; ++repetition) {
    std::vector<PN::Point_normal<double, 2>> old;
    std::vector<PN::Stencil<double>::Entry> row;
    double rest = 1;
    for (unsigned j = 0; j < 5; ++j) {
      const double t = angle(generator);
      old.push_back({{2 * std::cos(t), 2 * std::sin(t)}, {std::cos(t), std::sin(t)}});
      row.push_back({j, j == 4 ? rest : weight(generator)});
      rest -= row.back().weight;
    }
    const auto p = PN::PN_average<double, 2>()(row.data(), row.data() + 5, old.data());
    EXPECT_NEAR(std::hypot(p.point[0], p.point[1]), 2, 1e-14);
    EXPECT_NEAR(p.point[0], 2 * p.normal[0], 1e-14);
    EXPECT_NEAR(p.point[1], 2 * p.normal[1], 1e-14);
  }
}

// An entry without a normal has the height of its point: d = 1.
TYPED_TEST(PN_average_of, EntryWithoutNormalHasTheHeightOfItsPoint)
{
  using FT = TypeParam;
  // n = z, q = (0, 0, 3): h_0 = 3, and two arcs of h = tan(half / 2) - 3 each
  const FT half = FT(0.8), c = std::cos(half), s = std::sin(half);
  Rule<FT> rule;
  rule.add({0, 0, 6}, {0, 0, 0});
  rule.add({1, 0, 0}, {s, 0, c});
  rule.add({-1, 0, 0}, {-s, 0, c});
  const auto p = rule({FT(0.5), FT(0.25), FT(0.25)});
  EXPECT_NEAR(p.point[2], 3 + std::tan(half / 2) / 2, 16 * this->epsilon);
  EXPECT_NEAR(p.point[0], 0, this->epsilon);
  EXPECT_NEAR(p.normal[2], 1, this->epsilon);
}

// --- vanishing normals ---

TYPED_TEST(PN_average_of, NoNormalsGiveTheLinearPointAndNoNormal)
{
  using FT = TypeParam;
  Rule<FT> rule;
  rule.add({1, 2, 3}, {0, 0, 0});
  rule.add({5, 2, -1}, {0, 0, 0});
  const auto p = rule({FT(0.25), FT(0.75)});
  EXPECT_EQ(p.point, (PN::Coordinates<FT, 3>{4, 2, 0}));
  EXPECT_EQ(p.normal, (PN::Coordinates<FT, 3>{0, 0, 0}));
}

// Two nearly opposite normals with equal weights: |N| is half the angle between one and the reverse
// of the other, and the sum of lengths is 1.
TYPED_TEST(PN_average_of, NormalVanishesAtTheTolerance)
{
  using FT = TypeParam;
  const FT tolerance = 4096 * this->epsilon;
  for (FT factor : {FT(0), FT(0.5), FT(0.98), FT(1.02), FT(2)}) {
    const FT t = 2 * factor * tolerance;
    Rule<FT> rule;
    rule.add({1, 0, 0}, {0, 0, 1});
    rule.add({0, 1, 0}, {std::sin(t), 0, -std::cos(t)});
    const auto p = rule({FT(0.5), FT(0.5)});
    EXPECT_EQ((p.normal == PN::Coordinates<FT, 3>{0, 0, 0}), factor < 1) << factor;
    if (factor < 1) {
      EXPECT_EQ(p.point, (PN::Coordinates<FT, 3>{0.5, 0.5, 0}));
    }
  }
}

// Missing normals do not count in the sum of lengths, negative weights count by their size.
TYPED_TEST(PN_average_of, ToleranceIsRelativeToTheNormalsThatThereAre)
{
  using FT = TypeParam;
  const FT tolerance = 4096 * this->epsilon;
  for (FT factor : {FT(0.98), FT(1.02)}) {
    const FT t = factor * tolerance * 6 / 3; // |N| = 3 * t, lengths 3 + 3
    Rule<FT> rule;
    rule.add({1, 0, 0}, {0, 0, 1});
    rule.add({0, 1, 0}, {std::sin(t), 0, std::cos(t)});
    rule.add({0, 0, 7}, {0, 0, 0});
    const auto p = rule({FT(3), FT(-3), FT(1)});
    EXPECT_EQ((p.normal == PN::Coordinates<FT, 3>{0, 0, 0}), factor < 1) << factor;
  }
}

// --- the fade ---

// Two entries with normal z give the new normal, the third has d = (n_3 + z).z with no part in it.
template <class FT>
reference::Real height_with_opposite(FT d, FT opposite_weight)
{
  Rule<FT> rule;
  const FT cosine = d - 1, sine = std::sqrt((1 - cosine) * (1 + cosine));
  const FT rest = 1 - opposite_weight;
  rule.add({1, 0, 1}, {0, 0, 1});
  rule.add({-1, 0, 3}, {0, 0, 1});
  rule.add({0, 4, 0}, {0, sine, cosine});
  const std::vector<FT> a{rest / 2, rest / 2, opposite_weight}, b{FT(0.5), FT(0.5), FT(0)};
  const auto p = rule(a, b);
  EXPECT_EQ(p.normal, (PN::Coordinates<FT, 3>{0, 0, 1}));
  return reference::Real(p.point[2]) - 2 * reference::Real(rest);
}

// The sum of the first two weights times heights, and the height of the third.
struct Heights
{
  reference::Real others, third;
};
Heights heights(reference::Real d, reference::Real a)
{
  const reference::Real rest = 1 - a, q = 2 * rest; // z of q; its y is 4a
  const reference::Real sine = std::sqrt(d * (2 - d));
  return {rest * (2 - q), (sine * (4 - 4 * a) + d * (0 - q)) / d};
}

TYPED_TEST(PN_average_of, IsThePapersSumWhereNothingFades)
{
  using FT = TypeParam;
  for (FT d : {FT(75.01 / 256), FT(0.3), FT(0.5), FT(1)}) {
    const Heights h = heights(d, 0.25);
    const reference::Real expected = h.others + h.third / 4;
    EXPECT_NEAR(double(height_with_opposite<FT>(d, FT(0.25)) / expected), 1, 4096 * this->epsilon);
  }
}

TYPED_TEST(PN_average_of, LeavesOutOppositeNormals)
{
  using FT = TypeParam;
  for (FT d : {FT(0), FT(0.0005), FT(0.05), FT(2.9999 / 32)})
    EXPECT_NEAR(double(height_with_opposite<FT>(d, FT(0.25))),
                double(heights(0.5, 0.25).others / 0.75L), 64 * this->epsilon);
}

// In the window at t: the share is t^2 (3 - 2t), of the weight and of the sum.
TYPED_TEST(PN_average_of, FadesInTheWindow)
{
  using FT = TypeParam;
  for (int percent : {10, 25, 50, 75, 90}) {
    const reference::Real t = percent / reference::Real(100);
    const FT d = FT(3 / 32.L + t * (75 / 256.L - 3 / 32.L));
    const Heights h = heights(d, 0.25);
    const reference::Real share = t * t * (3 - 2 * t) / 4;
    const reference::Real expected = (h.others + share * h.third) / (0.75L + share);
    EXPECT_NEAR(double(height_with_opposite<FT>(d, FT(0.25)) / expected), 1, 1e5 * this->epsilon)
      << percent;
  }
}

TEST(PN_average_fade, IsContinuous)
{
  // Over the window the height changes by about 2; 4000 steps of at most 0.002 each.
  double before = double(height_with_opposite<double>(0.09, 0.25));
  double largest = 0;
  for (int i = 1; i <= 4000; ++i) {
    const double d = 0.09 + i * (0.3 - 0.09) / 4000;
    const double h = double(height_with_opposite<double>(d, 0.25));
    largest = std::max(largest, std::abs(h - before));
    before = h;
  }
  EXPECT_LT(largest, 0.005);
}

// Too little weight is left: no height at all. 1/64 is still enough.
TYPED_TEST(PN_average_of, HasNoHeightBelowTheLeastWeight)
{
  using FT = TypeParam;
  for (FT rest : {FT(1) / 128, FT(0.99) / 64, FT(1) / 64, FT(1) / 32}) {
    const reference::Real h = height_with_opposite<FT>(0, 1 - rest);
    const reference::Real expected =
      rest < FT(1) / 64 ? 0
                        : heights(0.5, 1 - reference::Real(rest)).others / reference::Real(rest);
    EXPECT_NEAR(double(h), double(expected), 64 * this->epsilon) << double(rest);
  }
}

} // namespace
