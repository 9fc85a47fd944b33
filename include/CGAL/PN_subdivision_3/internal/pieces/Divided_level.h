// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_DIVIDED_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_DIVIDED_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Face_division.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Which elements of a level each piece owns: its faces, listed once, so that no piece looks through the level, and
// what follows from them.
class Divided_level
{
public:
  using Index = Level_connectivity::Index;

  // point(v) as for Face_division; the level must stay
  template <class Point>
  Divided_level(const Level_connectivity& level, std::size_t number_of_pieces, const Point& point)
    : level_(level)
    , piece_of_face_(level.number_of_faces())
    , faces_by_piece_(level.number_of_faces())
    , first_of_piece_(number_of_pieces + 1, 0)
    , first_face_(level.number_of_vertices(), Level_connectivity::null)
  {
    list_faces(Face_division(level, number_of_pieces, point));
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (!level.is_border(h)) {
        Index& first = first_face_[level.target(h)];
        first = (std::min)(first, level.face(h));
      }
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (level.is_isolated(v)) isolated_vertices_.push_back(v);
    // where sqrt(3) refines the border other faces lose the vertex to their neighbors
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (level.is_border(h))
        first_face_[level.target(h)] = level.face(Level_connectivity::opposite(h));
  }

  // the faces of a piece, in increasing order
  const Index* begin(std::size_t piece) const
  {
    return faces_by_piece_.data() + first_of_piece_[piece];
  }
  const Index* end(std::size_t piece) const { return begin(piece + 1); }
  // all of them belong to the first piece
  const std::vector<Index>& isolated_vertices() const { return isolated_vertices_; }

  bool owns_face(std::size_t piece, Index f) const { return piece_of_face_[f] == piece; }
  bool owns_edge(std::size_t piece, Index e) const // null is the greatest number
  {
    return owns_face(piece, (std::min)(level_.face(2 * e), level_.face(2 * e + 1)));
  }
  bool owns_vertex(std::size_t piece, Index v) const
  {
    return level_.is_isolated(v) ? piece == 0 : owns_face(piece, first_face_[v]);
  }

private:
  void list_faces(const Face_division& division)
  {
    const Index faces = level_.number_of_faces();
    for (Index f = 0; f < faces; ++f) {
      piece_of_face_[f] = division.piece_of_face(f);
      ++first_of_piece_[piece_of_face_[f] + 1];
    }
    std::partial_sum(first_of_piece_.begin(), first_of_piece_.end(), first_of_piece_.begin());
    std::vector<Index> next(first_of_piece_.begin(), first_of_piece_.end() - 1);
    for (Index f = 0; f < faces; ++f) faces_by_piece_[next[piece_of_face_[f]]++] = f;
  }

  const Level_connectivity& level_;
  std::vector<std::size_t> piece_of_face_;
  std::vector<Index> faces_by_piece_, first_of_piece_;
  std::vector<Index> first_face_; // the face that decides on the piece of each vertex
  std::vector<Index> isolated_vertices_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_DIVIDED_LEVEL_H
