// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_PROBE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_PROBE_H

#include <CGAL/PN_subdivision_3/internal/cgal_masks/Mask_normalization.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What a mask is told when it asks for the point of a vertex: the point, the normal read as a
// point, or the vertex's share (chi h, chi, 0) in the height over q along n.
template <class PointNormalMap>
class Mask_probe
{
public:
  using Vertex = typename boost::property_traits<PointNormalMap>::key_type;
  using Point_normal = typename boost::property_traits<PointNormalMap>::value_type;
  using Point = typename Point_normal::first_type;
  using Vector = typename Point_normal::second_type;
  using FT = typename Kernel_traits<Point>::Kernel::FT;

  explicit Mask_probe(const PointNormalMap& point_normals)
    : point_normals_(point_normals)
  {}

  void answer_points() { answer_ = Answer::points; }
  void answer_normals() { answer_ = Answer::normals; }
  void answer_heights(const Point& q, const Vector& n)
  {
    answer_ = Answer::heights;
    q_ = q;
    n_ = n;
    fading_ = false;
  }

  Point operator()(const Vertex& v) const
  {
    const Point_normal pn = get(point_normals_, v);
    if (answer_ == Answer::points) return pn.first;
    const Vector n = normalization_.control(pn.second);
    return answer_ == Answer::normals ? ORIGIN + n : height(pn.first, n);
  }

  // The new normal for the mask's sum of the normals, zero if it vanishes.
  Vector normal(const Vector& sum) const
  {
    if (normalization_.vanishes(sum)) return Vector(FT(0), FT(0), FT(0));
    return normalization_.unit(sum);
  }

  // The new height for the mask's sum of the heights.
  FT height(const Point& sum) const
  {
    if (!fading_) return sum.x();
    if (sum.y() < FT(1) / FT(64)) return FT(0);
    return sum.x() / sum.y();
  }

private:
  enum class Answer { points, normals, heights };

  // The fade is decided before the division by d, which may be zero.
  Point height(const Point& p, const Vector& n_p) const
  {
    const Vector s = n_p + n_;
    const FT d = s * n_;
    const FT chi = fade(d);
    if (chi != FT(1)) fading_ = true;
    if (chi == FT(0)) return Point(FT(0), FT(0), FT(0));
    return Point(chi * ((s * (p - q_)) / d), chi, FT(0));
  }

  static FT fade(const FT& d)
  {
    const FT begin = FT(1) / FT(1024);
    const FT end = FT(1) / FT(256);
    if (d >= end) return FT(1);
    if (d <= begin) return FT(0);
    const FT t = (d - begin) / (end - begin);
    return t * t * (FT(3) - FT(2) * t);
  }

  PointNormalMap point_normals_;
  Mask_normalization<Vector, FT> normalization_;
  Answer answer_ = Answer::points;
  Point q_ = ORIGIN;
  Vector n_ = NULL_VECTOR;
  mutable bool fading_ = false;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_PROBE_H
