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

#include <cstddef>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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

// Of the sharpness of a star and its edges, as far as it counts(s) as less than a round; 1 if none does.
template <class FT, class Counts>
double mean_sharpness(const Creases<FT>& creases, const Crease_star& star, const Counts& counts)
{
  double sum = 0;
  int number = 0;
  const auto add = [&](double s) {
    if (!counts(s)) return;
    sum += s;
    ++number;
  };
  add(star.sharpness);
  for (const Crease_end& e : creases.ends_of(star)) add(creases.edge(e).sharpness);
  return number == 0 ? 1 : sum / number;
}

// the weight of a vertex's rule before the round beside that after it: the mean sharpness of what is sharp no
// more after the round, at most 1
template <class FT>
double weight_of_parent_rule(const Creases<FT>& creases, const Crease_star& star)
{
  return mean_sharpness(creases, star,
                        [](double s) { return s > 0 && !(refined_sharpness(s) > 0); });
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

// numbers the wedges as Creases::add_star() does for the ends that remain(end)
template <class FT, class Remains>
Wedge_join join_wedges(const Creases<FT>& creases, const Crease_star& star, const Remains& remains)
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
  for (const Crease_end& e : creases.ends_of(star)) {
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
    add_multiple(result[join.wedge[w]], FT(1), normals[w]);
    ++count[join.wedge[w]];
  }
  for (std::size_t w = 0; w < result.size(); ++w)
    if (count[w] > 1) result[w] = unit_or_zero(result[w], FT(count[w]));
  return result;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_JOIN_WEDGES_H
