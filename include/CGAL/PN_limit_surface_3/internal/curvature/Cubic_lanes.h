// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CUBIC_LANES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CUBIC_LANES_H

#include <CGAL/PN_subdivision_3/internal/average/Avx2_lanes.h>

#include <boost/config.hpp>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Cubics without a constant term, fitted to the heights of samples at several vertices side by side: the fit of
// Curvature_fit to points alone, by normal equations. Every loop over the lanes is one that compilers make
// arithmetic of wide registers of. Its matrix has moments of the samples as entries.
class Cubic_lanes
{
public:
  static constexpr std::size_t lanes = 4, unknowns = 9, max_samples = 96;
  using Lanes = double[lanes];

  // --- input ---
  std::size_t size = 0;         // the number of samples in the longest lane
  Lanes frame[3][3];            // e1, e2 and the normal
  Lanes number;                 // of samples in each lane
  Lanes sample[3][max_samples]; // offsets from the vertex; then x, y in units and the height
  Lanes cosine[max_samples];    // the weight; 0 behind the last sample of a lane

  // --- output ---
  Lanes unit[3];           // lower triangular: xx, yx, yy
  Lanes square_of_inverse; // the square of Curvature_fit's measure of condition
  Lanes least_pivot;
  Lanes coefficient[5]; // of x, y, xx, xy, yy

  void solve()
  {
#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
    if (__builtin_cpu_supports("avx2")) return solve_wide();
#endif
    solve_lanes();
  }

private:
#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
  [[gnu::target("avx2")]] void solve_wide()
  {
    solve_lanes();
  }
#endif

  BOOST_FORCEINLINE void solve_lanes()
  {
    set_units();
    set_moments();
    factor();
    invert();
    set_condition();
    set_coefficients();
  }

  // Coordinates in the frame, and units in which the second moments of the samples are 1.
  BOOST_FORCEINLINE void set_units()
  {
    Lanes xx{}, xy{}, yy{};
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t l = 0; l < lanes; ++l) {
        const double a = sample[0][j][l], b = sample[1][j][l], c = sample[2][j][l];
        const double x = frame[0][0][l] * a + frame[0][1][l] * b + frame[0][2][l] * c;
        const double y = frame[1][0][l] * a + frame[1][1][l] * b + frame[1][2][l] * c;
        sample[2][j][l] = frame[2][0][l] * a + frame[2][1][l] * b + frame[2][2][l] * c;
        sample[0][j][l] = x;
        sample[1][j][l] = y;
        xx[l] += x * x;
        xy[l] += x * y;
        yy[l] += y * y;
      }
    for (std::size_t l = 0; l < lanes; ++l) {
      const double of_vertex_too = number[l] + 1;
      unit[0][l] = std::sqrt(xx[l] / of_vertex_too);
      unit[1][l] = xy[l] / of_vertex_too / unit[0][l];
      const double rest = yy[l] / of_vertex_too - unit[1][l] * unit[1][l];
      unit[2][l] = std::sqrt(rest > 0 ? rest : 0);
    }
  }

  // The place of the moment of x^a y^b among all of degree 2 to 6.
  static constexpr std::size_t place(std::size_t a, std::size_t b)
  {
    return (a + b) * (a + b + 1) / 2 - 3 + b;
  }
  static constexpr std::size_t power_of_x[unknowns] = {1, 0, 2, 1, 0, 3, 2, 1, 0};
  static constexpr std::size_t power_of_y[unknowns] = {0, 1, 0, 1, 2, 0, 1, 2, 3};

  BOOST_FORCEINLINE void set_moments()
  {
    for (auto& m : moment_)
      for (double& x : m) x = 0;
    for (auto& m : right_side_)
      for (double& x : m) x = 0;
    Lanes over_xx, over_yy;
    for (std::size_t l = 0; l < lanes; ++l) {
      over_xx[l] = 1 / unit[0][l];
      over_yy[l] = 1 / unit[2][l];
    }
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t l = 0; l < lanes; ++l) {
        const double x = sample[0][j][l] * over_xx[l];
        const double y = (sample[1][j][l] - unit[1][l] * x) * over_yy[l], z = sample[2][j][l];
        const double weight = cosine[j][l] / (1 + (x * x + y * y) / 2);
        add_moments(l, x, y, z, weight * weight);
      }
  }

  BOOST_FORCEINLINE void add_moments(std::size_t l, double x, double y, double z, double weight)
  {
    const double wx = weight * x, wy = weight * y;
    const double xx = wx * x, xy = wx * y, yy = wy * y;
    const double xxx = xx * x, xxy = xx * y, xyy = yy * x, yyy = yy * y;
    const double x4 = xxx * x, x3y = xxx * y, x2y2 = xxy * y, xy3 = yyy * x, y4 = yyy * y;
    const double x5 = x4 * x, x4y = x4 * y, x3y2 = x3y * y, x2y3 = xy3 * x, xy4 = y4 * x,
                 y5 = y4 * y;
    // one by one: loops in the loop over the lanes would be in the way of wide registers
    moment_[0][l] += xx;
    moment_[1][l] += xy;
    moment_[2][l] += yy;
    moment_[3][l] += xxx;
    moment_[4][l] += xxy;
    moment_[5][l] += xyy;
    moment_[6][l] += yyy;
    moment_[7][l] += x4;
    moment_[8][l] += x3y;
    moment_[9][l] += x2y2;
    moment_[10][l] += xy3;
    moment_[11][l] += y4;
    moment_[12][l] += x5;
    moment_[13][l] += x4y;
    moment_[14][l] += x3y2;
    moment_[15][l] += x2y3;
    moment_[16][l] += xy4;
    moment_[17][l] += y5;
    moment_[18][l] += x5 * x;
    moment_[19][l] += x5 * y;
    moment_[20][l] += x4y * y;
    moment_[21][l] += x3y2 * y;
    moment_[22][l] += xy4 * x;
    moment_[23][l] += y5 * x;
    moment_[24][l] += y5 * y;
    right_side_[0][l] += z * wx;
    right_side_[1][l] += z * wy;
    right_side_[2][l] += z * xx;
    right_side_[3][l] += z * xy;
    right_side_[4][l] += z * yy;
    right_side_[5][l] += z * xxx;
    right_side_[6][l] += z * xxy;
    right_side_[7][l] += z * xyy;
    right_side_[8][l] += z * yyy;
  }

  BOOST_FORCEINLINE const double& moment(std::size_t i, std::size_t j, std::size_t l) const
  {
    return moment_[place(power_of_x[i] + power_of_x[j], power_of_y[i] + power_of_y[j])][l];
  }

  // L D L^T; the reciprocals of D, and L below the diagonal
  BOOST_FORCEINLINE void factor()
  {
    Lanes scaled[unknowns]; // a row of L D
    for (std::size_t l = 0; l < lanes; ++l) least_pivot[l] = 1;
    for (std::size_t i = 0; i < unknowns; ++i) {
      Lanes pivot;
      for (std::size_t l = 0; l < lanes; ++l) pivot[l] = moment(i, i, l);
      for (std::size_t j = 0; j < i; ++j) {
        Lanes sum;
        for (std::size_t l = 0; l < lanes; ++l) sum[l] = moment(i, j, l);
        for (std::size_t k = 0; k < j; ++k)
          for (std::size_t l = 0; l < lanes; ++l) sum[l] -= scaled[k][l] * lower_[j][k][l];
        for (std::size_t l = 0; l < lanes; ++l) {
          scaled[j][l] = sum[l];
          lower_[i][j][l] = sum[l] * inverse_pivot_[j][l];
          pivot[l] -= sum[l] * lower_[i][j][l];
        }
      }
      for (std::size_t l = 0; l < lanes; ++l) {
        inverse_pivot_[i][l] = 1 / pivot[l];
        least_pivot[l] = pivot[l] < least_pivot[l] ? pivot[l] : least_pivot[l];
      }
    }
  }

  // the inverse of L in its place
  BOOST_FORCEINLINE void invert()
  {
    for (std::size_t i = 1; i < unknowns; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Lanes sum;
        for (std::size_t l = 0; l < lanes; ++l) sum[l] = lower_[i][j][l];
        for (std::size_t k = j + 1; k < i; ++k)
          for (std::size_t l = 0; l < lanes; ++l) sum[l] += lower_[i][k][l] * lower_[k][j][l];
        for (std::size_t l = 0; l < lanes; ++l) lower_[i][j][l] = -sum[l];
      }
  }

  // The columns of each degree count as if they had a mean square of 1, and monomials as many times as
  // binomials tell: see Curvature_fit.
  BOOST_FORCEINLINE void set_condition()
  {
    constexpr double times[unknowns] = {1, 1, 1, 2, 1, 1, 3, 3, 1};
    constexpr std::size_t begin[] = {0, 2, 5, 9};
    for (std::size_t l = 0; l < lanes; ++l) square_of_inverse[l] = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      Lanes size_of_columns{}, inverse{};
      for (std::size_t i = begin[d]; i < begin[d + 1]; ++i)
        for (std::size_t l = 0; l < lanes; ++l) {
          double diagonal = inverse_pivot_[i][l];
          for (std::size_t k = i + 1; k < unknowns; ++k)
            diagonal += lower_[k][i][l] * lower_[k][i][l] * inverse_pivot_[k][l];
          inverse[l] += diagonal / times[i];
          size_of_columns[l] += times[i] * moment(i, i, l);
        }
      for (std::size_t l = 0; l < lanes; ++l)
        square_of_inverse[l] += inverse[l] * size_of_columns[l] / double(begin[d + 1] - begin[d]);
    }
  }

  BOOST_FORCEINLINE void set_coefficients()
  {
    // from the last row on, since a row needs the right sides of those before it
    for (std::size_t i = unknowns; i-- > 0;) {
      Lanes sum;
      for (std::size_t l = 0; l < lanes; ++l) sum[l] = right_side_[i][l];
      for (std::size_t k = 0; k < i; ++k)
        for (std::size_t l = 0; l < lanes; ++l) sum[l] += lower_[i][k][l] * right_side_[k][l];
      for (std::size_t l = 0; l < lanes; ++l) right_side_[i][l] = sum[l] * inverse_pivot_[i][l];
    }
    for (std::size_t i = 0; i < 5; ++i) {
      Lanes sum;
      for (std::size_t l = 0; l < lanes; ++l) sum[l] = right_side_[i][l];
      for (std::size_t k = i + 1; k < unknowns; ++k)
        for (std::size_t l = 0; l < lanes; ++l) sum[l] += lower_[k][i][l] * right_side_[k][l];
      for (std::size_t l = 0; l < lanes; ++l) coefficient[i][l] = sum[l];
    }
  }

  Lanes moment_[25];
  Lanes right_side_[unknowns];
  Lanes lower_[unknowns][unknowns];
  Lanes inverse_pivot_[unknowns];
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CUBIC_LANES_H
