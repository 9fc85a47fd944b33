// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_FACE_PATCH_H
#define CGAL_PN_LIMIT_SURFACE_3_FACE_PATCH_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Jet.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3LimitSurface

A curved patch over a triangle or quadrilateral, of the points and surface normals at its corners alone. It is their
point-normal average `PN_average` with weights \f$ a_j(u,v) \f$. These are barycentric, \f$ 1-u-v, u, v \f$, in a
triangle, and bilinear, \f$ (1-u)(1-v), u(1-v), uv, (1-u)v \f$, in a quadrilateral:
\f[ q=\sum a_jp_j, \quad n=\frac{\sum a_jn_j}{|\sum a_jn_j|}, \quad p=q+\Bigl(\sum a_j\frac{(n_j+n)\cdot(p_j-q)}{1+n_j\cdot n}\Bigr)n. \f]
It is exact on spheres, and on circular cylinders, whatever the face is. With limit points and the normals of the
limit surface at the corners, as `subdivide_to_limit()` gives them, it stands for the limit surface between them. The
patches of two faces with a common edge meet along the edge without a gap, since it depends on its two ends only, but
their tangent planes differ a little. A renderer evaluates it in a shader, see \ref PN_subdivision_3_limit_surface.

All is computed in `double`.

\tparam GeomTraits a kernel

\sa `Limit_surface`
*/
template <class GeomTraits>
class Face_patch
{
public:
  /// a point.
  using Point_3 = typename GeomTraits::Point_3;
  /// a normal.
  using Vector_3 = typename GeomTraits::Vector_3;

  /*!
  takes the corners in the order of the face.
  \param points 3 or 4 points
  \param normals unit normals in the same order; a vector of zero means that there is none, and takes no part
  \throws std::invalid_argument if there are not 3 or 4 points, or not as many normals
  */
  template <class Points, class Normals>
  Face_patch(const Points& points, const Normals& normals)
  {
    const auto n = static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
    const auto m = static_cast<std::size_t>(std::distance(std::begin(normals), std::end(normals)));
    if ((n != 3 && n != 4) || n != m)
      throw std::invalid_argument("PN_subdivision_3: a patch has 3 or 4 corners with as many "
                                  "normals, not " +
                                  std::to_string(n) + " points and " + std::to_string(m) +
                                  " normals");
    corners_.resize(n);
    auto normal = std::begin(normals);
    std::size_t i = 0;
    for (const auto& p : points) {
      corners_[i].point = in_double(p);
      corners_[i++].normal = in_double(*normal++);
    }
  }

  /// 3 or 4.
  std::size_t number_of_corners() const { return corners_.size(); }

  /// the point with these parameters.
  Point_3 point(double u, double v) const
  {
    const internal::Jet_vector p = jets(u, v).point;
    return Point_3(p[0].value, p[1].value, p[2].value);
  }

  /// the unit normal of the patch, \f$ p_u\times p_v \f$; that of the average, \f$ n \f$, where the patch has none.
  Vector_3 normal(double u, double v) const
  {
    const std::array<double, 3> n = jets(u, v).unit_normal();
    return Vector_3(n[0], n[1], n[2]);
  }

  /// the average of the normals, \f$ n \f$, the cheaper normal for shading: on spheres and cylinders that of the patch, elsewhere close to it,
  /// and the same for both faces of an edge.
  Vector_3 average_normal(double u, double v) const
  {
    const internal::Jet_vector n = jets(u, v).normal;
    return Vector_3(n[0].value, n[1].value, n[2].value);
  }

private:
  template <class Point_or_vector>
  static std::array<double, 3> in_double(const Point_or_vector& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  internal::Jet_average jets(double u, double v) const
  {
    return internal::patch_average(corners_, u, v);
  }

  std::vector<internal::Jet_entry> corners_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_FACE_PATCH_H
