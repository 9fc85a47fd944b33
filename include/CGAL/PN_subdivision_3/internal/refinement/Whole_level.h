// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_WHOLE_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_WHOLE_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/DQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/levels/Element_parent.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Some of the elements of a level that may be too large to be held: few, as those at its border are.
class Some_elements
{
public:
  using Number = std::uint64_t;

  Some_elements() = default;
  explicit Some_elements(std::vector<Number> numbers)
    : numbers_(std::move(numbers))
  {
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  }

  bool empty() const { return numbers_.empty(); }
  bool contains(Number i) const { return std::binary_search(numbers_.begin(), numbers_.end(), i); }
  // how many are before i
  Number operator[](Number i) const
  {
    return Number(std::lower_bound(numbers_.begin(), numbers_.end(), i) - numbers_.begin());
  }
  // the rank of i among all others
  Number rank(Number i) const { return i - (*this)[i]; }

private:
  std::vector<Number> numbers_;
};

// The number of the first corner of each face, if corners are counted face by face. The degrees are those of
// a level that is held, and 4 beyond its faces.
class First_corners
{
public:
  using Number = std::uint64_t;

  explicit First_corners(Level_connectivity::Index uniform_degree = 0)
    : degree_(uniform_degree)
  {}
  explicit First_corners(const Level_connectivity& level)
  {
    first_.reserve(std::size_t(level.size().faces) + 1);
    Number corner = 0;
    for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
      first_.push_back(corner);
      corner += level.degree(level.halfedge_of_face(f));
    }
    first_.push_back(corner);
  }

  Number first(Number f) const
  {
    if (degree_ != 0) return degree_ * f;
    const Number held = first_.size() - 1;
    return f <= held ? first_[f] : first_[held] + 4 * (f - held);
  }

private:
  Number degree_ = 0; // 0 if they differ
  std::vector<Number> first_;
};

// What the numbers of the children of a level depend on, besides their parents.
struct Whole_level
{
  Level_size size;
  First_corners corners;
  // found where the numbers depend on them: border faces for sqrt(3), the others for Doo-Sabin
  Some_elements border_faces, border_edges, border_vertices;
};

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

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_WHOLE_LEVEL_H
