// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SEPARATED_VERTICES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SEPARATED_VERTICES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>

#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Whether all faces at the interior vertex v have the degree, and none has another corner of
// irregular valence.
inline bool is_separated(const Level_connectivity& level, Level_connectivity::Index v,
                         Level_connectivity::Index degree,
                         const std::vector<Level_connectivity::Index>& irregular_valence)
{
  const Level_connectivity::Index first = level.halfedge_of_vertex(v);
  Level_connectivity::Index h = first;
  do {
    if (!level.has_degree(h, degree)) return false;
    for (Level_connectivity::Index g = level.next(h); g != h; g = level.next(g))
      if (irregular_valence[level.target(g)] != 0) return false; // also if v occurs again
    h = level.next_around_target(h);
  } while (h != first);
  return true;
}

// The sum of the squares of the valences of the separated vertices.
inline double squared_separated_valences(const Level_connectivity& level,
                                         Level_connectivity::Index regular_valence,
                                         Level_connectivity::Index degree)
{
  const auto valence = irregular_valences(level, regular_valence);
  double sum = 0;
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
    if (valence[v] > 2 && is_separated(level, v, degree, valence))
      sum += double(valence[v]) * double(valence[v]);
  return sum;
}

// The separated vertices of a level: the extraordinary ones about which a modified scheme replaces
// the rules of the plain scheme, with weights that depend on their valence. A face has at most one
// of them. Vertices of valence 2 keep others from being separated but are never separated
// themselves.
template <class Weights>
class Separated_vertices
{
public:
  using Index = Level_connectivity::Index;

  // none
  Separated_vertices() = default;

  // weights(n) makes those of valence n; it is called once for every valence that occurs. Vertices of
  // a valence n that is not has_weights(n) keep others from being separated all the same.
  template <class Function, class Predicate>
  Separated_vertices(const Level_connectivity& level, Index regular_valence, Index degree,
                     const Function& weights, const Predicate& has_weights)
    : valence_(irregular_valences(level, regular_valence))
  {
    std::vector<Index> separated, others;
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (valence_[v] != 0) {
        const bool is_one = valence_[v] > 2 && has_weights(valence_[v]) &&
                            counted_valence(level, v) == nullptr &&
                            is_separated(level, v, degree, valence_);
        (is_one ? separated : others).push_back(v);
      }
    for (Index v : others) valence_[v] = 0;
    for (Index v : separated)
      if (weights_.find(valence_[v]) == weights_.end())
        weights_.emplace(valence_[v], weights(valence_[v]));
    if (separated.empty()) valence_.clear();
  }

  // in ascending order
  std::vector<Index> vertices() const
  {
    std::vector<Index> result;
    for (Index v = 0; v < valence_.size(); ++v)
      if (valence_[v] != 0) result.push_back(v);
    return result;
  }

  // those of at least that valence
  std::vector<Index> vertices_of_valence(Index least) const
  {
    std::vector<Index> result;
    if (weights_.empty() || weights_.rbegin()->first < least) return result;
    for (Index v = 0; v < valence_.size(); ++v)
      if (valence_[v] >= least) result.push_back(v);
    return result;
  }

  // the weights about v, null if it is not separated
  const Weights* at(Index v) const
  {
    if (valence_.empty() || valence_[v] == 0) return nullptr;
    return &weights_.find(valence_[v])->second;
  }

  // the half-edge of e that leads to a separated vertex and the weights about that vertex, null if neither
  // end is separated
  std::pair<Index, const Weights*> at_edge(const Level_connectivity& level, Index e) const
  {
    const Index h = Level_connectivity::halfedge_of_edge(e);
    for (const Index g : {h, Level_connectivity::opposite(h)})
      if (const Weights* const w = at(level.target(g))) return {g, w};
    return {h, nullptr};
  }

private:
  std::vector<Index> valence_; // 0: not separated
  std::map<Index, Weights> weights_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SEPARATED_VERTICES_H
