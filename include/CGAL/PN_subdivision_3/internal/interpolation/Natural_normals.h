// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_NATURAL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_NATURAL_NORMALS_H

#include <CGAL/PN_subdivision_3/internal/interpolation/Interpolation_data.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Slide_interpolation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Normals M that are those of the surface that slides along them: the surface that interpolates with M
// tells its normals at the points P, and they become the next M. The normal at P is that at the limit
// point L, carried from L to P by the second fundamental form.
class Natural_normals
{
public:
  // the data, the normals of which are the first ones
  Natural_normals(Interpolation_data<3>& data, Surface_limits& source)
    : data_(data)
    , source_(source)
  {}

  void operator()()
  {
    double last_change = 0;
    for (unsigned k = 0; k < most_rounds; ++k) {
      const auto result = Slide_interpolation<3, 2>(data_, source_)();
      if (result.report.steps == 0) return; // they are exact
      Vectors<3> next = next_normals(result.points);
      double change = 0;
      for (const auto v : data_.vertices)
        change = (std::max)(change, (next[v] - data_.normals[v]).norm());
      if (k > 0 && !(change < 0.8 * last_change)) return;
      data_.normals = std::move(next);
      if (change <= 1e-5) return;
      last_change = change;
    }
  }

private:
  static constexpr unsigned most_rounds = 10;

  Vectors<3> next_normals(const Vectors<3>& points)
  {
    Limit_precision precision = data_.precision();
    precision.second_forms = 2e-5;
    const auto functionals =
      source_(to_values<3>(points, data_.normals, data_), data_.vertices, precision);
    Vectors<3> next = data_.normals;
    for (std::size_t i = 0; i < functionals.size(); ++i) {
      const auto v = data_.vertices[i];
      const auto& f = functionals[i];
      if (data_.is_at_border[v] != 0 || !f.has_tangents) continue;
      const Eigen_vector<3> nu = f.surface_normal(points, data_.normals[v]);
      const Eigen_vector<3> n = nu - f.second_form * (data_.points[v] - f.limit(points));
      const double length = n.norm();
      if (!(length > 0.1) || !std::isfinite(length) || n.dot(data_.normals[v]) <= 0) continue;
      next[v] = n / length;
    }
    return next;
  }

  Interpolation_data<3>& data_;
  Surface_limits& source_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_NATURAL_NORMALS_H
