// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_WHOLE_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_WHOLE_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/numberings.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstdint>

namespace CGAL::PN_subdivision_3::internal {

// What the numbers of the children of a level depend on, besides their parents.
struct Whole_level
{
  Level_size size;
  Face_corners<std::uint64_t> corners;
};

// The numbers that the children of elements have in a level that is not held, from those of their parents.
// The formulas are the hosts' own, in 64 bits. Only hosts that split edges have one: the numbers of others depend on
// the border of the whole level, too.
template <class Host>
class Whole_numbering;

using Whole_parent = Basic_element_parent<std::uint64_t>;

template <>
class Whole_numbering<PQQ_host>
{
public:
  using Number = std::uint64_t;

  explicit Whole_numbering(const Whole_level& level)
    : numbering_(level.size, level.corners)
  {}

  Number vertex(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::vertex) return p.index;
    if (p.kind == Whole_parent::Kind::edge) return numbering_.halves().vertex_of_edge(p.index);
    return numbering_.vertex_of_face(p.index);
  }
  Number edge(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::edge)
      return numbering_.halves().half_of_edge(p.index, p.ordinal);
    return numbering_.spoke(numbering_.first_corner(p.index), p.ordinal);
  }
  Number face(const Whole_parent& p) const
  {
    return numbering_.quad(p.index, numbering_.first_corner(p.index), p.ordinal);
  }

private:
  PQQ_numbering<Number> numbering_;
};

template <>
class Whole_numbering<PTQ_host>
{
public:
  using Number = std::uint64_t;

  explicit Whole_numbering(const Whole_level& level)
    : numbering_(level.size)
  {}

  Number vertex(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::vertex) return p.index;
    return numbering_.halves().vertex_of_edge(p.index);
  }
  Number edge(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::edge)
      return numbering_.halves().half_of_edge(p.index, p.ordinal);
    return numbering_.inner_edge(p.index, p.ordinal);
  }
  Number face(const Whole_parent& p) const
  {
    if (p.ordinal == 0) return numbering_.middle_triangle(p.index);
    return numbering_.corner_triangle(p.index, p.ordinal - 1);
  }

private:
  PTQ_numbering<Number> numbering_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_WHOLE_LEVEL_H
