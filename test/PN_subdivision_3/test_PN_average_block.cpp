// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The staged evaluation of blocks against the PN rule row by row, and both against the matrix form.

#include "reference/PN_rule.h"

#include <CGAL/PN_subdivision_3/PN_average.h>
#include <CGAL/PN_subdivision_3/Stencil.h>
#include <CGAL/PN_subdivision_3/internal/PN_average_block.h>

#include <gtest/gtest.h>

#include <limits>
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
PN::Stencil<FT> some_rows(std::size_t rows, std::size_t length, bool any_length, std::size_t values)
{
  std::mt19937 generator(static_cast<unsigned>(13 * length + rows));
  std::uniform_real_distribution<double> weight(-0.1, 0.5);
  PN::Stencil<FT> stencil;
  for (std::size_t r = 0; r < rows; ++r) {
    const std::size_t n = any_length ? 1 + generator() % length : length;
    for (std::size_t j = 0; j < n; ++j) {
      const auto v = static_cast<typename PN::Stencil<FT>::Index>(generator() % values);
      if (j + 1 == n)
        stencil.add_rest(v);
      else
        stencil.add(v, FT(weight(generator)));
    }
    stencil.close_row();
  }
  return stencil;
}

template <class FT>
void compare_block_with_rows(const PN::Stencil<FT>& rows,
                             const std::vector<PN::Point_normal<FT, 3>>& old, FT tolerance)
{
  using Block = typename PN::internal::Block_of<PN::PN_average<FT, 3>>::type;
  const std::vector<typename Block::Stored_value> stored(old.begin(), old.end());
  std::vector<PN::Point_normal<FT, 3>> result(rows.number_of_rows());
  Block()(rows, stored.data(), result.data());
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
  for (std::size_t length = 1; length <= 20; ++length)
    for (std::size_t rows : {std::size_t(1), std::size_t(5), PN::internal::block_size_v<FT>})
      for (bool any_length : {false, true})
        compare_block_with_rows(some_rows<FT>(rows, length, any_length, old.size()), old,
                                tolerance);
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
