// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_EXTRAORDINARY_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_TEST_EXTRAORDINARY_CHECKS_H

#include "../../examples/PN_limit_surface_3/Extraordinary_data.h"
#include "analysis/extraordinary_curvature.h"
#include "analysis/extraordinary_eigenvalues.h"

#include <gtest/gtest.h>

// What holds for plain and for modified schemes at a vertex of any valence.
namespace extraordinary_checks {

namespace data = extraordinary_data;
namespace PN = CGAL::PN_subdivision_3;

template <class Scheme>
using Zoom = PN::Extraordinary_vertex_zoom<std::decay_t<Scheme>>;

// Points and normals of a sphere stay on it at any depth.
template <class Scheme>
void check_sphere(const Scheme& scheme, data::Index valence)
{
  const Zoom<Scheme> zoom(scheme, valence);
  data::Values values = data::turned(data::sampled(zoom.net(), data::sphere));
  data::Vector origin{};
  for (int m = 0; m < 20; ++m) values = zoom.refined(values, origin);
  for (const auto& v : zoom.twice_refined(values)) {
    long double square = 0;
    for (std::size_t c = 0; c < 3; ++c)
      square += std::pow(static_cast<long double>(origin[c]) + v.point[c], 2);
    EXPECT_NEAR(double(std::sqrt(square) / data::sphere_radius), 1,
                8 * std::numeric_limits<double>::epsilon());
  }
}

// The limit normal of points and normals of a sphere, wherever on it, is that of the sphere: no slope is
// left over the plane perpendicular to it.
template <class Scheme>
void check_slope_on_sphere(const Scheme& scheme, data::Index valence)
{
  const Zoom<Scheme> zoom(scheme, valence);
  const data::Graph aside = [](double x, double y) { return data::sphere(x + .3, y - .2); };
  const auto limit = zoom.limit(data::turned(data::sampled(zoom.net(), aside)));
  EXPECT_NEAR(std::hypot(limit.slope[0], limit.slope[1]), 0, 1e-14);
}

// A linear round multiplies what a left eigenvector gives by its eigenvalue, whatever the data.
template <class Scheme>
void check_left_eigenvectors(const Scheme& scheme, data::Index valence)
{
  const auto twin = PN::linear(scheme);
  const Zoom<decltype(twin)> zoom(twin, valence);
  const PN::internal::Extraordinary_limit<double> mask(zoom.net());
  const data::Values values = data::rough(zoom.net(), data::cubic, 2);
  data::Vector origin{};
  const data::Values refined = zoom.refined(values, origin);
  const auto z = [](const data::Value& v) { return v.point[2]; };
  const double lambda = PN::extraordinary_eigenvalues(scheme, valence).subdominant;
  EXPECT_NEAR(zoom.limit(values).point[2], origin[2] + zoom.limit(refined).point[2], 1e-15);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(lambda * mask.tangent(values, z)[k], mask.tangent(refined, z)[k], 1e-15);
}

} // namespace extraordinary_checks

#endif // CGAL_PN_SUBDIVISION_3_TEST_EXTRAORDINARY_CHECKS_H
