// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_RING_TUNING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_RING_TUNING_H

#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// x with its absolute value cut to the bound. Where intervals do not decide, both are nearly equal.
template <class Number>
Number capped(const Number& x, const Number& bound)
{
  const Number opposite = -bound;
  if (CGAL::certainly(bound < x)) return bound;
  if (CGAL::certainly(x < opposite)) return opposite;
  if constexpr (is_interval_v<Number>) { // undecided: an interval that contains both
    if (CGAL::possibly(bound < x)) return interval_around_both(x, bound);
    if (CGAL::possibly(x < opposite)) return interval_around_both(x, opposite);
  }
  return x;
}

// What becomes of the eigenvalues of the ring matrix of a separated vertex, and from which round on.
struct Ring_tuning
{
  Ring_tuning() = default;
  Ring_tuning(const Scheme_parameter& a_cap, unsigned a_first_round, Tuned_valences some_valences)
    : cap(a_cap)
    , first_round(a_first_round)
    , valences(some_valences)
  {
    if (!(cap.to_double() > 0 && cap.to_double() <= 1))
      throw std::invalid_argument(
        "PN_subdivision_3: the cap of a modified scheme must be greater than 0 and at most 1");
    if (first_round == 0)
      throw std::invalid_argument(
        "PN_subdivision_3: the first round of a modified scheme must be at least 1");
  }

  bool holds_in(unsigned round) const { return round >= first_round; }

  // The new value of one that is neither 1 nor lambda. The quadratic ones belong to the surface's quadratic part.
  template <class Number>
  Number other(const Number& eigenvalue, bool is_quadratic, const Number& new_lambda) const
  {
    if (is_quadratic && keeps_quadratic) return new_lambda * new_lambda;
    const Number bound = cap.value<Number>() * new_lambda * new_lambda;
    return capped(eigenvalue, bound);
  }

  Scheme_parameter cap = 0.5;
  unsigned first_round = 1;
  Tuned_valences valences = Tuned_valences::all;
  bool keeps_quadratic = false;
};

// The base of the tuned form of a scheme, which adds its masks.
template <class Scheme>
class Tuned_scheme
{
public:
  using Host = typename Scheme::Host;

  static constexpr unsigned ghost_rings = 3;
  static constexpr Limit_neighborhood limit_neighborhood{
    1, Scheme::limit_neighborhood.takes_border, Scheme::limit_neighborhood.is_spline, false};
  static constexpr const char* parameter_name() { return "cap"; }
  static constexpr double default_parameter() { return 0.5; }
  static constexpr bool has_crease_rules = Scheme::has_crease_rules;

  explicit Tuned_scheme(const Scheme_parameter& cap = default_parameter(), unsigned first_round = 1,
                        Tuned_valences valences = Tuned_valences::all)
    : tuning_(cap, first_round, valences)
  {}
  static typename Scheme::Tuned of_the_paper(const Scheme_parameter& cap = default_parameter())
  {
    return typename Scheme::Tuned(cap, 2, Tuned_valences::diverging);
  }

  unsigned first_round() const { return tuning_.first_round; }
  Tuned_valences valences() const { return tuning_.valences; }

protected:
  Ring_tuning tuning_;
};

// the valence that v counts with, null if that is its own valence
inline const Level_connectivity::Counted_valence* counted_valence(const Level_connectivity& level,
                                                                  Level_connectivity::Index v)
{
  const auto& counted = level.counted_valences(); // in the order of the vertices
  const auto it = std::lower_bound(counted.begin(), counted.end(), v,
                                   [](const auto& c, auto vertex) { return c.vertex < vertex; });
  return it != counted.end() && it->vertex == v ? &*it : nullptr;
}

// The valence of each interior vertex that is not regular; 0 for all other vertices. Counted valences go
// first.
inline std::vector<Level_connectivity::Index> irregular_valences(const Level_connectivity& level,
                                                                 Level_connectivity::Index regular)
{
  // valences are counted, not found by walks round vertices: nearly all are regular
  std::vector<Level_connectivity::Index> irregular(level.number_of_vertices(), 0);
  for (Level_connectivity::Index h = 0; h < level.number_of_halfedges(); ++h)
    ++irregular[level.target(h)];
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
    if (irregular[v] == regular || (irregular[v] != 0 && level.is_border_vertex(v)))
      irregular[v] = 0;
  for (const auto& counted : level.counted_valences())
    irregular[counted.vertex] = counted.valence == regular ? 0 : counted.valence;
  return irregular;
}

// The sum of the squares of the irregular valences.
inline double squared_irregular_valences(const Level_connectivity& level,
                                         Level_connectivity::Index regular)
{
  double sum = 0;
  for (const Level_connectivity::Index n : irregular_valences(level, regular))
    sum += double(n) * double(n);
  return sum;
}

// The sum of the squares of the degrees of the faces that are not quadrilaterals.
inline double squared_irregular_degrees(const Level_connectivity& level)
{
  double sum = 0;
  if (level.uniform_degree() == 4) return sum;
  for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
    const Level_connectivity::Index h = level.halfedge_of_face(f);
    if (level.has_degree(h, 4)) continue;
    const double m = level.degree(h);
    sum += m * m;
  }
  return sum;
}

// Whether all faces at the interior vertex v have the degree, and none has another corner of
// irregular valence.
inline bool is_separated(const Level_connectivity& level, Level_connectivity::Index v,
                         Level_connectivity::Index degree,
                         const std::vector<Level_connectivity::Index>& irregular_valence)
{
  for (const auto h : halfedges_around_target(level, level.halfedge_of_vertex(v))) {
    if (!level.has_degree(h, degree)) return false;
    for (Level_connectivity::Index g = level.next(h); g != h; g = level.next(g))
      if (irregular_valence[level.target(g)] != 0) return false; // also if v occurs again
  }
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
// separated vertex. Vertices of valence 2 keep others from being separated but are never separated
// themselves.
template <class Weights>
class Separated_vertices
{
public:
  using Index = Level_connectivity::Index;

  // no separated vertices
  Separated_vertices() = default;

  // weights(n) makes the weights of valence n, once for every valence that occurs. Vertices of a valence
  // n without has_weights(n) are not separated, but keep others from being separated.
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

  // the separated vertices of at least that valence, in ascending order
  std::vector<Index> vertices(Index least = 1) const
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

// The neighbors of separated vertices of large valence, stored in their order. The row of each of the n edges at
// such a vertex has all n neighbors: walking round the vertex n times takes longer than the averages.
class Long_rings
{
public:
  using Index = Level_connectivity::Index;

  // no rings
  Long_rings() = default;

  template <class Separated>
  Long_rings(const Level_connectivity& level, const Separated& separated)
  {
    for (const Index v : separated.vertices(longest_walked + 1)) rings_.emplace(v, Ring(level, v));
  }

  // calls f(w) for the neighbors of the target of h, clockwise, from the source of h on
  template <class Function>
  void for_each_neighbor(const Level_connectivity& level, Index h, const Function& f) const
  {
    const auto ring = rings_.empty() ? rings_.end() : rings_.find(level.target(h));
    if (ring != rings_.end()) return ring->second.for_each_from(h, f);
    for (const Index g : halfedges_around_target(level, h)) f(level.source(g));
  }

private:
  static constexpr Index longest_walked = 64;

  class Ring
  {
  public:
    Ring(const Level_connectivity& level, Index v)
    {
      for (const Index h : halfedges_around_target(level, level.halfedge_of_vertex(v))) {
        places_.emplace_back(h, neighbors_.size());
        neighbors_.push_back(level.source(h));
      }
      std::sort(places_.begin(), places_.end());
    }

    template <class Function>
    void for_each_from(Index h, const Function& f) const
    {
      const std::size_t place =
        std::lower_bound(places_.begin(), places_.end(), std::pair(h, std::size_t(0)))->second;
      for (std::size_t i = place; i < neighbors_.size(); ++i) f(neighbors_[i]);
      for (std::size_t i = 0; i < place; ++i) f(neighbors_[i]);
    }

  private:
    std::vector<Index> neighbors_;
    std::vector<std::pair<Index, std::size_t>> places_; // of half-edges, in their order
  };

  std::map<Index, Ring> rings_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_RING_TUNING_H
