// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_CHILD_ELEMENTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_CHILD_ELEMENTS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Piece_extraction.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Whole_numbering.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The elements of the child of a level of a piece: their numbers follow from those of their parents, and who
// owns a parent owns its children.
template <class Host>
class Child_elements
{
public:
  using Index = Level_connectivity::Index;
  using Number = Numbered_elements::Number;

  // all of it must stay
  Child_elements(const Level_connectivity& level, const Piece_elements& elements, const Host& host,
                 const Whole_level& whole, const For_chunks& for_chunks)
    : level_(level)
    , elements_(elements)
    , host_(host)
    , numbering_(whole)
    , for_chunks_(for_chunks)
  {}

  Numbered_elements vertices(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_vertex(c); },
      [&](const Whole_parent& p) { return numbering_.vertex(p); }, 0);
  }
  Numbered_elements edges(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_edge(c); },
      [&](const Whole_parent& p) { return numbering_.edge(p); }, 1);
  }
  Numbered_elements faces(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_face(c); },
      [&](const Whole_parent& p) { return numbering_.face(p); }, 0);
  }
  Piece_elements all(const Level_size& size) const
  {
    return {vertices(size.vertices), edges(size.edges), faces(size.faces)};
  }

private:
  using Kind = Element_parent::Kind;
  using Whole_kind = Whole_parent::Kind;

  struct Origin
  {
    Whole_parent parent;
    bool is_owned;
  };

  template <class Parent_of, class Number_of>
  Numbered_elements children(std::size_t size, const Parent_of& parent_of, const Number_of& number,
                             Index border_ordinal) const
  {
    Numbered_elements result(size);
    for_chunks_(static_cast<Index>(size), [&](Index begin, Index end) {
      for (Index c = begin; c < end; ++c) {
        const Origin o = origin(parent_of(c), border_ordinal);
        if (o.parent.index == Numbered_elements::no_number)
          result.set(c, Numbered_elements::no_number, false);
        else
          result.set(c, number(o.parent), o.is_owned);
      }
    });
    return result;
  }

  static Origin origin_in(const Numbered_elements& of, Index i, Whole_kind kind, Index ordinal)
  {
    return {{kind, of.number(i), ordinal}, of.is_owned(i)};
  }

  Origin origin(const Element_parent& p, Index border_ordinal) const
  {
    switch (p.kind) {
    case Kind::vertex:
      return origin_in(elements_.vertices, p.index, Whole_kind::vertex, p.ordinal);
    case Kind::edge:
      return origin_in(elements_.edges, p.index, Whole_kind::edge, p.ordinal);
    case Kind::face:
      return origin_in(elements_.faces, p.index, Whole_kind::face, p.ordinal);
    case Kind::corner:
      return origin_in_corner(p.index);
    default:
      return origin_in_border_edge(p, border_ordinal);
    }
  }

  Origin origin_in_corner([[maybe_unused]] Index h) const
  {
    if constexpr (std::is_same_v<Host, DQQ_host>) {
      const Index f = level_.face(h), first = level_.halfedge_of_face(f);
      return origin_in(elements_.faces, f, Whole_kind::corner,
                       host_.vertex_of_corner(h) - host_.vertex_of_corner(first));
    } else
      return {{Whole_kind::corner, Numbered_elements::no_number}, false};
  }

  // The first part of a refined border edge has the number of the edge, all else those of the face. The parts
  // are numbered behind its inner edges.
  Origin origin_in_border_edge(const Element_parent& p, Index border_ordinal) const
  {
    if (border_ordinal != 0 && p.ordinal == 0)
      return origin_in(elements_.edges, Level_connectivity::edge(p.index), Whole_kind::edge, 0);
    return origin_in(elements_.faces, level_.face(p.index), Whole_kind::face,
                     p.ordinal + border_ordinal);
  }

  const Level_connectivity& level_;
  const Piece_elements& elements_;
  const Host& host_;
  Whole_numbering<Host> numbering_;
  const For_chunks& for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_CHILD_ELEMENTS_H
