// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_NEIGHBORHOOD_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_NEIGHBORHOOD_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/schemes/irregular_valences.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/ct_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/ct_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/modified_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/modified_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>
#include <CGAL/PN_subdivision_3/schemes/with_crease_tangents.h>

#include <algorithm>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What has to be regular around a vertex for a scheme to do there, from now on, the same in every
// round: to map the ring of the vertex to that of its successor by one matrix.
//  * regular_rings: in how many rings the other vertices have to be regular
//  * takes_border: whether they may lie on the border
//  * cut_rings: how many rings of faces a vertex needs around it for a round to come out right, again
//    and again, in the rings that the round after it needs: c rings of new faces lie in c/2 of old ones,
//    and these need ghost_rings around them, so c is twice that
//  * is_spline: whether the surface is one of piecewise polynomials where all vertices are regular
//  * keeps_points: whether vertices keep their points and normals
// This is for any scheme with masks no larger than those of the built-in ones.
template <unsigned rings, bool is_with_border, unsigned cut, bool spline, bool interpolatory>
struct Limit_neighborhood_of
{
  static constexpr unsigned regular_rings = rings;
  static constexpr bool takes_border = is_with_border;
  static constexpr unsigned cut_rings = cut;
  static constexpr bool is_spline = spline;
  static constexpr bool keeps_points = interpolatory;
};

// of a scheme that does not tell its ghost_rings as many as Kobbelt's
template <class Scheme>
constexpr unsigned wide_cut_rings()
{
  constexpr unsigned ghost_rings = Ghost_rings<Scheme>::value;
  return ghost_rings == 0 ? 8 : (std::max)(4u, 2 * ghost_rings);
}
template <class Scheme, bool interpolatory = false>
using Wide_neighborhood =
  Limit_neighborhood_of<2, false, wide_cut_rings<Scheme>(), false, interpolatory>;
// the rules at a vertex depend on its valence and the degrees of its faces alone
using Plain_neighborhood = Limit_neighborhood_of<0, true, 4, true, false>;
// whether a vertex is separated depends on the vertices of its faces
using Modified_neighborhood = Limit_neighborhood_of<1, true, 6, true, false>;
// Faces at the border are cut in another way, and in every other round: see is_settled(). Rings grow by the root of 3
// only.
using Sqrt3_neighborhood = Limit_neighborhood_of<0, true, 8, false, false>;

template <class Scheme>
struct Limit_neighborhood : Wide_neighborhood<Scheme>
{};
template <>
struct Limit_neighborhood<Butterfly_scheme> : Wide_neighborhood<Butterfly_scheme, true>
{};
template <>
struct Limit_neighborhood<Kobbelt_scheme> : Wide_neighborhood<Kobbelt_scheme, true>
{};
template <>
struct Limit_neighborhood<CatmullClark_scheme> : Plain_neighborhood
{};
template <>
struct Limit_neighborhood<Loop_scheme> : Plain_neighborhood
{};
template <>
struct Limit_neighborhood<modified_CatmullClark_scheme> : Modified_neighborhood
{};
template <>
struct Limit_neighborhood<modified_Loop_scheme> : Modified_neighborhood
{};
template <>
struct Limit_neighborhood<ct_CatmullClark_scheme> : Modified_neighborhood
{};
template <>
struct Limit_neighborhood<ct_Loop_scheme> : Modified_neighborhood
{};
template <>
struct Limit_neighborhood<Sqrt3_scheme> : Sqrt3_neighborhood
{};

template <class Scheme>
struct Limit_neighborhood<Linear_scheme<Scheme>> : Limit_neighborhood<Scheme>
{};

// beside creases the rules are those of the scheme
template <class Scheme>
struct Limit_neighborhood<Scheme_with_border<Scheme>> : Limit_neighborhood<Scheme>
{};
template <class Scheme, class Map>
struct Limit_neighborhood<Scheme_with_crease_tangents<Scheme, Map>> : Limit_neighborhood<Scheme>
{};

template <class Scheme, class Normal_scheme, class Points = Limit_neighborhood<Scheme>,
          class Normals = Limit_neighborhood<Normal_scheme>>
using Common_neighborhood =
  Limit_neighborhood_of<(std::max)(Points::regular_rings, Normals::regular_rings),
                        Points::takes_border && Normals::takes_border,
                        (std::max)(Points::cut_rings, Normals::cut_rings), false,
                        Points::keeps_points && Normals::keeps_points>;
template <class Scheme, class Normal_scheme>
struct Limit_neighborhood<Scheme_with_normals<Scheme, Normal_scheme>>
  : Common_neighborhood<Scheme, Normal_scheme>
{};

// Tells whether the neighborhood of a vertex of a level is settled, or will be once the rules are those
// of all later rounds, too.
template <class Scheme>
class Settled_neighborhood
{
public:
  using Index = Level_connectivity::Index;
  using Host = typename Scheme::Host;
  using Neighborhood = Limit_neighborhood<Scheme>;

  static constexpr Index degree = Host::refined_degree;
  static constexpr Index regular_valence = degree == 4 ? 4 : 6;

  // rules_are_final: whether the next round has the rules that all later ones have
  explicit Settled_neighborhood(const Level_connectivity& level, bool rules_are_final = true)
    : level_(level)
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
      if (!level_.is_border(h) && !is_settled_face(h, at_border)) return false;
      h = level_.next_around_target(h);
    } while (h != first);
    return Neighborhood::regular_rings < 2 || are_regular_beyond(first, at_border);
  }

  // Whether the vertices that a vertex gets around it in the next round, and they alone, decide on it, and
  // are found from the elements of this level. What transfers do to them is not.
  static constexpr bool has_next_ring =
    (std::is_same_v<Host, PQQ_host> ||
     std::is_same_v<Host, PTQ_host>)&&Neighborhood::regular_rings <= 1 &&
    Neighborhood::takes_border && !Has_curvature_transfer<Scheme>::value;

  // Whether the neighborhood of v will be settled after one round because the new vertices of edges and
  // faces around it are all regular, if the rules are final then.
  // \pre v has edges
  bool in_next_ring(Index v) const
  {
    if (!has_next_ring) return false;
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
  bool is_settled_face(Index h, bool at_border) const
  {
    if (!level_.has_degree(h, degree)) return false;
    if constexpr (std::is_same_v<Host, Sqrt3_host>)
      // the border of the vertex itself goes by rules of its own
      if (!at_border && level_.is_border(Level_connectivity::opposite(level_.next(level_.next(h)))))
        return false;
    if constexpr (Neighborhood::regular_rings > 0)
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
      return Neighborhood::takes_border &&
             (counted->valence == 0 || counted->valence == regular_valence);
    if (level_.is_border_vertex(v))
      return Neighborhood::takes_border ||
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
  bool rules_are_final_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_NEIGHBORHOOD_H
