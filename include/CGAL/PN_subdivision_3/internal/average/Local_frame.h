// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_LOCAL_FRAME_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_LOCAL_FRAME_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class FT>
using Pair = std::array<FT, 2>;

// divides a vector by its length; zero stays zero
template <class FT>
void normalize(Coordinates<FT, 3>& v)
{
  const FT length = square_root_of<FT>(dot<FT, 3>(v, v));
  if (length > FT(0))
    for (FT& x : v) x /= length;
}

// A point with a unit normal and two unit vectors perpendicular to it, right-handed. In the frame a
// point is (u, z), and a normal (-g, 1) but for its length.
template <class FT>
class Local_frame
{
public:
  using Vector = Coordinates<FT, 3>;

  Local_frame(const Vector& origin, const Vector& normal)
    : origin_(origin)
    , normal_(normal)
  {
    const auto smaller = [](const FT& a, const FT& b) {
      return absolute_value(a) < absolute_value(b);
    };
    const auto smallest = std::min_element(normal.begin(), normal.end(), smaller);
    Vector axis{};
    axis[static_cast<std::size_t>(smallest - normal.begin())] = FT(1);
    e1_ = cross<FT>(axis, normal);
    normalize(e1_);
    e2_ = cross<FT>(normal, e1_);
  }

  const Vector& origin() const { return origin_; }
  const Vector& normal() const { return normal_; }
  const Vector& e1() const { return e1_; }
  const Vector& e2() const { return e2_; }

  Pair<FT> u(const Vector& p) const
  {
    const Vector d = difference(p);
    return {dot<FT, 3>(d, e1_), dot<FT, 3>(d, e2_)};
  }
  FT z(const Vector& p) const { return dot<FT, 3>(difference(p), normal_); }

  // The slope of the plane perpendicular to n, bounded for normals that are not on the side of the
  // frame's; zero for no normal.
  Pair<FT> slope(const Vector& n) const
  {
    const FT c = -1 / (std::max)(dot<FT, 3>(n, normal_), FT(1) / FT(1024));
    return {c * dot<FT, 3>(n, e1_), c * dot<FT, 3>(n, e2_)};
  }

private:
  Vector difference(const Vector& p) const
  {
    return {p[0] - origin_[0], p[1] - origin_[1], p[2] - origin_[2]};
  }

  Vector origin_, normal_, e1_, e2_;
};

// the x with m x = b; NaN if m is singular but for rounding
template <class FT>
Pair<FT> solve(const std::array<Pair<FT>, 2>& m, const Pair<FT>& b)
{
  const FT det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const FT size = m[0][0] * m[0][0] + m[0][1] * m[0][1] + m[1][0] * m[1][0] + m[1][1] * m[1][1];
  if (!(absolute_value(det) > 64 * machine_epsilon<FT>() * size)) {
    const FT nan(std::numeric_limits<double>::quiet_NaN());
    return {nan, nan};
  }
  return {(b[0] * m[1][1] - b[1] * m[0][1]) / det, (m[0][0] * b[1] - m[1][0] * b[0]) / det};
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_LOCAL_FRAME_H
