// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_WHOLE_NUMBERING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_WHOLE_NUMBERING_H

#include <CGAL/PN_subdivision_3/hosts/DQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Whole_level.h>

#include <boost/container/vector.hpp>

#include <cstdint>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The numbers that the children of elements have in a level that is not held, from those of their parents.
// The formulas are the hosts' own, in 64 bits. A corner is the face with the ordinal of the corner; of the
// children of a face with a refined border edge see Sqrt3_numbering.
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
  PQQ_numbering<Number, First_corners> numbering_;
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

template <>
class Whole_numbering<Sqrt3_host>
{
public:
  using Number = std::uint64_t;

  explicit Whole_numbering(const Whole_level& level)
    : numbering_(level.size, level.border_faces, faces_of_centers_)
  {}

  Number vertex(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::vertex) return p.index;
    return numbering_.vertex_of_face(p.index) + p.ordinal;
  }
  Number edge(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::edge) return p.index;
    return p.ordinal < 3 ? numbering_.inner_edge(p.index, p.ordinal)
                         : numbering_.last_part(p.index);
  }
  Number face(const Whole_parent& p) const { return numbering_.triangle(p.index, p.ordinal); }

private:
  const boost::container::vector<Number> faces_of_centers_; // for the way back, which is not gone
  Sqrt3_numbering<Number, Some_elements> numbering_;
};

template <>
class Whole_numbering<DQQ_host>
{
public:
  using Number = std::uint64_t;

  explicit Whole_numbering(const Whole_level& level)
    : corners_(level.corners)
    , numbering_(level.size, level.border_edges, level.border_vertices)
  {}

  Number vertex(const Whole_parent& p) const { return corners_.first(p.index) + p.ordinal; }
  Number edge(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::edge) return numbering_.crossing_edge(p.index, p.ordinal);
    return numbering_.edge_of_corner(corners_.first(p.index) + p.ordinal);
  }
  Number face(const Whole_parent& p) const
  {
    if (p.kind == Whole_parent::Kind::face) return numbering_.face_of_face(p.index);
    if (p.kind == Whole_parent::Kind::edge) return numbering_.face_of_edge(p.index);
    return numbering_.face_of_vertex(p.index);
  }

private:
  const First_corners& corners_;
  DQQ_numbering<Number, Some_elements> numbering_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_WHOLE_NUMBERING_H
