// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WEDGE_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WEDGE_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Normals of corners without one for each corner of the refined mesh. Those of the control mesh are read from `corners`.
// Those of the refined mesh go to `vertices`, where a vertex has several wedges that of the first one, and those of
// the wedges of such vertices to `wedges`, with the half-edges that they begin at, clockwise. A border vertex's
// first wedge that begins at an edge that is no crease is not listed.
template <class Corner_map, class Vertex_map_>
struct Wedge_normals
{
  using Vertex_map = Vertex_map_;
  using key_type = typename boost::property_traits<Corner_map>::key_type;
  using value_type = typename boost::property_traits<Vertex_map>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  using List = std::vector<std::pair<key_type, value_type>>;

  Corner_map corners;
  Vertex_map vertices;
  List* wedges;

  friend value_type get(const Wedge_normals& n, const key_type& h) { return get(n.corners, h); }
};

// Lists the wedges; they are nobody's until keep() is called.
template <class Access, class Map>
class Wedge_normal_writer
{
public:
  static constexpr bool takes_corners = false, takes_wedges = true;

  Wedge_normal_writer(const Access& access, const Level_connectivity&, const Map& map)
    : access_(access)
    , map_(map)
  {}

  // `values` are pairs of a slot and its value, in the order of the stars
  template <class FT, class Slot_values>
  void list(const Creases<FT>& creases, const Slot_values& values)
  {
    using Normal = typename Map::value_type;
    auto value = values.begin();
    for (const Crease_star& star : creases.stars) {
      if (star.number_of_wedges == 1) continue;
      while (value->first != star.vertex) ++value;
      for (Level_connectivity::Index i = 0; i < star.number_of_ends; ++i) {
        const Crease_end& e = creases.end(star, i);
        if (!creases.edge(e).has_after(e.side)) continue;
        const auto wedge = star.wedge(creases.edge(e).after[e.side]);
        const Coordinates<FT, 3>& n = (value + std::ptrdiff_t(wedge))->second.normal;
        wedges_.emplace_back(access_.halfedge_at(creases.halfedge(e)), Normal(n[0], n[1], n[2]));
      }
    }
  }
  void keep() noexcept { map_.wedges->swap(wedges_); }

private:
  const Access& access_;
  Map map_;
  typename Map::List wedges_;
};

template <class Access, class Corners, class Vertices>
struct Normal_writers<Access, Wedge_normals<Corners, Vertices>, true>
{
  using Map = Wedge_normals<Corners, Vertices>;
  using Vertex_map = Vertices;
  using Corner_writer = Wedge_normal_writer<Access, Map>;
  static Vertex_map vertex_map(const Map& map) { return map.vertices; }
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_WEDGE_NORMALS_H
