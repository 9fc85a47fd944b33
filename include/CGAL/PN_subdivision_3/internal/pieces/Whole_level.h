// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_WHOLE_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_WHOLE_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

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

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_WHOLE_LEVEL_H
