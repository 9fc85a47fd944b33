// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_PIECE_NUMBERS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_PIECE_NUMBERS_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The numbers of the vertices of a tessellation whose pieces are made one after the other. Those of the control mesh keep
// theirs; the others get the next ones, in the piece that has them first. Of edges of the control mesh between two pieces
// the numbers are kept until the other piece has come.
class Piece_numbers
{
public:
  using Index = Level_connectivity::Index;
  using Number = std::uint64_t;

  explicit Piece_numbers(std::size_t control_vertices)
    : is_given_(control_vertices, false)
    , next_(control_vertices)
  {}

  // so far, with all those of the control mesh
  Number number_of_vertices() const { return next_; }
  std::size_t number_of_open_edges() const { return open_.size(); }

  // whether this piece is the first one with a vertex of the control mesh
  bool give(Index control_vertex)
  {
    if (is_given_[control_vertex]) return false;
    is_given_[control_vertex] = true;
    return true;
  }
  Number next() { return next_++; }

  // Calls f(i, number, is_new) for so many vertices along an edge of the control mesh that is between two pieces, from its
  // first half-edge's source to the target.
  template <class Function>
  void for_edge(Index control_edge, std::size_t vertices, const Function& f)
  {
    const auto it = open_.find(control_edge);
    if (it == open_.end()) {
      std::vector<Number>& numbers = open_[control_edge];
      for (std::size_t i = 0; i < vertices; ++i) numbers.push_back(next());
      for (std::size_t i = 0; i < vertices; ++i) f(i, numbers[i], true);
      return;
    }
    if (it->second.size() != vertices)
      throw std::logic_error("PN_subdivision_3: two pieces of a tessellation do not fit together");
    for (std::size_t i = 0; i < vertices; ++i) f(i, it->second[i], false);
    open_.erase(it);
  }

private:
  std::vector<bool> is_given_;
  Number next_;
  std::unordered_map<Index, std::vector<Number>> open_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_PIECE_NUMBERS_H
