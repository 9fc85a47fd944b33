// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The modified schemes in all number types.

#include "Modified_rings.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/FPU.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/operators.hpp>

#ifdef CGAL_USE_CORE
#  include <CGAL/CORE_Expr.h>
#endif

namespace {

template <class Kind>
class Modified_scheme_numbers : public testing::Test
{};
TYPED_TEST_SUITE(Modified_scheme_numbers, Kinds_of_faces, );

template <class FT>
double as_double(const FT& x)
{
  return CGAL::to_double(x);
}
using Big = boost::multiprecision::cpp_bin_float_50;
double as_double(const Big& x)
{
  return x.convert_to<double>();
}

// A user's number type that has cos() and acos(), but no sqrt(): a long double behind operators.
class Rootless : boost::ordered_field_operators<Rootless>
{
public:
  Rootless() = default;
  explicit Rootless(int x)
    : value_(x)
  {}
  explicit Rootless(double x)
    : value_(x)
  {}

  Rootless operator-() const { return Rootless(-value_); }
  Rootless& operator+=(const Rootless& x) { return value_ += x.value_, *this; }
  Rootless& operator-=(const Rootless& x) { return value_ -= x.value_, *this; }
  Rootless& operator*=(const Rootless& x) { return value_ *= x.value_, *this; }
  Rootless& operator/=(const Rootless& x) { return value_ /= x.value_, *this; }
  [[maybe_unused]] friend bool operator==(const Rootless& a, const Rootless& b)
  {
    return a.value_ == b.value_;
  }
  friend bool operator<(const Rootless& a, const Rootless& b) { return a.value_ < b.value_; }
  friend Rootless cos(const Rootless& x) { return Rootless(std::cos(x.value_)); }
  friend Rootless acos(const Rootless& x) { return Rootless(std::acos(x.value_)); }
  friend double as_double(const Rootless& x) { return static_cast<double>(x.value_); }

private:
  explicit Rootless(long double x)
    : value_(x)
  {}

  long double value_ = 0;
};

template <class FT, class Kind>
void expect_weights_of_reference(double tolerance)
{
  for (int n : {3, 4, 5, 6, 7, 8, 12}) {
    if (n == Kind::regular_valence) continue;
    const auto rows = ring_of<FT, Kind>(n, typename Kind::Modified(0.25));
    const Matrix expected = Kind::ring(n, Real(0.25));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows.size(); ++j)
        EXPECT_NEAR(as_double(rows[i][j]), double(expected(Eigen::Index(i), Eigen::Index(j))),
                    tolerance)
          << n;
  }
}

TYPED_TEST(Modified_scheme_numbers, ServesAllNumberTypes)
{
  expect_weights_of_reference<float, TypeParam>(2e-7);
  expect_weights_of_reference<double, TypeParam>(4e-16);
  expect_weights_of_reference<long double, TypeParam>(2e-16);
  expect_weights_of_reference<CGAL::Gmpq, TypeParam>(4e-16);
  expect_weights_of_reference<CGAL::Epeck::FT, TypeParam>(4e-16);
  expect_weights_of_reference<CGAL::Interval_nt<>, TypeParam>(4e-16);
  expect_weights_of_reference<Big, TypeParam>(2e-16);
#ifdef CGAL_USE_CORE
  expect_weights_of_reference<CORE::Expr, TypeParam>(4e-16);
#endif
}

// S' S = S S', as precisely as the weights are
template <class FT, class Kind>
void expect_commutation(double tolerance)
{
  for (int n : {5, 7, 9}) {
    const auto plain = ring_of<FT, Kind>(n, Kind::unmodified()),
               m = ring_of<FT, Kind>(n, typename Kind::Modified());
    for (std::size_t i = 0; i < m.size(); ++i)
      for (std::size_t j = 0; j < m.size(); ++j) {
        FT commutator(0);
        for (std::size_t k = 0; k < m.size(); ++k)
          commutator += plain[i][k] * m[k][j] - m[i][k] * plain[k][j];
        EXPECT_LE(std::abs(as_double(commutator)), tolerance) << n;
      }
  }
}

// More digits than long double has: the cosines and roots are those of the type itself.
TYPED_TEST(Modified_scheme_numbers, UsesTheCosinesOfTheNumberType)
{
  expect_commutation<Big, TypeParam>(1e-47);
}

// Only the eigenvalues of Catmull-Clark subdivision are roots. Loop's weights keep the digits that a
// long double has beyond a double, to which weights of other types are rounded.
TYPED_TEST(Modified_scheme_numbers, NeedsNoRootsOfTheNumberType)
{
  expect_weights_of_reference<Rootless, TypeParam>(4e-16);
  expect_commutation<Rootless, TypeParam>(std::is_same_v<TypeParam, Triangles> ? 1e-18 : 1e-15);
}

// Intervals are computed with rounding upward: what that leaves behind must not be seen in double.
TEST(Irrational_weights, DoNotDependOnTheRoundingOfTheCaller)
{
  std::vector<double> upward, nearest;
  const auto append_cosines = [](std::vector<double>& cosines) {
    for (int n = 5; n <= 200; ++n)
      for (int k = 1; k < n; ++k) cosines.push_back(PN::cosine_weight<double>(k, n));
  };
  {
    const CGAL::Protect_FPU_rounding<true> rounding(CGAL_FE_UPWARD);
    append_cosines(upward);
  }
  append_cosines(nearest);
  EXPECT_EQ(upward, nearest);
}

// Neither the cosine of the mathematical library nor the size of long double is seen: with 80 bits the weights of
// valence 12 and the cosines of 53rds come out otherwise than with 113.
TEST(Irrational_weights, AreTheNearestDoubles)
{
  const Big turn = 2 * boost::math::constants::pi<Big>();
  for (int n = 5; n <= 400; ++n)
    for (int k = 1; k < n; ++k) {
      const auto nearest = Big(cos(Big(turn * k / n))).convert_to<double>();
      if (4 * k == n || 4 * k == 3 * n) continue; // 0, exactly
      ASSERT_EQ(PN::cosine_weight<double>(k, n), nearest) << k << " of " << n;
      ASSERT_EQ(PN::cosine_weight<float>(k, n), static_cast<float>(nearest)) << k << " of " << n;
    }
  for (int n : {5, 7, 12, 30, 39, 49, 53, 58}) {
    const auto rows = ring_of<double, Triangles>(n, PN::Loop_scheme::Tuned());
    const auto exact = ring_of<Big, Triangles>(n, PN::Loop_scheme::Tuned());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 1; j < rows.size(); ++j) // the center has the rest
        EXPECT_EQ(rows[i][j], exact[i][j].convert_to<double>()) << n << ": " << i << ", " << j;
  }
}

} // namespace
