// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_FACE_DIVISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_FACE_DIVISION_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Divides the faces of a level into pieces with about equally many corners, by planes across the longest
// extent of what is divided. The same on all machines: ties go by the numbers of the faces.
class Face_division
{
public:
  using Index = Level_connectivity::Index;
  using Center = std::array<double, 3>;

  // point(v): the coordinates of a vertex, as Center
  template <class Point>
  Face_division(const Level_connectivity& level, std::size_t number_of_pieces, const Point& point)
    : piece_(level.number_of_faces(), 0)
    , centers_(level.number_of_faces())
    , corners_(level.number_of_faces())
  {
    std::vector<Index> faces(level.number_of_faces());
    for (Index f = 0; f < faces.size(); ++f) {
      faces[f] = f;
      const Index first = level.halfedge_of_face(f);
      const double m = level.degree(first);
      corners_[f] = m;
      Center& center = centers_[f];
      center = {0, 0, 0};
      Index h = first;
      do {
        const Center p = point(level.target(h));
        for (std::size_t i = 0; i < 3; ++i) center[i] += p[i] / m;
        h = level.next(h);
      } while (h != first);
    }
    is_uniform_ =
      std::adjacent_find(corners_.begin(), corners_.end(), std::not_equal_to<>()) == corners_.end();
    divide(faces.data(), faces.data() + faces.size(), 0, number_of_pieces);
  }

  std::size_t piece_of_face(Index f) const { return piece_[f]; }

private:
  // into pieces [first, first + number)
  void divide(Index* begin, Index* end, std::size_t first, std::size_t number)
  {
    if (number == 1 || begin == end) {
      for (const Index* f = begin; f != end; ++f) piece_[*f] = first;
      return;
    }
    const std::size_t axis = longest_axis(begin, end);
    const auto is_before = [&](Index f, Index g) {
      return centers_[f][axis] != centers_[g][axis] ? centers_[f][axis] < centers_[g][axis] : f < g;
    };
    if (!is_uniform_) std::sort(begin, end, is_before);
    const std::size_t half = number / 2;
    Index* const middle = end_of_share(begin, end, double(half) / double(number));
    if (is_uniform_ && middle != end) std::nth_element(begin, middle, end, is_before);
    divide(begin, middle, first, half);
    divide(middle, end, first + half, number - half);
  }

  // The order matters only where the faces have different numbers of corners.
  Index* end_of_share(Index* begin, Index* end, double share) const
  {
    double total = 0;
    for (const Index* f = begin; f != end; ++f) total += corners_[*f];
    Index* middle = begin;
    for (double sum = corners_[*middle] / 2; middle != end && sum < total * share;) {
      sum += corners_[*middle] / 2;
      if (++middle != end) sum += corners_[*middle] / 2;
    }
    return middle;
  }

  std::size_t longest_axis(const Index* begin, const Index* end) const
  {
    std::size_t axis = 0;
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      double low = centers_[*begin][i], high = low;
      for (const Index* f = begin; f != end; ++f) {
        low = (std::min)(low, centers_[*f][i]);
        high = (std::max)(high, centers_[*f][i]);
      }
      if (high - low > longest) {
        longest = high - low;
        axis = i;
      }
    }
    return axis;
  }

  std::vector<std::size_t> piece_;
  std::vector<Center> centers_;
  std::vector<double> corners_;
  bool is_uniform_ = false;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_FACE_DIVISION_H
