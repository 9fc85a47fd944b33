// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_READ_ATTRIBUTES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_READ_ATTRIBUTES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Columns.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

template <class T>
using Sum_of = decltype(T(std::declval<const T&>() + std::declval<const T&>()));
template <class T>
using Has_sum = boost::is_detected<Sum_of, T>;

// whether averages of values of an attribute can be computed in FT
template <class T, class FT>
constexpr bool has_averages()
{
  using Traits = Attribute_traits<T, FT>;
  using Sum = typename Traits::Sum;
  if constexpr (Traits::has_components)
    return true;
  else if constexpr (std::is_base_of_v<Arithmetic_of_values, Traits>)
    return Has_sum<T>::value && (Has_product<T, FT>::value || Has_product<T, double>::value ||
                                 Has_product_with_weight_first<T>::value);
  else
    return Has_sum<Sum>::value;
}

template <class T, class FT, class Keys, Attribute_rule rule>
constexpr bool check_attribute_values()
{
  constexpr bool is_label = rule == Attribute_rule::nearest;
  constexpr bool can_be_copied =
    !is_label || (std::is_default_constructible_v<T> && std::is_copy_constructible_v<T>);
  static_assert(can_be_copied,
                "PN_subdivision_3: the labels of vertices cannot be copied, or have no default "
                "constructor");
  if constexpr (!is_label) {
    constexpr bool can_be_averaged = std::is_default_constructible_v<T> && has_averages<T, FT>();
    constexpr bool can_be_compared =
      !can_be_averaged || !std::is_same_v<Keys, Halfedge_of_mesh> || Has_equality<T>::value;
    constexpr bool have_length =
      rule != Attribute_rule::direction || Attribute_traits<T, FT>::has_components;
    static_assert(
      can_be_averaged,
      "PN_subdivision_3: the values of an attribute of vertices or corners have no sum a + "
      "b, no product a * 0.5 or no default constructor: see PNSubdivisionAttribute, or "
      "specialize Attribute_traits; labels of vertices are named by nearest_attribute()");
    static_assert(can_be_compared, "PN_subdivision_3: the values of an attribute of corners cannot "
                                   "be compared by ==, which finds its seams");
    static_assert(have_length, "PN_subdivision_3: directions are vectors of numbers that "
                               "Attribute_traits knows");
    return can_be_averaged && can_be_compared && have_length;
  } else
    return can_be_copied;
}

// The rules of values of vertices: that of their type, or one that is given.
struct Rule_of_type
{
  template <class Traits, class = void>
  struct Of : std::integral_constant<Attribute_rule, Attribute_rule::average>
  {};
  template <class Traits>
  struct Of<Traits, std::void_t<decltype(Traits::rule)>>
    : std::integral_constant<Attribute_rule, Traits::rule>
  {};
  template <class T, class FT>
  static constexpr Attribute_rule of = Of<Attribute_traits<T, FT>>::value;
};
template <Attribute_rule rule>
struct Given_rule
{
  template <class T, class FT>
  static constexpr Attribute_rule of = rule;
};

// the values of a map by a rule, null if they do not have it; a rule that is not named here is an average
template <class FT, class Keys, Attribute_rule rule, class Access, class Map>
std::unique_ptr<Row_values<FT>> rows_of_map(const Access& access, const Level_connectivity& level,
                                            const Map& map)
{
  using T = Value_of_map<Map>;
  if constexpr (!check_attribute_values<T, FT, Keys, rule>())
    return nullptr;
  else if constexpr (rule == Attribute_rule::nearest)
    return std::make_unique<Rows<FT, Label_values<FT>>>(
      column_of_map<Keys, Copied<T>>(access, level, map));
  else {
    using Traits = Attribute_traits<T, FT>;
    using Kind =
      std::conditional_t<Traits::has_components, Number_values<FT>, Sum_values<FT, Traits>>;
    return std::make_unique<Rows<FT, Kind>>(
      column_of_map<Keys, Averaged<T, FT>>(access, level, map), rule == Attribute_rule::direction);
  }
}

// What attributes() takes. Each adds itself to a list of the attributes of the call.

template <class Map, class Rule = Rule_of_type>
struct Vertex_attribute
{
  using Keys = Vertex_of_mesh;

  template <class FT>
  static auto& list(Control_attributes<FT>& c)
  {
    return c.vertices;
  }
  template <class FT, class Access>
  void read(const Access& access, const Level_connectivity& level, Control_attributes<FT>& c) const
  {
    constexpr Attribute_rule rule = Rule::template of<Value_of_map<Map>, FT>;
    c.vertices.push_back(rows_of_map<FT, Keys, rule>(access, level, map));
  }
  Map map;
};

template <class Map>
struct Corner_attribute
{
  using Keys = Halfedge_of_mesh;

  template <class FT>
  static auto& list(Control_attributes<FT>& c)
  {
    return c.corners;
  }
  template <class FT, class Access>
  void read(const Access& access, const Level_connectivity& level, Control_attributes<FT>& c) const
  {
    c.corners.push_back(rows_of_map<FT, Keys, Attribute_rule::average>(access, level, map));
    c.corner_rules.push_back(rule);
  }
  Map map;
  Corner_rule rule;
};

// The others have no rows.
template <class Map, class Keys_, template <class> class Conversion, auto columns>
struct Item_without_rows
{
  using Keys = Keys_;

  static auto& list(Columns_of_call& c) { return c.*columns; }
  template <class FT, class Access>
  void read(const Access& access, const Level_connectivity& level, Control_attributes<FT>& c) const
  {
    list(c).push_back(column_of_map<Keys, Conversion<Value_of_map<Map>>>(access, level, map));
  }
  Map map;
};

template <class Map>
using Edge_attribute = Item_without_rows<Map, Edge_of_mesh, Copied, &Columns_of_call::edges>;
template <class Map>
using Face_attribute = Item_without_rows<Map, Face_of_mesh, Copied, &Columns_of_call::faces>;
template <class Map>
using Face_parents = Item_without_rows<Map, Face_of_mesh, Parent, &Columns_of_call::face_origins>;
template <class Map>
using Vertex_parents =
  Item_without_rows<Map, Vertex_of_mesh, Parent, &Columns_of_call::vertex_origins>;
template <class Map>
using Edge_parents = Item_without_rows<Map, Edge_of_mesh, Parent, &Columns_of_call::edge_origins>;

// the result of attributes()
template <class... Items>
struct Attributes
{
  std::tuple<Items...> items;
};

template <class T>
using Is_attributes = std::disjunction<Is_instance<Attributes, T>, std::is_same<T, Not_given>,
                                       std::is_same<T, Attribute_table>>;

template <class... Items>
bool is_empty(const Attributes<Items...>&)
{
  return sizeof...(Items) == 0;
}
inline bool is_empty(const Attribute_table& table)
{
  return table.vertices.empty() && table.corners.empty() && table.edges.empty() &&
         !table.has_face_parents;
}

template <class FT, class Access>
Control_attributes<FT> read_attributes(const Access&, const Level_connectivity&, const Not_given&)
{
  return {};
}

template <class FT, class Access, class... Items>
Control_attributes<FT> read_attributes(const Access& access, const Level_connectivity& level,
                                       const Attributes<Items...>& attributes)
{
  Control_attributes<FT> result;
  std::apply([&](const Items&... items) { (items.read(access, level, result), ...); },
             attributes.items);
  return result;
}

// refuses an array that does not fit its elements
inline void check_array(const Attribute_array& array, std::size_t number, const char* kind)
{
  const auto n = [](std::size_t x) { return std::to_string(x); };
  if (array.dimension == 0)
    throw std::invalid_argument(std::string("PN_subdivision_3: an attribute of ") + kind +
                                " has dimension 0");
  if (array.values.size() / array.dimension == number && array.values.size() % array.dimension == 0)
    return;
  throw std::invalid_argument(std::string("PN_subdivision_3: an attribute of ") + kind + " has " +
                              n(array.values.size()) + " values, but the mesh has " + n(number) +
                              " of them with " + n(array.dimension) + " each");
}
constexpr const char* corners_in_messages = "corners (half-edges)";

// the table is const if it is only read
template <class FT, class Access, class Table>
std::enable_if_t<std::is_same_v<const Table, const Attribute_table>, Control_attributes<FT>>
read_attributes(const Access& access, const Level_connectivity& level, Table& table)
{
  Control_attributes<FT> c;
  const auto column = [&](auto conversion, auto& array, std::size_t number, const char* kind) {
    check_array(array, number, kind);
    return column_of_array<decltype(conversion)>(access, array.dimension, array.values);
  };
  using Numbers = Rows<FT, Number_values<FT>>;
  for (auto& array : table.vertices) {
    const std::size_t n = level.number_of_vertices();
    if (array.rule_of_vertices == Attribute_rule::nearest)
      c.vertices.push_back(std::make_unique<Rows<FT, Label_values<FT>>>(
        column(Copied<double>(), array, n, "vertices")));
    else
      c.vertices.push_back(
        std::make_unique<Numbers>(column(Averaged<double, FT>(), array, n, "vertices"),
                                  array.rule_of_vertices == Attribute_rule::direction));
  }
  for (auto& array : table.corners) {
    c.corners.push_back(std::make_unique<Numbers>(
      column(Averaged<double, FT>(), array, level.number_of_halfedges(), corners_in_messages)));
    c.corner_rules.push_back(array.rule);
  }
  for (auto& array : table.edges)
    c.edges.push_back(column(Copied<double>(), array, level.number_of_edges(), "edges"));
  if (table.has_face_parents)
    c.face_origins.push_back(column_of_array<Parent<std::uint32_t>>(access, 1, table.face_parents));
  return c;
}

// whether the values of corners have a seam
inline bool have_seam(const Level_connectivity& level, Are_values_equal are_equal)
{
  return Charts<double>(level, Corner_rule::none, Control_sharpness(), are_equal).has_seams();
}
template <class Access, class Map>
bool has_seam(const Access& access, const Level_connectivity& level, const Map& map)
{
  const Map_store<Access, Map, Halfedge_of_mesh> values(access, level, map);
  return have_seam(level, [&](auto h, auto g) { return values.old(h) == values.old(g); });
}
template <class Access>
bool has_seam(const Access&, const Level_connectivity& level, const Attribute_array& array)
{
  const std::size_t d = array.dimension;
  check_array(array, level.number_of_halfedges(), corners_in_messages);
  return have_seam(level, [&](auto h, auto g) {
    const auto value = array.values.begin() + std::ptrdiff_t(h * d);
    return std::equal(value, value + std::ptrdiff_t(d),
                      array.values.begin() + std::ptrdiff_t(g * d));
  });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_READ_ATTRIBUTES_H
