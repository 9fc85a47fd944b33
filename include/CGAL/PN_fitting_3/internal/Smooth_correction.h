// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_SMOOTH_CORRECTION_H
#define CGAL_PN_FITTING_3_INTERNAL_SMOOTH_CORRECTION_H

#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Unknowns with few entries first, those with many at the end: of symmetric patterns. Eigen's SparseLU takes
// an order the other way round than Eigen's factors of symmetric matrices.
struct Degree_ordering
{
  using PermutationType = Eigen::AMDOrdering<int>::PermutationType;

  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& order) const
  {
    PermutationType inverse;
    Eigen::AMDOrdering<int>()(matrix, inverse);
    order = inverse.inverse();
  }
};

// The smallest smooth change d of control points, sum |U d|^2 + 1e-6 |d|^2 with the umbrella Laplacian
// U, that fulfils linear conditions on it. Vertices further than some rings of faces from all that have
// conditions stay. Conditions that contradict each other are met as well as they can be.
//
// A row of U at a vertex of large valence n would give the matrix n^2 entries. Its value is an unknown s instead,
// with the equations U d - s = 0 and, in place of U^T U d, U^T s: 2n entries.
template <int dimension>
class Smooth_correction
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Eigen_vector<3>;

  // sum of coefficient . d over the vertices
  using Condition = std::vector<std::pair<Index, Vector>>;

  Smooth_correction(const Level_connectivity& level, const std::vector<Index>& vertices,
                    unsigned rings)
    : level_(level)
    , place_(level.number_of_vertices(), -1)
  {
    find_free(vertices, rings);
    set_energy();
  }

  // Factors the system; whether it is regular.
  bool set_conditions(const std::vector<Condition>& conditions)
  {
    std::vector<Eigen::Triplet<double>> entries = energy_;
    const int n = number_of_unknowns();
    const auto m = static_cast<int>(conditions.size());
    for (int i = 0; i < m; ++i) {
      for (const auto& [v, c] : conditions[static_cast<std::size_t>(i)]) {
        if (place_[v] < 0) continue;
        for (int k = 0; k < 3; ++k) {
          entries.emplace_back(n + i, 3 * place_[v] + k, c[k]);
          entries.emplace_back(3 * place_[v] + k, n + i, c[k]);
        }
      }
      entries.emplace_back(n + i, n + i, -1e-13);
    }
    Matrix system(n + m, n + m);
    system.setFromTriplets(entries.begin(), entries.end());
    return sums_ == 0 ? is_factored(factor_, system) : is_factored(factor_with_sums_, system);
  }

  // Adds the change for which the conditions have these values. \pre set_conditions()
  bool add_to(Vectors<3>& points, const std::vector<double>& values) const
  {
    const Eigen::Index n = number_of_unknowns();
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) b[n + static_cast<Eigen::Index>(i)] = values[i];
    const Eigen::VectorXd x =
      sums_ == 0 ? factor_.solve(b).eval() : factor_with_sums_.solve(b).eval();
    if (!x.allFinite()) return false;
    for (std::size_t i = 0; i < free_.size(); ++i)
      points[free_[i]] += x.segment<3>(3 * static_cast<Eigen::Index>(i));
    return true;
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Umbrella = std::vector<std::pair<int, double>>; // a row of U
  static constexpr std::size_t longest_multiplied = 64;

  // without the multipliers of the conditions
  int number_of_unknowns() const { return 3 * (static_cast<int>(free_.size()) + sums_); }

  template <class Factor>
  static bool is_factored(Factor& factor, const Matrix& system)
  {
    factor.compute(system);
    // ComputationInfo() is Success, of which X11 has a macro
    return factor.info() == Eigen::ComputationInfo();
  }

  void find_free(const std::vector<Index>& vertices, unsigned rings)
  {
    std::vector<Index> front, next;
    const auto add = [&](Index v) {
      if (place_[v] >= 0) return;
      place_[v] = static_cast<int>(free_.size());
      free_.push_back(v);
      next.push_back(v);
    };
    for (const Index v : vertices) add(v);
    for (unsigned r = 0; r < rings && !next.empty(); ++r) {
      front.swap(next);
      next.clear();
      for (const Index v : front) for_each_in_faces(v, add);
    }
  }

  template <class Function>
  void for_each_in_faces(Index v, const Function& f) const
  {
    if (level_.is_isolated(v)) return;
    for_each_halfedge_to(level_, v, [&](Index h) {
      f(level_.source(h));
      if (!level_.is_border(h))
        for (Index g = level_.next(h); g != h; g = level_.next(g)) f(level_.target(g));
    });
  }

  // of each coordinate; entries for the same place are added up
  void set_energy()
  {
    std::vector<char> is_done(level_.number_of_vertices(), 0);
    Umbrella umbrella;
    const auto add_row = [&](Index v) {
      if (is_done[v] != 0 || level_.is_isolated(v)) return;
      is_done[v] = 1;
      umbrella.clear();
      if (place_[v] >= 0) umbrella.emplace_back(place_[v], 1.);
      const double share = 1. / level_.valence(v);
      level_.for_each_neighbor(level_.halfedge_of_vertex(v), [&](Index w) {
        if (place_[w] >= 0) umbrella.emplace_back(place_[w], -share);
      });
      if (umbrella.size() > longest_multiplied) return add_sum(umbrella);
      for (const auto& [i, x] : umbrella)
        for (const auto& [j, y] : umbrella)
          for (int k = 0; k < 3; ++k) energy_.emplace_back(3 * i + k, 3 * j + k, x * y);
    };
    for (const Index v : free_) {
      add_row(v);
      for_each_in_faces(v, add_row);
    }
    for (int i = 0; i < static_cast<int>(3 * free_.size()); ++i) energy_.emplace_back(i, i, 1e-6);
  }

  void add_sum(const Umbrella& umbrella)
  {
    const int first = number_of_unknowns();
    ++sums_;
    for (int k = 0; k < 3; ++k) {
      for (const auto& [i, x] : umbrella) {
        energy_.emplace_back(3 * i + k, first + k, x);
        energy_.emplace_back(first + k, 3 * i + k, x);
      }
      energy_.emplace_back(first + k, first + k, -1);
    }
  }

  const Level_connectivity& level_;
  std::vector<int> place_; // of a vertex among the free ones
  std::vector<Index> free_;
  std::vector<Eigen::Triplet<double>> energy_;
  int sums_ = 0; // three unknowns each
  Eigen::SparseLU<Matrix> factor_;
  Eigen::SparseLU<Matrix, Degree_ordering> factor_with_sums_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_SMOOTH_CORRECTION_H
