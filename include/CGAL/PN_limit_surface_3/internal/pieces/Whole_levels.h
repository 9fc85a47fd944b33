// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_WHOLE_LEVELS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_WHOLE_LEVELS_H

#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_extraction.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Whole_level.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <vector>

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

  // all of it must stay
  Child_elements(const Piece_elements& elements, const Host& host, const Whole_level& whole,
                 const For_chunks& for_chunks)
    : elements_(elements)
    , host_(host)
    , numbering_(whole)
    , for_chunks_(for_chunks)
  {}

  Numbered_elements vertices(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_vertex(c); },
      [&](const Whole_parent& p) { return numbering_.vertex(p); });
  }
  Numbered_elements edges(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_edge(c); },
      [&](const Whole_parent& p) { return numbering_.edge(p); });
  }
  Numbered_elements faces(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_face(c); },
      [&](const Whole_parent& p) { return numbering_.face(p); });
  }
  Piece_elements all(const Level_size& size) const
  {
    return {vertices(size.vertices), edges(size.edges), faces(size.faces)};
  }

private:
  using Kind = Element_parent::Kind;

  template <class Parent_of, class Number_of>
  Numbered_elements children(std::size_t size, const Parent_of& parent_of,
                             const Number_of& number) const
  {
    Numbered_elements result(size);
    for_chunks_(static_cast<Index>(size), [&](Index begin, Index end) {
      for (Index c = begin; c < end; ++c) {
        const Element_parent p = parent_of(c);
        const Numbered_elements& parents = p.kind == Kind::vertex ? elements_.vertices
                                           : p.kind == Kind::edge ? elements_.edges
                                                                  : elements_.faces;
        const auto kind = static_cast<Whole_parent::Kind>(p.kind);
        result.set(c, number(Whole_parent{kind, parents.number(p.index), p.ordinal}),
                   parents.is_owned(p.index));
      }
    });
    return result;
  }

  const Piece_elements& elements_;
  const Host& host_;
  Whole_numbering<Host> numbering_;
  const For_chunks& for_chunks_;
};

inline Face_marks owned_faces(const Numbered_elements& faces)
{
  Face_marks is_owned(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) is_owned[f] = faces.is_owned(f) ? 1 : 0;
  return is_owned;
}

// What the numbers of the elements depend on, from a level that is held up to the last one.
template <class Host>
class Whole_levels
{
public:
  // the first level, the number of its round, and that of the last one
  Whole_levels(const Level_connectivity& base, unsigned base_round, unsigned last_round)
    : base_round_(base_round)
  {
    levels_.push_back({base.size(), Face_corners<std::uint64_t>(base)});
    for (unsigned k = base_round + 1; k <= last_round; ++k)
      levels_.push_back({Host::refined_size(levels_.back().size, k),
                         Face_corners<std::uint64_t>(Host::refined_degree)});
  }

  // after round k
  const Whole_level& operator[](unsigned k) const { return levels_[k - base_round_]; }
  const Whole_level& back() const { return levels_.back(); }

private:
  unsigned base_round_;
  std::vector<Whole_level> levels_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_WHOLE_LEVELS_H
