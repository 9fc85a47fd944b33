// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_PRESCRIPTION_H
#define CGAL_PN_FITTING_3_INTERNAL_PRESCRIPTION_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
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

// Control points for prescribed limit points and surface normals, with the control normals as they are:
// limit points and tangents are linear in the control points, so that one system of conditions is
// solved, together with the smoothest change.
template <int dimension>
class Prescription
{
public:
  using Functionals = Surface_limits::Functionals;

  // rings: how far from the vertices control points may move
  Prescription(const Level_connectivity& level, const Interpolation_data<dimension>& data,
               Surface_limits& source, std::vector<Prescribed_vertex> prescribed, unsigned rings)
    : data_(data)
    , source_(source)
    , prescribed_(std::move(prescribed))
    , vertices_(vertices_of(prescribed_))
    , correction_(level, vertices_, rings)
  {}

  Interpolation_result<3> operator()()
  {
    Interpolation_result<3> result;
    result.normals = data_.normals;
    result.points = data_.points;
    result.report.tolerance = data_.tolerance;
    meet(result.points, result.normals, result.report);
    return result;
  }

  // Brings the points to what is prescribed, if they are not there, with these control normals; returns
  // by how many tolerances they still miss it.
  double meet(Vectors<3>& points, const Vectors<3>& normals, Limit_interpolation& report)
  {
    double best = evaluate(points, normals);
    // with the functionals that are right for the data, then for the result
    for (unsigned k = 0; k < 3 && best > 1 && report.steps < data_.max_steps; ++k) {
      if (!correction_.set_conditions(conditions())) break;
      ++report.steps;
      Vectors<3> next = points;
      // what the first solution leaves is due to rounding
      for (unsigned refinement = 0; refinement < 3; ++refinement)
        if (!correction_.add_to(next, defects(next))) break;
      const double now = evaluate(next, normals);
      if (!(now < best)) break;
      best = now;
      points = std::move(next);
    }
    evaluate(points, normals);
    note_evaluation(functionals_, report);
    report.residual = point_residual(points);
    report.normal_residual = normal_residual(points);
    return best;
  }

private:
  using Vector = Eigen_vector<3>;
  using Index = Level_connectivity::Index;
  using Condition = typename Smooth_correction<dimension>::Condition;

  static constexpr double normal_tolerance = 1e-12; // in radians
  static constexpr unsigned most_rounds = 100;      // of normals

  static std::vector<Index> vertices_of(const std::vector<Prescribed_vertex>& prescribed)
  {
    std::vector<Index> vertices;
    vertices.reserve(prescribed.size());
    for (const Prescribed_vertex& p : prescribed) vertices.push_back(p.vertex);
    return vertices;
  }

  // Surface normals converge slowly, and there are few of these vertices.
  Limit_precision precision() const
  {
    Limit_precision p = data_.precision();
    p.tangents = normal_tolerance / 10;
    p.max_depth = (std::max)(p.max_depth, most_rounds);
    return p;
  }

  double evaluate(const Vectors<3>& points, const Vectors<3>& normals)
  {
    functionals_ = source_(to_values<3>(points, normals, data_), vertices_, precision());
    // the two are of different kinds: by how much they miss what is asked
    return point_residual(points) / (std::max)(data_.tolerance, 1e-300) +
           normal_residual(points) / normal_tolerance;
  }

  double point_residual(const Vectors<3>& points) const
  {
    double largest = 0;
    for (std::size_t i = 0; i < prescribed_.size(); ++i)
      if (prescribed_[i].point)
        largest = (std::max)(
          largest,
          finite_or_infinite((*prescribed_[i].point - functionals_[i].limit(points)).norm()));
    return largest;
  }
  double normal_residual(const Vectors<3>& points) const
  {
    double largest = 0;
    for (std::size_t i = 0; i < prescribed_.size(); ++i)
      if (prescribed_[i].normal) {
        const Vector& m = *prescribed_[i].normal;
        const Vector nu = functionals_[i].surface_normal(points, m);
        largest =
          (std::max)(largest, finite_or_infinite(std::atan2(m.cross(nu).norm(), m.dot(nu))));
      }
    return largest;
  }

  // the condition on the vector x.p of the functional's rows [first, first + 3), times `row`; of length 1
  static Condition scaled(const Functionals& f, int first, const Vector& row, double& scale)
  {
    Condition c;
    double square = 0;
    for (const auto& e : f.entries) {
      c.emplace_back(e.vertex, e.block.template middleRows<3>(first).transpose() * row);
      square += c.back().second.squaredNorm();
    }
    scale = square > 0 ? 1 / std::sqrt(square) : 0;
    for (auto& entry : c) entry.second *= scale;
    return c;
  }

  std::vector<Condition> conditions()
  {
    std::vector<Condition> all;
    scales_.clear();
    for (std::size_t i = 0; i < prescribed_.size(); ++i) {
      if (prescribed_[i].point)
        for (int k = 0; k < 3; ++k)
          all.push_back(scaled(functionals_[i], 0, Vector::Unit(k), scales_.emplace_back()));
      if (prescribed_[i].normal)
        for (int a = 0; a < 2; ++a)
          all.push_back(
            scaled(functionals_[i], 3 * (1 + a), *prescribed_[i].normal, scales_.emplace_back()));
    }
    return all;
  }

  // what the conditions lack
  std::vector<double> defects(const Vectors<3>& points) const
  {
    std::vector<double> d;
    for (std::size_t i = 0; i < prescribed_.size(); ++i) {
      if (prescribed_[i].point) {
        const Vector x = *prescribed_[i].point - functionals_[i].limit(points);
        for (int k = 0; k < 3; ++k) d.push_back(scales_[d.size()] * x[k]);
      }
      if (prescribed_[i].normal)
        for (int a = 0; a < 2; ++a)
          d.push_back(-scales_[d.size()] *
                      prescribed_[i].normal->dot(functionals_[i].tangent(a, points)));
    }
    return d;
  }

  const Interpolation_data<3>& data_;
  Surface_limits& source_;
  const std::vector<Prescribed_vertex> prescribed_;
  const std::vector<Index> vertices_;
  Smooth_correction<dimension> correction_;
  std::vector<Functionals> functionals_;
  std::vector<double> scales_; // of the conditions
};

// the first vertex of a prescribed normal where the scheme has no tangent plane
inline std::optional<Level_connectivity::Index>
vertex_without_tangents(const std::vector<Prescribed_vertex>& prescribed,
                        const Interpolation_data<3>& data, Surface_limits& source)
{
  std::vector<Level_connectivity::Index> vertices;
  for (const Prescribed_vertex& p : prescribed)
    if (p.normal) vertices.push_back(p.vertex);
  Limit_precision precision = data.precision();
  precision.max_depth = 0;
  precision.with_blocks = false;
  const auto functionals =
    source(to_values<3>(data.points, data.normals, data), vertices, precision);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!functionals[i].has_tangents) return vertices[i];
  return std::nullopt;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_PRESCRIPTION_H
