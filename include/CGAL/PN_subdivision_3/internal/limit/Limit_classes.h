// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_CLASSES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_CLASSES_H

#include <CGAL/PN_subdivision_3/curvature/Extraordinary_net.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_neighborhood.h>
#include <CGAL/PN_subdivision_3/internal/limit/Ring_class.h>
#include <CGAL/PN_subdivision_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/internal/limit/Vertex_ring.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The kinds of rings that the vertices of a level have: one for each valence, in the interior and on
// the border. A kind is made where it occurs first, from the scheme itself at work around the vertex.
template <class Scheme, class FT>
class Limit_classes
{
public:
  using Index = Level_connectivity::Index;
  using Class = Ring_class<Scheme, FT>;
  using Host = typename Scheme::Host;

  struct Kind
  {
    std::unique_ptr<Class> ring_class;
    unsigned rings = 1; // how many the class takes; 0: the vertex and its neighbors on the border
  };

  explicit Limit_classes(const Scheme& scheme)
    : scheme_(scheme)
    , any_round_((std::max)(101u, First_tuned_round<Scheme>::of(scheme) | 1u))
  {}

  // the kind of a vertex with edges
  const Kind& at(const Level_connectivity& level, Index v)
  {
    const bool at_border = level.is_border_vertex(v);
    // those of sqrt(3) on the border are all alike
    const Index valence = is_sqrt3 && at_border ? 0 : level.valence(v);
    Kind& kind = kinds_[{at_border, valence}];
    if (!kind.ring_class) kind = is_sqrt3 && at_border ? make_sqrt3_border() : make(level, v);
    return kind;
  }

  // the ring of a vertex of the kind
  static void append_ring(const Level_connectivity& level, Index v, const Kind& kind,
                          std::vector<Index>& ring)
  {
    if (kind.rings != 0) return Vertex_ring::append(level, v, kind.rings, ring);
    const Index h = level.halfedge_of_vertex(v);
    ring.insert(ring.end(), {v, level.target(level.next(h)), level.source(h)});
  }

private:
  static constexpr bool is_sqrt3 = std::is_same_v<Host, Sqrt3_host>;
  static constexpr unsigned most_rings = 3;

  Level_connectivity refined(const Level_connectivity& level) const
  {
    const Host host(level, any_round_);
    Level_connectivity child(Host::refined_size(level.size(), any_round_));
    child.set_uniform_degree(Host::refined_degree);
    host.connect(child, For_chunks());
    return child;
  }

  // Refined twice, any vertex is alone among regular ones.
  Kind make(const Level_connectivity& level, Index v) const
  {
    Sub_level around(level, {v}, 2);
    const Level_connectivity fine = refined(refined(around.level()));
    const bool at_border = level.is_border_vertex(v);
    Kind kind;
    for (kind.rings = 1; kind.rings <= most_rings; ++kind.rings) {
      const Sub_level cut(fine, around.centers(), kind.rings + 3);
      const Index c = cut.centers().front();
      Ring_pair rings;
      Vertex_ring::append(cut.level(), c, kind.rings, rings.ring);
      Vertex_ring::append(refined(cut.level()), c, kind.rings, rings.next_ring);
      Ring_layout layout;
      // of larger rings on the border the two eigenvalues need not be those of a tangent plane
      if (!at_border || kind.rings == 1) layout.number = cut.level().valence(c);
      layout.at_border = at_border;
      kind.ring_class = std::make_unique<Class>(scheme_, cut.level(), any_round_, rings, layout);
      if (kind.ring_class->is_valid()) return kind;
    }
    throw std::invalid_argument("PN_subdivision_3: the scheme has no limit mask on " +
                                std::to_string(most_rings) + " rings about a vertex of valence " +
                                std::to_string(level.valence(v)) +
                                (at_border ? " on the border" : ""));
  }

  // The border is refined in even rounds, as a curve.
  Kind make_sqrt3_border() const
  {
    if constexpr (is_sqrt3) {
      const Extraordinary_net net(3, 6, 3);
      const Level_connectivity level = net.level();
      const Index v = net.vertex(0, 2, 1);
      const Host host(level, any_round_ + 1);
      Level_connectivity child(Host::refined_size(level.size(), any_round_ + 1));
      host.connect(child, For_chunks());
      Kind kind;
      kind.rings = 0;
      Ring_pair rings;
      append_ring(level, v, kind, rings.ring);
      append_ring(child, v, kind, rings.next_ring);
      kind.ring_class =
        std::make_unique<Class>(scheme_, level, any_round_ + 1, rings, Ring_layout());
      return kind;
    } else
      return Kind();
  }

  const Scheme& scheme_;
  // an odd one, in which sqrt(3) keeps the border, not the first, and one with the rules of all later ones
  unsigned any_round_;
  std::map<std::pair<bool, Index>, Kind> kinds_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_CLASSES_H
