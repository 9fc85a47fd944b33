// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_WINDOW_GEOMETRY_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_WINDOW_GEOMETRY_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// First and second order of a curve at the limit of a window, in double. In the frame of the limit control
// normal N points have a part u perpendicular to N and a height z over it; slopes of normals are g. With the roundness r and
// the point-normal height h, which is z - g.u / 2, the three u, w = z + r (h - z) and g are refined linearly but for terms of
// third order.
template <int dimension>
class Window_geometry
{
public:
  using Vector = Coordinates<double, dimension>;
  using Value = Point_normal<double, dimension>;

  // N is zero without control normals
  Window_geometry(const std::vector<Value>& window, const Value& limit, double roundness = 1)
    : roundness_(roundness)
    , normal_(limit.normal)
    , has_normal_(dot<double, dimension>(normal_, normal_) > 0.5)
  {
    for (const Value& v : window) {
      Vector u = v.point;
      add_multiple<double, dimension>(u, -1, limit.point);
      double w = 0;
      if (has_normal_) {
        const PN_height<double> h = pn_height<double, dimension>(v, limit.point, normal_);
        w = h.numerator / (std::max)(h.denominator, 1. / 1024);
        const auto z = dot<double, dimension>(u, normal_);
        if (roundness_ != 1) w = z + roundness_ * (w - z);
        add_multiple<double, dimension>(u, -z, normal_);
      }
      u_.push_back(u);
      w_.push_back(w);
    }
    if (has_normal_)
      for (const Value& v : window) {
        const auto height = dot<double, dimension>(v.normal, normal_);
        Vector g = normal_;
        for (std::size_t c = 0; c < dimension; ++c) g[c] -= v.normal[c] / height;
        g_.push_back(g);
      }
  }

  // the derivative with respect to the parameter
  Vector derivative(const std::vector<double>& first) const
  {
    Vector d = masked(first, u_);
    add_multiple<double, dimension>(d, masked(first, w_), normal_);
    return d;
  }

  // The curvature vector. `second` may be empty, and `normal_first` is the first derivative of the normals.
  // It is not finite where the derivative is zero or normals are turned by a right angle.
  Vector curvature_vector(const std::vector<double>& first, const std::vector<double>& normal_first,
                          const std::vector<double>& second) const
  {
    const Vector d = derivative(first);
    Vector dd{};
    double height = 0;
    if (!second.empty()) {
      dd = masked(second, u_);
      height = masked(second, w_);
    }
    if (has_normal_) {
      const Vector slope = masked(normal_first, g_), u = masked(first, u_);
      height += roundness_ * dot<double, dimension>(slope, u);
    }
    add_multiple<double, dimension>(dd, height, normal_);
    const auto square = dot<double, dimension>(d, d);
    add_multiple<double, dimension>(dd, -dot<double, dimension>(d, dd) / square, d);
    for (double& x : dd) x /= square;
    return dd;
  }

private:
  static Vector masked(const std::vector<double>& mask, const std::vector<Vector>& values)
  {
    Vector sum{};
    for (std::size_t j = 0; j < mask.size(); ++j)
      add_multiple<double, dimension>(sum, mask[j], values[j]);
    return sum;
  }
  static double masked(const std::vector<double>& mask, const std::vector<double>& values)
  {
    double sum = 0;
    for (std::size_t j = 0; j < mask.size(); ++j) sum += mask[j] * values[j];
    return sum;
  }

  double roundness_;
  Vector normal_;
  bool has_normal_;
  std::vector<Vector> u_, g_;
  std::vector<double> w_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_WINDOW_GEOMETRY_H
