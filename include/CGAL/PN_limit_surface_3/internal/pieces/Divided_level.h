// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_DIVIDED_LEVEL_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_DIVIDED_LEVEL_H

#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Divides the faces of a level into pieces with about equally many corners, by planes across the longest
// extent of what is divided. The same on all machines: ties go by the numbers of the faces.
class Face_division
{
public:
  using Index = Level_connectivity::Index;
  using Center = std::array<double, 3>;

  // point(v): the coordinates of a vertex, as Center
  Face_division(const Level_connectivity& level, std::size_t number_of_pieces,
                Function_ref<Center(Index)> point)
    : piece_(level.number_of_faces(), 0)
  {
    std::vector<Face> faces(level.number_of_faces());
    for (Index f = 0; f < faces.size(); ++f) {
      const Index first = level.halfedge_of_face(f);
      const double m = level.degree(first);
      Center center{0, 0, 0};
      for (const Index h : halfedges_around_face(level, first)) {
        const Center p = point(level.target(h));
        for (std::size_t i = 0; i < 3; ++i) center[i] += p[i] / m;
      }
      faces[f] = {center, m, f};
    }
    const auto differs = [](const Face& f, const Face& g) { return f.corners != g.corners; };
    is_uniform_ = std::adjacent_find(faces.begin(), faces.end(), differs) == faces.end();
    divide(faces.data(), faces.data() + faces.size(), 0, number_of_pieces);
  }

  std::size_t piece_of_face(Index f) const { return piece_[f]; }

private:
  // moved as a whole: what is looked at lies in a row
  struct Face
  {
    Center center;
    double corners;
    Index number;
  };

  // into pieces [first, first + number)
  void divide(Face* begin, Face* end, std::size_t first, std::size_t number)
  {
    if (number == 1 || begin == end) {
      for (const Face* f = begin; f != end; ++f) piece_[f->number] = first;
      return;
    }
    const std::size_t axis = longest_axis(begin, end);
    const auto is_before = [axis](const Face& f, const Face& g) {
      return f.center[axis] != g.center[axis] ? f.center[axis] < g.center[axis]
                                              : f.number < g.number;
    };
    if (!is_uniform_) std::sort(begin, end, is_before);
    const std::size_t half = number / 2;
    Face* const middle = end_of_share(begin, end, double(half) / double(number));
    if (is_uniform_ && middle != end) std::nth_element(begin, middle, end, is_before);
    divide(begin, middle, first, half);
    divide(middle, end, first + half, number - half);
  }

  // The order matters only where the faces have different numbers of corners.
  Face* end_of_share(Face* begin, Face* end, double share) const
  {
    if (is_uniform_) return end_of_uniform_share(begin, end, share);
    double total = 0;
    for (const Face* f = begin; f != end; ++f) total += f->corners;
    Face* middle = begin;
    for (double sum = middle->corners / 2; middle != end && sum < total * share;) {
      sum += middle->corners / 2;
      if (++middle != end) sum += middle->corners / 2;
    }
    return middle;
  }
  // the same sums, which are exact
  static Face* end_of_uniform_share(Face* begin, Face* end, double share)
  {
    const double m = begin->corners, wanted = double(end - begin) * m * share;
    auto i = static_cast<std::ptrdiff_t>(wanted / m - 0.5);
    while (i > 0 && m / 2 + double(i - 1) * m >= wanted) --i;
    while (begin + i != end && m / 2 + double(i) * m < wanted) ++i;
    return begin + i;
  }

  static std::size_t longest_axis(const Face* begin, const Face* end)
  {
    Center low = begin->center, high = low;
    for (const Face* f = begin; f != end; ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], f->center[i]);
        high[i] = (std::max)(high[i], f->center[i]);
      }
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    return axis;
  }

  std::vector<std::size_t> piece_;
  bool is_uniform_ = false;
};

// Which elements of a level each piece owns: its faces, listed once, so that no piece looks through the level, and
// what follows from them.
class Divided_level
{
public:
  using Index = Level_connectivity::Index;

  // point(v) as for Face_division; the level must stay
  Divided_level(const Level_connectivity& level, std::size_t number_of_pieces,
                Function_ref<Face_division::Center(Index)> point)
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
  }

  // the faces of a piece, in increasing order
  const Index* begin(std::size_t piece) const
  {
    return faces_by_piece_.data() + first_of_piece_[piece];
  }
  const Index* end(std::size_t piece) const { return begin(piece + 1); }
  // all isolated vertices belong to the first piece
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_DIVIDED_LEVEL_H
