// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Tuned_ring.h"

#include "Complex_matrix.h"

#include <Eigen/Eigenvalues>

namespace reference {
namespace {

class Tuned_ring
{
public:
  Tuned_ring(const Matrix& plain, int valence, int groups, Real cap, Real new_lambda)
    : basis_(Complex_matrix::Zero(plain.rows(), plain.rows()))
    , matrix_(Complex_matrix::Zero(plain.rows(), plain.rows()))
  {
    basis_(0, 0) = 1;
    for (int k = 0; k < valence; ++k)
      for (int g = 0; g < groups; ++g)
        for (int d = 0; d < valence; ++d)
          basis_(1 + g * valence + d, column(k, g, groups)) = std::polar(
            1 / std::sqrt(Real(valence)), 2 * std::acos(Real(-1)) * Real(k * d) / Real(valence));
    const Complex_matrix transformed = basis_.adjoint() * plain.cast<Complex>() * basis_;
    const auto block_of = [&](int k) -> Complex_matrix {
      return k == 0 ? transformed.topLeftCorner(1 + groups, 1 + groups)
                    : transformed.block(column(k, 0, groups), column(k, 0, groups), groups, groups);
    };
    lambda_ = new_lambda > 0 ? new_lambda : greatest(block_of(1));
    const Real square = cap == 0 ? lambda_ * lambda_ : 0;
    bound_ = (cap == 0 ? Real(0.5) : cap) * lambda_ * lambda_;
    matrix_.topLeftCorner(1 + groups, 1 + groups) = with_greatest(block_of(0), 1, square);
    for (int k = 1; k < valence; ++k) {
      const bool is_dominant = k == 1 || k == valence - 1, is_second = k == 2 || k == valence - 2;
      matrix_.block(column(k, 0, groups), column(k, 0, groups), groups, groups) =
        is_dominant ? with_greatest(block_of(k), lambda_, valence == 3 && groups == 2 ? square : 0)
        : is_second && square > 0 ? with_greatest(block_of(k), square)
                                  : capped(block_of(k));
    }
  }

  Matrix matrix() const { return (basis_ * matrix_ * basis_.adjoint()).real(); }

private:
  static int column(int k, int g, int groups) { return 1 + k * groups + g; }

  static Eigen::Index greatest_of(const Complex_vector& values)
  {
    Eigen::Index i = 0;
    values.cwiseAbs().maxCoeff(&i);
    return i;
  }
  static Real greatest(const Complex_matrix& block)
  {
    const Complex_vector values = block.eigenvalues();
    return values[greatest_of(values)].real();
  }

  Complex capped(Complex x) const { return std::abs(x) > bound_ ? x * (bound_ / std::abs(x)) : x; }

  // The block with all eigenvalues capped, but the greatest one is replaced by `replacement`, and the
  // next one by `second`, if these are not 0.
  Complex_matrix with_greatest(const Complex_matrix& block, Real replacement, Real second = 0) const
  {
    const Eigen::ComplexEigenSolver<Complex_matrix> solver(block);
    Complex_vector values = solver.eigenvalues();
    const Eigen::Index greatest = greatest_of(values);
    Complex_vector others = values;
    others[greatest] = 0;
    const Eigen::Index next = greatest_of(others);
    for (Complex& x : values) x = capped(x);
    if (second > 0) values[next] = second;
    if (replacement > 0) values[greatest] = replacement;
    return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().inverse();
  }
  Complex_matrix capped(const Complex_matrix& block) const
  {
    const Complex_matrix multiple =
      block(0, 0) * Complex_matrix::Identity(block.rows(), block.cols());
    if ((block - multiple).cwiseAbs().maxCoeff() > 1e-16L) return with_greatest(block, 0);
    return capped(block(0, 0)) * Complex_matrix::Identity(block.rows(), block.cols());
  }

  Complex_matrix basis_, matrix_;
  Real lambda_ = 0, bound_ = 0;
};

} // namespace

Matrix tuned_ring(const Matrix& plain, int valence, int groups, Real cap, Real new_lambda)
{
  return Tuned_ring(plain, valence, groups, cap, new_lambda).matrix();
}

} // namespace reference
