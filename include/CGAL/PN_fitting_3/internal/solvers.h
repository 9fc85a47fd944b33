// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_SOLVERS_H
#define CGAL_PN_FITTING_3_INTERNAL_SOLVERS_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

using Row_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// A factor of the matrix M of the linear limit points. Rows of border vertices involve border vertices
// only and are solved first. What is left is symmetric but for a factor a row with most schemes and
// meshes, and then positive definite; otherwise it is factored as it is.
template <class Real = double>
class Limit_matrix
{
public:
  using Vector = Eigen::VectorXd;

  // is_first: the rows that involve each other only
  Limit_matrix(const Row_matrix& matrix, const std::vector<char>& is_first)
    : is_first_(is_first)
    , place_(is_first.size())
  {
    Eigen::Index n[2] = {0, 0};
    for (std::size_t i = 0; i < place_.size(); ++i) place_[i] = n[is_first[i] ? 0 : 1]++;
    split(matrix, n[0], n[1]);
    is_regular_ = factor();
    if (is_regular_) is_regular_ = is_well_conditioned(matrix);
  }

  // whether the matrix is far from being singular
  bool is_regular() const { return is_regular_; }

  // \pre is_regular()
  Vector solve(const Vector& b) const
  {
    Vector first(first_.rows()), rest(rest_.rows());
    for (std::size_t i = 0; i < place_.size(); ++i)
      (is_first_[i] ? first : rest)[place_[i]] = b[static_cast<Eigen::Index>(i)];
    if (first.size() > 0) first = first_factor_.solve(first).eval();
    if (rest.size() > 0) {
      if (first.size() > 0) rest -= coupling_ * first;
      if (is_symmetric_) rest.array() *= scale_.array();
      rest = is_symmetric_ ? Vector(cholesky_.solve(rest)) : Vector(rest_factor_.solve(rest));
    }
    Vector x(b.size());
    for (std::size_t i = 0; i < place_.size(); ++i)
      x[static_cast<Eigen::Index>(i)] = (is_first_[i] ? first : rest)[place_[i]];
    return x;
  }

private:
  using Column_matrix = Eigen::SparseMatrix<double>;
  using Triplets = std::vector<Eigen::Triplet<double>>;

  void split(const Row_matrix& matrix, Eigen::Index firsts, Eigen::Index rests)
  {
    Triplets first, rest, coupling;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const bool is_first = is_first_[static_cast<std::size_t>(i)] != 0;
      for (Row_matrix::InnerIterator e(matrix, i); e; ++e) {
        const auto j = static_cast<std::size_t>(e.col());
        const bool to_first = is_first_[j] != 0;
        Triplets& part = is_first ? first : to_first ? coupling : rest;
        part.emplace_back(place_[static_cast<std::size_t>(i)], place_[j], e.value());
      }
    }
    first_.resize(firsts, firsts);
    first_.setFromTriplets(first.begin(), first.end());
    coupling_.resize(rests, firsts);
    coupling_.setFromTriplets(coupling.begin(), coupling.end());
    rest_.resize(rests, rests);
    rest_.setFromTriplets(rest.begin(), rest.end());
  }

  bool factor()
  {
    if (first_.rows() > 0) {
      first_factor_.compute(first_);
      // ComputationInfo() is Success, of which X11 has a macro
      if (first_factor_.info() != Eigen::ComputationInfo()) return false;
    }
    if (rest_.rows() == 0) return true;
    find_scale();
    if (is_symmetric_) {
      cholesky_.compute(scale_.asDiagonal() * rest_);
      if (cholesky_.info() == Eigen::ComputationInfo() && cholesky_.vectorD().minCoeff() > 0)
        return true;
      is_symmetric_ = false;
    }
    rest_factor_.compute(rest_);
    return rest_factor_.info() == Eigen::ComputationInfo();
  }

  // the factors d_i that make d_i m_ij symmetric, if there are any
  void find_scale()
  {
    const Row_matrix rows(rest_);
    scale_ = Vector::Zero(rows.rows());
    std::vector<Eigen::Index> found;
    is_symmetric_ = false;
    for (Eigen::Index start = 0; start < rows.rows(); ++start) {
      if (scale_[start] != 0) continue;
      scale_[start] = 1;
      found.assign(1, start);
      while (!found.empty()) {
        const Eigen::Index i = found.back();
        found.pop_back();
        for (Row_matrix::InnerIterator e(rows, i); e; ++e) {
          const double transposed = rows.coeff(e.col(), i);
          if (e.value() == 0 && transposed == 0) continue;
          const double scale = scale_[i] * e.value() / transposed;
          if (!(scale > 0) || !std::isfinite(scale)) return;
          double& other = scale_[e.col()];
          if (other == 0) {
            other = scale;
            found.push_back(e.col());
          } else if (std::abs(scale - other) > 1e-9 * other)
            return;
        }
      }
    }
    is_symmetric_ = true;
  }

  // found out by two steps of inverse iteration from a vector that has a part in every direction
  bool is_well_conditioned(const Row_matrix& matrix) const
  {
    if (matrix.rows() == 0) return true;
    Vector x(matrix.rows());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = std::sin(1. + static_cast<double>(i) * static_cast<double>(i % 1000 + 3));
    for (int k = 0; k < 2; ++k) {
      x /= x.norm();
      const Vector y = solve(x);
      if (!(y.norm() < 1e8)) return false; // also refuses NaN
      x = y;
    }
    return true;
  }

  std::vector<char> is_first_;
  std::vector<Eigen::Index> place_; // of a row in its part
  Column_matrix first_, coupling_, rest_;
  Vector scale_;
  bool is_symmetric_ = false, is_regular_ = false;
  Eigen::SparseLU<Column_matrix> first_factor_, rest_factor_;
  Eigen::SimplicialLDLT<Column_matrix> cholesky_;
};

// M for each of some coordinates, in the form that Eigen's iterative solvers ask of a preconditioner
template <class Real>
class Limit_preconditioner
{
public:
  void set(const Limit_matrix<Real>* matrix, Eigen::Index copies)
  {
    matrix_ = matrix;
    copies_ = copies;
  }
  template <class Matrix>
  Limit_preconditioner& compute(const Matrix&)
  {
    return *this;
  }
  Eigen::ComputationInfo info() const { return Eigen::ComputationInfo(); }

  // of values by rows: all copies of the first unknown, of the second, ...
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    using By_rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    if (copies_ == 1) return matrix_->solve(b);
    Eigen::VectorXd x(b.size());
    const Eigen::Map<const By_rows> from(b.data(), b.size() / copies_, copies_);
    Eigen::Map<By_rows> to(x.data(), b.size() / copies_, copies_);
    for (Eigen::Index c = 0; c < copies_; ++c) to.col(c) = matrix_->solve(from.col(c));
    return x;
  }

private:
  const Limit_matrix<Real>* matrix_ = nullptr;
  Eigen::Index copies_ = 1;
};

// Solves a x = b to a relative tolerance by iterations with M, `copies` times, as preconditioner; by a
// factor of a itself where M is singular or this fails. Empty if a is singular.
template <class Real>
Eigen::VectorXd solve_limit_system(const Row_matrix& a, const Eigen::VectorXd& b,
                                   const Limit_matrix<Real>& m, Eigen::Index copies,
                                   double tolerance)
{
  if (m.is_regular()) {
    Eigen::BiCGSTAB<Row_matrix, Limit_preconditioner<Real>> solver;
    solver.preconditioner().set(&m, copies);
    solver.setTolerance(tolerance);
    solver.setMaxIterations(60);
    solver.compute(a);
    Eigen::VectorXd x = solver.solve(b);
    if (solver.info() == Eigen::ComputationInfo() && x.allFinite()) return x;
  }
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factor;
  factor.compute(Eigen::SparseMatrix<double>(a));
  if (factor.info() != Eigen::ComputationInfo()) return {};
  Eigen::VectorXd x = factor.solve(b);
  if (!x.allFinite()) return {};
  return x;
}

// the factor of the matrix of the linear limit points
template <int dimension, class Functionals>
Limit_matrix<> make_limit_matrix(const Interpolation_data<dimension>& data,
                                 const std::vector<Functionals>& functionals,
                                 const std::vector<int>& unknowns)
{
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<char> is_at_border;
  for (std::size_t i = 0; i < functionals.size(); ++i) {
    is_at_border.push_back(data.is_at_border[data.vertices[i]]);
    for (const auto& e : functionals[i].entries)
      if (e.weight != 0 && unknowns[e.vertex] >= 0)
        entries.emplace_back(static_cast<int>(i), unknowns[e.vertex], e.weight);
  }
  const auto n = static_cast<Eigen::Index>(functionals.size());
  Row_matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Limit_matrix<>(matrix, is_at_border);
}

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

  // the vector to be tried after x, where r = r(x)
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

#endif // CGAL_PN_FITTING_3_INTERNAL_SOLVERS_H
