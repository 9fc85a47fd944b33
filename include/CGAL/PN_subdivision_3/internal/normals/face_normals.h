// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FACE_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FACE_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/numbers/Weight_number.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Differences of points in double. Where squares of the size of the mesh would leave the range of
// double, all is scaled by a power of two.
template <class FT, class Values = Point_normals<FT>>
class Scaled_differences
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  Scaled_differences(const Level_connectivity& level, const Values& values)
    : values_(values)
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
    using T = At_least_double<FT>;
    const auto &p = point_of(values_[v]), &q = point_of(values_[origin]);
    Vector d = to_double_3<T>({T(p[0]) - T(q[0]), T(p[1]) - T(q[1]), T(p[2]) - T(q[2])});
    if (exponent_ != 0)
      for (double& x : d) x = std::ldexp(x, exponent_);
    return d;
  }

  // the rounding of differences to a point, of at most this size, by the rounding of the coordinates
  double rounding(Index origin, double size) const
  {
    constexpr double of_double = std::numeric_limits<double>::epsilon();
    if constexpr (is_exact_v<FT>)
      return of_double * size;
    else {
      const auto epsilon = static_cast<double>(CGAL::to_double(machine_epsilon<FT>()));
      double coordinate = largest_coordinate(to_double_3<FT>(point_of(values_[origin])));
      if (exponent_ != 0) coordinate = std::ldexp(coordinate, exponent_);
      return (std::max)(epsilon * (coordinate + size), of_double * size);
    }
  }

private:
  const Values& values_;
  int exponent_ = 0;
};

// The sum of the area vectors of the faces of a vertex.
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

// twice the area vector of a face, with what rounding may have made of it
template <class FT, class Values>
Area_sum area_of_face(const Level_connectivity& level,
                      const Scaled_differences<FT, Values>& difference, Level_connectivity::Index f)
{
  using Index = Level_connectivity::Index;
  const Index first = level.halfedge_of_face(f), origin = level.target(first);
  Index h = level.next(first);
  Area_sum result;
  auto before = difference(level.target(h), origin);
  double size = largest_coordinate(before);
  for (h = level.next(h); h != first; h = level.next(h)) {
    const auto d = difference(level.target(h), origin);
    add_multiple(result.area, 1, cross(before, d));
    size = (std::max)(size, largest_coordinate(d));
    before = d;
  }
  result.rounding = 16 * size * difference.rounding(origin, size) +
                    3 * vanishing_tolerance<FT>() * largest_coordinate(result.area);
  return result;
}

// adds the areas of all faces to sum_of(v) of the vertices v at their corners
template <class FT, class Sum_of>
void add_areas(const Level_connectivity& level, const Scaled_differences<FT>& difference,
               const Sum_of& sum_of)
{
  using Index = Level_connectivity::Index;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    const Area_sum face = area_of_face(level, difference, f);
    for (const Index h : halfedges_around_face(level, level.halfedge_of_face(f)))
      sum_of(level.target(h)).add(face.area, face.rounding);
  }
}

// Sums, over the faces of each vertex, of the corner's angle times the unit face normal. The area
// vectors are computed in the number type (float is widened); the factor angle/area, irrational
// anyway, is a double, but in number types that round and have angles themselves.
template <class FT>
class Angle_weighted_normals
{
public:
  using Index = Level_connectivity::Index;
  using T = At_least_double<FT>;
  // the type of angles: double, unless the number type rounds and has angles of its own
  static constexpr bool has_own_angles =
    !std::is_floating_point_v<T> && std::is_same_v<Rooted_number<T>, T> && Has_own_angle<T>::value;
  using Angle = std::conditional_t<has_own_angles, T, double>;

  Angle_weighted_normals(const Level_connectivity& level, const Point_normals<FT>& values)
    : level_(level)
    , values_(values)
    , sums_(level.number_of_vertices(), Coordinates<T, 3>{T(0), T(0), T(0)})
    , angles_(level.number_of_vertices(), 0.)
  {}

  void add_face(Index f)
  {
    collect_corners(f);
    Coordinates<T, 3> area{T(0), T(0), T(0)};
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
      const auto c = cross(corners_[i], corners_[i + 1]);
      for (int k = 0; k < 3; ++k) area[k] += c[k];
    }
    const double area_length = length(to_double_3(area));
    if (!(area_length > least_area_) || !std::isfinite(area_length)) return;
    Angle length_of_area(area_length);
    if constexpr (has_own_angles) length_of_area = square_root_of<T>(dot(area, area));
    const std::size_t n = corners_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Angle angle = corner_angle(edge_at(i, n - 1), edge_at(i, 1));
      const T weight(angle / length_of_area);
      for (int k = 0; k < 3; ++k) sums_[vertices_[i]][k] += weight * area[k];
      angles_[vertices_[i]] += close_double(angle);
    }
  }

  // the unit sum of a vertex whose faces have been added; zero if it vanishes
  Coordinates<FT, 3> normal(Index v) const
  {
    const double vanishing = 4096 * std::numeric_limits<double>::epsilon() * angles_[v];
    if (!(length(to_double_3(sums_[v])) > vanishing)) return {FT(0), FT(0), FT(0)};
    Coordinates<T, 3> n = sums_[v];
    normalize_control_normal<T, 3>(n);
    return {FT(n[0]), FT(n[1]), FT(n[2])};
  }

private:
  // The corners relative to the first one, scaled to a size of about 1 by a power of two. What the
  // rounding of the coordinates alone can make of a face without area counts as no area: its
  // direction is arbitrary, and its angles are the largest there are.
  void collect_corners(Index f)
  {
    vertices_.clear();
    corners_.clear();
    const Index first = level_.halfedge_of_face(f);
    const auto& origin = values_[level_.target(first)].point;
    double largest = 0, largest_coordinate = 0;
    for (const Index h : halfedges_around_face(level_, first)) {
      vertices_.push_back(level_.target(h));
      const auto& p = values_[vertices_.back()].point;
      corners_.push_back({T(p[0]) - T(origin[0]), T(p[1]) - T(origin[1]), T(p[2]) - T(origin[2])});
      for (double x : to_double_3(corners_.back())) largest = (std::max)(largest, std::abs(x));
      if constexpr (!is_exact_v<FT>)
        for (const FT& x : p)
          largest_coordinate = (std::max)(largest_coordinate, std::abs(double(CGAL::to_double(x))));
    }
    least_area_ = 0;
    if (!(largest > 0) || !std::isfinite(largest)) return;
    const int exponent = std::ilogb(largest);
    const T scale(std::ldexp(1., -exponent / 2)), rest(std::ldexp(1., -exponent + exponent / 2));
    for (auto& c : corners_)
      for (T& x : c) x = x * scale * rest;
    if constexpr (!is_exact_v<FT>)
      least_area_ = 16 * double(CGAL::to_double(machine_epsilon<FT>())) *
                    std::ldexp(largest_coordinate, -exponent);
  }

  // To the next corner that is at another point: between an edge without length and another one there is no angle, and
  // what atan2() makes of zeros depends on their signs.
  Coordinates<T, 3> edge_at(std::size_t i, std::size_t step) const
  {
    const std::size_t n = corners_.size();
    Coordinates<T, 3> e;
    std::size_t j = i;
    do {
      j = (j + step) % n;
      e = difference(corners_[j], corners_[i]);
    } while (is_zero(to_double_3(e)) && j != i);
    return e;
  }

  static Angle corner_angle(const Coordinates<T, 3>& u, const Coordinates<T, 3>& w)
  {
    if constexpr (has_own_angles) {
      const Coordinates<T, 3> c = cross(u, w);
      return own_angle<T>(square_root_of<T>(dot(c, c)), dot(u, w));
    } else {
      const auto a = to_double_3(u), b = to_double_3(w);
      return std::atan2(length(cross(a, b)), dot(a, b));
    }
  }

  const Level_connectivity& level_;
  const Point_normals<FT>& values_;
  std::vector<Coordinates<T, 3>> sums_;
  std::vector<double> angles_;
  std::vector<Index> vertices_; // of the corners of a face
  std::vector<Coordinates<T, 3>> corners_;
  double least_area_ = 0;
};

// The unit area vectors of polygons, in double. Those of large ones are kept, since each of their
// corners may ask.
template <class FT>
class Face_normals
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  Face_normals(const Level_connectivity& level, const Point_normals<FT>& values)
    : level_(level)
    , values_(values)
  {}

  // the normal of the face of a half-edge; zero if it has no area or is a triangle, whose corners tell it
  Vector operator()(Index h)
  {
    if (level_.has_degree(h, 3)) return {0, 0, 0};
    constexpr Index few = 16;
    Index degree = 0, g = h;
    do {
      g = level_.next(g);
      ++degree;
    } while (g != h && degree <= few);
    if (degree <= few) return normal(h);
    const auto [place, is_new] = kept_.insert({level_.face(h), Vector{0, 0, 0}});
    if (is_new) place->second = normal(h);
    return place->second;
  }

private:
  using T = At_least_double<FT>;

  Vector normal(Index first) const
  {
    Vector area{0, 0, 0}, before{0, 0, 0};
    double scale = 0; // of the first edge that has a length
    const auto& origin = values_[level_.target(first)].point;
    for (Index h = level_.next(first); h != first; h = level_.next(h)) {
      const auto& p = values_[level_.target(h)].point;
      Vector corner =
        to_double_3<T>({T(p[0]) - T(origin[0]), T(p[1]) - T(origin[1]), T(p[2]) - T(origin[2])});
      if (scale == 0) scale = length(corner);
      if (scale > 0) corner = quotient(corner, scale);
      add_multiple(area, 1, cross(before, corner));
      before = corner;
    }
    const double area_length = length(area);
    if (!(area_length > 0) || !std::isfinite(area_length)) return {0, 0, 0};
    return quotient(area, area_length);
  }

  const Level_connectivity& level_;
  const Point_normals<FT>& values_;
  std::unordered_map<Index, Vector> kept_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FACE_NORMALS_H
