// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_GLOBAL_IDS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_GLOBAL_IDS_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Elements of one kind in a piece: their numbers in the whole level, and whether the piece owns them. Every
// element of the whole level has one owner.
class Global_ids
{
public:
  using Number = std::uint64_t;

  Global_ids() = default;
  explicit Global_ids(std::size_t size)
    : number_(size, boost::container::default_init)
    , is_owned_(size, boost::container::default_init)
  {}

  std::size_t size() const { return number_.size(); }
  Number number(std::size_t i) const { return number_[i]; }
  bool is_owned(std::size_t i) const { return is_owned_[i] != 0; }

  // different elements by different threads
  void set(std::size_t i, Number number, bool is_owned)
  {
    number_[i] = number;
    is_owned_[i] = is_owned ? 1 : 0;
  }

private:
  boost::container::vector<Number> number_;
  boost::container::vector<char> is_owned_;
};

// The elements of a level of a piece, beside its connectivity. In all three kinds the numbers increase.
struct Piece_elements
{
  Global_ids vertices, edges, faces;
};

// The elements of a part of a level, whose elements in the level are `origins`; of a vertex that is there several times the
// first one may be owned.
template <class Elements>
Global_ids elements_of_part(const std::vector<Level_connectivity::Index>& origins,
                            const Elements& whole)
{
  Global_ids part(origins.size());
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const bool is_first = i == 0 || origins[i - 1] != origins[i];
    part.set(i, whole.number(origins[i]), is_first && whole.is_owned(origins[i]));
  }
  return part;
}

// What the numbers of the children of a level depend on, besides their parents.
struct Global_level
{
  Level_size size;
  Face_corners<std::uint64_t> corners;
};

// The numbers that the children of elements have in a level that is not held, from those of their parents.
// The formulas are the hosts' own, in 64 bits. Only hosts that split edges have one: the numbers of others depend on
// the border of the whole level, too.
template <class Host>
class Global_numbering;

using Global_parent = Basic_element_parent<std::uint64_t>;

template <>
class Global_numbering<PQQ_host>
{
public:
  using Number = std::uint64_t;

  explicit Global_numbering(const Global_level& level)
    : numbering_(level.size, level.corners)
  {}

  Number vertex(const Global_parent& p) const
  {
    if (p.kind == Global_parent::Kind::vertex) return p.index;
    if (p.kind == Global_parent::Kind::edge) return numbering_.halves().vertex_of_edge(p.index);
    return numbering_.vertex_of_face(p.index);
  }
  Number edge(const Global_parent& p) const
  {
    if (p.kind == Global_parent::Kind::edge)
      return numbering_.halves().half_of_edge(p.index, p.ordinal);
    return numbering_.spoke(numbering_.first_corner(p.index), p.ordinal);
  }
  Number face(const Global_parent& p) const
  {
    return numbering_.quad(p.index, numbering_.first_corner(p.index), p.ordinal);
  }

private:
  PQQ_numbering<Number> numbering_;
};

template <>
class Global_numbering<PTQ_host>
{
public:
  using Number = std::uint64_t;

  explicit Global_numbering(const Global_level& level)
    : numbering_(level.size)
  {}

  Number vertex(const Global_parent& p) const
  {
    if (p.kind == Global_parent::Kind::vertex) return p.index;
    return numbering_.halves().vertex_of_edge(p.index);
  }
  Number edge(const Global_parent& p) const
  {
    if (p.kind == Global_parent::Kind::edge)
      return numbering_.halves().half_of_edge(p.index, p.ordinal);
    return numbering_.inner_edge(p.index, p.ordinal);
  }
  Number face(const Global_parent& p) const
  {
    if (p.ordinal == 0) return numbering_.middle_triangle(p.index);
    return numbering_.corner_triangle(p.index, p.ordinal - 1);
  }

private:
  PTQ_numbering<Number> numbering_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_GLOBAL_IDS_H
