// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Smoothness by measurement: divided differences of PN B-splines behave like those of the linear
// scheme; the cubic with 4-point normals is smooth, but less so.

#include "Curve_cases.h"

using namespace curve_cases;

namespace {

using Vector = Long_double::Vector_2;

Real length(const Vector& v)
{
  return std::sqrt(v.squared_length());
}

// own differences: the package's are tested elsewhere
template <class Mask>
std::vector<Vector> differences(const Mask& mask, unsigned order, unsigned k)
{
  const auto curve = PN::subdivide_curve(wavy<Long_double>(9), mask, Curve_end::closed,
                                         params::number_of_iterations(k));
  std::vector<Vector> d;
  for (const auto& item : curve) d.push_back(item.first - CGAL::ORIGIN);
  for (unsigned m = 0; m < order; ++m) {
    const Vector first = d[0];
    for (std::size_t i = 0; i < d.size(); ++i)
      d[i] = ((i + 1 < d.size() ? d[i + 1] : first) - d[i]) * std::ldexp(Real(1), int(k));
  }
  return d;
}

Real largest_length(const std::vector<Vector>& d)
{
  return largest(d, length);
}

// between neighbors
std::vector<Real> jumps(const std::vector<Vector>& d)
{
  std::vector<Real> result;
  for (std::size_t i = 0; i < d.size(); ++i) result.push_back(length(d[(i + 1) % d.size()] - d[i]));
  return result;
}

Real largest_jump(const std::vector<Vector>& d)
{
  return largest(jumps(d), [](Real x) { return x; });
}

// how far round k + 1 moves the differences of round k
template <class Mask>
Real increment(const Mask& mask, unsigned order, unsigned k)
{
  const auto coarse = differences(mask, order, k), fine = differences(mask, order, k + 1);
  Real result = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i)
    result = std::max(result, length(fine[2 * i] - coarse[i]));
  return result;
}

class CurveSmoothness : public testing::TestWithParam<int>
{
protected:
  int degree() const { return GetParam(); }
  unsigned order() const { return static_cast<unsigned>(GetParam()); }
  PN::B_spline_mask mask() const { return PN::B_spline_mask(GetParam()); }
};

TEST_P(CurveSmoothness, DifferencesBelowTheDegreeConvergeAsTheLinearOnesDo)
{
  // the modulus of continuity, which halves each round for the linear scheme
  for (unsigned k = 7; k <= 10; ++k) {
    const Real linear = largest_jump(differences(PN::linear(mask()), order() - 1, k + 1)) /
                        largest_jump(differences(PN::linear(mask()), order() - 1, k));
    const Real pn = largest_jump(differences(mask(), order() - 1, k + 1)) /
                    largest_jump(differences(mask(), order() - 1, k));
    EXPECT_NEAR(linear, 0.5, 1e-6);
    EXPECT_NEAR(pn, linear, 0.01);
    EXPECT_LE(increment(mask(), order() - 1, k + 1), 0.51L * increment(mask(), order() - 1, k));
  }
}

TEST_P(CurveSmoothness, DifferencesOfTheDegreeAreBounded)
{
  const Real early = largest_length(differences(mask(), order(), 6));
  for (unsigned k = 7; k <= 11; ++k)
    EXPECT_NEAR(largest_length(differences(mask(), order(), k)) / early, 1, 0.03);
}

// the largest of the jumps that are at most 4 places from position i
Real jump_near(const std::vector<Real>& d, std::size_t i)
{
  Real result = 0;
  for (std::size_t k = 0; k < 9; ++k)
    result = std::max(result, d[(i + d.size() + k - 4) % d.size()]);
  return result;
}

// A round adds knots, whose jumps are the smaller the later they come; a third of an interval never
// becomes one.
TEST_P(CurveSmoothness, DifferencesOfTheDegreeJumpAtKnots)
{
  for (unsigned k = 8; k <= 11; ++k) {
    const auto coarse = jumps(differences(mask(), order(), k));
    const auto fine = jumps(differences(mask(), order(), k + 1));
    const std::size_t interval = std::size_t(1) << k;
    // knots are at old points for odd degrees, in the middle of edges for even ones
    const std::size_t knot = degree() % 2 != 0 ? 0 : interval / 2;
    for (std::size_t j = 0; j < 9; ++j) {
      const std::size_t at = j * interval + knot, beside = at + interval / 3;
      EXPECT_GT(jump_near(fine, 2 * at), 0.03L);
      EXPECT_NEAR(jump_near(fine, 2 * at) / jump_near(coarse, at), 1, 0.05);
      EXPECT_LE(jump_near(fine, 2 * beside), 0.7L * jump_near(coarse, beside));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(QuadraticAndCubic, CurveSmoothness, testing::Values(2, 3));

TEST(CurveSmoothnessOfMixedMasks, CubicWithFourPointNormals)
{
  const auto mask = PN::with_normal_mask(PN::B_spline_mask(3), PN::Dubuc_Deslauriers_mask(4));
  const PN::B_spline_mask cubic(3);
  for (unsigned k = 7; k <= 10; ++k) {
    // first differences converge as those of a curve with a bounded second derivative
    EXPECT_LE(increment(mask, 1, k + 1), 0.51L * increment(mask, 1, k));
    EXPECT_LE(largest_jump(differences(mask, 1, k + 1)),
              0.51L * largest_jump(differences(mask, 1, k)));
    // So do second differences: a round adds about c h^2 g' to the height over a tangent, g' being the
    // derivative of the 4-point normals' slope; its second differences over h^2 are those of g', which is
    // almost Lipschitz, and hence summable. The ratio tends to 1/2 like 1/2 + c/k.
    EXPECT_LE(increment(mask, 2, k + 1), 0.6L * increment(mask, 2, k));
    // third differences, bounded with the cubic's own normals, grow by as much each round
    const Real growth =
      largest_length(differences(mask, 3, k + 1)) - largest_length(differences(mask, 3, k));
    EXPECT_GT(growth, 1);
    EXPECT_LE(largest_length(differences(cubic, 3, k + 1)) -
                largest_length(differences(cubic, 3, k)),
              0.05L);
  }
}

} // namespace
