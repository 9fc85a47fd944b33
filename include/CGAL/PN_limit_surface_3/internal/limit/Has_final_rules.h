// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_HAS_FINAL_RULES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_HAS_FINAL_RULES_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <algorithm>
#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// How many rings of faces a vertex needs around it for a round to come out right, again and again, in the rings that
// the round after it needs: c rings of new faces lie in c/2 of old ones, and these need the ghost rings around them, so
// c is twice as many; rings of sqrt(3) grow by the root of 3 only. A scheme that does not tell has as many as Kobbelt's.
template <class Scheme>
unsigned cut_rings(const Scheme& scheme)
{
  constexpr unsigned least = 4, times = std::is_same_v<typename Scheme::Host, Sqrt3_host> ? 4 : 2;
  const unsigned ghosts = ghost_rings(scheme);
  return ghosts == 0 ? 8 : (std::max)(least, times * ghosts);
}

// Tells whether the neighborhood of a vertex of a level is settled, or will be once the rules are those
// of all later rounds, too.
template <class Scheme>
class Has_final_rules
{
public:
  using Index = Level_connectivity::Index;
  using Host = typename Scheme::Host;

  static constexpr Index degree = Host::refined_degree;
  static constexpr Index regular_valence = degree == 4 ? 4 : 6;

  // rules_are_final: whether the next round has the rules that all later ones have
  Has_final_rules(const Scheme& scheme, const Level_connectivity& level, bool rules_are_final)
    : level_(level)
    , neighborhood_(limit_neighborhood(scheme))
    , has_next_ring_(may_have_next_ring && neighborhood_.regular_rings <= 1 &&
                     neighborhood_.takes_border && !transfers_curvature(scheme))
    , rules_are_final_(rules_are_final)
  {}

  // \pre v has edges
  bool operator()(Index v) const
  {
    const bool at_border = level_.is_border_vertex(v);
    const Index first = level_.halfedge_of_vertex(v);
    if (!rules_are_final_ && !at_border && !has_valence(v, regular_valence)) return false;
    Index h = first;
    do {
      if (!level_.is_border(h) && !has_final_face(h, at_border)) return false;
      h = level_.next_around_target(h);
    } while (h != first);
    return neighborhood_.regular_rings < 2 || are_regular_beyond(first, at_border);
  }

  // Whether the vertices that a vertex gets around it in the next round may decide on it, they alone, and
  // are found from the elements of this level. What transfers do to them is not.
  static constexpr bool may_have_next_ring =
    std::is_same_v<Host, PQQ_host> || std::is_same_v<Host, PTQ_host>;

  // Whether the neighborhood of v will be settled after one round because the new vertices of edges and
  // faces around it are all regular, if the rules are final then.
  // \pre v has edges
  bool in_next_ring(Index v) const
  {
    if (!has_next_ring_) return false;
    const Index first = level_.halfedge_of_vertex(v);
    Index h = first;
    do {
      if (!level_.is_border(h) && !level_.has_degree(h, degree)) return false;
      h = level_.next_around_target(h);
    } while (h != first);
    return true;
  }

private:
  // h leads to the vertex
  bool has_final_face(Index h, bool at_border) const
  {
    if (!level_.has_degree(h, degree)) return false;
    if constexpr (std::is_same_v<Host, Sqrt3_host>)
      // the border of the vertex itself goes by rules of its own
      if (!at_border && level_.is_border(Level_connectivity::opposite(level_.next(level_.next(h)))))
        return false;
    if (neighborhood_.regular_rings > 0)
      for (Index g = level_.next(h); g != h; g = level_.next(g))
        if (!is_regular(level_.target(g), at_border)) return false;
    return true;
  }

  // the vertices of the faces around the neighbors and diagonal vertices
  bool are_regular_beyond(Index first, bool at_border) const
  {
    const Index v = level_.target(first);
    Index h = first;
    do {
      if (!level_.is_border(h))
        for (Index g = level_.next(h); g != h; g = level_.next(g)) {
          Index k = g;
          do {
            if (!level_.is_border(k)) {
              if (!level_.has_degree(k, degree)) return false;
              for (Index c = level_.next(k); c != k; c = level_.next(c))
                if (level_.target(c) != v && !is_regular(level_.target(c), at_border)) return false;
            }
            k = level_.next_around_target(k);
          } while (k != g);
        }
      h = level_.next_around_target(h);
    } while (h != first);
    return true;
  }

  bool is_regular(Index v, bool at_border) const
  {
    // a dart is cut open, but counts by its valence
    if (const auto* counted = counted_valence(level_, v); counted != nullptr)
      return neighborhood_.takes_border &&
             (counted->valence == 0 || counted->valence == regular_valence);
    if (level_.is_border_vertex(v))
      return neighborhood_.takes_border ||
             (at_border && level_.valence(v) == (degree == 4 ? 3 : 4));
    return has_valence(v, regular_valence);
  }

  bool has_valence(Index v, Index n) const
  {
    const Index first = level_.halfedge_of_vertex(v);
    Index h = level_.next_around_target(first);
    for (Index i = 1; i < n; ++i, h = level_.next_around_target(h))
      if (h == first) return false;
    return h == first;
  }

  const Level_connectivity& level_;
  const Limit_neighborhood neighborhood_;
  const bool has_next_ring_, rules_are_final_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_HAS_FINAL_RULES_H
