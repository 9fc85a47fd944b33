// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_FACE_CORNERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_FACE_CORNERS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The corners of a level numbered face by face: closed forms if all faces have the same degree, else
// from the first corners of the faces.
template <class Index>
class Face_corners
{
public:
  explicit Face_corners(Index uniform_degree = 0)
    : degree_(uniform_degree)
  {}
  explicit Face_corners(const Level_connectivity& level)
    : degree_(level.uniform_degree())
  {
    if (degree_ != 0) return;
    first_.resize(level.number_of_faces(), boost::container::default_init);
    Index corner = 0;
    for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
      first_[f] = corner;
      corner += level.degree(level.halfedge_of_face(f));
    }
  }

  Index first(Index f) const { return degree_ != 0 ? degree_ * f : first_[f]; }

  // the face of a corner, and which of its corners it is
  std::pair<Index, Index> face_of_corner(Index corner) const
  {
    if (degree_ != 0) return {corner / degree_, corner % degree_};
    const auto next = std::upper_bound(first_.begin(), first_.end(), corner);
    const auto f = static_cast<Index>(next - first_.begin() - 1);
    return {f, corner - first_[f]};
  }
  // the same if the first corner of every face is left out of the numbering; the result is at least 1
  std::pair<Index, Index> face_of_later_corner(Index rank) const
  {
    if (degree_ != 0) return {rank / (degree_ - 1), rank % (degree_ - 1) + 1};
    std::size_t begin = 0, end = first_.size(); // the last face with first_[f] - f <= rank
    while (end - begin > 1) {
      const std::size_t middle = begin + (end - begin) / 2;
      (first_[middle] - middle <= rank ? begin : end) = middle;
    }
    const auto f = static_cast<Index>(begin);
    return {f, rank - (first_[f] - f) + 1};
  }

private:
  Index degree_; // 0 if they differ
  boost::container::vector<Index> first_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_FACE_CORNERS_H
