// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_LIMIT_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_LIMIT_H

#include "analysis/Extraordinary_net.h"

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Ring_functionals.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Left eigenvectors of Catmull-Clark and Loop subdivision at a vertex of any valence, over its
// 1-ring: that of 1, the limit mask, and the complex one of the subdominant eigenvalue. Tuned rules
// with the same eigenvectors share them.
template <class FT>
class Extraordinary_limit
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<FT, 3>;

  explicit Extraordinary_limit(const Extraordinary_net& net)
  {
    const Index n = net.valence();
    const Ring_functionals<FT> ring(net.degree(), n);
    const auto add = [&](Index v, Index place) {
      entries_.push_back(
        {v, ring.limit()[place].weight, {ring.tangent(0)[place], ring.tangent(1)[place]}});
    };
    add(0, 0);
    for (Index s = 0; s < n; ++s) {
      add(net.vertex(s, 1, 0), 1 + s);
      if (net.degree() == 4) add(net.vertex(s, 1, 1), 1 + n + s);
    }
  }

  // The limit point and the limit control normal, zero without control normals: the PN average.
  Value limit(const std::vector<Value>& values) const
  {
    const Entry* const first = entries_.data();
    return PN_average<FT, 3>{FT(1)}(first, first + entries_.size(), values.data());
  }

  // applies the tangent mask to f(value), a scalar
  template <class Function>
  Pair<FT> tangent(const std::vector<Value>& values, const Function& f) const
  {
    Pair<FT> t{};
    for (const Entry& e : entries_) {
      const FT x = f(values[e.vertex]);
      t[0] += e.tangent[0] * x;
      t[1] += e.tangent[1] * x;
    }
    return t;
  }

private:
  struct Entry
  {
    Index vertex;
    FT weight;        // of the limit mask
    Pair<FT> tangent; // real and imaginary part
  };

  std::vector<Entry> entries_;
};

template <class Host, class = void>
struct Has_edge_vertices : std::false_type
{};
template <class Host>
struct Has_edge_vertices<Host,
                         std::void_t<decltype(std::declval<const Host&>().vertex_of_edge(0u))>>
  : std::true_type
{};

// A net about an extraordinary vertex, and a round of a scheme on it followed by a crop to a net of
// another number of rings. The connectivity is that of every level alike.
template <class Scheme, class FT>
class Zoom_level
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<FT, 3>;
  using Values = std::vector<Value>;

  static constexpr Index degree = Scheme::Host::refined_degree;

  static_assert(
    Has_edge_vertices<typename Scheme::Host>::value && (degree == 3 || degree == 4),
    "Only schemes that split every edge into two (their host is PQQ_host or PTQ_host) can be "
    "measured at extraordinary vertices");

  Zoom_level(const Scheme& scheme, Index valence, Index rings)
    : net_(degree, valence, rings)
    , level_(net_.level())
    , round_(scheme, level_, facts_of(scheme).first_round)
  {}
  // the round refers to the level
  Zoom_level(const Zoom_level&) = delete;
  Zoom_level& operator=(const Zoom_level&) = delete;

  const Extraordinary_net& net() const { return net_; }
  const Level_connectivity& level() const { return level_; }

  // the new vertex that has each place of the smaller or larger net `to`
  std::vector<Index> children(const Extraordinary_net& to) const
  {
    std::vector<Index> child(to.number_of_vertices());
    const auto set = [&](Index s, Index i, Index j, Index v) {
      if (to.norm(i, j) <= to.rings()) child[to.vertex(s, i, j)] = v;
    };
    const auto& host = round_.host();
    for (Index f = 0; f < net_.faces().size(); ++f) {
      const auto& [s, corners] = net_.faces()[f];
      Index h = level_.halfedge_of_face(f);
      std::array<Index, 2> sum{};
      for (Index k = 0; k < degree; ++k, h = level_.next(h)) {
        const auto& [i, j] = corners[k];
        const auto& [next_i, next_j] = corners[(k + 1) % degree];
        set(s, 2 * i, 2 * j, level_.source(h));
        set(s, i + next_i, j + next_j, host.vertex_of_edge(Level_connectivity::edge(h)));
        sum = {sum[0] + i, sum[1] + j};
      }
      if constexpr (degree == 4) set(s, sum[0] / 2, sum[1] / 2, host.vertex_of_face(f));
    }
    return child;
  }

  // the round, and of its vertices those of `child`
  Values refined(const Values& values, const std::vector<Index>& child) const
  {
    Values all(round_.refined_size().vertices);
    round_.evaluate(0, static_cast<Index>(all.size()), values.data(),
                    round_.transfers(values.data(), For_chunks()),
                    [&](Index first, const Value* v, Index n) {
                      std::copy(v, v + n, all.begin() + static_cast<std::ptrdiff_t>(first));
                    });
    Values result(child.size());
    for (std::size_t v = 0; v < child.size(); ++v) result[v] = all[child[v]];
    return result;
  }

private:
  using Plain_round = Round<Scheme, PN_average<FT, 3>>;

  Extraordinary_net net_;
  Level_connectivity level_;
  Plain_round round_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_LIMIT_H
