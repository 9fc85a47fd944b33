// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_CURVE_MAPS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_CURVE_MAPS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Item>
struct Default_curve_point_map
{
  using type = CGAL::Identity_property_map<const Item>;
};
template <class Point, class Vector>
struct Default_curve_point_map<std::pair<Point, Vector>>
{
  using type = CGAL::First_of_pair_property_map<std::pair<Point, Vector>>;
};

struct No_curve_normal_map
{};

template <class Item>
struct Default_curve_normal_map
{
  using type = No_curve_normal_map;
};
template <class Point, class Vector>
struct Default_curve_normal_map<std::pair<Point, Vector>>
{
  using type = CGAL::Second_of_pair_property_map<std::pair<Point, Vector>>;
};

// Where a range has its points: its items, the first members of its pairs, or what a named parameter
// says; likewise its normals, if any.
template <class Range, class NamedParameters>
struct Curve_maps
{
  using Item =
    typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::value_type;
  using Point_map = std::decay_t<typename internal_np::Lookup_named_param_def<
    internal_np::point_t, NamedParameters, typename Default_curve_point_map<Item>::type>::type>;
  using Normal_map = std::decay_t<typename internal_np::Lookup_named_param_def<
    internal_np::normal_t, NamedParameters, typename Default_curve_normal_map<Item>::type>::type>;
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

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_CURVE_MAPS_H
