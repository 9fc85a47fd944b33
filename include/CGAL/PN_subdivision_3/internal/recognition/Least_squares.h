// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_LEAST_SQUARES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_LEAST_SQUARES_H

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// Linear least squares of few unknowns: rows are taken up one by one by Givens rotations, so that nothing is squared and
// only a triangle is kept. Unknowns that the rows do not determine get the solution of least norm (in the scale of the
// columns), by one-sided Jacobi rotations of the triangle.
class Least_squares
{
public:
  static constexpr int most = 8;
  using Row = std::array<double, most>;

  explicit Least_squares(int unknowns)
    : n_(unknowns)
  {}

  void add(Row row, double right)
  {
    for (int i = 0; i < n_; ++i) {
      if (row[i] == 0) continue;
      const double a = r_[i][i], b = row[i], h = std::sqrt(a * a + b * b);
      const double c = a / h, s = b / h;
      r_[i][i] = h;
      for (int j = i + 1; j < n_; ++j) turn(r_[i][j], row[j], c, s);
      turn(right_[i], right, c, s);
    }
  }

  Row solve() const
  {
    Row scale{}, x{};
    for (int j = 0; j < n_; ++j) {
      for (int i = 0; i <= j; ++i) scale[j] += r_[i][j] * r_[i][j];
      scale[j] = std::sqrt(scale[j]);
    }
    bool is_regular = true;
    for (int j = 0; j < n_; ++j) is_regular = is_regular && std::abs(r_[j][j]) > 1e-6 * scale[j];
    if (!is_regular) return solve_by_jacobi(scale);
    for (int i = n_ - 1; i >= 0; --i) {
      double sum = right_[i];
      for (int j = i + 1; j < n_; ++j) sum -= r_[i][j] * x[j];
      x[i] = sum / r_[i][i];
    }
    return x;
  }

private:
  using Matrix = std::array<Row, most>;
  static constexpr double rank_tolerance = 1e-9;

  static void turn(double& x, double& y, double c, double s)
  {
    const double old = x;
    x = c * old + s * y;
    y = c * y - s * old;
  }

  // turns the columns of w, and those of v with them, until they are orthogonal
  void make_orthogonal(Matrix& w, Matrix& v) const
  {
    for (int sweep = 0; sweep < 30; ++sweep) {
      bool is_done = true;
      for (int p = 0; p < n_; ++p)
        for (int q = p + 1; q < n_; ++q) {
          double a = 0, b = 0, g = 0;
          for (int i = 0; i < n_; ++i) {
            a += w[i][p] * w[i][p];
            b += w[i][q] * w[i][q];
            g += w[i][p] * w[i][q];
          }
          if (!(std::abs(g) > 1e-15 * std::sqrt(a * b))) continue;
          is_done = false;
          const double zeta = (b - a) / (2 * g);
          const double t = (zeta >= 0 ? 1 : -1) / (std::abs(zeta) + std::hypot(zeta, 1.));
          const double c = 1 / std::hypot(t, 1.), s = -c * t;
          for (int i = 0; i < n_; ++i) {
            turn(w[i][p], w[i][q], c, s);
            turn(v[i][p], v[i][q], c, s);
          }
        }
      if (is_done) break;
    }
  }

  Row solve_by_jacobi(const Row& scale) const
  {
    Matrix w{}, v{};
    for (int j = 0; j < n_; ++j) {
      v[j][j] = 1;
      for (int i = 0; i <= j && scale[j] > 0; ++i) w[i][j] = r_[i][j] / scale[j];
    }
    make_orthogonal(w, v);
    Row x{}, length{};
    double longest = 0;
    for (int j = 0; j < n_; ++j) {
      for (int i = 0; i < n_; ++i) length[j] += w[i][j] * w[i][j];
      longest = (std::max)(longest, length[j]);
    }
    for (int j = 0; j < n_; ++j) {
      if (!(length[j] > rank_tolerance * rank_tolerance * longest)) continue;
      double along = 0;
      for (int i = 0; i < n_; ++i) along += w[i][j] * right_[i];
      for (int i = 0; i < n_; ++i) x[i] += v[i][j] * along / length[j];
    }
    for (int j = 0; j < n_; ++j) x[j] = scale[j] > 0 ? x[j] / scale[j] : 0;
    return x;
  }

  int n_;
  Matrix r_{};
  Row right_{};
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_LEAST_SQUARES_H
