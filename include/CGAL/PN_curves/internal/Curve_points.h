// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_CURVE_POINTS_H
#define CGAL_PN_CURVES_INTERNAL_CURVE_POINTS_H

#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/package_parameters.h>

#include <CGAL/Dimension.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Item>
struct Default_curve_maps
{
  using Points = CGAL::Identity_property_map<const Item>;
  using Normals = Not_given;
};
template <class Point, class Vector>
struct Default_curve_maps<std::pair<Point, Vector>>
{
  using Points = CGAL::First_of_pair_property_map<std::pair<Point, Vector>>;
  using Normals = CGAL::Second_of_pair_property_map<std::pair<Point, Vector>>;
};

template <class FT, int dimension, class Point_or_vector>
Coordinates<FT, dimension> coordinates_of(const Point_or_vector& p)
{
  Coordinates<FT, dimension> c;
  for (int i = 0; i < dimension; ++i) c[static_cast<std::size_t>(i)] = FT(p.cartesian(i));
  return c;
}

// a point or vector, of numbers of its kernel or others
template <class Point_or_vector, class Number, std::size_t dimension>
Point_or_vector from_coordinates(const std::array<Number, dimension>& c)
{
  using FT = typename CGAL::Kernel_traits<Point_or_vector>::Kernel::FT;
  const auto number = [](const Number& x) {
    if constexpr (std::is_floating_point_v<FT> || std::is_same_v<FT, Number>)
      return static_cast<FT>(x);
    else
      return FT(static_cast<double>(x));
  };
  if constexpr (dimension == 2)
    return Point_or_vector(number(c[0]), number(c[1]));
  else
    return Point_or_vector(number(c[0]), number(c[1]), number(c[2]));
}

// Where a range has its points: its items, the first members of its pairs, or what a named parameter
// says; likewise its normals, if any. Nothing is asked of the kernel, which is checked afterwards.
template <class Range, class NamedParameters>
struct Curve_maps
{
  using Item =
    typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::value_type;
  using Point_map = std::decay_t<typename internal_np::Lookup_named_param_def<
    internal_np::point_t, NamedParameters, typename Default_curve_maps<Item>::Points>::type>;
  using Normal_map = std::decay_t<typename internal_np::Lookup_named_param_def<
    internal_np::normal_t, NamedParameters, typename Default_curve_maps<Item>::Normals>::type>;
  using Point = std::remove_const_t<typename boost::property_traits<Point_map>::value_type>;

  static Point_map point_map(const NamedParameters& np)
  {
    return parameters::choose_parameter<Point_map>(
      parameters::get_parameter(np, internal_np::point_map));
  }
  static Normal_map normal_map(const NamedParameters& np)
  {
    return parameters::choose_parameter<Normal_map>(
      parameters::get_parameter(np, internal_np::normal_map));
  }
};

// And the points in other number types.
template <class Range, class NamedParameters>
struct Curve_points : Curve_maps<Range, NamedParameters>
{
  using Maps = Curve_maps<Range, NamedParameters>;
  using typename Maps::Normal_map;
  using typename Maps::Point;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using FT = typename Kernel::FT;

  static constexpr int dimension = CGAL::Ambient_dimension<Point>::value;
  static constexpr bool has_normals = is_there_v<Normal_map>;
  using Vector =
    std::conditional_t<dimension == 2, typename Kernel::Vector_2, typename Kernel::Vector_3>;

  // the points in the number type Number
  template <class Number>
  static std::vector<Coordinates<Number, dimension>> get_all(const Range& range,
                                                             const NamedParameters& np)
  {
    const auto map = Maps::point_map(np);
    std::vector<Coordinates<Number, dimension>> points;
    for (const auto& item : range) {
      const Point p = get(map, item);
      Coordinates<Number, dimension> c;
      for (int i = 0; i < dimension; ++i)
        c[static_cast<std::size_t>(i)] = number<Number>(p.cartesian(i));
      check_finite<Number, dimension>(c, "position",
                                      [&] { return "point " + std::to_string(points.size()); });
      points.push_back(c);
    }
    return points;
  }

  template <class Number>
  static Number number(const FT& x)
  {
    if constexpr (std::is_same_v<FT, Number> || std::is_floating_point_v<FT>)
      return Number(x);
    else
      return Number(close_double(x));
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CURVES_INTERNAL_CURVE_POINTS_H
