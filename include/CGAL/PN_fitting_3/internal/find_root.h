// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_FIND_ROOT_H
#define CGAL_PN_FITTING_3_INTERNAL_FIND_ROOT_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The values of some vertices, one vertex after the other.
template <int dimension>
Eigen::VectorXd gathered(const Vectors<dimension>& values,
                         const std::vector<std::uint32_t>& vertices)
{
  Eigen::VectorXd x(dimension * static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    x.segment<dimension>(dimension * static_cast<Eigen::Index>(i)) = values[vertices[i]];
  return x;
}

// puts them back
template <int dimension>
void put_gathered(const Eigen::VectorXd& x, const std::vector<std::uint32_t>& vertices,
                  Vectors<dimension>& values)
{
  for (std::size_t i = 0; i < vertices.size(); ++i)
    values[vertices[i]] = x.segment<dimension>(dimension * static_cast<Eigen::Index>(i));
}

// of the vectors that x has one after the other
template <int dimension>
double largest_length(const Eigen::VectorXd& x)
{
  double length = 0;
  for (Eigen::Index i = 0; i < x.size(); i += dimension)
    length = (std::max)(length, finite_or_infinite(x.segment<dimension>(i).norm()));
  return length;
}

// Steps towards r(x) = 0 where x + r(x) is nearer to the solution than x: this step, mixed with the last ones so that what is left of a
// linear r would be the least (D. G. Anderson, Iterative procedures for nonlinear integral equations, 1965). The changes of r by the last
// steps are kept as Q R, from which the oldest is taken by rotations.
class Anderson_iteration
{
public:
  using Vector = Eigen::VectorXd;

  explicit Anderson_iteration(std::size_t most_kept)
    : most_kept_(most_kept)
    , r_(Eigen::Index(most_kept), Eigen::Index(most_kept))
  {}

  // the vector to be tried after x, where r = r(x)
  Vector next(const Vector& x, const Vector& r)
  {
    if (last_x_.size() == x.size()) keep(x - last_x_, r - last_r_);
    last_x_ = x;
    last_r_ = r;
    Vector step = r;
    const Vector part = take_off_kept(step);
    const Vector c =
      r_.topLeftCorner(part.size(), part.size()).triangularView<Eigen::Upper>().solve(part);
    for (std::size_t j = 0; j < steps_.size(); ++j) step -= c[Eigen::Index(j)] * steps_[j];
    return step.allFinite() ? Vector(x + step) : Vector(x + r);
  }

private:
  // leaves what is orthogonal to Q; the rest as a combination of it
  Vector take_off_kept(Vector& v) const
  {
    Vector part(Eigen::Index(q_.size()));
    for (std::size_t j = 0; j < q_.size(); ++j) {
      part[Eigen::Index(j)] = q_[j].dot(v);
      v -= part[Eigen::Index(j)] * q_[j];
    }
    return part;
  }

  void keep(const Vector& step, Vector change)
  {
    if (q_.size() == most_kept_) drop_oldest();
    const double length = change.norm();
    Vector part = take_off_kept(change);
    part += take_off_kept(change); // what rounding has left
    const double height = change.norm();
    if (!(height > 1e-14 * length) || !std::isfinite(height)) return; // it depends on the others
    const auto n = Eigen::Index(q_.size());
    r_.col(n).head(n) = part;
    r_(n, n) = height;
    q_.emplace_back(change / height);
    steps_.push_back(step);
  }

  void drop_oldest()
  {
    const auto n = Eigen::Index(q_.size());
    for (Eigen::Index j = 1; j < n; ++j) {
      r_.col(j - 1).head(j + 1) = r_.col(j).head(j + 1);
      r_.col(j - 1).tail(n - j - 1).setZero();
    }
    for (Eigen::Index j = 0; j + 1 < n; ++j) {
      const double h = std::hypot(r_(j, j), r_(j + 1, j));
      const double c = r_(j, j) / h, s = r_(j + 1, j) / h;
      const auto rotate = [&](auto&& a, auto&& b) {
        const Vector old = a;
        a = c * old + s * b;
        b = c * b - s * old;
      };
      rotate(r_.row(j).head(n - 1).transpose(), r_.row(j + 1).head(n - 1).transpose());
      rotate(q_[std::size_t(j)], q_[std::size_t(j) + 1]);
    }
    q_.pop_back();
    steps_.pop_front();
  }

  const std::size_t most_kept_;
  Vector last_x_, last_r_;
  std::deque<Vector> steps_;
  std::vector<Vector> q_;
  Eigen::MatrixXd r_;
};

struct Root
{
  Eigen::VectorXd x;              // the best that was found
  double residual = 0, first = 0; // there, and where the search began
  unsigned steps = 0;
};

// Seeks r(x) = 0 from x. residual(x, r) sets r, and may bring x to where it is allowed; it returns the size of r, infinite where the search
// has to end. The search ends too after some steps that do not take a tenth off the least residual.
inline Root find_root(Eigen::VectorXd x,
                      Function_ref<double(Eigen::VectorXd&, Eigen::VectorXd&)> residual,
                      double tolerance, unsigned max_steps, unsigned most_without_gain = 8,
                      std::size_t most_kept = 20)
{
  Eigen::VectorXd r;
  Root root;
  root.first = root.residual = residual(x, r);
  root.x = x;
  Anderson_iteration iteration(most_kept);
  unsigned without_gain = 0;
  double now = root.residual;
  while (root.residual > tolerance && std::isfinite(now) && root.steps < max_steps &&
         without_gain < most_without_gain) {
    x = iteration.next(x, r);
    now = residual(x, r);
    ++root.steps;
    without_gain = now < 0.9 * root.residual ? 0 : without_gain + 1;
    if (!(now < root.residual)) continue;
    root.residual = now;
    root.x = x;
  }
  return root;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_FIND_ROOT_H
