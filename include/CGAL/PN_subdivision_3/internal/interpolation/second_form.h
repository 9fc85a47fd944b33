// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_SECOND_FORM_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_SECOND_FORM_H

#include <CGAL/PN_subdivision_3/internal/curvature/Regular_jet.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/PN_row_blocks.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The second fundamental form of a jet as a symmetric map in space, zero along the normal; positive where
// the surface bends towards the normal of its frame. Zero if the jet is degenerate.
inline Eigen::Matrix3d second_form(const Surface_jet<double>& jet)
{
  const Eigen::Vector3d e1 = to_eigen<3>(jet.frame.e1()), e2 = to_eigen<3>(jet.frame.e2()),
                        e3 = to_eigen<3>(jet.frame.normal());
  Eigen::Matrix<double, 3, 2> x;
  x.col(0) = jet.u[0].a * e1 + jet.u[1].a * e2 + jet.z.a * e3;
  x.col(1) = jet.u[0].b * e1 + jet.u[1].b * e2 + jet.z.b * e3;
  Eigen::Vector3d n = x.col(0).cross(x.col(1));
  if (n.dot(e3) < 0) n = -n;
  n.normalize();
  const auto second = [&](double u, double v, double z) { return n.dot(u * e1 + v * e2 + z * e3); };
  Eigen::Matrix2d form;
  form(0, 0) = second(jet.u[0].aa, jet.u[1].aa, jet.z.aa);
  form(0, 1) = form(1, 0) = second(jet.u[0].ab, jet.u[1].ab, jet.z.ab);
  form(1, 1) = second(jet.u[0].bb, jet.u[1].bb, jet.z.bb);
  const Eigen::Matrix2d inverse = (x.transpose() * x).inverse();
  const Eigen::Matrix3d result = x * inverse * form * inverse * x.transpose();
  return result.allFinite() ? result : Eigen::Matrix3d(Eigen::Matrix3d::Zero());
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_SECOND_FORM_H
