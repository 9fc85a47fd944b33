// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_LEVEL_ORIGINS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_LEVEL_ORIGINS_H

#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>

#include <boost/container/vector.hpp>
#include <boost/type_traits/detected_or.hpp>

#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// An element of the control level.
struct Origin
{
  using Kind = Control_element::Kind;

  Kind kind;
  Level_connectivity::Index index;
};

template <class Host>
using Splitting_of = std::bool_constant<Host::splits_edges>;
template <class Host>
using Splits_edges = boost::detected_or_t<std::false_type, Splitting_of, Host>;

// whether vertices remain in the rounds of a host, and edges as their halves
struct Kept_elements
{
  bool vertices, edges;
};
template <class Host>
constexpr Kept_elements kept_elements_v{Host::keeps_vertices, Splits_edges<Host>::value};

// Where the elements of a level come from in the control level.
class Origin_source
{
public:
  using Index = Level_connectivity::Index;

  virtual Origin vertex(Index) const = 0;
  virtual Origin edge(Index) const = 0;
  virtual Origin face(Index) const = 0;

protected:
  ~Origin_source() = default;
};

// The origins of a level that are kept: of elements of every kind that is asked for, and of the kinds that tell the origins a
// round later.
class Level_origins final : public Origin_source
{
public:
  using Kind = Origin::Kind;

  struct Kinds
  {
    bool vertices = false, edges = false, faces = false;
    constexpr bool any() const { return vertices || edges || faces; }
  };

  // the origins of the control level: every element itself
  Level_origins() = default;

  Origin vertex(Index v) const override
  {
    return is_control_ ? Origin{Kind::vertex, v} : vertices_[v];
  }
  Origin edge(Index e) const override { return is_control_ ? Origin{Kind::edge, e} : edges_[e]; }
  Origin face(Index f) const override { return is_control_ ? Origin{Kind::face, f} : faces_[f]; }

  // in a host that splits edges, children of faces have faces as origins, and so on
  static Kinds needed(Kinds wanted, bool splits_edges)
  {
    if (!wanted.any() || !splits_edges) return {wanted.any(), wanted.any(), wanted.any()};
    wanted.edges = wanted.edges || wanted.vertices;
    wanted.faces = true;
    return wanted;
  }

  // the origins of the elements of the child that are needed
  static Level_origins of_child(const Origin_source& rules, const Level_size& child, Kinds kinds,
                                const For_chunks& for_chunks)
  {
    Level_origins result;
    result.is_control_ = false;
    const auto fill = [&](Origins& origins, std::uint64_t number, const auto& origin_of) {
      origins.resize(number, boost::container::default_init);
      for_each_index(for_chunks, static_cast<Index>(number),
                     [&](Index i) { origins[i] = origin_of(i); });
    };
    if (kinds.vertices)
      fill(result.vertices_, child.vertices, [&](Index v) { return rules.vertex(v); });
    if (kinds.edges) fill(result.edges_, child.edges, [&](Index e) { return rules.edge(e); });
    if (kinds.faces) fill(result.faces_, child.faces, [&](Index f) { return rules.face(f); });
    return result;
  }

private:
  using Origins = boost::container::vector<Origin>;

  bool is_control_ = true;
  Origins vertices_, edges_, faces_;
};

// The origins of the children in a round: the origins of their parents; a corner counts as its face.
template <class Host>
class Origin_rules final : public Origin_source
{
public:
  Origin_rules(const Host& host, const Level_connectivity& level, const Level_origins& origins,
               unsigned /*round*/)
    : host_(host)
    , level_(level)
    , origins_(origins)
  {}

  Origin vertex(Index child) const override { return of(host_.parent_of_vertex(child)); }
  Origin edge(Index child) const override { return of(host_.parent_of_edge(child)); }
  Origin face(Index child) const override { return of(host_.parent_of_face(child)); }

private:
  Origin of(const Element_parent& parent) const
  {
    using Kind = Element_parent::Kind;
    switch (parent.kind) {
    case Kind::vertex:
      return origins_.vertex(parent.index);
    case Kind::edge:
      return origins_.edge(parent.index);
    case Kind::border_edge:
      return origins_.edge(Level_connectivity::edge(parent.index));
    case Kind::corner:
      return origins_.face(level_.face(parent.index));
    default:
      return origins_.face(parent.index);
    }
  }

  const Host& host_;
  const Level_connectivity& level_;
  const Level_origins& origins_;
};

// After an odd number of rounds every new triangle lies on both sides of a flipped edge; it counts as a part of
// the face whose half-edge it was at, and the flipped edge as coming from the edge that it crosses. After an even
// number control edges are cut into three, and everything lies on one or inside a face again.
template <>
class Origin_rules<Sqrt3_host> final : public Origin_source
{
public:
  Origin_rules(const Sqrt3_host& host, const Level_connectivity& level,
               const Level_origins& origins, unsigned round)
    : host_(host)
    , level_(level)
    , origins_(origins)
    , is_even_(round % 2 == 0)
  {}

  Origin vertex(Index child) const override
  {
    const Element_parent parent = host_.parent_of_vertex(child);
    if (parent.kind == Kind::vertex) return origins_.vertex(parent.index);
    if (parent.kind == Kind::border_edge) return of_edge_at(parent.index);
    return is_even_ ? of_base(parent.index) : origins_.face(parent.index);
  }

  Origin edge(Index child) const override
  {
    const Element_parent parent = host_.parent_of_edge(child);
    if (parent.kind == Kind::edge) return origins_.edge(parent.index);
    if (parent.kind == Kind::border_edge) return of_edge_at(parent.index);
    const Origin base = of_base(parent.index);
    if (!is_even_ || base.kind == Origin::Kind::face || has_refined_border(parent.index))
      return origins_.face(parent.index);
    // from the middle of the flipped edge to a corner of the triangle
    const Origin corner = origins_.vertex(level_.target(halfedge(parent)));
    return corner.kind == Origin::Kind::face ? corner : base;
  }

  Origin face(Index child) const override
  {
    const Element_parent parent = host_.parent_of_face(child);
    if (!is_even_) return origins_.face(parent.index);
    const Index h = halfedge(parent);
    const Origin side = of_edge_at(h);
    if (side.kind == Origin::Kind::face) return side;
    // at a flipped edge the half towards its target
    const Origin corner = origins_.vertex(level_.target(h));
    if (!level_.is_border_edge(Level_connectivity::edge(h)) && corner.kind == Origin::Kind::face)
      return corner;
    return origins_.face(parent.index);
  }

private:
  using Kind = Element_parent::Kind;

  Origin of_edge_at(Index h) const { return origins_.edge(Level_connectivity::edge(h)); }
  // the origin of the edge that a triangle of an odd round has flipped, or has kept on the border
  Origin of_base(Index f) const { return of_edge_at(level_.halfedge_of_face(f)); }
  bool has_refined_border(Index f) const
  {
    return host_.has_refined_border() &&
           level_.is_border_edge(Level_connectivity::edge(level_.halfedge_of_face(f)));
  }
  Index halfedge(const Element_parent& parent) const
  {
    Index h = level_.halfedge_of_face(parent.index);
    for (Index i = 0; i < parent.ordinal; ++i) h = level_.next(h);
    return h;
  }

  const Sqrt3_host& host_;
  const Level_connectivity& level_;
  const Level_origins& origins_;
  const bool is_even_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_LEVEL_ORIGINS_H
