// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_PROPERTY_MAP_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_PROPERTY_MAP_CHECKS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/PN_subdivision_3/internal/average/kernel_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>

// What the surface functions ask of property maps, see concept_checks.h.

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Map, class Key, class = void>
struct Is_property_map_of : std::false_type
{};
template <class Map, class Key>
struct Is_property_map_of<Map, Key,
                          std::void_t<typename boost::property_traits<Map>::value_type,
                                      typename boost::property_traits<Map>::category>>
  : std::is_convertible<Key, typename boost::property_traits<Map>::key_type>
{};

template <class Map, class Tag>
constexpr bool has_category_v =
  std::is_convertible_v<typename boost::property_traits<Map>::category, Tag>;

// A type of points or vectors may be the user's own; one of CGAL's has to be the right one.
template <class T, class = void>
struct Kernel_of_type
{
  static constexpr bool exists = false;
};
template <class T>
struct Kernel_of_type<T, std::void_t<typename Kernel_traits<T>::Kernel::Point_3>>
{
  static constexpr bool exists = true;
  using type = typename Kernel_traits<T>::Kernel;
};

template <class T, class FT>
constexpr bool may_be_point_3()
{
  if constexpr (Kernel_of_type<T>::exists)
    return std::is_same_v<T, typename Kernel_of_type<T>::type::Point_3>;
  else
    return Has_coordinates_3<T, FT>::value;
}

// vectors, with the number type of the points or of the computation
template <class Normal, class Point, class Geom_traits>
constexpr bool may_be_normal_of()
{
  if constexpr (!Kernel_of_type<Normal>::exists)
    return Has_coordinates_3<Normal, typename Geom_traits::FT>::value;
  else if constexpr (!Kernel_of_type<Point>::exists)
    return true;
  else {
    using Kernel = typename Kernel_of_type<Normal>::type;
    using FT = typename Kernel::FT;
    return std::is_same_v<Normal, typename Kernel::Vector_3> &&
           (std::is_same_v<FT, typename Kernel_of_type<Point>::type::FT> ||
            std::is_same_v<FT, typename Geom_traits::FT>);
  }
}

// to be asked first: CGAL deduces the kernel from the map
template <class Mesh, class NamedParameters>
constexpr bool check_is_point_map()
{
  using Vertex = typename boost::graph_traits<std::remove_const_t<Mesh>>::vertex_descriptor;
  using Map = typename GetVertexPointMap<Mesh, NamedParameters>::type;
  constexpr bool is_map = Is_property_map_of<Map, Vertex>::value;
  static_assert(is_map, "PN_subdivision_3: vertex_point_map is not a property map of the mesh's "
                        "vertices (a function object is not one: see "
                        "boost::make_function_property_map())");
  if constexpr (is_map)
    return check_kernel<typename GetGeomTraits<std::remove_const_t<Mesh>, NamedParameters>::type>();
  else
    return false;
}

template <class Map, class Access_tag, class FT>
constexpr bool check_point_map()
{
  constexpr bool is_accessible = has_category_v<Map, Access_tag>;
  static_assert(is_accessible, "PN_subdivision_3: vertex_point_map cannot be written");
  constexpr bool has_points =
    may_be_point_3<typename boost::property_traits<Map>::value_type, FT>();
  static_assert(has_points, "PN_subdivision_3: the values of vertex_point_map are not Point_3");
  return is_accessible && has_points;
}

// normals of vertices or, if the function takes them, of corners
template <class Mesh, class Map, class Point_map, class Geom_traits, class Access_tag,
          bool takes_corners = false>
constexpr bool check_normal_map()
{
  using Traits = boost::graph_traits<std::remove_const_t<Mesh>>;
  constexpr bool is_map =
    Is_property_map_of<Map, typename Traits::vertex_descriptor>::value ||
    (takes_corners && Is_property_map_of<Map, typename Traits::halfedge_descriptor>::value);
  if constexpr (std::is_same_v<Map, No_normal_map>)
    return true;
  else if constexpr (!is_map) {
    static_assert(is_map,
                  "PN_subdivision_3: the normal map is not a property map of the mesh's vertices "
                  "(a function object is not one: see boost::make_function_property_map())");
    return false;
  } else {
    constexpr bool is_accessible = has_category_v<Map, Access_tag>;
    static_assert(is_accessible, "PN_subdivision_3: the normal map cannot be written");
    constexpr bool has_normals =
      may_be_normal_of<typename boost::property_traits<Map>::value_type,
                       typename boost::property_traits<Point_map>::value_type, Geom_traits>();
    static_assert(has_normals,
                  "PN_subdivision_3: the values of the normal map are not Vector_3 with "
                  "the number type of the points");
    return is_accessible && has_normals;
  }
}

template <class Map>
struct Has_sharpness
{
  using Value = std::decay_t<typename boost::property_traits<Map>::value_type>;
  static constexpr bool value =
    std::is_arithmetic_v<Value> ||
    std::is_convertible_v<typename Algebraic_structure_traits<Value>::Algebraic_category*,
                          Integral_domain_without_division_tag*>;
};

template <class T>
struct Is_roundness
  : std::bool_constant<
      (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) ||
      std::is_convertible_v<typename Algebraic_structure_traits<T>::Algebraic_category*,
                            Integral_domain_without_division_tag*>>
{};

template <class Key, class Map>
constexpr bool check_constraint_map()
{
  if constexpr (!is_constraint_map_v<Map>)
    return true;
  else if constexpr (!Is_property_map_of<Map, Key>::value) {
    static_assert(Is_property_map_of<Map, Key>::value,
                  "PN_subdivision_3: edge_is_constrained_map or vertex_is_constrained_map is "
                  "not a property map of the mesh's edges or vertices");
    return false;
  } else {
    constexpr bool is_readable = has_category_v<Map, boost::readable_property_map_tag>;
    static_assert(is_readable, "PN_subdivision_3: edge_is_constrained_map or "
                               "vertex_is_constrained_map cannot be read");
    constexpr bool is_number = Has_sharpness<Map>::value;
    static_assert(is_number, "PN_subdivision_3: the values of edge_is_constrained_map or "
                             "vertex_is_constrained_map are neither bool nor numbers");
    return is_readable && is_number;
  }
}

// the roundness that is given, if any
template <class Mesh, class Parameters>
constexpr bool check_roundness()
{
  using Map = typename Parameters::Roundness_map;
  using Roundness = typename Parameters::Roundness;
  constexpr bool has_map = !std::is_same_v<Map, No_roundness>;
  constexpr bool has_number = !std::is_same_v<Roundness, No_roundness>;
  static_assert(!has_map || !has_number,
                "PN_subdivision_3: roundness and vertex_roundness_map are both given");
  if constexpr (has_number) {
    static_assert(Is_roundness<Roundness>::value, "PN_subdivision_3: the roundness is no number");
    return !has_map && Is_roundness<Roundness>::value;
  } else if constexpr (!has_map)
    return true;
  else if constexpr (!Is_property_map_of<
                       Map, typename boost::graph_traits<Mesh>::vertex_descriptor>::value) {
    static_assert(
      !has_map,
      "PN_subdivision_3: vertex_roundness_map is not a property map of the mesh's vertices");
    return false;
  } else {
    constexpr bool is_readable = has_category_v<Map, boost::readable_property_map_tag>;
    static_assert(is_readable, "PN_subdivision_3: vertex_roundness_map cannot be read");
    constexpr bool is_number =
      Is_roundness<std::decay_t<typename boost::property_traits<Map>::value_type>>::value;
    static_assert(is_number, "PN_subdivision_3: the values of vertex_roundness_map are no numbers");
    return is_readable && is_number;
  }
}

// the map for roundness that is estimated, if there is one
template <class Mesh, class Map>
constexpr bool check_written_roundness()
{
  if constexpr (std::is_same_v<Map, No_roundness>)
    return true;
  else if constexpr (!Is_property_map_of<
                       Map, typename boost::graph_traits<Mesh>::vertex_descriptor>::value) {
    static_assert(
      !std::is_same_v<Map, Map>,
      "PN_subdivision_3: vertex_roundness_map is not a property map of the mesh's vertices");
    return false;
  } else {
    constexpr bool is_writable = has_category_v<Map, boost::writable_property_map_tag>;
    static_assert(is_writable, "PN_subdivision_3: vertex_roundness_map cannot be written");
    constexpr bool is_number =
      Is_roundness<std::decay_t<typename boost::property_traits<Map>::value_type>>::value;
    static_assert(is_number, "PN_subdivision_3: the values of vertex_roundness_map are no numbers");
    return is_writable && is_number;
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_PROPERTY_MAP_CHECKS_H
