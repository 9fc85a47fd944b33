// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_RING_LIMIT_FUNCTIONALS_H
#define CGAL_PN_FITTING_3_INTERNAL_RING_LIMIT_FUNCTIONALS_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_eigenvectors.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The PN average of a row for fixed normals, a linear map of the points. Its blocks are
//   B_j = a_j (1 + n r_j^T),  r_j = w (v_j - v),  v_j = chi_j (n_j + n) / (W d_j),  v = sum a_j v_j
// with n, w, chi_j, d_j and W of PN_average; W = 1 if nothing fades. Their sum is 1.
template <int dimension>
class PN_row_blocks
{
public:
  using Vector = Eigen_vector<dimension>;
  using Value = Point_normal<double, dimension>;

  // The row over old values, whose normals are read, and the value that the row gives, whose normal and roundness are
  // read.
  template <class Entry, class Values>
  void assign(const Entry* begin, const Entry* end, const Values& old, const Value& value)
  {
    const auto size = static_cast<std::size_t>(end - begin);
    normal_ = to_eigen<dimension>(value.normal);
    r_.assign(size, Vector::Zero());
    if (size == 1 || PN_average<double, dimension>::is_zero(value.normal)) return;
    double faded_weight = 0;
    bool faded = false;
    for (std::size_t j = 0; j < size; ++j) {
      if (begin[j].weight == 0) continue;
      const Vector sum = to_eigen<dimension>(old[begin[j].vertex].normal) + normal_;
      const double d = sum.dot(normal_);
      double chi = 1;
      if (d < fade_begin<double>()) {
        faded = true;
        chi = fade(d);
      }
      if (chi == 0) continue;
      faded_weight += begin[j].weight * chi;
      r_[j] = chi / d * sum;
    }
    if (faded) {
      const double scale = faded_weight < 1. / 64 ? 0. : 1 / faded_weight;
      for (Vector& r : r_) r *= scale;
    }
    Vector mean = Vector::Zero();
    for (std::size_t j = 0; j < size; ++j) mean += begin[j].weight * r_[j];
    for (Vector& r : r_) r = value.roundness * (r - mean);
  }

  const Vector& normal() const { return normal_; }
  const Vector& direction(std::size_t j) const { return r_[j]; }

private:
  Vector normal_ = Vector::Zero();
  std::vector<Vector> r_;
};

// What is done to the rings of a kind in every round, in double.
struct Ring_averages
{
  using Row = Ring_row<double>;

  Ring_matrix<double> rows_of_points, rows_of_normals;
  Row limit, normal_limit;
  std::vector<std::vector<double>> tangents; // over all places; none if there is no tangent plane
  double error_factor = 1, error_ratio = 0;  // see Ring_rules

  std::size_t size() const { return rows_of_points.size(); }
};

// The limit of a ring and the tangents there, for fixed normals as linear functions of the points of
// the ring: found after some rounds of the ring alone, and pulled back to its points by the transposed
// blocks of the PN averages.
//
// Each place has a block of `rows` rows: the rows of the limit point, then, if there are tangents,
// the rows of the vectors t_a = sum T_aj [(1 - N N^T)(p_j - o) + N (n_j + N).(p_j - o) / ((n_j + N).N)], whatever the
// roundness: with any multiple of the difference from p_j - o these vectors tend to the tangents.
template <int dimension, int tangents>
class Ring_limit_functionals
{
public:
  using Value = Point_normal<double, dimension>;
  using Vector = Eigen_vector<dimension>;
  using Average = PN_average<double, dimension>;
  static constexpr int rows = dimension * (1 + tangents);
  using Block = Eigen::Matrix<double, rows, dimension>;

  // Refines the ring until the limit is estimated to be known to the tolerance; `ring` is best given
  // relative to its center. Blocks are only made if they are wanted.
  void run(const Ring_averages& rule, const std::vector<Value>& ring,
           const Limit_precision& precision)
  {
    rule_ = &rule;
    if (levels_.empty()) levels_.resize(1);
    levels_[0] = ring;
    error_ = 0;
    limit_ = limit_at(0);
    double last_step = 0;
    const unsigned max_depth = is_exact_at_once() ? 0 : precision.max_depth;
    depth_ = 0;
    while (depth_ < max_depth) {
      const Value last = limit_;
      refine(++depth_);
      limit_ = limit_at(depth_);
      const double step =
        (to_eigen<dimension>(limit_.point) - to_eigen<dimension>(last.point)).norm();
      error_ = limit_error(rule.error_factor, rule.error_ratio, step, last_step);
      if (error_ <= precision.tolerance && depth_ >= precision.min_depth) break;
    }
    if (!precision.with_blocks) return;
    set_functionals();
    for (unsigned d = depth_; d-- > 0;) pull_back(d);
    if constexpr (tangents > 0)
      if (!rule.tangents.empty()) remove_limit_from_tangents();
  }

  const Value& limit() const { return limit_; }
  double error() const { return error_; }
  // the ring after the last round
  const std::vector<Value>& top() const { return levels_[depth_]; }
  unsigned depth() const { return depth_; }
  // the block of place p of the given ring
  const Block& block(std::size_t p) const { return blocks_[p]; }

private:
  using Square = Eigen::Matrix<double, dimension, dimension>;

  bool is_exact_at_once() const
  {
    return rule_->limit.size() == 1 ||
           std::all_of(levels_[0].begin(), levels_[0].end(),
                       [](const Value& v) { return Average::is_zero(v.normal); });
  }

  Value average(const Ring_averages::Row& row, const Ring_averages::Row& normal_row,
                unsigned depth) const
  {
    const Value* old = levels_[depth].data();
    return average_(row.data(), row.data() + row.size(), normal_row.data(),
                    normal_row.data() + normal_row.size(), old);
  }
  Value limit_at(unsigned depth) const { return average(rule_->limit, rule_->normal_limit, depth); }
  void refine(unsigned depth)
  {
    if (levels_.size() <= depth) levels_.resize(depth + 1);
    levels_[depth].resize(rule_->size());
    for (std::size_t p = 0; p < rule_->size(); ++p)
      levels_[depth][p] = average(rule_->rows_of_points[p], rule_->rows_of_normals[p], depth - 1);
  }

  // the functionals of the ring after the last round
  void set_functionals()
  {
    const std::vector<Value>& ring = levels_[depth_];
    blocks_.assign(rule_->size(), Block::Zero());
    const Ring_averages::Row& row = rule_->limit;
    row_blocks_.assign(row.data(), row.data() + row.size(), ring, limit_);
    const Vector& n = row_blocks_.normal();
    for (std::size_t j = 0; j < row.size(); ++j) {
      auto b = blocks_[row[j].vertex].template topRows<dimension>();
      b += row[j].weight * n * row_blocks_.direction(j).transpose();
      b.diagonal().array() += row[j].weight;
    }
    if constexpr (tangents > 0)
      if (!rule_->tangents.empty()) set_tangents();
  }

  // the tangents of the points themselves; remove_limit_from_tangents() makes them relative to o
  void set_tangents()
  {
    const std::vector<Value>& ring = levels_[depth_];
    const Vector n = to_eigen<dimension>(limit_.normal);
    const bool has_normal = !Average::is_zero(limit_.normal);
    for (int a = 0; a < tangents; ++a) {
      const std::vector<double>& mask = rule_->tangents[static_cast<std::size_t>(a)];
      for (std::size_t p = 0; p < ring.size(); ++p) {
        if (mask[p] == 0) continue;
        Square g = Square::Identity();
        if (has_normal) {
          const Vector s = to_eigen<dimension>(ring[p].normal) + n;
          g += n * (s / (std::max)(s.dot(n), 1. / 1024) - n).transpose();
        }
        blocks_[p].template middleRows<dimension>(dimension * (1 + a)) += mask[p] * g;
      }
    }
  }

  // Makes tangents relative to the limit point o, at the base: rounding at the top adds to them a part of
  // the limit point, which does not shrink on the way down as they do.
  void remove_limit_from_tangents()
  {
    for (int a = 0; a < tangents; ++a) {
      Square sum = Square::Zero();
      for (const Block& b : blocks_) sum += b.template middleRows<dimension>(dimension * (1 + a));
      for (Block& b : blocks_)
        b.template middleRows<dimension>(dimension * (1 + a)) -=
          sum * b.template topRows<dimension>();
    }
  }

  // from the ring at depth + 1 to the ring at depth
  void pull_back(unsigned depth)
  {
    next_.swap(blocks_);
    blocks_.assign(rule_->size(), Block::Zero());
    for (std::size_t p = 0; p < rule_->size(); ++p) {
      const Ring_averages::Row& row = rule_->rows_of_points[p];
      row_blocks_.assign(row.data(), row.data() + row.size(), levels_[depth],
                         levels_[depth + 1][p]);
      const Eigen::Matrix<double, rows, 1> x = next_[p] * row_blocks_.normal();
      for (std::size_t j = 0; j < row.size(); ++j)
        blocks_[row[j].vertex] +=
          row[j].weight * (next_[p] + x * row_blocks_.direction(j).transpose());
    }
  }

  Average average_;
  const Ring_averages* rule_ = nullptr;
  std::vector<std::vector<Value>> levels_;
  std::vector<Block> blocks_, next_;
  PN_row_blocks<dimension> row_blocks_;
  Value limit_{};
  double error_ = 0;
  unsigned depth_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_RING_LIMIT_FUNCTIONALS_H
