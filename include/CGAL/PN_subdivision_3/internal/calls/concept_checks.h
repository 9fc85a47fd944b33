// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_CONCEPT_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_CONCEPT_CHECKS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/property_map_checks.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

// What the surface functions ask of their arguments, each said in one readable line at compile time.
// A function whose check returns false has nothing else to compile.

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// \name Named parameters

template <class NamedParameters>
constexpr bool check_named_parameters()
{
  static_assert(
    are_named_parameters_v<NamedParameters>,
    "PN_subdivision_3: the last argument is not a named parameter: for a number of rounds write "
    "CGAL::parameters::number_of_iterations(3)");
  return are_named_parameters_v<NamedParameters>;
}

// What a deduction guide makes of a call. Of something else than named parameters it says nothing, the constructor does.
template <class Mesh, class NamedParameters>
using Geom_traits_of_call = typename Surface_parameters<
  Mesh, std::conditional_t<are_named_parameters_v<NamedParameters>, NamedParameters,
                           parameters::Default_named_parameters>>::Geom_traits;

// \name Meshes

// asked first: of what is no graph, such as a soup, boost::graph_traits is an error
template <class Mesh, class = void>
struct Has_add_edge : std::false_type
{};
template <class Mesh>
struct Has_add_edge<Mesh, std::void_t<decltype(add_edge(std::declval<Mesh&>()))>> : std::true_type
{};

template <class Mesh, bool = Has_add_edge<Mesh>::value, class = void>
struct Is_mutable_face_graph : std::false_type
{};
template <class Mesh>
struct Is_mutable_face_graph<
  Mesh, true,
  std::void_t<
    decltype(set_target(std::declval<typename boost::graph_traits<Mesh>::halfedge_descriptor>(),
                        std::declval<typename boost::graph_traits<Mesh>::vertex_descriptor>(),
                        std::declval<Mesh&>())),
    decltype(set_next(std::declval<typename boost::graph_traits<Mesh>::halfedge_descriptor>(),
                      std::declval<typename boost::graph_traits<Mesh>::halfedge_descriptor>(),
                      std::declval<Mesh&>())),
    typename boost::graph_traits<Mesh>::face_descriptor>> : std::true_type
{};

template <class Mesh>
constexpr bool check_mutable_mesh()
{
  constexpr bool is_mutable = !std::is_const_v<Mesh>;
  constexpr bool is_mutable_face_graph = Is_mutable_face_graph<std::remove_const_t<Mesh>>::value;
  static_assert(is_mutable, "PN_subdivision_3: the mesh is const, but it is to be refined");
  static_assert(
    is_mutable_face_graph,
    "PN_subdivision_3: the mesh is not a model of MutableFaceGraph: views and filtered "
    "graphs cannot be refined, copy the mesh (CGAL::copy_face_graph()); a soup becomes a mesh by "
    "CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh()");
  return is_mutable && is_mutable_face_graph;
}

// \name Schemes

template <class Scheme, class FT, class = void>
struct Is_scheme : std::false_type
{};
template <class Scheme, class FT>
struct Is_scheme<
  Scheme, FT,
  std::void_t<typename Scheme::Host, decltype(std::declval<const Scheme&>().template mask<FT>(
                                       std::declval<const Level_connectivity&>(), 0u))>>
  : std::true_type
{};

// the map of the tangents of creases
template <class Mesh, class Scheme, class Point_map, class Geom_traits>
constexpr bool check_crease_tangents()
{
  using Map = Crease_tangent_map<Scheme>;
  constexpr bool is_given = has_crease_tangents_v<Scheme>;
  constexpr bool has_rules = Has_crease_rules<Scheme>::value;
  static_assert(
    !is_given || has_rules,
    "PN_subdivision_3: crease_tangent_map is given for a scheme without rules for creases");
  if constexpr (!is_given || !has_rules)
    return !is_given;
  else if constexpr (!Is_property_map_of<
                       Map, typename boost::graph_traits<Mesh>::halfedge_descriptor>::value) {
    static_assert(!is_given, "PN_subdivision_3: crease_tangent_map is not a property map "
                             "of the mesh's half-edges");
    return false;
  } else {
    constexpr bool is_readable = has_category_v<Map, boost::readable_property_map_tag>;
    static_assert(is_readable, "PN_subdivision_3: crease_tangent_map cannot be read");
    constexpr bool has_vectors =
      may_be_normal_of<typename boost::property_traits<Map>::value_type,
                       typename boost::property_traits<Point_map>::value_type, Geom_traits>();
    static_assert(has_vectors, "PN_subdivision_3: the values of crease_tangent_map are "
                               "not Vector_3 with the number type of the points");
    return is_readable && has_vectors;
  }
}

// \name Functions

template <class NamedParameters>
constexpr bool check_subdivision_parameters()
{
  using Iterations =
    typename internal_np::Lookup_named_param_def<internal_np::number_of_iterations_t,
                                                 NamedParameters, unsigned>::type;
  constexpr bool is_integer = std::is_integral_v<std::decay_t<Iterations>>;
  static_assert(is_integer, "PN_subdivision_3: number_of_iterations is not an integer");
  return is_integer;
}

// the maps of a call that say what is sharp and how round it is
template <class Mesh, class Parameters>
constexpr bool check_sharpness_and_roundness()
{
  return check_constraint_map<typename boost::graph_traits<Mesh>::edge_descriptor,
                              typename Parameters::Edge_constraint_map>() &&
         check_constraint_map<typename boost::graph_traits<Mesh>::vertex_descriptor,
                              typename Parameters::Vertex_constraint_map>() &&
         check_roundness<Mesh, Parameters>();
}

// points and normals, of vertices or, if the function takes them, of corners
template <class Mesh, class Parameters, class Access_tag, bool takes_corners>
constexpr bool check_points_and_normals()
{
  return check_point_map<typename Parameters::Point_map, Access_tag, typename Parameters::FT>() &&
         check_normal_map<Mesh, typename Parameters::Normal_map, typename Parameters::Point_map,
                          typename Parameters::Geom_traits, Access_tag, takes_corners>();
}

// the scheme and the control mesh, which is only read or refined
template <class Mesh, class Scheme, class NamedParameters,
          class Access_tag = boost::readable_property_map_tag>
constexpr bool check_control_arguments()
{
  if constexpr (!check_named_parameters<NamedParameters>())
    return false;
  else if constexpr (!check_is_point_map<Mesh, NamedParameters>())
    return false;
  else {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    constexpr bool is_scheme = Is_scheme<Scheme, typename Parameters::FT>::value;
    static_assert(is_scheme, "PN_subdivision_3: the scheme is no model of PNSubdivisionScheme_3");
    if constexpr (is_scheme)
      return check_points_and_normals<Mesh, Parameters, Access_tag, true>() &&
             check_sharpness_and_roundness<Mesh, Parameters>();
    return false;
  }
}

template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_refiner_arguments()
{
  constexpr bool has_tangents = has_crease_tangents_v<Scheme>;
  static_assert(!has_tangents, "PN_subdivision_3: Surface_refiner makes the tangents of creases "
                               "from the control points: it takes no crease_tangent_map");
  if constexpr (has_tangents)
    return false;
  else
    return check_control_arguments<Mesh, Scheme, NamedParameters>();
}

template <class Mesh, class Scheme, class NamedParameters,
          class Access_tag = boost::readable_property_map_tag>
constexpr bool check_pieces_arguments()
{
  if constexpr (check_control_arguments<Mesh, Scheme, NamedParameters, Access_tag>()) {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    return check_crease_tangents<Mesh, Scheme, typename Parameters::Point_map,
                                 typename Parameters::Geom_traits>();
  } else
    return false;
}

template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_subdivision_arguments()
{
  if constexpr (!check_mutable_mesh<Mesh>())
    return false;
  else if constexpr (!check_named_parameters<NamedParameters>())
    return false;
  else if constexpr (check_subdivision_parameters<NamedParameters>())
    return check_pieces_arguments<Mesh, Scheme, NamedParameters,
                                  boost::writable_property_map_tag>();
  else
    return false;
}

template <class Mesh, class NamedParameters, bool takes_corners = false>
constexpr bool check_build_arguments()
{
  if constexpr (check_mutable_mesh<Mesh>()) {
    if constexpr (check_is_point_map<Mesh, NamedParameters>())
      return check_points_and_normals<Mesh, Surface_parameters<Mesh, NamedParameters>,
                                      boost::writable_property_map_tag, takes_corners>();
  }
  return false;
}

template <class T, class = void>
struct Is_limit_point : std::false_type
{};
template <class T>
struct Is_limit_point<
  T, std::void_t<decltype(std::declval<T>().point), decltype(std::declval<T>().control_normal),
                 decltype(std::declval<T>().surface_normal)>> : std::true_type
{};

// the map of limit points of vertices, or of faces
template <class Map, class Key>
constexpr bool check_limit_map()
{
  if constexpr (!Is_property_map_of<Map, Key>::value) {
    static_assert(
      Is_property_map_of<Map, Key>::value,
      "PN_subdivision_3: the map of limit points is not a property map of the mesh's vertices "
      "(of a dual scheme: of its faces)");
    return false;
  } else {
    constexpr bool is_writable = has_category_v<Map, boost::writable_property_map_tag>;
    static_assert(is_writable, "PN_subdivision_3: the map of limit points cannot be written");
    constexpr bool has_limits =
      Is_limit_point<typename boost::property_traits<Map>::value_type>::value;
    static_assert(
      has_limits,
      "PN_subdivision_3: the values of the map of limit points are not Limit_point<Kernel>");
    return is_writable && has_limits;
  }
}

// the maps of a function for limits that say what is sharp
template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_creased_limit_arguments()
{
  if constexpr (check_is_point_map<Mesh, NamedParameters>()) {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    return check_sharpness_and_roundness<Mesh, Parameters>() &&
           check_crease_tangents<Mesh, Scheme, typename Parameters::Point_map,
                                 typename Parameters::Geom_traits>();
  } else
    return false;
}

template <class Mesh, class Item>
constexpr bool is_attribute_of_v = false;
template <class Mesh, template <class> class Item, class Map>
inline constexpr bool is_attribute_of_v<Mesh, Item<Map>> =
  Is_property_map_of<Map, typename Item<Map>::Keys::template Descriptor<Mesh>>::value;

template <class Mesh, class Attributes>
constexpr bool are_attributes_of_v = true;
template <class Mesh, class... Items>
inline constexpr bool
  are_attributes_of_v<Mesh, Attributes<Items...>> = (is_attribute_of_v<Mesh, Items> && ...);

template <class Mesh, class Given>
constexpr bool check_given_attributes()
{
  constexpr bool are_attributes = Is_attributes<Given>::value;
  static_assert(are_attributes,
                "PN_subdivision_3: parameters::attributes() is given neither attributes nor an "
                "Attribute_table");
  constexpr bool have_keys = are_attributes_of_v<Mesh, Given>;
  static_assert(have_keys, "PN_subdivision_3: the map of an attribute is not a property map of the "
                           "mesh's vertices, half-edges, edges or faces, as its name says");
  return are_attributes && have_keys;
}

template <class T>
struct Unwrapped
{
  using type = T;
};
template <class T>
struct Unwrapped<std::reference_wrapper<T>>
{
  using type = T;
};

// the attributes of a call; a table that is to be refined is not const
template <class Mesh, class NamedParameters, bool are_changed = true>
constexpr bool check_attributes()
{
  if constexpr (!are_named_parameters_v<NamedParameters>)
    return false;
  else {
    using Attributes =
      typename Unwrapped<Parameter_type<attributes_t, NamedParameters, No_attributes>>::type;
    constexpr bool is_const_table =
      are_changed && std::is_same_v<Attributes, const Attribute_table>;
    static_assert(!is_const_table, "PN_subdivision_3: the table of attributes is const, but it is "
                                   "to be refined");
    return check_given_attributes<Mesh, std::remove_const_t<Attributes>>() && !is_const_table;
  }
}

template <class Mesh, class Normal_map, class NamedParameters>
constexpr bool check_estimation_arguments()
{
  if constexpr (!check_is_point_map<Mesh, NamedParameters>())
    return false;
  else {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    if constexpr (check_point_map<typename Parameters::Point_map, boost::readable_property_map_tag,
                                  typename Parameters::FT>())
      return check_normal_map<Mesh, Normal_map, typename Parameters::Point_map,
                              typename Parameters::Geom_traits, boost::writable_property_map_tag,
                              true>();
    else
      return false;
  }
}

template <class Mesh, class Map, class NamedParameters>
constexpr bool check_detection_arguments()
{
  using Edge = typename boost::graph_traits<Mesh>::edge_descriptor;
  if constexpr (!check_is_point_map<Mesh, NamedParameters>())
    return false;
  else if constexpr (!Is_property_map_of<Map, Edge>::value) {
    static_assert(Is_property_map_of<Map, Edge>::value,
                  "PN_subdivision_3: the map of creases is not a property map of the mesh's edges");
    return false;
  } else {
    constexpr bool is_writable = has_category_v<Map, boost::writable_property_map_tag>;
    static_assert(is_writable, "PN_subdivision_3: the map of creases cannot be written");
    constexpr bool is_number =
      std::is_arithmetic_v<std::decay_t<typename boost::property_traits<Map>::value_type>>;
    static_assert(is_number,
                  "PN_subdivision_3: the values of the map of creases are neither bool nor "
                  "built-in numbers");
    return is_writable && is_number;
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_CONCEPT_CHECKS_H
