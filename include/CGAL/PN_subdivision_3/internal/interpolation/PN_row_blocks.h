// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_PN_ROW_BLOCKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_PN_ROW_BLOCKS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <int dimension>
using Eigen_vector = Eigen::Matrix<double, dimension, 1>;
template <int dimension>
using Vectors = std::vector<Eigen_vector<dimension>>;

template <int dimension>
Eigen_vector<dimension> to_eigen(const Coordinates<double, dimension>& c)
{
  return Eigen::Map<const Eigen_vector<dimension>>(c.data());
}
template <int dimension>
Coordinates<double, dimension> to_coordinates(const Eigen_vector<dimension>& v)
{
  Coordinates<double, dimension> c;
  for (int i = 0; i < dimension; ++i) c[static_cast<std::size_t>(i)] = v[i];
  return c;
}

// The PN average of a row as what it is for fixed normals, a linear map of the points: its blocks are
//   B_j = a_j (1 + n r_j^T),  r_j = v_j - v,  v_j = chi_j (n_j + n) / (W d_j),  v = sum a_j v_j
// with n, chi_j, d_j and W of PN_average; W = 1 if nothing fades. Their sum is 1.
template <int dimension>
class PN_row_blocks
{
public:
  using Vector = Eigen_vector<dimension>;
  using Value = Point_normal<double, dimension>;

  // The row over old values, of which the normals are read, and the normal that it gives.
  template <class Entry, class Values>
  void assign(const Entry* begin, const Entry* end, const Values& old,
              const Coordinates<double, dimension>& normal)
  {
    const auto size = static_cast<std::size_t>(end - begin);
    normal_ = to_eigen<dimension>(normal);
    r_.assign(size, Vector::Zero());
    if (size == 1 || PN_average<double, dimension>::is_zero(normal)) return;
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
    for (Vector& r : r_) r -= mean;
  }

  const Vector& normal() const { return normal_; }
  const Vector& direction(std::size_t j) const { return r_[j]; }

private:
  Vector normal_ = Vector::Zero();
  std::vector<Vector> r_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_PN_ROW_BLOCKS_H
