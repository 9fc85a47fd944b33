// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CURVATURE_FIT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CURVATURE_FIT_H

#include <CGAL/PN_subdivision_3/internal/average/number_functions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The derivatives of the unit normal in an orthonormal basis of eigenvectors.
struct Principal_curvatures
{
  double minimal = 0, maximal = 0, gaussian = 0, mean = 0;
  Eigen::Vector3d minimal_direction{0, 0, 0}, maximal_direction{0, 0, 0};
  bool is_estimated = false;
};

// What is known of a graph z = f(u) at u = 0; z is along the last column of the frame.
struct Graph_derivatives
{
  Eigen::Matrix3d frame;
  Eigen::Vector2d gradient;
  Eigen::Matrix2d hessian;
};

// The unit vector at half the angle of (x, y), which has the given length.
inline Eigen::Vector2d half_angle(double x, double y, double length)
{
  if (!(length > 0)) return {1, 0};
  const double larger = std::sqrt((1 + std::abs(x) / length) / 2);
  const double smaller = std::abs(y) / (2 * length * larger);
  return x < 0 ? Eigen::Vector2d(smaller, std::copysign(larger, y))
               : Eigen::Vector2d(larger, std::copysign(smaller, y));
}

// The curvatures of the graph, whose lengths have been divided by `scale`. The shape operator is that of
// the derivative of the normal (-grad f, 1)/W, so that a sphere with outward normals has positive curvatures.
inline Principal_curvatures principal_curvatures(const Graph_derivatives& f, double scale)
{
  const double a = f.gradient[0], b = f.gradient[1], w = std::sqrt(1 + a * a + b * b);
  // the columns of `basis` are the projections of an orthonormal basis of the tangent plane
  const double l = std::sqrt(1 + a * a);
  Eigen::Matrix2d basis;
  basis << 1 / l, -a * b / (l * w), 0, l / w;
  const Eigen::Matrix2d shape = -basis.transpose() * f.hessian * basis / w;

  Principal_curvatures c;
  const double difference = (shape(0, 0) - shape(1, 1)) / 2;
  const double size = (std::max)(std::abs(difference), std::abs(shape(0, 1)));
  const double x = size > 0 ? difference / size : 0, y = size > 0 ? shape(0, 1) / size : 0;
  const double length = std::sqrt(x * x + y * y), radius = size * length / scale;
  c.mean = (shape(0, 0) + shape(1, 1)) / 2 / scale;
  c.minimal = c.mean - radius;
  c.maximal = c.mean + radius;
  c.gaussian =
    shape(0, 0) / scale * (shape(1, 1) / scale) - shape(0, 1) / scale * (shape(0, 1) / scale);
  const Eigen::Vector2d along = half_angle(x, y, length), across(along[1], -along[0]);
  const auto in_space = [&](const Eigen::Vector2d& t) -> Eigen::Vector3d {
    const Eigen::Vector2d u = basis * t;
    return (f.frame * Eigen::Vector3d(u[0], u[1], f.gradient.dot(u))).normalized();
  };
  c.minimal_direction = in_space(across);
  c.maximal_direction = in_space(along);
  c.is_estimated = std::isfinite(c.gaussian) && std::isfinite(c.mean) && std::isfinite(radius);
  return c.is_estimated ? c : Principal_curvatures();
}

// A point of the neighborhood, relative to the vertex, and its normal, zero if it has none to fit.
struct Curvature_sample
{
  Eigen::Vector3d offset;
  Eigen::Vector3d normal;
  double weight;
};

// The graph z = f(u), f(0) = 0, a polynomial of degree 2 or 3 over the plane normal to a given unit
// vector, fitted to points and normals by least squares. Unknown are the derivatives of f at 0.
class Curvature_fit
{
  static constexpr int max_unknowns = 9;
  static constexpr double root_2 = 1.41421356237309505, root_3 = 1.73205080756887729;
  using Matrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, max_unknowns>;
  using Row = Eigen::Matrix<double, 1, max_unknowns>;
  using Square =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_unknowns, max_unknowns>;
  using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_unknowns, 1>;

public:
  // The Frobenius norm of the pseudoinverse, beyond which the samples do not determine the fit. Two
  // rings of an even mesh have 5 in the interior and hundreds at the border, where three have 30.
  static constexpr double max_condition = 50;

  static int number_of_unknowns(int degree) { return degree == 3 ? 9 : 5; }

  // whether the samples determine all derivatives
  bool fit(const std::vector<Curvature_sample>& samples, const Eigen::Vector3d& normal, int degree)
  {
    const Eigen::Index unknowns = number_of_unknowns(degree);
    set_frame(normal);
    if (!set_units(samples)) return false;
    matrix_.resize(Eigen::Index(3 * samples.size()), unknowns);
    right_side_.resize(matrix_.rows());
    rows_ = 0;
    for (const Curvature_sample& s : samples) add(s);
    if (rows_ < unknowns) return false;
    matrix_.conservativeResize(rows_, unknowns);
    return solve();
  }

  // The fitted surface at the vertex.
  Principal_curvatures curvatures(double scale) const
  {
    return principal_curvatures(graph_, scale);
  }

private:
  void set_frame(const Eigen::Vector3d& normal)
  {
    graph_.frame.col(2) = normal;
    graph_.frame.col(0) = normal.unitOrthogonal();
    graph_.frame.col(1) = normal.cross(graph_.frame.col(0));
  }

  // Units in which the second moments of the samples are 1 make the fit independent of affine maps
  // of the plane: quads may be long or skew.
  bool set_units(const std::vector<Curvature_sample>& samples)
  {
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (const Curvature_sample& s : samples) {
      const Eigen::Vector2d u = graph_.frame.leftCols<2>().transpose() * s.offset;
      moments += u * u.transpose() / double(samples.size());
    }
    constexpr double on_a_line = 1e-12;
    const double determinant = moments.determinant();
    if (!(determinant > on_a_line * moments.trace() * moments.trace())) return false;
    units_ = Eigen::LLT<Eigen::Matrix2d>(moments).matrixL();
    return true;
  }

  // With n = (-nu, n_w) the normal equations are nu = grad f, to third order. z is corrected by the
  // term of fourth order that makes both linear equations exact on spheres and circular cylinders:
  // there z = nu.u / (1 + n_w), the height of the arc in the average of points and normals.
  void add(const Curvature_sample& s)
  {
    const Eigen::Vector3d p = graph_.frame.transpose() * s.offset;
    const Eigen::Vector3d n = graph_.frame.transpose() * s.normal;
    const Eigen::Vector2d u = units_.triangularView<Eigen::Lower>().solve(p.head<2>());
    const double x = u[0], y = u[1], weight = s.weight / (1 + u.squaredNorm() / 2);
    double z = p[2];
    if (n[2] > 0) {
      const Eigen::Vector2d slope = -units_.transpose() * n.head<2>();
      z += slope.dot(u) * (0.5 - 1 / (1 + n[2]));
      Row dx, dy;
      dx << 1, 0, x, root_2 * y / 2, 0, x * x / 2, x * y / root_3, y * y / (2 * root_3), 0;
      dy << 0, 1, 0, root_2 * x / 2, y, 0, x * x / (2 * root_3), x * y / root_3, y * y / 2;
      add_row(weight, dx, slope[0]);
      add_row(weight, dy, slope[1]);
    }
    Row value;
    value << x, y, x * x / 2, x * y / root_2, y * y / 2, x * x * x / 6, x * x * y / (2 * root_3),
      x * y * y / (2 * root_3), y * y * y / 6;
    if (x != 0 || y != 0) add_row(weight, value, z);
  }

  void add_row(double weight, const Row& row, double right_side)
  {
    matrix_.row(rows_) = weight * row.head(matrix_.cols());
    right_side_[rows_] = weight * right_side;
    ++rows_;
  }

  // The columns of each degree get a mean square of 1. That, the coefficients of binomials in front
  // of the unknowns and Frobenius norms make the condition independent of the choice of the frame.
  bool solve()
  {
    Unknowns scales(matrix_.cols());
    for (Eigen::Index first = 0, n = 2; first < matrix_.cols(); first += n, ++n) {
      const double size = matrix_.middleCols(first, n).norm() / std::sqrt(double(n));
      if (!(size > 0)) return false;
      matrix_.middleCols(first, n) /= size;
      scales.segment(first, n).setConstant(1 / size);
    }
    qr_.compute(matrix_);
    const Square inverse = qr_.matrixQR()
                             .topRows(matrix_.cols())
                             .template triangularView<Eigen::Upper>()
                             .solve(Square::Identity(matrix_.cols(), matrix_.cols()));
    if (!(inverse.norm() <= max_condition)) return false;
    const Unknowns x = qr_.solve(right_side_.head(rows_)).cwiseProduct(scales);
    Eigen::Matrix2d second;
    second << x[2], x[3] / root_2, x[3] / root_2, x[4];
    const Eigen::Matrix2d inverse_units = units_.inverse();
    graph_.gradient = inverse_units.transpose() * x.head<2>();
    graph_.hessian = inverse_units.transpose() * second * inverse_units;
    return true;
  }

  Graph_derivatives graph_;
  Eigen::Matrix2d units_; // lower triangular
  Matrix matrix_;
  Eigen::VectorXd right_side_;
  Eigen::Index rows_ = 0;
  Eigen::HouseholderQR<Matrix> qr_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CURVATURE_FIT_H
