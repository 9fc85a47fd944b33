// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_NEAR_VERTICES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_NEAR_VERTICES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Curvature_data.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Face_neighbors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The vertices around a vertex of the interior from which a cubic is fitted there: one ring, or two if it
// has less than 12 vertices, where a ring has the vertices that share a face with the ring before. What
// faces the other way belongs to another part of the surface and is not entered.
class Near_vertices
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;
  static constexpr std::size_t capacity = 96;
  static constexpr std::size_t least = 12;

  struct Neighbor
  {
    Index vertex;
    double cosine; // of the angle between the normals
  };

  Near_vertices(const Curvature_data& data, const Face_neighbors& faces)
    : data_(data)
    , faces_(faces)
  {}

  // Whether they have been found: not at the border or next to it, nor where there are too few or too many.
  bool find(Index v)
  {
    ++turn_;
    collisions_ = 0;
    listed_ = 0;
    list(&v, &v + 1);
    normal_ = data_.vertices[v].normal;
    size_ = 0;
    if (!add_ring(v)) return false;
    add_listed(1);
    if (size_ < least) {
      const std::size_t ring = size_, ring_listed = listed_;
      for (std::size_t i = 0; i < ring; ++i)
        if (!add_ring(neighbors_[i].vertex)) return false;
      if (listed_ > capacity) return false;
      add_listed(ring_listed);
    }
    return size_ >= least;
  }

  std::size_t size() const { return size_; }
  const Neighbor& operator[](std::size_t i) const { return neighbors_[i]; }

private:
  // lists the ring of a vertex; false at the border, and where there are too many
  bool add_ring(Index v)
  {
    const Index *const begin = faces_.begin(v), *const end = faces_.end(v);
    const auto length = static_cast<std::size_t>(end - begin);
    if (length == 0 || listed_ + length > capacity) return false;
    const std::size_t old = listed_;
    list(begin, end);
    if (collisions_ != 0) list_again(old, begin, end);
    return true;
  }

  // Lists those that are not in the list, without branches, which would be mispredicted. The table holds the number
  // that was listed last of those with the same remainder; another one there tells of a collision.
  void list(const Index* begin, const Index* end)
  {
    for (; begin != end; ++begin) {
      const std::uint64_t mark = turn_ << 32 | *begin;
      std::uint64_t& last = last_[*begin % last_.size()];
      const std::uint64_t difference = last ^ mark;
      const auto is_new = static_cast<unsigned>(difference != 0);
      collisions_ += is_new & static_cast<unsigned>(difference >> 32 == 0);
      list_[listed_] = *begin;
      listed_ += is_new;
      last = mark;
    }
  }

  // the same by searching, from the end that the list had
  void list_again(std::size_t old, const Index* begin, const Index* end)
  {
    listed_ = old;
    for (; begin != end; ++begin)
      if (std::find(list_.begin(), list_.begin() + std::ptrdiff_t(listed_), *begin) ==
          list_.begin() + std::ptrdiff_t(listed_))
        list_[listed_++] = *begin;
  }

  // takes those from the i-th on
  void add_listed(std::size_t i)
  {
    for (; i < listed_; ++i) {
      const Vector& n = data_.vertices[list_[i]].normal;
      const double cosine = dot<double, 3>(n, normal_);
      if (cosine > 0)
        neighbors_[size_++] = {list_[i], cosine};
      else if (is_zero(n))
        neighbors_[size_++] = {list_[i], 1};
    }
  }

  const Curvature_data& data_;
  const Face_neighbors& faces_;
  Vector normal_;
  std::uint64_t turn_ = 0; // counts the vertices
  unsigned collisions_ = 0;
  std::size_t size_ = 0, listed_ = 0; // how many are taken, and how many have been looked at
  std::array<Neighbor, capacity> neighbors_;
  std::array<Index, capacity + 1> list_;
  std::array<std::uint64_t, 1024> last_{}; // turn and vertex
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_NEAR_VERTICES_H
