// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_AREA_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_AREA_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Differences of points in double. Where squares of the size of the mesh would leave the range of
// double, all is scaled by a power of two.
template <class FT, class Point_of>
class Scaled_differences
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  Scaled_differences(const Level_connectivity& level, const Point_of& point)
    : point_(point)
  {
    constexpr double most = 0x1p200;
    double largest = 0;
    for (Index v = 1; v < level.number_of_vertices(); ++v)
      largest = (std::max)(largest, largest_coordinate((*this)(v, 0)));
    if (std::isfinite(largest) && largest > 0 && !(largest < most && largest > 1 / most))
      exponent_ = -std::ilogb(largest);
  }

  Vector operator()(Index v, Index origin) const
  {
    using T = Wide_number<FT>;
    const auto &p = point_(v), &q = point_(origin);
    Vector d = to_double_3<T>({T(p[0]) - T(q[0]), T(p[1]) - T(q[1]), T(p[2]) - T(q[2])});
    if (exponent_ != 0)
      for (double& x : d) x = std::ldexp(x, exponent_);
    return d;
  }

  // of differences to a point, at most of a size, by the rounding of the coordinates
  double rounding(Index origin, double size) const
  {
    constexpr double of_double = std::numeric_limits<double>::epsilon();
    if constexpr (is_exact_v<FT>)
      return of_double * size;
    else {
      const auto epsilon = static_cast<double>(CGAL::to_double(machine_epsilon<FT>()));
      double coordinate = largest_coordinate(to_double_3<FT>(point_(origin)));
      if (exponent_ != 0) coordinate = std::ldexp(coordinate, exponent_);
      return (std::max)(epsilon * (coordinate + size), of_double * size);
    }
  }

private:
  const Point_of& point_;
  int exponent_ = 0;
};

// The sum of the area vectors of the faces of a sector.
struct Area_sum
{
  using Vector = Coordinates<double, 3>;

  void add(const Vector& of_face, double rounding_of_face)
  {
    for (int c = 0; c < 3; ++c) area[c] += of_face[c];
    rounding += rounding_of_face;
  }
  // zero if rounding could have made it
  Vector unit() const
  {
    const double size = quick_length(area);
    if (!(size > rounding) || !std::isfinite(size)) return {0, 0, 0};
    return quotient(area, size);
  }

  Vector area{0, 0, 0};
  double rounding = 0;
};

// into sum_of(s) of all sectors s
template <class FT, class Point_of, class Sectors, class Sum_of>
void add_areas(const Level_connectivity& level, const Sectors& sectors,
               const Scaled_differences<FT, Point_of>& difference, const Sum_of& sum_of)
{
  using Index = Level_connectivity::Index;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    const Index first = level.halfedge_of_face(f), origin = level.target(first);
    Index h = level.next(first);
    Area_sum::Vector area{0, 0, 0}, before = difference(level.target(h), origin);
    double size = largest_coordinate(before);
    for (h = level.next(h); h != first; h = level.next(h)) {
      const auto d = difference(level.target(h), origin);
      add_multiple<double, 3>(area, 1, cross(before, d));
      size = (std::max)(size, largest_coordinate(d));
      before = d;
    }
    const double rounding = 16 * size * difference.rounding(origin, size) +
                            3 * vanishing_tolerance<FT>() * largest_coordinate(area);
    do {
      sum_of(sectors.at_target(h)).add(area, rounding);
      h = level.next(h);
    } while (h != first);
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_AREA_NORMALS_H
