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
#include <CGAL/PN_subdivision_3/internal/attributes/Array_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Map_values.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>

#include <boost/property_map/property_map.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class T>
using Sum_of = decltype(T(std::declval<const T&>() + std::declval<const T&>()));
template <class T>
using Has_sum = boost::is_detected<Sum_of, T>;
template <class T>
using Equality_of = decltype(bool(std::declval<const T&>() == std::declval<const T&>()));
template <class T>
using Has_equality = boost::is_detected<Equality_of, T>;

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

// the values of an attribute that has rows
template <class Map, class Keys, class FT>
constexpr bool check_attribute_values()
{
  using T = std::decay_t<typename boost::property_traits<Map>::value_type>;
  constexpr bool can_be_averaged = std::is_default_constructible_v<T> && has_averages<T, FT>();
  static_assert(
    can_be_averaged,
    "PN_subdivision_3: the values of an attribute of vertices or corners have no sum a + "
    "b, no product a * 0.5 or no default constructor: see PNSubdivisionAttribute, or "
    "specialize Attribute_traits; labels of vertices are named by nearest_attribute()");
  if constexpr (can_be_averaged && std::is_same_v<Keys, Halfedge_of_mesh>) {
    constexpr bool can_be_compared = Has_equality<typename Attribute_traits<T, FT>::Sum>::value;
    static_assert(can_be_compared, "PN_subdivision_3: the values of an attribute of corners cannot "
                                   "be compared by ==, which finds its seams");
    return can_be_compared;
  } else
    return can_be_averaged;
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

// the values of labels are copied
template <class T>
constexpr bool check_label()
{
  constexpr bool can_be_copied =
    std::is_default_constructible_v<T> && std::is_copy_constructible_v<T>;
  static_assert(can_be_copied,
                "PN_subdivision_3: the labels of vertices cannot be copied, or have no default "
                "constructor");
  return can_be_copied;
}
template <Attribute_rule rule, class T, class FT>
constexpr bool check_direction()
{
  constexpr bool is_right =
    rule != Attribute_rule::direction || Attribute_traits<T, FT>::has_components;
  static_assert(is_right, "PN_subdivision_3: directions are vectors of numbers that "
                          "Attribute_traits knows");
  return is_right;
}

// What attributes() takes. Each adds itself to the attributes of the call.

template <class Map, class Rule>
struct Vertex_attribute_by
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
    using T = std::decay_t<typename boost::property_traits<Map>::value_type>;
    constexpr Attribute_rule rule = Rule::template of<T, FT>;
    const std::size_t n = level.number_of_vertices();
    if constexpr (rule == Attribute_rule::nearest) {
      if constexpr (check_label<T>())
        c.vertices.push_back(std::make_unique<Nearest_values<FT>>(
          std::make_unique<Copied_map<Access, Map, Keys>>(access, map, n)));
    } else if constexpr (check_attribute_values<Map, Keys, FT>()) {
      if constexpr (check_direction<rule, T, FT>()) {
        using Values = Row_map<Access, Map, Keys, FT, rule>;
        c.vertices.push_back(std::make_unique<Values>(access, map, first_indices(n)));
      }
    }
  }
  Map map;
};
template <class Map>
struct Vertex_attribute : Vertex_attribute_by<Map, Rule_of_type>
{};
template <class Map>
struct Nearest_attribute : Vertex_attribute_by<Map, Given_rule<Attribute_rule::nearest>>
{};
template <class Map>
struct Direction_attribute : Vertex_attribute_by<Map, Given_rule<Attribute_rule::direction>>
{};

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
    if constexpr (check_attribute_values<Map, Keys, FT>()) {
      using Values = Row_map<Access, Map, Keys, FT>;
      c.corners.push_back({std::make_unique<Values>(access, map, corners_of(level)), rule});
    }
  }
  Map map;
  Corner_rule rule;
};

// The others have no rows, and are in a list of copies.
template <class Map, class Keys_, template <class, class, class> class Values, auto copies>
struct Item_without_rows
{
  using Keys = Keys_;

  template <class FT>
  static auto& list(Control_attributes<FT>& c)
  {
    return c.*copies;
  }
  template <class FT, class Access>
  void read(const Access& access, const Level_connectivity& level, Control_attributes<FT>& c) const
  {
    list(c).push_back(
      std::make_unique<Values<Access, Map, Keys>>(access, map, Keys::number(level.size())));
  }
  Map map;
};

template <class Map>
struct Edge_attribute : Item_without_rows<Map, Edge_of_mesh, Copied_map, &Copied_attributes::edges>
{};
template <class Map>
struct Face_attribute : Item_without_rows<Map, Face_of_mesh, Copied_map, &Copied_attributes::faces>
{};
template <class Map>
struct Face_parents
  : Item_without_rows<Map, Face_of_mesh, Origin_map, &Copied_attributes::face_origins>
{};
template <class Map>
struct Vertex_parents
  : Item_without_rows<Map, Vertex_of_mesh, Origin_map, &Copied_attributes::vertex_origins>
{};
template <class Map>
struct Edge_parents
  : Item_without_rows<Map, Edge_of_mesh, Origin_map, &Copied_attributes::edge_origins>
{};

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

template <class FT, class Access>
Control_attributes<FT> read_attributes(const Access&, const Level_connectivity& level,
                                       Attribute_table& table)
{
  Control_attributes<FT> c;
  for (Attribute_array& array : table.vertices) {
    const std::size_t n = level.number_of_vertices();
    if (array.rule_of_vertices == Attribute_rule::nearest)
      c.vertices.push_back(
        std::make_unique<Nearest_values<FT>>(std::make_unique<Copied_array>(array, n, "vertices")));
    else
      c.vertices.push_back(std::make_unique<Array_values<FT>>(array, n, "vertices"));
  }
  for (Attribute_array& array : table.corners)
    c.corners.push_back({std::make_unique<Array_values<FT>>(array, level.number_of_halfedges(),
                                                            "corners (half-edges)"),
                         array.rule});
  for (Attribute_array& array : table.edges)
    c.edges.push_back(std::make_unique<Copied_array>(array, level.number_of_edges(), "edges"));
  if (table.has_face_parents)
    c.face_origins.push_back(std::make_unique<Face_parent_array>(table.face_parents));
  return c;
}

// whether the values of corners have a seam
template <class Values>
bool have_seam(const Level_connectivity& level, const Values& values)
{
  return Charts<double>(level, Corner_rule::none, Control_sharpness(),
                        [&](auto h, auto g) { return values.are_equal(h, g); })
    .has_seams();
}
template <class Access, class Map>
bool has_seam(const Access& access, const Level_connectivity& level, const Map& map)
{
  return have_seam(level,
                   Row_map<Access, Map, Halfedge_of_mesh, double>(access, map, corners_of(level)));
}
template <class Access>
bool has_seam(const Access&, const Level_connectivity& level, Attribute_array array)
{
  return have_seam(
    level, Array_values<double>(array, level.number_of_halfedges(), "corners (half-edges)"));
}

// The first control face at an origin, that is the one with the least number at an edge or a vertex. Where
// faces come from faces only, nothing is stored.
class Control_faces
{
public:
  using Index = Level_connectivity::Index;

  Control_faces() = default;
  explicit Control_faces(const Level_connectivity& level)
    : of_edge_(level.number_of_edges(), Level_connectivity::null)
    , of_vertex_(level.number_of_vertices(), Level_connectivity::null)
  {
    for (Index h = 0; h < level.number_of_halfedges(); ++h) {
      if (level.is_border(h)) continue;
      const Index f = level.face(h);
      for (Index* first : {&of_edge_[Level_connectivity::edge(h)], &of_vertex_[level.target(h)]})
        *first = (std::min)(*first, f); // null is the largest
    }
  }

  Index operator()(const Origin& origin) const
  {
    if (origin.kind == Origin::Kind::face) return origin.index;
    const std::vector<Index>& faces = origin.kind == Origin::Kind::edge ? of_edge_ : of_vertex_;
    return faces.empty() ? Level_connectivity::null : faces[origin.index];
  }

private:
  std::vector<Index> of_edge_, of_vertex_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_READ_ATTRIBUTES_H
