// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_ANDERSON_ITERATION_H
#define CGAL_PN_FITTING_3_INTERNAL_ANDERSON_ITERATION_H

#include <Eigen/Dense>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Solves r(x) = 0 where x + r(x) is nearer to the solution than x: this step, mixed with the last ones so that what is left of a
// linear r would be the least (D. G. Anderson, Iterative procedures for nonlinear integral equations, 1965).
template <class Real = double>
class Anderson_iteration
{
public:
  using Vector = Eigen::VectorXd;

  // Old differences are longer by far. If they are scaled all count alike, otherwise what is short beside them, and tells little of an
  // r that is rough, is left out.
  Anderson_iteration(std::size_t most_kept, bool scales)
    : most_kept_(most_kept)
    , scales_(scales)
  {}

  // what is to be tried after x, of which r is r(x)
  Vector next(const Vector& x, const Vector& r)
  {
    Vector result = x + r;
    if (const auto columns = static_cast<Eigen::Index>(last_.size()); columns > 0) {
      Eigen::MatrixXd dx(x.size(), columns), dr(x.size(), columns);
      for (Eigen::Index k = 0; k < columns; ++k) {
        dx.col(k) = x - last_[static_cast<std::size_t>(k)].first;
        dr.col(k) = r - last_[static_cast<std::size_t>(k)].second;
        const double length = scales_ ? dr.col(k).norm() : 1;
        dx.col(k) /= length;
        dr.col(k) /= length;
      }
      const Vector mixed = result - (dx + dr) * dr.colPivHouseholderQr().solve(r);
      if (mixed.allFinite()) result = mixed;
    }
    last_.emplace_back(x, r);
    if (last_.size() > most_kept_) last_.erase(last_.begin());
    return result;
  }

private:
  const std::size_t most_kept_;
  const bool scales_;
  std::vector<std::pair<Vector, Vector>> last_; // x and r(x)
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_ANDERSON_ITERATION_H
