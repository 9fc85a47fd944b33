// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXACT_CYLINDER_3_H
#define CGAL_PN_SUBDIVISION_3_EXACT_CYLINDER_3_H

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Reproduction

A circular cylinder: the points at a given distance from a line.

\tparam Kernel a model of `Kernel`
*/
template <class Kernel>
class Cylinder_3
{
public:
  /// the number type.
  using FT = typename Kernel::FT;
  /// the type of the axis.
  using Line_3 = typename Kernel::Line_3;

  /// the cylinder of radius R about the axis, given R<sup>2</sup>.
  Cylinder_3(const Line_3& axis, const FT& squared_radius)
    : axis_(axis)
    , squared_radius_(squared_radius)
  {}

  /// the axis.
  const Line_3& axis() const { return axis_; }
  /// the squared radius.
  const FT& squared_radius() const { return squared_radius_; }

private:
  Line_3 axis_;
  FT squared_radius_;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_EXACT_CYLINDER_3_H
