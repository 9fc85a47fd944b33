// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CALL_ATTRIBUTES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CALL_ATTRIBUTES_H

#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_rounds.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

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

// \name The members: their names, and what they answer
#define CGAL_PN_SUBDIVISION_3_MEMBER(MEMBER, NAME, EXPECTED, ...)                                  \
  template <class Mesh>                                                                            \
  struct MEMBER                                                                                    \
  {                                                                                                \
    template <class Visitor>                                                                       \
    using Name = decltype(&Visitor::NAME);                                                         \
    template <class Visitor>                                                                       \
    using Answer = decltype(std::declval<Visitor&>().NAME(__VA_ARGS__));                           \
    template <bool is_right>                                                                       \
    static constexpr bool check()                                                                  \
    {                                                                                              \
      static_assert(is_right, "PN_subdivision_3: the visitor's " #NAME                             \
                              "() cannot be called; expected is void " #NAME EXPECTED);            \
      return is_right;                                                                             \
    }                                                                                              \
  };
CGAL_PN_SUBDIVISION_3_MEMBER(Round_done, round_done,
                             "(unsigned round, std::size_t number_of_faces)", 0u, std::size_t())
CGAL_PN_SUBDIVISION_3_MEMBER(Vertex_created, vertex_created,
                             "(vertex_descriptor, const Control_element& origin)",
                             std::declval<typename boost::graph_traits<Mesh>::vertex_descriptor>(),
                             std::declval<const Control_element&>())
CGAL_PN_SUBDIVISION_3_MEMBER(Edge_created, edge_created,
                             "(edge_descriptor, const Control_element& origin)",
                             std::declval<typename boost::graph_traits<Mesh>::edge_descriptor>(),
                             std::declval<const Control_element&>())
CGAL_PN_SUBDIVISION_3_MEMBER(Face_created, face_created,
                             "(face_descriptor, const Control_element& parent)",
                             std::declval<typename boost::graph_traits<Mesh>::face_descriptor>(),
                             std::declval<const Control_element&>())
#undef CGAL_PN_SUBDIVISION_3_MEMBER

template <class Visitor, class Member, class = void>
constexpr bool has_member_name_v = true;
template <class Visitor, class Member>
inline constexpr bool has_member_name_v<
  Visitor, Member,
  std::void_t<typename Member::template Name<With_names<Visitor, Visitor_names>>>> = false;

// whether there is a member that does not answer Not_visited
template <class Visitor, class Member, class = void>
struct Visits : std::false_type
{
  static constexpr bool is_callable = false, is_right = !has_member_name_v<Visitor, Member>;
};
template <class Visitor, class Member>
struct Visits<Visitor, Member, std::void_t<typename Member::template Answer<Visitor>>>
  : std::bool_constant<!std::is_same_v<typename Member::template Answer<Visitor>, Not_visited>>
{
  static constexpr bool is_callable = true, is_right = true;
};

template <class Visitor, class... Members>
constexpr bool check_members_of_visitor()
{
  constexpr bool are_right = (Members::template check<Visits<Visitor, Members>::is_right>() && ...);
  constexpr bool visits = (Visits<Visitor, Members>::is_callable || ...);
  static_assert(visits || !are_right,
                "PN_subdivision_3: the visitor has none of the members round_done(), "
                "vertex_created(), edge_created(), face_created()");
  return are_right && visits;
}
template <class Visitor, class Mesh>
constexpr bool check_visitor()
{
  return check_members_of_visitor<Visitor, Round_done<Mesh>, Vertex_created<Mesh>,
                                  Edge_created<Mesh>, Face_created<Mesh>>();
}

// calls the visitor's member if it has one
template <class Visitor>
struct Call_round_done
{
  void operator()([[maybe_unused]] unsigned round, [[maybe_unused]] std::size_t faces) const
  {
    if constexpr (Visits<Visitor, Round_done<void>>::value) visitor.round_done(round, faces);
  }
  Visitor& visitor;
};

// What a call refines beside points and normals: its attributes, and what its
// visitor asks for.
template <class Mesh, class Visitor, class Attributes>
struct Call_attributes
{
  using Index = Level_connectivity::Index;

  static constexpr Level_origins::Kinds visited{Visits<Visitor, Vertex_created<Mesh>>::value,
                                                Visits<Visitor, Edge_created<Mesh>>::value,
                                                Visits<Visitor, Face_created<Mesh>>::value};
  // there is nothing to refine, whatever the attributes
  static constexpr bool is_empty = !is_there_v<std::decay_t<Attributes>> && !visited.any();
  static constexpr bool is_any() { return !is_empty; }

  template <class FT, class Access>
  Control_attributes<FT> read(const Access& access, const Level_connectivity& level) const
  {
    return read_attributes<FT>(access, level, attributes);
  }

  // calls the visitor for the elements of the refined mesh
  template <class Access, class Rules>
  void visit(const Access& access, const Level_size& size, const Rules& rules) const
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

// The attributes of a call, whatever their types, as the library PN_subdivision_3_double reads them.
template <class Access>
class Any_attributes
{
public:
  static constexpr bool is_empty = false;
  static constexpr Level_origins::Kinds visited{};

  template <class Attributes>
  explicit Any_attributes(const Attributes& attributes)
    : attributes_(&attributes)
  {
    if constexpr (!Attributes::is_empty)
      read_ = [](const void* a, const Access& access, const Level_connectivity& level) {
        return static_cast<const Attributes*>(a)->template read<double>(access, level);
      };
  }
  bool is_any() const { return read_ != nullptr; }
  template <class FT>
  Control_attributes<FT> read(const Access& access, const Level_connectivity& level) const
  {
    return read_(attributes_, access, level);
  }

private:
  const void* attributes_;
  Control_attributes<double> (*read_)(const void*, const Access&,
                                      const Level_connectivity&) = nullptr;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CALL_ATTRIBUTES_H
