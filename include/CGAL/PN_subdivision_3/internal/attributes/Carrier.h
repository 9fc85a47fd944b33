// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIER_H

#include <CGAL/PN_subdivision_3/Control_element.h>
#include <CGAL/PN_subdivision_3/Default_visitor.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_rounds.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Level_origins.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// \name Visitors
// Of each member: whether there is one of this name, and whether it can be
// called with what it is given. A name that the visitor shares with another
// base class is ambiguous; from a final class nothing can be derived.

template <bool is_open, class Visitor, class Named>
struct Visitor_and_names : Visitor, Named
{};
template <class Visitor, class Named>
struct Visitor_and_names<false, Visitor, Named> : Named
{};
template <class Visitor, class Named>
using With_names = Visitor_and_names<std::is_class_v<Visitor> && !std::is_final_v<Visitor>,
                                     std::remove_cv_t<Visitor>, Named>;

struct Visitor_names
{
  void round_done();
  void vertex_created();
  void edge_created();
  void face_created();
};

// an answer that is not Not_visited
template <class Result>
constexpr bool is_visit_v = !std::is_same_v<Result, Not_visited>;

template <class Visitor, class = void>
struct Has_round_done : std::true_type
{};
template <class Visitor>
struct Has_round_done<Visitor,
                      std::void_t<decltype(&With_names<Visitor, Visitor_names>::round_done)>>
  : std::false_type
{};
template <class Visitor, class = void>
struct Visits_rounds : std::false_type
{
  static constexpr bool is_callable = false;
};
template <class Visitor>
struct Visits_rounds<Visitor,
                     std::void_t<decltype(std::declval<Visitor&>().round_done(0u, std::size_t()))>>
  : std::bool_constant<is_visit_v<decltype(std::declval<Visitor&>().round_done(0u, std::size_t()))>>
{
  static constexpr bool is_callable = true;
};

template <class Visitor, class = void>
struct Has_vertex_created : std::true_type
{};
template <class Visitor>
struct Has_vertex_created<
  Visitor, std::void_t<decltype(&With_names<Visitor, Visitor_names>::vertex_created)>>
  : std::false_type
{};
template <class Visitor, class Mesh, class = void>
struct Visits_vertices : std::false_type
{
  static constexpr bool is_callable = false;
};
template <class Visitor, class Mesh>
struct Visits_vertices<Visitor, Mesh,
                       std::void_t<decltype(std::declval<Visitor&>().vertex_created(
                         std::declval<typename boost::graph_traits<Mesh>::vertex_descriptor>(),
                         std::declval<const Control_element&>()))>>
  : std::bool_constant<is_visit_v<decltype(std::declval<Visitor&>().vertex_created(
      std::declval<typename boost::graph_traits<Mesh>::vertex_descriptor>(),
      std::declval<const Control_element&>()))>>
{
  static constexpr bool is_callable = true;
};

template <class Visitor, class = void>
struct Has_edge_created : std::true_type
{};
template <class Visitor>
struct Has_edge_created<Visitor,
                        std::void_t<decltype(&With_names<Visitor, Visitor_names>::edge_created)>>
  : std::false_type
{};
template <class Visitor, class Mesh, class = void>
struct Visits_edges : std::false_type
{
  static constexpr bool is_callable = false;
};
template <class Visitor, class Mesh>
struct Visits_edges<Visitor, Mesh,
                    std::void_t<decltype(std::declval<Visitor&>().edge_created(
                      std::declval<typename boost::graph_traits<Mesh>::edge_descriptor>(),
                      std::declval<const Control_element&>()))>>
  : std::bool_constant<is_visit_v<decltype(std::declval<Visitor&>().edge_created(
      std::declval<typename boost::graph_traits<Mesh>::edge_descriptor>(),
      std::declval<const Control_element&>()))>>
{
  static constexpr bool is_callable = true;
};

template <class Visitor, class = void>
struct Has_face_created : std::true_type
{};
template <class Visitor>
struct Has_face_created<Visitor,
                        std::void_t<decltype(&With_names<Visitor, Visitor_names>::face_created)>>
  : std::false_type
{};
template <class Visitor, class Mesh, class = void>
struct Visits_faces : std::false_type
{
  static constexpr bool is_callable = false;
};
template <class Visitor, class Mesh>
struct Visits_faces<Visitor, Mesh,
                    std::void_t<decltype(std::declval<Visitor&>().face_created(
                      std::declval<typename boost::graph_traits<Mesh>::face_descriptor>(),
                      std::declval<const Control_element&>()))>>
  : std::bool_constant<is_visit_v<decltype(std::declval<Visitor&>().face_created(
      std::declval<typename boost::graph_traits<Mesh>::face_descriptor>(),
      std::declval<const Control_element&>()))>>
{
  static constexpr bool is_callable = true;
};

template <class Visitor, class Mesh>
constexpr bool check_visitor()
{
  constexpr bool rounds = Visits_rounds<Visitor>::is_callable || !Has_round_done<Visitor>::value;
  static_assert(rounds, "PN_subdivision_3: the visitor's round_done() cannot be "
                        "called; expected is "
                        "void round_done(unsigned round, std::size_t number_of_faces)");
  constexpr bool vertices =
    Visits_vertices<Visitor, Mesh>::is_callable || !Has_vertex_created<Visitor>::value;
  static_assert(vertices, "PN_subdivision_3: the visitor's vertex_created() cannot be called; "
                          "expected is "
                          "void vertex_created(vertex_descriptor, const Control_element& origin)");
  constexpr bool edges =
    Visits_edges<Visitor, Mesh>::is_callable || !Has_edge_created<Visitor>::value;
  static_assert(edges, "PN_subdivision_3: the visitor's edge_created() cannot be called; "
                       "expected is "
                       "void edge_created(edge_descriptor, const Control_element& origin)");
  constexpr bool faces =
    Visits_faces<Visitor, Mesh>::is_callable || !Has_face_created<Visitor>::value;
  static_assert(faces, "PN_subdivision_3: the visitor's face_created() cannot be called; "
                       "expected is "
                       "void face_created(face_descriptor, const Control_element& parent)");
  constexpr bool visits =
    Visits_rounds<Visitor>::is_callable || Visits_vertices<Visitor, Mesh>::is_callable ||
    Visits_edges<Visitor, Mesh>::is_callable || Visits_faces<Visitor, Mesh>::is_callable;
  static_assert(visits || !(rounds && vertices && edges && faces),
                "PN_subdivision_3: the visitor has none of the members round_done(), "
                "vertex_created(), edge_created(), face_created()");
  return rounds && vertices && edges && faces && visits;
}

// calls the visitor's member if it has one
template <class Visitor>
struct Call_round_done
{
  void operator()([[maybe_unused]] unsigned round, [[maybe_unused]] std::size_t faces) const
  {
    if constexpr (Visits_rounds<Visitor>::value) visitor.round_done(round, faces);
  }
  Visitor& visitor;
};

// What a call carries beside points and normals: its attributes, and what its
// visitor asks for.
template <class Mesh, class Visitor, class Attributes>
struct Carrier
{
  using Size = Level_size;
  using Index = Level_connectivity::Index;

  static constexpr Level_origins::Kinds visited{Visits_vertices<Visitor, Mesh>::value,
                                                Visits_edges<Visitor, Mesh>::value,
                                                Visits_faces<Visitor, Mesh>::value};
  // there is nothing to carry, whatever the attributes
  static constexpr bool is_empty = std::is_same_v<std::decay_t<Attributes>, No_attributes> &&
                                   !visited.vertices && !visited.edges && !visited.faces;

  template <class FT, class Access>
  Carried_attributes<FT> read(const Access& access, const Level_connectivity& level) const
  {
    return read_attributes<FT>(access, level, attributes);
  }

  // calls the visitor for the elements of the refined mesh
  template <class Access, class Rules>
  void visit(const Access& access, const Size& size, const Rules& rules) const
  {
    (void)access, (void)size, (void)rules;
    if constexpr (visited.vertices)
      for (Index v = 0; v < size.vertices; ++v)
        visitor.vertex_created(access.vertex(v), control_element(rules.vertex(v)));
    if constexpr (visited.edges)
      for (Index e = 0; e < size.edges; ++e)
        visitor.edge_created(access.edge_at(e), control_element(rules.edge(e)));
    if constexpr (visited.faces)
      for (Index f = 0; f < size.faces; ++f)
        visitor.face_created(access.face_at(f), control_element(rules.face(f)));
  }

  Visitor& visitor;
  Attributes& attributes;
};

struct Nothing_carried
{
  static constexpr bool is_empty = true;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIER_H
