// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The staged evaluation of blocks against the PN rule row by row, and both against the matrix form.

#include "reference/PN_rule.h"

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/rows/PN_average_block.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>

#include <gtest/gtest.h>

#include <random>

namespace {

namespace PN = CGAL::PN_subdivision_3;

template <class FT>
class PN_average_block : public testing::Test
{
public:
  static constexpr FT epsilon = std::numeric_limits<FT>::epsilon();
};
using Number_types = testing::Types<double, float, long double>;
TYPED_TEST_SUITE(PN_average_block, Number_types, );

template <class FT>
reference::Values as_reference(const std::vector<PN::Point_normal<FT, 3>>& old)
{
  reference::Values values;
  for (const auto& v : old) {
    values.points.emplace_back(v.point[0], v.point[1], v.point[2]);
    values.normals.emplace_back(v.normal[0], v.normal[1], v.normal[2]);
  }
  return values;
}

// Normals about z; every `wild`-th one is missing or opposite.
template <class FT>
std::vector<PN::Point_normal<FT, 3>> some_values(std::size_t n, std::size_t wild)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<PN::Point_normal<FT, 3>> values;
  for (std::size_t i = 0; i < n; ++i) {
    FT x = FT(coordinate(generator)), y = FT(coordinate(generator)), z = 2;
    FT length = std::sqrt(x * x + y * y + z * z);
    if (wild != 0 && i % wild == 0) length = -length;
    PN::Coordinates<FT, 3> normal{x / length, y / length, z / length};
    if (wild != 0 && i % wild == 1) normal = {0, 0, 0};
    values.push_back(
      {{FT(coordinate(generator)), FT(coordinate(generator)), FT(coordinate(generator))}, normal});
  }
  return values;
}

// `rows` rows of random weights that sum to 1; of `length` entries, or of any number up to it.
template <class FT>
PN::internal::Stencil_block<FT> some_rows(std::size_t rows, std::size_t length, bool any_length,
                                          std::size_t values)
{
  std::mt19937 generator(static_cast<unsigned>(13 * length + rows));
  std::uniform_real_distribution<double> weight(-0.1, 0.5);
  PN::internal::Stencil_block<FT> stencil;
  for (std::size_t r = 0; r < rows; ++r) {
    const std::size_t n = any_length ? 1 + generator() % length : length;
    for (std::size_t j = 0; j < n; ++j) {
      const auto v =
        static_cast<typename PN::internal::Stencil_block<FT>::Index>(generator() % values);
      if (j + 1 == n)
        stencil.row().add_rest(v);
      else
        stencil.row().add(v, FT(weight(generator)));
    }
    stencil.close_row();
  }
  return stencil;
}

// what processors without wide registers compute
struct Not_wide
{
  static constexpr std::size_t maximum_length = 0;
};
template <class FT, int dimension>
using Narrow_block =
  PN::internal::Staged_PN_average_block<PN::PN_average<FT, dimension>, dimension, Not_wide>;

template <class Block>
std::vector<typename Block::Value>
block_of_rows(const PN::internal::Stencil_block<typename Block::FT>& rows,
              const std::vector<typename Block::Value>& old)
{
  std::vector<typename Block::Value> result(rows.number_of_rows());
  Block()(rows, old.data(), result.data());
  return result;
}

// One roundness of all values: that fraction of the way from the linear point, whichever the block.
template <class Block, class FT>
void expect_fraction_of_the_way(FT roundness)
{
  const auto old = some_values<FT>(40, 6);
  std::vector<PN::Coordinates<FT, 3>> points;
  for (const auto& v : old) points.push_back(v.point);
  PN::PN_average<FT, 3> average;
  average.roundness = roundness;
  const Block block{average};
  for (std::size_t length = 1; length <= 20; ++length) {
    const auto rows = some_rows<FT>(PN::internal::block_size_v<FT>, length, false, old.size());
    const auto round = block_of_rows<Block>(rows, old);
    auto part = round;
    block(rows, old.data(), part.data());
    for (std::size_t r = 0; r < part.size(); ++r) {
      const auto linear = PN::Linear_average<FT, 3>()(rows.begin(r), rows.end(r), points.data());
      EXPECT_EQ(part[r].normal, round[r].normal);
      for (std::size_t k = 0; k < 3; ++k) {
        const FT way = round[r].point[k] - linear[k];
        EXPECT_NEAR(part[r].point[k], linear[k] + roundness * way,
                    64 * std::numeric_limits<FT>::epsilon() * (1 + std::abs(way)))
          << "row of " << length;
      }
    }
  }
}

TYPED_TEST(PN_average_block, OneRoundnessOfAllIsAFractionOfTheWay)
{
  for (const TypeParam w : {TypeParam(0), TypeParam(3) / 8, TypeParam(1)}) {
    expect_fraction_of_the_way<typename PN::internal::Block_of<PN::PN_average<TypeParam, 3>>::type>(
      w);
    expect_fraction_of_the_way<Narrow_block<TypeParam, 3>>(w);
  }
}

// A roundness of every value is summed as the points are, and that fraction of the way is gone.
template <class Block, class FT>
void expect_summed_roundness(FT epsilon)
{
  const auto equal = some_values<FT>(40, 0);
  std::vector<typename Block::Value> old;
  for (std::size_t v = 0; v < equal.size(); ++v)
    old.push_back({equal[v].point, equal[v].normal, FT(7 * v % 41) / FT(40)});
  for (std::size_t length = 2; length <= 20; ++length) {
    const auto rows = some_rows<FT>(PN::internal::block_size_v<FT>, length, false, old.size());
    const auto result = block_of_rows<Block>(rows, old);
    for (std::size_t r = 0; r < result.size(); ++r) {
      FT w(0);
      PN::Coordinates<FT, 3> linear{};
      for (const auto* e = rows.begin(r); e != rows.end(r); ++e) {
        w += e->weight * old[e->vertex].roundness;
        for (std::size_t k = 0; k < 3; ++k) linear[k] += e->weight * old[e->vertex].point[k];
      }
      const auto round = PN::PN_average<FT, 3>()(rows.begin(r), rows.end(r), equal.data());
      ASSERT_NEAR(result[r].roundness, w, 16 * epsilon) << "row " << r << " of " << length;
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(result[r].point[k], linear[k] + w * (round.point[k] - linear[k]), 64 * epsilon)
          << "row " << r << " of " << length;
    }
  }
}

TYPED_TEST(PN_average_block, RoundnessOfEveryValueIsSummedAsThePointsAre)
{
  using Average = PN::PN_average<TypeParam, 3>;
  expect_summed_roundness<typename PN::internal::Block_of<Average>::type>(this->epsilon);
  expect_summed_roundness<PN::internal::Staged_PN_average_block<Average, 3, Not_wide>>(
    this->epsilon);
}

template <class Block, class FT>
void compare_block_with_rows(const PN::internal::Stencil_block<FT>& rows,
                             const std::vector<PN::Point_normal<FT, 3>>& old, FT tolerance)
{
  const auto result = block_of_rows<Block>(rows, old);
  for (std::size_t r = 0; r < result.size(); ++r) {
    const auto expected = PN::PN_average<FT, 3>()(rows.begin(r), rows.end(r), old.data());
    for (std::size_t k = 0; k < 3; ++k) {
      // two roundings each: of 1/|N| and the product, of |N| and the quotient
      EXPECT_LE(std::abs(result[r].normal[k] - expected.normal[k]),
                2 * std::numeric_limits<FT>::epsilon())
        << "row " << r;
      EXPECT_LE(std::abs(result[r].point[k] - expected.point[k]), tolerance)
        << "row " << r << " of " << rows.end(r) - rows.begin(r);
    }
    if (rows.end(r) - rows.begin(r) == 1) {
      EXPECT_EQ(result[r].point, old[rows.begin(r)->vertex].point);
    }
  }
}

template <class FT>
void compare_blocks(const std::vector<PN::Point_normal<FT, 3>>& old, FT tolerance)
{
  using Block = typename PN::internal::Block_of<PN::PN_average<FT, 3>>::type;
  for (std::size_t length = 1; length <= 20; ++length)
    for (std::size_t number : {std::size_t(1), std::size_t(5), PN::internal::block_size_v<FT>})
      for (bool any_length : {false, true}) {
        const auto rows = some_rows<FT>(number, length, any_length, old.size());
        compare_block_with_rows<Block>(rows, old, tolerance);
        compare_block_with_rows<Narrow_block<FT, 3>>(rows, old, tolerance);
      }
}

TYPED_TEST(PN_average_block, BlocksAreRowsOneByOne)
{
  compare_blocks<TypeParam>(some_values<TypeParam>(40, 0), 64 * this->epsilon);
}

// Where normals are opposite, the rows of a block are those of the rule, or magnified rounding.
TYPED_TEST(PN_average_block, BlocksWithOppositeAndMissingNormalsAreRowsOneByOne)
{
  compare_blocks<TypeParam>(some_values<TypeParam>(40, 6), 65536 * this->epsilon);
}

template <class FT, int dimension>
std::vector<PN::Point_normal<FT, dimension>> some_values_of(std::size_t n, std::size_t wild)
{
  std::vector<PN::Point_normal<FT, dimension>> values;
  for (const auto& v : some_values<FT>(n, wild)) {
    values.emplace_back();
    for (std::size_t c = 0; c < dimension; ++c) {
      values.back().point[c] = v.point[c];
      values.back().normal[c] = v.normal[3 - dimension + c];
    }
  }
  return values;
}

// The wide block against the narrow one: rows of any length and number, runs that end anywhere.
template <class FT, int dimension>
void expect_same_bits(std::size_t wild)
{
  using Block = typename PN::internal::Block_of<PN::PN_average<FT, dimension>>::type;
  const auto old = some_values_of<FT, dimension>(40, wild);
  for (std::size_t length = 1; length <= 64; ++length)
    for (std::size_t number = 1; number <= PN::internal::block_size_v<FT>; ++number)
      for (bool any_length : {false, true}) {
        // of few lengths, so that there are runs
        const std::size_t longest = any_length ? 1 + length % 3 : length;
        const auto rows = some_rows<FT>(number, longest, any_length, old.size());
        const auto wide = block_of_rows<Block>(rows, old);
        const auto narrow = block_of_rows<Narrow_block<FT, dimension>>(rows, old);
        for (std::size_t r = 0; r < number; ++r) {
          ASSERT_EQ(wide[r].point, narrow[r].point) << r << " of " << number << " x " << length;
          ASSERT_EQ(wide[r].normal, narrow[r].normal) << r << " of " << number << " x " << length;
        }
      }
}

template <class FT>
bool differs_by_design()
{
#if defined(__FMA__) // the compiler fuses operations as it likes
  return true;
#else
  using Vectorized = PN::internal::Vectorized_PN_average<FT, 3>;
  if constexpr (Vectorized::maximum_length == 0)
    return true;
  else
    return !Vectorized::is_available();
#endif
}

TYPED_TEST(PN_average_block, OfWideRegistersHasTheBitsOfTheNarrowOne)
{
  if (differs_by_design<TypeParam>())
    GTEST_SKIP() << "does not apply: no wide registers, or fused operations";
  expect_same_bits<TypeParam, 2>(0);
  expect_same_bits<TypeParam, 3>(0);
}

TYPED_TEST(PN_average_block, OfWideRegistersHasTheBitsOfTheNarrowOneWithOppositeAndMissingNormals)
{
  if (differs_by_design<TypeParam>())
    GTEST_SKIP() << "does not apply: no wide registers, or fused operations";
  expect_same_bits<TypeParam, 2>(6);
  expect_same_bits<TypeParam, 3>(6);
}

// What programs that trap floating point exceptions rely on.
template <class Block, class FT, int dimension>
int exceptions_raised(const std::vector<PN::Point_normal<FT, dimension>>& old)
{
  const auto rows = some_rows<FT>(PN::internal::block_size_v<FT>, 7, true, old.size());
  std::feclearexcept(FE_ALL_EXCEPT);
  block_of_rows<Block>(rows, old);
  return std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
}

TYPED_TEST(PN_average_block, DividesByZeroNowhere)
{
  using FT = TypeParam;
  using Block = typename PN::internal::Block_of<PN::PN_average<FT, 3>>::type;
  auto old = some_values<FT>(40, 6);
  EXPECT_EQ((exceptions_raised<Block, FT, 3>(old)), 0);
  for (auto& value : old) value.normal.fill(FT(0));
  EXPECT_EQ((exceptions_raised<Block, FT, 3>(old)), 0);
  EXPECT_EQ((exceptions_raised<Narrow_block<FT, 3>, FT, 3>(old)), 0);
  for (std::size_t v = 0; v < old.size(); ++v) old[v].normal[0] = FT(v % 2 == 0 ? 1 : -1);
  EXPECT_EQ((exceptions_raised<Block, FT, 3>(old)), 0);
  EXPECT_EQ((exceptions_raised<Narrow_block<FT, 3>, FT, 3>(old)), 0);
}

TYPED_TEST(PN_average_block, EqualsTheMatrixForm)
{
  using FT = TypeParam;
  const auto old = some_values<FT>(30, 0);
  const auto values = as_reference(old);
  for (std::size_t length = 2; length <= 20; ++length) {
    const auto rows = some_rows<FT>(8, length, false, old.size());
    for (std::size_t r = 0; r < 8; ++r) {
      reference::Row a = reference::Row::Zero(30);
      for (auto e = rows.begin(r); e != rows.end(r); ++e) a[e->vertex] += e->weight;
      const auto expected = reference::pn_rule(a, a, values, this->epsilon);
      const auto p = PN::PN_average<FT, 3>()(rows.begin(r), rows.end(r), old.data());
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(double(p.point[std::size_t(k)]), double(expected.point[k]),
                    256 * this->epsilon);
        EXPECT_NEAR(double(p.normal[std::size_t(k)]), double(expected.normal[k]),
                    64 * this->epsilon);
      }
    }
  }
}

} // namespace
