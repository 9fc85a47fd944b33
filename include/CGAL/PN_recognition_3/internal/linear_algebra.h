// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_LINEAR_ALGEBRA_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_LINEAR_ALGEBRA_H

#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <array>
#include <cmath>

namespace CGAL::PN_subdivision_3::internal::recognition {

using internal::cross;
using internal::dot;

// coordinates that begin as zero, and that expressions are written with
struct Vec3 : Coordinates<double, 3>
{
  Vec3()
    : Vec3(0, 0, 0)
  {}
  Vec3(double x, double y, double z)
    : Coordinates<double, 3>{x, y, z}
  {}
  Vec3(const Coordinates<double, 3>& a)
    : Coordinates<double, 3>(a)
  {}
};

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return difference(a, b);
}
inline Vec3 operator-(const Vec3& a)
{
  return opposite_vector(a);
}
inline Vec3 operator*(double s, const Vec3& a)
{
  return multiple(s, a);
}
inline Vec3& operator+=(Vec3& a, const Vec3& b)
{
  return a = a + b;
}
inline double norm(const Vec3& a)
{
  return std::sqrt(dot(a, a));
}
// zero of zero
inline Vec3 unit(const Vec3& a)
{
  const double n = norm(a);
  return n > 0 ? (1 / n) * a : Vec3();
}
inline double angle_between(const Vec3& a, const Vec3& b)
{
  return std::atan2(norm(cross(a, b)), dot(a, b));
}
inline double radians(double degrees)
{
  return degrees * std::acos(-1.) / 180;
}

// turns the coordinates of a plane by an angle of this cosine and sine
inline void turn(double& x, double& y, double c, double s)
{
  const double old = x;
  x = c * old - s * y;
  y = s * old + c * y;
}

// two unit vectors that are orthogonal to a unit vector and to each other
struct Cross_section
{
  explicit Cross_section(const Vec3& axis)
  {
    const double x = std::abs(axis[0]), y = std::abs(axis[1]), z = std::abs(axis[2]);
    const Vec3 least = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    u = unit(cross(axis, least));
    v = cross(axis, u);
  }
  double angle(const Vec3& a) const { return std::atan2(dot(a, v), dot(a, u)); }

  Vec3 u, v;
};

// A symmetric matrix, the sum of squares of vectors.
class Covariance
{
public:
  void add(const Vec3& a)
  {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m_[i][j] += a[i] * a[j];
  }
  // the eigenvector of the least eigenvalue, by Jacobi's rotations
  Vec3 least_direction() const
  {
    Matrix a = m_, v = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < 30; ++sweep) {
      const double off = std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]);
      if (!(off > 1e-18 * (std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2])))) break;
      rotate(a, v, 0, 1);
      rotate(a, v, 0, 2);
      rotate(a, v, 1, 2);
    }
    int k = 0;
    for (int i = 1; i < 3; ++i)
      if (a[i][i] < a[k][k]) k = i;
    return unit({v[0][k], v[1][k], v[2][k]});
  }

private:
  using Matrix = std::array<std::array<double, 3>, 3>;

  static void rotate(Matrix& a, Matrix& v, int p, int q)
  {
    if (a[p][q] == 0) return;
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::hypot(theta, 1.));
    const double c = 1 / std::hypot(t, 1.), s = t * c;
    for (int k = 0; k < 3; ++k) turn(a[k][p], a[k][q], c, s);
    for (int k = 0; k < 3; ++k) turn(a[p][k], a[q][k], c, s);
    for (int k = 0; k < 3; ++k) turn(v[k][p], v[k][q], c, s);
  }
  Matrix m_{};
};

// Linear least squares of few unknowns: rows are taken up one by one by Givens rotations, so that nothing is squared and
// only a triangle is kept. Unknowns that the rows do not determine are left at zero.
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
      for (int j = i + 1; j < n_; ++j) turn(r_[i][j], row[j], c, -s);
      turn(right_[i], right, c, -s);
    }
  }

  Row solve() const
  {
    Row x{};
    for (int i = n_ - 1; i >= 0; --i) {
      double sum = right_[i], scale = 0;
      for (int j = i + 1; j < n_; ++j) sum -= r_[i][j] * x[j];
      for (int j = 0; j <= i; ++j) scale += r_[j][i] * r_[j][i];
      if (std::abs(r_[i][i]) > 1e-12 * std::sqrt(scale)) x[i] = sum / r_[i][i];
    }
    return x;
  }

private:
  int n_;
  std::array<Row, most> r_{};
  Row right_{};
};

} // namespace CGAL::PN_subdivision_3::internal::recognition

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_LINEAR_ALGEBRA_H
