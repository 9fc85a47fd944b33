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
#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The sums of the area vectors of the faces of sectors, in double. Where squares of the size of the
// mesh would leave the range of double, all is scaled by a power of two.
template <class FT, class Sectors, class Point_of>
class Area_normals
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  Area_normals(const Level_connectivity& level, const Sectors& sectors, const Point_of& point)
    : level_(level)
    , sectors_(sectors)
    , point_(point)
    , exponent_(-exponent_of_size())
    , sums_(sectors.number_of_sectors())
  {
    for (Index f = 0; f < level.number_of_faces(); ++f) add(level.halfedge_of_face(f));
  }

  // the unit vector of the sum of a sector; zero if rounding could have made it
  Vector operator()(Index s) const
  {
    const Sum& sum = sums_[s];
    const auto squared = dot<double, 3>(sum.area, sum.area);
    if (!(squared > 0)) return {0, 0, 0};
    const double size = length(sum.area);
    if (!(size > sum.rounding) || !std::isfinite(size)) return {0, 0, 0};
    return quotient(sum.area, size);
  }

private:
  using T = Wide_number<FT>;

  struct Sum
  {
    Vector area{0, 0, 0};
    double rounding = 0;
  };

  Vector difference(Index v, Index origin) const
  {
    const auto &p = point_(v), &q = point_(origin);
    Vector d = to_double_3<T>({T(p[0]) - T(q[0]), T(p[1]) - T(q[1]), T(p[2]) - T(q[2])});
    if (exponent_ != 0)
      for (double& x : d) x = std::ldexp(x, exponent_);
    return d;
  }

  // zero for a size that is harmless
  int exponent_of_size() const
  {
    constexpr double most = 0x1p200;
    double largest = 0;
    for (Index v = 1; v < level_.number_of_vertices(); ++v)
      largest = (std::max)(largest, size_of(difference(v, 0)));
    const bool is_harmless = largest == 0 || (largest < most && largest > 1 / most);
    return is_harmless || !std::isfinite(largest) ? 0 : std::ilogb(largest);
  }

  static double size_of(const Vector& a)
  {
    return (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  }

  // of a coordinate, relative to the sizes of points and their differences
  double rounding_of(Index v, double largest) const
  {
    constexpr double of_double = std::numeric_limits<double>::epsilon();
    if constexpr (is_exact_v<FT>) return of_double * largest;
    const auto epsilon = static_cast<double>(CGAL::to_double(machine_epsilon<FT>()));
    const double coordinate = std::ldexp(size_of(to_double_3<FT>(point_(v))), exponent_);
    return (std::max)(epsilon * (coordinate + largest), of_double * largest);
  }

  void add(Index first)
  {
    const Index origin = level_.target(first);
    Vector area{0, 0, 0}, before{0, 0, 0};
    double largest = 0;
    for (Index h = level_.next(first); h != first; h = level_.next(h)) {
      const Vector d = difference(level_.target(h), origin);
      add_multiple<double, 3>(area, 1, cross(before, d));
      largest = (std::max)(largest, size_of(d));
      before = d;
    }
    const double rounding =
      16 * largest * rounding_of(origin, largest) + vanishing_tolerance<FT>() * 3 * size_of(area);
    Index h = first;
    do {
      Sum& sum = sums_[sectors_.at_target(h)];
      add_multiple<double, 3>(sum.area, 1, area);
      sum.rounding += rounding;
      h = level_.next(h);
    } while (h != first);
  }

  const Level_connectivity& level_;
  const Sectors& sectors_;
  const Point_of& point_;
  const int exponent_;
  std::vector<Sum> sums_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_AREA_NORMALS_H
