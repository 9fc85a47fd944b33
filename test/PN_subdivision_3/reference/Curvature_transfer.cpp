// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Curvature_transfer.h"

#include "Complex_matrix.h"
#include "modified_CatmullClark.h"
#include "modified_Loop.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace reference {
namespace {

using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

// The left eigenvectors of a ring matrix: of 1, of lambda, and of the quadratic eigenvalues.
class Left_eigenvectors
{
public:
  Left_eigenvectors(const Matrix& plain, int valence, int groups)
    : plain_(plain)
    , n_(valence)
    , groups_(groups)
  {
    limit = left(0, 0).real();
    limit /= limit.sum();
    tangent = left(1, 0);
    add(left(0, 1), 1);
    if (groups == 2)
      add(n_ == 3 ? left(1, 1) : left(2, 0), 2);
    else if (n_ > 3)
      add(left(2, 0), n_ == 4 ? 1 : 2);
  }

  Row limit;
  Complex_vector tangent;
  std::vector<Row> quadratic;

private:
  // that of the (rank + 1)-th largest eigenvalue of a frequency
  Complex_vector left(int frequency, int rank) const
  {
    const Eigen::Index size = frequency == 0 ? 1 + groups_ : groups_;
    Complex_matrix waves = Complex_matrix::Zero(plain_.rows(), size);
    if (frequency == 0) waves(0, 0) = 1;
    for (int g = 0; g < groups_; ++g)
      for (int d = 0; d < n_; ++d)
        waves(1 + g * n_ + d, size - groups_ + g) = std::polar(
          1 / std::sqrt(Real(n_)), 2 * std::acos(Real(-1)) * Real(frequency * d) / Real(n_));
    const Complex_matrix block = waves.adjoint() * plain_.cast<Complex>() * waves;
    const Eigen::ComplexEigenSolver<Complex_matrix> solver(Complex_matrix(block.transpose()));
    std::vector<Eigen::Index> order;
    for (Eigen::Index i = 0; i < size; ++i) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
      return std::abs(solver.eigenvalues()[a]) > std::abs(solver.eigenvalues()[b]);
    });
    const Complex_vector in_block = solver.eigenvectors().col(order[std::size_t(rank)]);
    Complex_vector all = waves.conjugate() * in_block;
    Eigen::Index largest = 0;
    all.cwiseAbs().maxCoeff(&largest);
    all /= all[largest]; // and its phase is fixed
    return all;
  }

  void add(const Complex_vector& v, int parts)
  {
    quadratic.push_back(v.real());
    if (parts == 2) quadratic.push_back(v.imag());
  }

  const Matrix& plain_;
  int n_, groups_;
};

// The ring is a list of vertices: the vertex, its neighbors, and among quads those between them.
void transfer_curvature(const Left_eigenvectors& left, const std::vector<int>& ring, Values& values)
{
  Values in_ring;
  for (int v : ring) {
    in_ring.points.push_back(values.points[std::size_t(v)]);
    in_ring.normals.push_back(values.normals[std::size_t(v)]);
  }
  const Point_normal limit = pn_rule(left.limit, left.limit, in_ring);
  const Vector& n = limit.normal;
  Real largest = 0;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    if (in_ring.normals[j].dot(n) < Real(1) / 2 || n.norm() < Real(1) / 2) return;
    largest = (std::max)(largest, in_ring.points[j].cwiseAbs().maxCoeff());
  }
  // any frame will do
  const Vector some = std::abs(n[0]) < 0.6L ? Vector(1, 0, 0) : Vector(0, 1, 0);
  const Vector e1 = (some - some.dot(n) * n).normalized(), e2 = n.cross(e1);
  const auto size = Eigen::Index(ring.size());
  Eigen::Matrix<Real, Eigen::Dynamic, 2> u(size, 2);
  Row w(size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const Vector d = in_ring.points[std::size_t(j)] - limit.point,
                 s = in_ring.normals[std::size_t(j)] + n;
    u.row(j) << d.dot(e1), d.dot(e2);
    w[j] = s.dot(d) / s.dot(n);
  }
  const auto of = [&](const auto& f, const auto& x) {
    Real sum = 0;
    for (Eigen::Index j = 0; j < size; ++j) sum += f[j] * x[j];
    return sum;
  };
  Eigen::Matrix<Real, 2, 2> tangents;
  Eigen::Matrix<Real, 2, 1> heights;
  for (int part = 0; part < 2; ++part) {
    const Column t = part == 0 ? Column(left.tangent.real()) : Column(left.tangent.imag());
    tangents.row(part) << of(t, u.col(0)), of(t, u.col(1));
    heights[part] = of(t, w);
  }
  const Eigen::Matrix<Real, 2, 1> a = tangents.inverse() * heights;
  for (Eigen::Index j = 0; j < size; ++j) w[j] -= u.row(j).dot(a);

  const auto rows = Eigen::Index(left.quadratic.size());
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> forms(rows, 3);
  Column rest(rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Row& l = left.quadratic[std::size_t(k)];
    rest[k] = of(l, w);
    forms(k, 0) = of(l, u.col(0).cwiseProduct(u.col(0)).eval()) / 2;
    forms(k, 1) = of(l, u.col(1).cwiseProduct(u.col(1)).eval()) / 2;
    forms(k, 2) = of(l, u.col(0).cwiseProduct(u.col(1)).eval()) / std::sqrt(Real(2));
  }
  if (rest.cwiseAbs().maxCoeff() <= 64 * std::numeric_limits<double>::epsilon() * largest) return;
  Eigen::JacobiSVD<decltype(forms)> svd(forms, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(1e-8L);
  const Column q = svd.solve(rest);
  Eigen::Matrix<Real, 2, 2> form;
  form << q[0], q[2] / std::sqrt(Real(2)), q[2] / std::sqrt(Real(2)), q[1];
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Vector& old = in_ring.normals[j];
    const Eigen::Matrix<Real, 2, 1> slope(-old.dot(e1) / old.dot(n), -old.dot(e2) / old.dot(n)),
      g = slope + form * u.row(Eigen::Index(j)).transpose() / 2;
    values.normals[std::size_t(ring[j])] = (n - g[0] * e1 - g[1] * e2).normalized();
  }
}

} // namespace

void transfer_curvature(const Face_list& mesh, bool quads, Values& values)
{
  static std::map<std::pair<bool, int>, Left_eigenvectors> known;
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    if (!is_separated(mesh, v, quads ? 4 : 6, quads ? 4 : 3)) continue;
    const std::vector<int> neighbors = mesh.ring(v);
    const int n = int(neighbors.size());
    std::vector<int> ring{v};
    for (int u : neighbors) ring.push_back(int(edge_point(mesh, v, u)));
    if (quads)
      for (int u : neighbors) ring.push_back(int(face_point(mesh, mesh.face(v, u))));
    auto found = known.find({quads, n});
    if (found == known.end())
      found = known
                .emplace(
                  std::make_pair(quads, n),
                  Left_eigenvectors(quads ? catmull_clark_ring(n) : loop_ring(n), n, quads ? 2 : 1))
                .first;
    transfer_curvature(found->second, ring, values);
  }
}

} // namespace reference
