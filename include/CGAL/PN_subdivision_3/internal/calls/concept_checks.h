// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_CONCEPT_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_CONCEPT_CHECKS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
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

namespace CGAL::PN_subdivision_3::internal {

// \name Property maps

// what is known of a type that may be no property map
template <class Map, class = void>
struct Facts_of_map
{
  struct Value
  {};
  template <class>
  static constexpr bool has_key = false;
};
template <class Map>
struct Facts_of_map<Map, std::void_t<typename boost::property_traits<Map>::value_type,
                                     typename boost::property_traits<Map>::category>>
{
  using Traits = boost::property_traits<Map>;
  using Value = std::decay_t<typename Traits::value_type>;
  template <class Key>
  static constexpr bool has_key = std::is_convertible_v<Key, typename Traits::key_type>;
};
template <class Map, class Key>
constexpr bool is_property_map_of_v = Facts_of_map<Map>::template has_key<Key>;

// the keys of maps of a mesh
template <class Mesh>
using Traits_of = boost::graph_traits<std::remove_const_t<Mesh>>;
template <class Mesh>
using Vertex_of = typename Traits_of<Mesh>::vertex_descriptor;
template <class Mesh>
using Halfedge_of = typename Traits_of<Mesh>::halfedge_descriptor;
template <class Mesh>
using Edge_of = typename Traits_of<Mesh>::edge_descriptor;
template <class Mesh>
struct Vertex_or_halfedge_of
{};
template <class Map, class Mesh>
inline constexpr bool is_property_map_of_v<Map, Vertex_or_halfedge_of<Mesh>> =
  is_property_map_of_v<Map, Vertex_of<Mesh>> || is_property_map_of_v<Map, Halfedge_of<Mesh>>;
template <class Key>
using Key_itself = Key;

// their values, of a call with some Surface_parameters

template <class T, class>
constexpr bool is_anything_v = true;

template <class T, class Parameters>
constexpr bool is_point_v = may_be_point_3<T, typename Parameters::FT>();
template <class T, class Parameters>
constexpr bool
  is_vector_v = may_be_vector_3<T, typename Facts_of_map<typename Parameters::Point_map>::Value,
                                typename Parameters::FT>();
template <class T, class>
constexpr bool is_built_in_v = std::is_arithmetic_v<T>;
template <class T, class>
constexpr bool is_sharpness_v =
  std::is_arithmetic_v<T> ||
  std::is_convertible_v<typename Algebraic_structure_traits<T>::Algebraic_category*,
                        Integral_domain_without_division_tag*>;
template <class T, class Parameters>
constexpr bool is_roundness_v = is_sharpness_v<T, Parameters> && !std::is_same_v<T, bool>;

template <class T, class, class = void>
constexpr bool is_limit_point_v = false;
template <class T, class Parameters>
inline constexpr bool is_limit_point_v<
  T, Parameters,
  std::void_t<decltype(std::declval<T>().point), decltype(std::declval<T>().control_normal),
              decltype(std::declval<T>().surface_normal)>> = true;

// how a function uses a map
using Readable = boost::readable_property_map_tag;
using Writable = boost::writable_property_map_tag;

// A map, by its parameter or as an argument of its own, if it is given.
template <class Parameter>
struct Check_map;
struct Points_of_kernel;
struct Normals_of_corners;
struct Map_of_limits;
struct Map_of_creases;

template <class Map, class Access_tag, class Tag>
constexpr bool lacks_v = std::is_convertible_v<Access_tag, Tag> && !has_category_v<Map, Tag>;

#define CGAL_PN_SUBDIVISION_3_MAP(PARAMETER, KEY, is_value_v, MAP, KEYS, VALUES)                   \
  template <>                                                                                      \
  struct Check_map<PARAMETER>                                                                      \
  {                                                                                                \
    template <class Map, class Mesh, class Parameters, class Access_tag>                           \
    static constexpr bool check()                                                                  \
    {                                                                                              \
      constexpr bool is_given = is_there_v<Map>;                                                   \
      constexpr bool has_keys = !is_given || is_property_map_of_v<Map, KEY<Mesh>>;                 \
      constexpr bool is_map = is_given && has_keys;                                                \
      constexpr bool is_read = !is_map || !lacks_v<Map, Access_tag, Readable>;                     \
      constexpr bool is_written = !is_map || !lacks_v<Map, Access_tag, Writable>;                  \
      constexpr bool fits = !is_map || is_value_v<typename Facts_of_map<Map>::Value, Parameters>;  \
      static_assert(has_keys,                                                                      \
                    "PN_subdivision_3: " MAP " is not a property map of the mesh's " KEYS);        \
      static_assert(is_read, "PN_subdivision_3: " MAP " cannot be read");                          \
      static_assert(is_written, "PN_subdivision_3: " MAP " cannot be written");                    \
      static_assert(fits, "PN_subdivision_3: the values of " MAP " are not " VALUES);              \
      return has_keys && is_read && is_written && fits;                                            \
    }                                                                                              \
  };
#define CGAL_PN_SUBDIVISION_3_NO_FUNCTION                                                          \
  "vertices (a function object is not one: see boost::make_function_property_map())"
#define CGAL_PN_SUBDIVISION_3_VECTORS "Vector_3 with the number type of the points"
#define CGAL_PN_SUBDIVISION_3_OF_LIMITS "vertices (of a dual scheme: of its faces)"
// clang-format off
CGAL_PN_SUBDIVISION_3_MAP(Points_of_kernel, Vertex_of, is_anything_v, "vertex_point_map", CGAL_PN_SUBDIVISION_3_NO_FUNCTION, "points")
CGAL_PN_SUBDIVISION_3_MAP(internal_np::vertex_point_t, Vertex_of, is_point_v, "vertex_point_map", "vertices", "Point_3")
CGAL_PN_SUBDIVISION_3_MAP(internal_np::vertex_normal_map_t, Vertex_of, is_vector_v, "the normal map", CGAL_PN_SUBDIVISION_3_NO_FUNCTION, CGAL_PN_SUBDIVISION_3_VECTORS)
CGAL_PN_SUBDIVISION_3_MAP(Normals_of_corners, Vertex_or_halfedge_of, is_vector_v, "the normal map", CGAL_PN_SUBDIVISION_3_NO_FUNCTION, CGAL_PN_SUBDIVISION_3_VECTORS)
CGAL_PN_SUBDIVISION_3_MAP(internal_np::edge_is_constrained_t, Edge_of, is_sharpness_v, "edge_is_constrained_map", "edges", "bool or numbers")
CGAL_PN_SUBDIVISION_3_MAP(internal_np::vertex_is_constrained_t, Vertex_of, is_sharpness_v, "vertex_is_constrained_map", "vertices", "bool or numbers")
CGAL_PN_SUBDIVISION_3_MAP(vertex_roundness_map_t, Vertex_of, is_roundness_v, "vertex_roundness_map", "vertices", "numbers")
CGAL_PN_SUBDIVISION_3_MAP(crease_tangent_map_t, Halfedge_of, is_vector_v, "crease_tangent_map", "half-edges", CGAL_PN_SUBDIVISION_3_VECTORS)
CGAL_PN_SUBDIVISION_3_MAP(Map_of_limits, Key_itself, is_limit_point_v, "the map of limit points", CGAL_PN_SUBDIVISION_3_OF_LIMITS, "Limit_point<Kernel>")
CGAL_PN_SUBDIVISION_3_MAP(limit_point_map_t, Key_itself, is_anything_v, "limit_point_map", CGAL_PN_SUBDIVISION_3_OF_LIMITS, "points")
CGAL_PN_SUBDIVISION_3_MAP(limit_normal_map_t, Key_itself, is_anything_v, "limit_normal_map", CGAL_PN_SUBDIVISION_3_OF_LIMITS, "vectors")
CGAL_PN_SUBDIVISION_3_MAP(limit_error_map_t, Key_itself, is_anything_v, "limit_error_map", CGAL_PN_SUBDIVISION_3_OF_LIMITS, "numbers")
CGAL_PN_SUBDIVISION_3_MAP(Map_of_creases, Edge_of, is_built_in_v, "the map of creases", "edges", "bool or built-in numbers")
// clang-format on
#undef CGAL_PN_SUBDIVISION_3_MAP
#undef CGAL_PN_SUBDIVISION_3_NO_FUNCTION
#undef CGAL_PN_SUBDIVISION_3_VECTORS
#undef CGAL_PN_SUBDIVISION_3_OF_LIMITS

// to be asked first: CGAL deduces the kernel from the map
template <class Mesh, class NamedParameters>
constexpr bool check_is_point_map()
{
  using Map = typename GetVertexPointMap<Mesh, NamedParameters>::type;
  if constexpr (Check_map<Points_of_kernel>::check<Map, Mesh, NamedParameters, void>())
    return check_kernel<typename GetGeomTraits<std::remove_const_t<Mesh>, NamedParameters>::type>();
  return false;
}

// points and normals, of vertices or, if the function takes them, of corners
template <class Mesh, class Parameters, class Access_tag, bool takes_corners>
constexpr bool check_points_and_normals()
{
  using Normals =
    std::conditional_t<takes_corners, Normals_of_corners, internal_np::vertex_normal_map_t>;
  return Check_map<internal_np::vertex_point_t>::check<typename Parameters::Point_map, Mesh,
                                                       Parameters, Access_tag>() &&
         Check_map<Normals>::template check<typename Parameters::Normal_map, Mesh, Parameters,
                                            Access_tag>();
}

// the maps of a call that say what is sharp
template <class Mesh, class Parameters>
constexpr bool check_sharpness()
{
  return Check_map<internal_np::edge_is_constrained_t>::check<
           typename Parameters::Edge_constraint_map, Mesh, Parameters, Readable>() &&
         Check_map<internal_np::vertex_is_constrained_t>::check<
           typename Parameters::Vertex_constraint_map, Mesh, Parameters, Readable>();
}

// the maps of a call that say what is sharp, and how round it is
template <class Mesh, class Parameters>
constexpr bool check_sharpness_and_roundness()
{
  using Roundness = typename Parameters::Roundness;
  using Roundness_map = typename Parameters::Roundness_map;
  constexpr bool is_given = is_there_v<Roundness>;
  constexpr bool is_one = !is_given || !is_there_v<Roundness_map>;
  constexpr bool is_number = !is_given || is_roundness_v<Roundness, Parameters>;
  static_assert(is_one, "PN_subdivision_3: roundness and vertex_roundness_map are both given");
  static_assert(is_number, "PN_subdivision_3: the roundness is no number");
  return is_one && is_number && check_sharpness<Mesh, Parameters>() &&
         Check_map<vertex_roundness_map_t>::check<Roundness_map, Mesh, Parameters, Readable>();
}

// the map of the tangents of creases
template <class Mesh, class Scheme, class Parameters>
constexpr bool check_crease_tangents()
{
  constexpr bool is_given = has_crease_tangents_v<Scheme>;
  constexpr bool is_taken = !is_given || Has_crease_rules<Scheme>::value;
  static_assert(
    is_taken,
    "PN_subdivision_3: crease_tangent_map is given for a scheme without rules for creases");
  if constexpr (is_given && is_taken)
    return Check_map<crease_tangent_map_t>::check<Crease_tangent_map<Scheme>, Mesh, Parameters,
                                                  Readable>();
  else
    return is_taken;
}

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

template <class Mesh, class Item, class = void>
constexpr bool is_attribute_of_v = false;
template <class Mesh, class Item>
inline constexpr bool is_attribute_of_v<Mesh, Item, std::void_t<typename Item::Keys>> =
  is_property_map_of_v<decltype(Item::map), typename Item::Keys::template Descriptor<Mesh>>;

template <class Mesh, class Attributes>
constexpr bool are_attributes_of_v = true;
template <class Mesh, class... Items>
inline constexpr bool
  are_attributes_of_v<Mesh, Attributes<Items...>> = (is_attribute_of_v<Mesh, Items> && ...);

// the attributes of a call; a table that is to be refined is not const
template <class Mesh, class NamedParameters, bool are_changed = true>
constexpr bool check_attributes()
{
  if constexpr (!are_named_parameters_v<NamedParameters>)
    return false;
  else {
    using Given = std::remove_reference_t<decltype(unwrapped(
      std::declval<Parameter_type<attributes_t, NamedParameters>&>()))>;
    constexpr bool is_changeable = !are_changed || !std::is_same_v<Given, const Attribute_table>;
    constexpr bool are_attributes = Is_attributes<std::remove_const_t<Given>>::value;
    constexpr bool have_keys = are_attributes_of_v<Mesh, std::remove_const_t<Given>>;
    static_assert(is_changeable,
                  "PN_subdivision_3: the table of attributes is const, but it is to be refined");
    static_assert(are_attributes,
                  "PN_subdivision_3: parameters::attributes() is given neither attributes nor an "
                  "Attribute_table");
    static_assert(have_keys,
                  "PN_subdivision_3: the map of an attribute is not a property map of the "
                  "mesh's vertices, half-edges, edges or faces, as its name says");
    return is_changeable && are_attributes && have_keys;
  }
}

// \name Meshes

// for a type that is no graph, such as a soup, boost::graph_traits is an error, and views have no such function
template <class Mesh, class = void>
constexpr bool has_add_edge_v = false;
template <class Mesh>
inline constexpr bool has_add_edge_v<Mesh, std::void_t<decltype(add_edge(std::declval<Mesh&>()))>> =
  true;

template <class Mesh>
constexpr bool check_mutable_mesh()
{
  constexpr bool is_mutable = !std::is_const_v<Mesh>;
  constexpr bool is_mutable_face_graph = has_add_edge_v<std::remove_const_t<Mesh>>;
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
constexpr bool is_scheme_v = false;
template <class Scheme, class FT>
inline constexpr bool is_scheme_v<
  Scheme, FT,
  std::void_t<typename Scheme::Host, decltype(std::declval<const Scheme&>().template mask<FT>(
                                       std::declval<const Level_connectivity&>(), 0u))>> = true;

// \name Functions

// the scheme and the control mesh, which is only read or refined
template <class Mesh, class Scheme, class NamedParameters, class Access_tag = Readable>
constexpr bool check_control_arguments()
{
  if constexpr (check_named_parameters<NamedParameters>())
    if constexpr (check_is_point_map<Mesh, NamedParameters>()) {
      using Parameters = Surface_parameters<Mesh, NamedParameters>;
      constexpr bool is_scheme = is_scheme_v<Scheme, typename Parameters::FT>;
      static_assert(is_scheme, "PN_subdivision_3: the scheme is no model of PNSubdivisionScheme_3");
      if constexpr (is_scheme)
        return check_points_and_normals<Mesh, Parameters, Access_tag, true>() &&
               check_sharpness_and_roundness<Mesh, Parameters>();
    }
  return false;
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

template <class Mesh, class Scheme, class NamedParameters, class Access_tag = Readable>
constexpr bool check_pieces_arguments()
{
  if constexpr (check_control_arguments<Mesh, Scheme, NamedParameters, Access_tag>())
    return check_crease_tangents<Mesh, Scheme, Surface_parameters<Mesh, NamedParameters>>();
  return false;
}

template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_subdivision_arguments()
{
  if constexpr (check_mutable_mesh<Mesh>())
    if constexpr (check_named_parameters<NamedParameters>()) {
      constexpr bool is_integer = std::is_integral_v<
        Parameter_type<internal_np::number_of_iterations_t, NamedParameters, unsigned>>;
      static_assert(is_integer, "PN_subdivision_3: number_of_iterations is not an integer");
      if constexpr (is_integer)
        return check_pieces_arguments<Mesh, Scheme, NamedParameters, Writable>();
    }
  return false;
}

template <class Mesh, class NamedParameters, bool takes_corners = false>
constexpr bool check_build_arguments()
{
  if constexpr (check_mutable_mesh<Mesh>())
    if constexpr (check_is_point_map<Mesh, NamedParameters>())
      return check_points_and_normals<Mesh, Surface_parameters<Mesh, NamedParameters>, Writable,
                                      takes_corners>();
  return false;
}

// the maps of a function for limits that say what is sharp
template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_creased_limit_arguments()
{
  if constexpr (check_is_point_map<Mesh, NamedParameters>()) {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    return check_sharpness_and_roundness<Mesh, Parameters>() &&
           check_crease_tangents<Mesh, Scheme, Parameters>();
  } else
    return false;
}

// points and sharpness that are read, and a map of normals of vertices or corners
template <class Mesh, class Normal_map, class NamedParameters, class Access_tag = Writable>
constexpr bool check_estimation_arguments()
{
  if constexpr (check_is_point_map<Mesh, NamedParameters>()) {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    return Check_map<internal_np::vertex_point_t>::check<typename Parameters::Point_map, Mesh,
                                                         Parameters, Readable>() &&
           Check_map<Normals_of_corners>::check<Normal_map, Mesh, Parameters, Access_tag>() &&
           check_sharpness<Mesh, Parameters>();
  } else
    return false;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_CONCEPT_CHECKS_H
