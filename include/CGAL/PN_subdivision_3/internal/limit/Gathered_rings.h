// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_GATHERED_RINGS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_GATHERED_RINGS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The valences of some vertices, at most `most_at_once`, isolated ones too. They are found side by side: each step round a
// vertex waits for memory, and the steps round several do so at the same time.
constexpr std::size_t most_at_once = 32;
inline void find_valences(const Level_connectivity& level, const Level_connectivity::Index* begin,
                          std::size_t number, Level_connectivity::Index* valences)
{
  using Index = Level_connectivity::Index;
  Index at[most_at_once] = {};
  std::size_t left = 0;
  std::size_t unfinished[most_at_once]; // those that are not yet gone round
  for (std::size_t i = 0; i < number; ++i) {
    valences[i] = 0;
    if (level.is_isolated(begin[i])) continue;
    at[i] = level.halfedge_of_vertex(begin[i]);
    unfinished[left++] = i;
  }
  while (left != 0) {
    std::size_t still = 0;
    for (std::size_t k = 0; k < left; ++k) {
      const std::size_t i = unfinished[k];
      at[i] = level.next_around_target(at[i]);
      ++valences[i];
      if (at[i] != level.halfedge_of_vertex(begin[i])) unfinished[still++] = i;
    }
    left = still;
  }
}

// Rings of a level on their way to the towers. Values are far from each other in a level: they are asked for when a ring
// is found, and used some rings later, when they have come from memory.
template <class Value, class Vertex>
class Gathered_rings
{
public:
  using Index = Level_connectivity::Index;

  explicit Gathered_rings(const std::vector<Value>& values)
    : values_(values)
  {}

  bool is_full() const { return vertices_.size() == most_at_once; }

  // append(ring) appends the ring of the vertex
  template <class Append>
  void add(const Vertex& vertex, const Append& append)
  {
    const std::size_t begin = ring_.size();
    append(ring_);
    for (std::size_t i = begin; i < ring_.size(); ++i) prefetch(values_[ring_[i]]);
    vertices_.emplace_back(vertex, begin);
  }

  // calls f(vertex, value_of), where value_of(place) is a value of its ring, and is empty again
  template <class Function>
  void take(const Function& f)
  {
    for (const auto& entry : vertices_) {
      const Index* const ring = ring_.data() + entry.second;
      f(entry.first, [&](std::size_t place) -> const Value& { return values_[ring[place]]; });
    }
    vertices_.clear();
    ring_.clear();
  }

private:
  static void prefetch([[maybe_unused]] const Value& value)
  {
#if defined(__GNUC__) // and clang
    __builtin_prefetch(&value);
    __builtin_prefetch(reinterpret_cast<const char*>(&value + 1) - 1);
#endif
  }

  const std::vector<Value>& values_;
  std::vector<Index> ring_;
  std::vector<std::pair<Vertex, std::size_t>> vertices_; // and where their rings begin
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_GATHERED_RINGS_H
