// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_TRANSFERRED_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_TRANSFERRED_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/numbers/is_interval.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Curvature_transfer.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// of a round whose normals are those of the rows
struct No_transfers
{
  bool is_empty() const { return true; }
  template <class Index, class Value>
  void put(Index, Index, Value*) const
  {}
};

// The normals that a round gives to the rings of its separated vertices by the transfer of curvature.
// The rows of the rings are evaluated for it, besides the round itself, which is not stored in any
// call: a round's values go by in blocks. Rings have no vertex in common, and each has one owner among
// the threads.
template <class FT>
class Transferred_normals
{
public:
  using Index = Level_connectivity::Index;

  // none
  Transferred_normals() = default;

  // evaluate(vertices, how many, values) gives the new vertices their values by the rows.
  template <class Host, class Function>
  Transferred_normals(const Level_connectivity& level, const Host& host,
                      const std::vector<Index>& separated, Index degree,
                      const For_chunks& for_chunks, const Function& evaluate)
  {
    if (separated.empty()) return;
    if constexpr (is_interval_v<FT>)
      throw std::invalid_argument("PN_subdivision_3: the transfer of curvature is computed in "
                                  "double, and its results are not "
                                  "intervals: take another scheme or number type");
    std::vector<std::size_t> begin{0};
    for (const Index v : separated) {
      append_ring(level, host, v);
      begin.push_back(vertices_.size());
    }
    std::vector<Point_normal<FT, 3>> values(vertices_.size());
    std::vector<char> is_changed(separated.size(), 0);
    const Caller_precision<FT> precision;
    for_chunks(static_cast<Index>(separated.size()), [&](Index first, Index last) {
      const typename Caller_precision<FT>::In_this_thread scope(precision);
      std::map<std::size_t, Normal_transfer<FT>> transfers; // for each size of a ring
      std::vector<Point_normal<FT, 3>> ring;
      for (Index i = first; i < last; ++i) {
        const std::size_t size = begin[i + 1] - begin[i];
        ring.resize(size);
        evaluate(&vertices_[begin[i]], static_cast<Index>(size), ring.data());
        auto transfer = transfers.find(size);
        if (transfer == transfers.end())
          transfer =
            transfers.emplace(size, Normal_transfer<FT>(degree, level.valence(separated[i]))).first;
        const auto part = transfer->second(ring);
        if (!part) continue;
        transfer->second.add_half(
          *part, [&](std::size_t j) -> auto& { return ring[j].normal; });
        is_changed[i] = 1;
        std::copy(ring.begin(), ring.end(), values.begin() + static_cast<std::ptrdiff_t>(begin[i]));
      }
    });
    for (std::size_t i = 0; i < separated.size(); ++i)
      if (is_changed[i] != 0)
        for (std::size_t j = begin[i]; j < begin[i + 1]; ++j)
          normals_.emplace_back(vertices_[j], values[j].normal);
    std::vector<Index>().swap(vertices_);
    std::sort(normals_.begin(), normals_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  bool is_empty() const { return normals_.empty(); }
  // into the values of the new vertices [first, first + n)
  void put(Index first, Index n, Point_normal<FT, 3>* values) const
  {
    if (normals_.empty()) return;
    auto it = std::lower_bound(normals_.begin(), normals_.end(), first,
                               [](const auto& a, Index v) { return a.first < v; });
    for (; it != normals_.end() && it->first - first < n; ++it)
      values[it->first - first].normal = it->second;
  }

private:
  // in the order of Ring_functionals
  template <class Host>
  void append_ring(const Level_connectivity& level, const Host& host, Index v)
  {
    vertices_.push_back(v);
    const Index first = level.halfedge_of_vertex(v);
    Index h = first;
    do {
      vertices_.push_back(host.vertex_of_edge(Level_connectivity::edge(h)));
      h = level.next_around_target(h);
    } while (h != first);
    if constexpr (Host::refined_degree == 4) do {
        vertices_.push_back(host.vertex_of_face(level.face(h)));
        h = level.next_around_target(h);
      } while (h != first);
  }

  std::vector<Index> vertices_; // of the rings
  std::vector<std::pair<Index, Coordinates<FT, 3>>> normals_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_TRANSFERRED_NORMALS_H
