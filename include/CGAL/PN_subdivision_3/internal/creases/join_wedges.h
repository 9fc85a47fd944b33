// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_JOIN_WEDGES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_JOIN_WEDGES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// few in general
template <class T>
using Short_vector = boost::container::small_vector<T, 4>;

// a dart has the smooth rule
inline bool is_same_rule(Vertex_rule a, Vertex_rule b)
{
  const auto smooth = [](Vertex_rule r) {
    return r == Vertex_rule::dart ? Vertex_rule::smooth : r;
  };
  return smooth(a) == smooth(b);
}

// the weight of a vertex's rule before the round beside that after it: the mean sharpness of what is sharp no
// more after the round, at most 1
template <class FT>
double weight_of_parent_rule(const Creases<FT>& creases, const Crease_star& star)
{
  double sum = 0;
  int number = 0;
  const auto add = [&](double s) {
    if (!(s > 0) || refined_sharpness(s) > 0) return;
    sum += s;
    ++number;
  };
  add(star.sharpness);
  for (Level_connectivity::Index i = 0; i < star.number_of_ends; ++i)
    add(creases.edge(creases.end(star, i)).sharpness);
  return number == 0 ? 1 : sum / number;
}

// Which ends of a star remain, and how the others join its wedges.
struct Wedge_join
{
  using Index = Level_connectivity::Index;

  Short_vector<Index> ends;  // positions among the ends of the star
  Short_vector<Index> wedge; // for every wedge of the star the joined one
  Index number_of_wedges = 1;
  bool has_inner_end = false;
};

template <class FT>
Wedge_join keep_all(const Creases<FT>& creases, const Crease_star& star)
{
  Wedge_join join;
  for (Wedge_join::Index i = 0; i < star.number_of_ends; ++i) {
    join.ends.push_back(i);
    join.has_inner_end = join.has_inner_end || creases.is_inner(creases.end(star, i));
  }
  for (Wedge_join::Index w = 0; w < star.number_of_wedges; ++w) join.wedge.push_back(w);
  join.number_of_wedges = star.number_of_wedges;
  return join;
}

// numbers the wedges as Creases::add_star() numbers those of the ends that remain(end)
template <class FT, class Remains>
Wedge_join keep(const Creases<FT>& creases, const Crease_star& star, const Remains& remains)
{
  using Index = Level_connectivity::Index;
  Wedge_join join;
  Index inner = 0;
  for (Index i = 0; i < star.number_of_ends; ++i)
    if (remains(creases.end(star, i))) {
      join.ends.push_back(i);
      if (creases.is_inner(creases.end(star, i))) ++inner;
    }
  join.has_inner_end = inner != 0;
  if (star.is_border)
    join.number_of_wedges = inner + 1;
  else if (inner != 0)
    join.number_of_wedges = inner;
  join.wedge.assign(star.number_of_wedges, 0);
  // the wedges before the first end that remains end there
  Index wedge = star.is_border ? 0 : join.number_of_wedges - 1, rank = 0;
  for (Index i = 0; i < star.number_of_ends; ++i) {
    const Crease_end& e = creases.end(star, i);
    const Crease_edge<FT>& crease = creases.edge(e);
    if (crease.is_border()) continue;
    if (remains(e)) {
      wedge = star.is_border ? wedge + 1 : rank;
      ++rank;
    }
    join.wedge[star.wedge(crease.after[e.side])] = wedge;
  }
  return join;
}

// The normals of the joined wedges: the unit vectors of their sums. One alone stays as it is.
template <class FT>
std::vector<Coordinates<FT, 3>> join_normals(const std::vector<Coordinates<FT, 3>>& normals,
                                             const Wedge_join& join)
{
  if (join.number_of_wedges == normals.size()) return normals;
  std::vector<Coordinates<FT, 3>> result(join.number_of_wedges, zero_vector<FT, 3>());
  Short_vector<int> count(join.number_of_wedges, 0);
  for (std::size_t w = 0; w < normals.size(); ++w) {
    add_multiple<FT, 3>(result[join.wedge[w]], FT(1), normals[w]);
    ++count[join.wedge[w]];
  }
  for (std::size_t w = 0; w < result.size(); ++w)
    if (count[w] > 1) result[w] = unit_or_zero<FT, 3>(result[w], FT(count[w]));
  return result;
}

// The normals of the wedges of one vertex as a round reads them, where creases run out in this round.
//
// Crease edge e couples its wedges by c_e = 1 - min(1, s_e). The normal of wedge w becomes the unit
// vector of the sum of kappa_wx n_x over all wedges x, kappa_wx = 1 - (1 - P)(1 - P'), P and P' the
// products of the couplings passed on the way from w to x going one and the other way round. The
// border passes nothing.
//
// Since P P' is the product of all couplings, kappa_wx = P + P' - P P', and the sums over the P and
// those over the P' follow from wedge to wedge: linear in the number of wedges.
template <class FT>
class Soften_normals
{
public:
  using Vector = Coordinates<FT, 3>;

  // normals[w] of wedge w; coupling[w] between wedge w - 1, cyclically, and wedge w
  void operator()(std::vector<Vector>& normals, const std::vector<FT>& coupling)
  {
    const std::size_t m = normals.size();
    sum_.assign(m, zero_vector<FT, 3>());
    FT all(1);
    Vector total = zero_vector<FT, 3>();
    for (std::size_t w = 0; w < m; ++w) {
      all *= coupling[w];
      add_multiple<FT, 3>(total, FT(1), normals[w]);
    }
    add_one_way(
      normals, [&](std::size_t w) { return (w + 1) % m; },
      [&](std::size_t w) { return coupling[(w + 1) % m]; }, all);
    add_one_way(
      normals, [&](std::size_t w) { return (w + m - 1) % m; },
      [&](std::size_t w) { return coupling[w]; }, all);
    for (std::size_t w = 0; w < m; ++w) {
      // P P' belongs to all other wedges
      add_multiple<FT, 3>(sum_[w], FT(-all), total);
      add_multiple<FT, 3>(sum_[w], FT(FT(1) + all), normals[w]);
    }
    for (std::size_t w = 0; w < m; ++w) normals[w] = unit_or_zero<FT, 3>(sum_[w], FT(int(m)));
  }

private:
  // adds to every sum those of P n_x over the others, where `passed(w)` is between w and next(w)
  template <class Next, class Passed>
  void add_one_way(const std::vector<Vector>& normals, const Next& next, const Passed& passed,
                   const FT& all)
  {
    // that of wedge 0 first: c_0 (n_1 + c_1 (n_2 + ...))
    Vector f = zero_vector<FT, 3>();
    order_.clear();
    for (std::size_t w = next(0); w != 0; w = next(w)) order_.push_back(w);
    for (auto w = order_.rbegin(); w != order_.rend(); ++w) {
      add_multiple<FT, 3>(f, FT(1), normals[*w]);
      const std::size_t before = w + 1 == order_.rend() ? 0 : *(w + 1);
      scale<FT, 3>(f, passed(before));
    }
    add_multiple<FT, 3>(sum_[0], FT(1), f);
    // then backward: all of the way round leads to the wedge itself, which is no other one
    std::size_t after = 0;
    for (auto w = order_.rbegin(); w != order_.rend(); ++w) {
      add_multiple<FT, 3>(f, FT(1), normals[after]);
      scale<FT, 3>(f, passed(*w));
      add_multiple<FT, 3>(f, FT(-all), normals[*w]);
      add_multiple<FT, 3>(sum_[*w], FT(1), f);
      after = *w;
    }
  }

  std::vector<Vector> sum_;
  std::vector<std::size_t> order_;
};

// whether a crease of the star runs out in this round with less than its full weight
template <class FT>
bool is_softened(const Creases<FT>& creases, const Crease_star& star)
{
  if (star.number_of_wedges == 1) return false;
  for (Level_connectivity::Index i = 0; i < star.number_of_ends; ++i)
    if (creases.edge(creases.end(star, i)).sharpness < 1) return true;
  return false;
}

// calls set_normal(slot, n) for the slots of the star, given normal(slot)
template <class FT, class Normal_of, class Set_normal>
void soften_normals(const Creases<FT>& creases, const Crease_star& star, const Normal_of& normal,
                    const Set_normal& set_normal)
{
  using Index = Level_connectivity::Index;
  std::vector<Coordinates<FT, 3>> normals;
  for (Index w = 0; w < star.number_of_wedges; ++w) normals.push_back(normal(star.slot(w)));
  std::vector<FT> coupling(star.number_of_wedges, FT(0));
  for (Index i = 0; i < star.number_of_ends; ++i) {
    const Crease_end& e = creases.end(star, i);
    const Crease_edge<FT>& crease = creases.edge(e);
    if (!crease.is_border() && crease.sharpness < 1)
      coupling[star.wedge(crease.after[e.side])] = FT(1) - FT(crease.sharpness);
  }
  Soften_normals<FT>()(normals, coupling);
  for (Index w = 0; w < star.number_of_wedges; ++w) set_normal(star.slot(w), normals[w]);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_JOIN_WEDGES_H
