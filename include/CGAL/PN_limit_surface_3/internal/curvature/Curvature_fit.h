// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_FIT_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_FIT_H

#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>

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

// A point of the neighborhood, relative to the vertex, and its normal, zero if it has none.
struct Curvature_sample
{
  Eigen::Vector3d offset;
  Eigen::Vector3d normal;
  double weight;
};

// The second derivatives of the graph z = f(u), f(0) = 0, over the plane normal to a given unit vector, by least squares. To
// points a polynomial of degree 2 or 3 is fitted; unknown are its derivatives at 0. Where there are normals, the vector is that of
// the vertex, the gradient is 0, and every normal tells of the second derivatives and, with degree 3, of the third ones.
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
  using Samples = std::vector<Curvature_sample>;

public:
  // The Frobenius norm of the pseudoinverse, beyond which the samples do not determine the fit. Two
  // rings of an even mesh have 5 in the interior and hundreds at the border, where three have 30.
  static constexpr double max_condition = 50;

  // whether the points determine all derivatives
  bool fit(const Samples& samples, const Eigen::Vector3d& normal, int degree)
  {
    if (!begin(samples, normal, degree == 3 ? 9 : 5)) return false;
    for (const Curvature_sample& s : samples) add_point(s);
    if (!solve(2)) return false;
    set_derivatives(solution_.head<2>(), solution_.segment<3>(2));
    return true;
  }

  // whether the normals do, and the points of samples without one
  bool fit_normals(const Samples& samples, const Eigen::Vector3d& normal, int degree)
  {
    if (!begin(samples, normal, degree == 3 ? 7 : 3)) return false;
    for (const Curvature_sample& s : samples) add_normal(s);
    if (!solve(3)) return false;
    set_derivatives({0, 0}, -solution_.head<3>());
    return true;
  }

  // The fitted surface at the vertex.
  Principal_curvatures curvatures(double scale) const
  {
    return principal_curvatures(graph_, scale);
  }

private:
  bool begin(const Samples& samples, const Eigen::Vector3d& normal, Eigen::Index unknowns)
  {
    graph_.frame.col(2) = normal;
    graph_.frame.col(0) = normal.unitOrthogonal();
    graph_.frame.col(1) = normal.cross(graph_.frame.col(0));
    if (!set_units(samples)) return false;
    matrix_.resize(Eigen::Index(3 * samples.size()), unknowns);
    right_side_.resize(matrix_.rows());
    rows_ = 0;
    return true;
  }

  // Units in which the second moments of the samples are 1 make the fit independent of affine maps
  // of the plane: quads may be long or skew.
  bool set_units(const Samples& samples)
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

  Eigen::Vector2d in_units(const Eigen::Vector2d& u) const
  {
    return units_.triangularView<Eigen::Lower>().solve(u);
  }
  static double weight_of(const Curvature_sample& s, const Eigen::Vector2d& u)
  {
    return s.weight / (1 + u.squaredNorm() / 2);
  }

  void add_point(const Curvature_sample& s)
  {
    const Eigen::Vector3d p = graph_.frame.transpose() * s.offset;
    const Eigen::Vector2d u = in_units(p.head<2>());
    const double x = u[0], y = u[1];
    Row value;
    value << x, y, x * x / 2, x * y / root_2, y * y / 2, x * x * x / 6, x * x * y / (2 * root_3),
      x * y * y / (2 * root_3), y * y * y / 6;
    if (x != 0 || y != 0) add_row(weight_of(s, u), value, p[2]);
  }

  // Let m be half-way between the normals of frame and sample. What is perpendicular to it, as the change n of the normals and a
  // part of the offset are, is turned into the plane of the frame, where n and u then are; h is the rest of the offset. In the
  // direction t of u, |u| = r, with the shape operator S and its derivative C,
  //   n.t / r = S(t,t) + r/2 C(t,t,t) + r^2 E,   12 h / r^2 = r C(t,t,t) + 3 r^2 E,
  // and E, h and C vanish on spheres and circular cylinders, of any triangulation. From both E is eliminated. What tells of C
  // alone, and of S across t, where E is another one, has a small weight: it is for rings that do not tell otherwise.
  void add_normal(const Curvature_sample& s)
  {
    constexpr double part = 0.3; // less suits exact normals, more those that are estimated
    const Eigen::Vector3d p = graph_.frame.transpose() * s.offset;
    const bool has_normal = !s.normal.isZero(0), is_cubic = matrix_.cols() > 3;
    Eigen::Vector3d m(0, 0, 1);
    if (has_normal) m = (m + graph_.frame.transpose() * s.normal).normalized();
    const double h = p.dot(m);
    const Eigen::Vector2d u = in_units(p.head<2>() - m.head<2>() * ((h + p[2]) / (1 + m[2])));
    const double r = u.norm(), weight = weight_of(s, u);
    if (!(r > 0)) return;
    const double x = u[0] / r, y = u[1] / r;
    Row along, third, across;
    along << x * x, root_2 * x * y, y * y, 0, 0, 0, 0, 0, 0;
    third << 0, 0, 0, x * x * x, root_3 * x * x * y, root_3 * x * y * y, y * y * y, 0, 0;
    if (!has_normal) return add_row(weight, along + r / 3 * third, -2 * h / (r * r));
    const Eigen::Vector2d n = 2 * units_.transpose() * m.head<2>() / r;
    const double of_third = h / (r * r);
    add_row(weight, along + r / 6 * third, n[0] * x + n[1] * y - (is_cubic ? 4 : 6) * of_third);
    across << -x * y, (x * x - y * y) / root_2, x * y, -r / 2 * x * x * y,
      r / 2 * (x * x - 2 * y * y) * x / root_3, r / 2 * (2 * x * x - y * y) * y / root_3,
      r / 2 * x * y * y, 0, 0;
    add_row(part * weight, across, n[1] * x - n[0] * y);
    if (is_cubic) add_row(part * weight, r / 2 * third, 6 * of_third);
  }

  void add_row(double weight, const Row& row, double right_side)
  {
    matrix_.row(rows_) = weight * row.head(matrix_.cols());
    right_side_[rows_] = weight * right_side;
    ++rows_;
  }

  // The columns of each degree, of which the lowest has so many, get a mean square of 1. That, the coefficients of binomials
  // in front of the unknowns and Frobenius norms make the condition independent of the choice of the frame.
  bool solve(Eigen::Index of_lowest)
  {
    if (rows_ < matrix_.cols()) return false;
    matrix_.conservativeResize(rows_, matrix_.cols());
    Unknowns scales(matrix_.cols());
    for (Eigen::Index first = 0, n = of_lowest; first < matrix_.cols(); first += n, ++n) {
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
    solution_ = qr_.solve(right_side_.head(rows_)).cwiseProduct(scales);
    return true;
  }

  void set_derivatives(const Eigen::Vector2d& first, const Eigen::Vector3d& second)
  {
    Eigen::Matrix2d hessian;
    hessian << second[0], second[1] / root_2, second[1] / root_2, second[2];
    const Eigen::Matrix2d inverse_units = units_.inverse();
    graph_.gradient = inverse_units.transpose() * first;
    graph_.hessian = inverse_units.transpose() * hessian * inverse_units;
  }

  Graph_derivatives graph_;
  Eigen::Matrix2d units_; // lower triangular
  Matrix matrix_;
  Eigen::VectorXd right_side_;
  Unknowns solution_;
  Eigen::Index rows_ = 0;
  Eigen::HouseholderQR<Matrix> qr_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_FIT_H
