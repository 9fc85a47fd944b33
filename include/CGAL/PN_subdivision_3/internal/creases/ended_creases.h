// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ENDED_CREASES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ENDED_CREASES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// for few elements in general
template <class T>
using Short_vector = boost::container::small_vector<T, 4>;

// a dart has the smooth rule
inline bool is_smooth(Vertex_rule r)
{
  return r == Vertex_rule::smooth || r == Vertex_rule::dart;
}
inline bool is_same_rule(Vertex_rule a, Vertex_rule b)
{
  return a == b || (is_smooth(a) && is_smooth(b));
}

// The mean of each sharpness s of a star and of its edges for which counts(s) is true; 1 if there is none.
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
  for (const Crease_halfedge& e : creases.ends_of(star)) add(creases.edge(e).sharpness);
  return number == 0 ? 1 : sum / number;
}

// the weight of a vertex's rule before the round, beside the rule after it: the mean sharpness of what the round makes smooth
template <class FT>
double weight_of_parent_rule(const Creases<FT>& creases, const Crease_star& star)
{
  return mean_sharpness(creases, star,
                        [](double s) { return s > 0 && !(refined_sharpness(s) > 0); });
}

// Whether the vertex of a star has a smooth rule before a round or, where sharp and smooth rules are mixed (rules_fade), after it.
template <class FT>
bool has_smooth_rule(const Creases<FT>& creases, const Refined_creases<FT>& refined,
                     const Crease_star& star, bool rules_fade)
{
  if (is_smooth(creases.rule(star))) return true;
  if (!rules_fade) return false;
  const auto child = refined.star[std::size_t(&star - creases.stars.data())];
  return child == Level_connectivity::null ||
         is_smooth(refined.creases.rule(refined.creases.stars[child]));
}

// whether any vertex has one, or an edge
template <class FT>
bool has_smooth_rules(const Creases<FT>& creases, const Refined_creases<FT>& refined,
                      bool rules_fade)
{
  for (const Crease_star& s : creases.stars)
    if (has_smooth_rule(creases, refined, s, rules_fade)) return true;
  return rules_fade && std::any_of(creases.edges.begin(), creases.edges.end(),
                                   [](const Crease_edge<FT>& e) { return e.sharpness < 1; });
}

// Which ends of a star remain, and how its wedges are merged where other ends were.
struct Wedge_merge
{
  using Index = Level_connectivity::Index;

  Short_vector<Index> ends;  // positions among the ends of the star
  Short_vector<Index> wedge; // for every wedge of the star the merged wedge
  Index number_of_wedges = 1;
  bool has_inner_end = false;
};

// numbers the merged wedges as Creases::add_star() does, for the ends with remains(end)
template <class FT>
Wedge_merge merge_wedges(const Creases<FT>& creases, const Crease_star& star,
                         Function_ref<bool(const Crease_halfedge&)> remains)
{
  using Index = Level_connectivity::Index;
  Wedge_merge merge;
  Index inner = 0;
  for (Index i = 0; i < star.number_of_ends; ++i)
    if (remains(creases.end(star, i))) {
      merge.ends.push_back(i);
      if (creases.is_inner(creases.end(star, i))) ++inner;
    }
  merge.has_inner_end = inner != 0;
  if (star.is_border)
    merge.number_of_wedges = inner + 1;
  else if (inner != 0)
    merge.number_of_wedges = inner;
  merge.wedge.assign(star.number_of_wedges, 0);
  // the wedges before the first remaining end belong to the merged wedge that ends there
  Index wedge = star.is_border ? 0 : merge.number_of_wedges - 1, rank = 0;
  for (const Crease_halfedge& e : creases.ends_of(star)) {
    const Crease_edge<FT>& crease = creases.edge(e);
    if (crease.is_border()) continue;
    if (remains(e)) {
      wedge = star.is_border ? wedge + 1 : rank;
      ++rank;
    }
    merge.wedge[star.wedge(crease.after[e.side])] = wedge;
  }
  return merge;
}

// The normals of the merged wedges: unit vectors of sums of normals. A wedge that merges with no other keeps its normal.
template <class FT>
std::vector<Coordinates<FT, 3>> merge_normals(const std::vector<Coordinates<FT, 3>>& normals,
                                              const Wedge_merge& merge)
{
  if (merge.number_of_wedges == normals.size()) return normals;
  std::vector<Coordinates<FT, 3>> result(merge.number_of_wedges, zero_vector<FT, 3>());
  Short_vector<int> count(merge.number_of_wedges, 0);
  for (std::size_t w = 0; w < normals.size(); ++w) {
    add_multiple(result[merge.wedge[w]], FT(1), normals[w]);
    ++count[merge.wedge[w]];
  }
  for (std::size_t w = 0; w < result.size(); ++w)
    if (count[w] > 1) result[w] = unit_or_zero(result[w], FT(count[w]));
  return result;
}

// Calls f(half-edge, wedge) for the corners at a star that has ends.
template <class FT, class Function>
void for_each_corner_of_star(const Level_connectivity& level, const Creases<FT>& creases,
                             const Crease_star& star, const Function& f)
{
  using Index = Level_connectivity::Index;
  const Index first = star.is_border
                        ? level.next_around_target(level.halfedge_of_vertex(star.vertex))
                        : creases.halfedge(creases.end(star, 0));
  Index wedge = 0, i = 0;
  for (const Index h : halfedges_around_target(level, first)) {
    if (i < star.number_of_ends && creases.halfedge(creases.end(star, i)) == h) {
      const Crease_halfedge& e = creases.end(star, i++);
      if (creases.edge(e).has_after(e.side)) wedge = star.wedge(creases.edge(e).after[e.side]);
    }
    if (!level.is_border(h)) f(h, wedge);
  }
}

// Calls f(half-edge, merged wedge, s) for the corners of wedges that are merged over edges of a star that end, in faces that
// touch such an edge. s is the least sharpness of these edges.
template <class FT>
void for_each_corner_at_ended(
  const Level_connectivity& level, const Creases<FT>& creases, const Crease_star& star,
  Function_ref<bool(double)> ends,
  Function_ref<void(Level_connectivity::Index, Level_connectivity::Index, double)> f)
{
  using Index = Level_connectivity::Index;
  const auto is_ended = [&](const Crease_halfedge& e) {
    return creases.is_inner(e) && ends(creases.edge(e).sharpness);
  };
  const Wedge_merge merge =
    merge_wedges<FT>(creases, star, [&](const Crease_halfedge& e) { return !is_ended(e); });
  if (merge.ends.size() == star.number_of_ends) return;
  Short_vector<double> least(merge.number_of_wedges, infinite_sharpness);
  for (const Crease_halfedge& e : creases.ends_of(star)) {
    const Crease_edge<FT>& crease = creases.edge(e);
    if (!is_ended(e)) continue;
    double& s = least[merge.wedge[star.wedge(crease.after[e.side])]];
    s = (std::min)(s, crease.sharpness);
  }
  for_each_corner_of_star(level, creases, star, [&](Index h, Index wedge) {
    const Index merged = merge.wedge[wedge];
    if (least[merged] != infinite_sharpness) f(h, merged, least[merged]);
  });
}

// The slots of a refined level that get the roundness 0, by their numbers: at the corners of faces that touch the halves of
// an edge that ends in this round. `level` is whole.
template <class Host, class FT>
std::vector<Level_connectivity::Index>
slots_at_ended(const Host& host, const Level_connectivity& level, const Creases<FT>& creases,
               const Refined_creases<FT>& refined)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> slot_ids;
  const auto edge_slot = [&](Index h) {
    const Index v = host.vertex_of_edge(Level_connectivity::edge(h));
    const Crease_edge<FT>* const e = creases.edge_at(Level_connectivity::edge(h));
    if (e == nullptr || e->is_border()) return v;
    const Index rank = refined.rank[std::size_t(e - creases.edges.data())];
    if (rank == Level_connectivity::null) return v;
    return refined.creases.stars[refined.first_edge_star + rank].slot(h & 1u);
  };
  const auto ends = [](double s) { return !(refined_sharpness(s) > 0); };
  for (std::size_t i = 0; i < creases.stars.size(); ++i)
    for_each_corner_at_ended<FT>(level, creases, creases.stars[i], ends,
                                 [&](Index h, Index wedge, double) {
                                   const Index star = refined.star[i];
                                   slot_ids.push_back(star == Level_connectivity::null
                                                        ? level.target(h)
                                                        : refined.creases.stars[star].slot(wedge));
                                   slot_ids.push_back(edge_slot(h));
                                   slot_ids.push_back(edge_slot(level.next(h)));
                                   if constexpr (Host::refined_degree == 4)
                                     slot_ids.push_back(host.vertex_of_face(level.face(h)));
                                 });
  std::sort(slot_ids.begin(), slot_ids.end());
  slot_ids.erase(std::unique(slot_ids.begin(), slot_ids.end()), slot_ids.end());
  return slot_ids;
}

// The creases of a level without edges and vertices whose sharpness is less than 1.
template <class FT>
struct Creases_without_fractions
{
  using Index = Level_connectivity::Index;

  Creases<FT> creases;
  std::vector<double>
    reach; // of each slot: the least sharpness of fractional edges that touch a face at the slot, or 1

  // `level` is whole
  Creases_without_fractions(const Level_connectivity& level, const Creases<FT>& old)
    : number_of_vertices_(level.number_of_vertices())
  {
    const auto lasting = [](const auto* s) {
      return s == nullptr || is_fraction(s->sharpness) ? nullptr : s;
    };
    creases = creases_among<FT>(
      old, level, [&](Index e) { return lasting(old.edge_at(e)); },
      [&](Index v) { return lasting(old.star_at(v)); });
    for (const Crease_star& star : old.stars) {
      const Crease_star* const lasts = creases.star_at(star.vertex);
      star_.push_back(lasts == nullptr ? Level_connectivity::null
                                       : static_cast<Index>(lasts - creases.stars.data()));
    }
    take_tangents(old);
    find_reach(level, old);
  }

  // the tangents that the old creases have now; a corner that becomes a crease vertex passes on one direction of travel
  void take_tangents(const Creases<FT>& old)
  {
    auto remaining = creases.edges.begin();
    for (const Crease_edge<FT>& e : old.edges)
      if (!is_fraction(e.sharpness)) (remaining++)->tangent_from = e.tangent_from;
    for (std::size_t i = 0; i < star_.size(); ++i) {
      if (star_[i] == Level_connectivity::null) continue;
      const Crease_star& star = creases.stars[star_[i]];
      if (creases.rule(star) == Vertex_rule::crease &&
          old.rule(old.stars[i]) == Vertex_rule::corner)
        make_opposite_vectors<FT>(creases.tangent_from(creases.end(star, 0)),
                                  creases.tangent_from(creases.end(star, 1)));
    }
  }

  // The values of the slots of these creases: wedges are merged where the edge between them is gone, and the faces that
  // touch such an edge are not round.
  template <class Value, class Old_value>
  std::vector<Value> merged(const Creases<FT>& old, const Old_value& old_value) const
  {
    std::vector<Value> values(creases.number_of_slots);
    for (Index v = 0; v < number_of_vertices_; ++v) values[v] = old_value(v);
    for (std::size_t i = 0; i < star_.size(); ++i) {
      const Crease_star& star = old.stars[i];
      const Wedge_merge merge = remaining(old, star);
      std::vector<Coordinates<FT, 3>> normals;
      for (Index w = 0; w < star.number_of_wedges; ++w) {
        const Value value = old_value(star.slot(w));
        values[slot(star, i, merge.wedge[w])] = value;
        normals.push_back(value.normal);
      }
      normals = merge_normals<FT>(normals, merge);
      for (Index w = 0; w < merge.number_of_wedges; ++w)
        values[slot(star, i, w)].normal = normals[w];
    }
    for (std::size_t s = 0; s < values.size(); ++s)
      if (reach[s] < 1) values[s].roundness = FT(0);
    return values;
  }

private:
  static Wedge_merge remaining(const Creases<FT>& old, const Crease_star& star)
  {
    return merge_wedges<FT>(
      old, star, [&](const Crease_halfedge& e) { return !is_fraction(old.edge(e).sharpness); });
  }
  Index slot(const Crease_star& star, std::size_t i, Index wedge) const
  {
    return star_[i] == Level_connectivity::null ? star.vertex : creases.stars[star_[i]].slot(wedge);
  }

  void find_reach(const Level_connectivity& level, const Creases<FT>& old)
  {
    reach.assign(creases.number_of_slots, 1);
    const Corner_slots<FT> slot_of(level, creases);
    for (const Crease_star& star : old.stars)
      for_each_corner_at_ended<FT>(
        level, old, star, [](double s) { return is_fraction(s); },
        [&](Index h, Index, double s) {
          for (const Index g : halfedges_around_face(level, h))
            reach[slot_of(g)] = (std::min)(reach[slot_of(g)], s);
        });
  }

  Index number_of_vertices_;
  std::vector<Index> star_; // of the old stars, or null
};

// Keeps with control creases the level without edges and vertices whose sharpness is less than 1: values(c) returns the
// values of its slots, and completes its creases c.
template <class FT>
void keep_without_fractions(const Level_connectivity& level, Creases<FT>& creases,
                            Function_ref<std::vector<Point_normal<FT, 3>>(Creases<FT>&)> values)
{
  if (!has_fractions(creases)) return;
  auto without = std::make_shared<Control_without_fractions<FT>>();
  without->creases = Creases_without_fractions<FT>(level, creases).creases;
  without->values = values(without->creases);
  creases.without_fractions = std::move(without);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ENDED_CREASES_H
