// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The matrix that maps the 1-ring of an extraordinary vertex to the next one, with other
// eigenvalues: by a discrete Fourier transform and numerical eigenvectors of its blocks.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_TUNED_RING_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_TUNED_RING_H

#include "Quadrisection.h"

#include <Eigen/Eigenvalues>

#include <complex>

namespace reference {

using Complex = std::complex<Real>;
using Complex_matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using Complex_vector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

class Tuned_ring
{
public:
  // `plain` acts on the vertex and `groups` rings of `valence` vertices each; the pair of
  // eigenvalues lambda becomes `new_lambda`, or stays if this is 0. With a cap of 0, which stands for
  // 1/2, the quadratic ones (of frequency 0 the second, of 2 the first; of groups of 3 instead the
  // second of frequency 1) become the square of lambda.
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

// Whether v is extraordinary, its faces have the degree, and they have no other extraordinary
// corner.
inline bool is_separated(const Face_list& mesh, int v, int regular_valence, std::size_t degree)
{
  const auto is_extraordinary = [&](int u) {
    return mesh.is_interior_of_valence_other_than(regular_valence, u);
  };
  const std::vector<int> ring = mesh.ring(v);
  if (ring.size() < 3 || !is_extraordinary(v)) return false;
  for (int u : ring) {
    const Face& face = mesh.faces()[std::size_t(mesh.face(v, u))];
    if (face.size() != degree) return false;
    for (int corner : face)
      if (corner != v && is_extraordinary(corner)) return false;
  }
  return true;
}

// The row `weights` over the vertices `ring`.
inline Row spread(const Face_list& mesh, const std::vector<int>& ring, const Row& weights)
{
  Row row = mesh.zero();
  for (std::size_t i = 0; i < ring.size(); ++i) row[ring[i]] += weights[Eigen::Index(i)];
  return row;
}

// The index of the new vertex of the edge ab.
inline std::size_t edge_point(const Face_list& mesh, int a, int b)
{
  for (std::size_t e = 0; e < mesh.edges().size(); ++e)
    if (mesh.edges()[e] == Edge(a, b) || mesh.edges()[e] == Edge(b, a))
      return std::size_t(mesh.number_of_vertices()) + e;
  throw std::logic_error("reference: no such edge");
}
inline std::size_t face_point(const Face_list& mesh, int f)
{
  return std::size_t(mesh.number_of_vertices()) + mesh.edges().size() + std::size_t(f);
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_TUNED_RING_H
