// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_SLOT_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_SLOT_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// whether the map has a normal for every corner: at the target of a half-edge in its face
template <class Access, class Map>
constexpr bool has_corner_normals_v =
  std::is_same_v<std::decay_t<Key_of_map<Map>>,
                 std::decay_t<decltype(std::declval<const Access&>().halfedge_at(0))>>;

// The control normals of a map of corners: a slot has the normal of its corners or, where they differ, the unit vector of
// their sum. From an estimate it also has the largest roundness, and whether a corner is no estimate any more.
template <class FT, class Access, class Map, class Value>
void read_corner_normals(const Access& access, const Level_connectivity& level,
                         const Creases<FT>& creases, Map map, std::vector<Value>& values,
                         [[maybe_unused]] std::vector<bool>* is_put = nullptr)
{
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;
  const Cut_copy<FT> cut(level, creases);
  std::vector<Vector> sum(values.size(), zero_vector<FT, 3>());
  std::vector<int> count(values.size(), 0);
  std::vector<bool> differ(values.size(), false);
  for_each_corner(level, cut.connectivity(), [&](Index h, Index slot) {
    Vector n = coordinates_3<FT>(get(map, access.halfedge_at(h)));
    const auto name = [&] { return access.halfedge_name(h); };
    check_finite<FT, 3>(n, "normal", name);
    normalize_control_normal<FT, 3>(n, name);
    if constexpr (is_of_estimate_v<Map>) {
      const auto whole = get_whole(map, access.halfedge_at(h));
      if (is_put != nullptr && !whole.is_estimated) (*is_put)[slot] = true;
      if constexpr (goes_with_roundness_v<Map>) {
        const FT w = checked_roundness<FT>(roundness_as<FT>(whole.roundness), true, name);
        FT& of_slot = values[slot].roundness;
        if (count[slot] == 0 || of_slot < w) of_slot = w;
      }
    }
    if (count[slot]++ == 0)
      values[slot].normal = n;
    else if (!are_certainly_equal(n, values[slot].normal))
      differ[slot] = true;
    add_multiple(sum[slot], FT(1), n);
  });
  for (std::size_t slot = 0; slot < values.size(); ++slot)
    if (differ[slot])
      name_undecided<FT>([&] { values[slot].normal = unit_or_zero(sum[slot], FT(count[slot])); },
                         [] { return "whether the normals of the corners of a wedge cancel"; });
}

// Puts the normals of all corners of a level, and puts the old normals back without commit().
template <class Access, class Map>
class Corner_normal_writer
{
public:
  static constexpr bool takes_corners = true, takes_wedges = false;
  using Index = Level_connectivity::Index;

  Corner_normal_writer(const Access& access, const Level_connectivity& level, Map map)
    : map_(access, map, corners_of(level))
  {}

  // `values` are the values of the slots, or their normals alone
  template <class FT, class Values>
  void put_all(const Level_connectivity& level, const Creases<FT>& creases, const Values& values)
  {
    map_.begin();
    const Cut_copy<FT> cut(level, creases);
    for_each_corner(level, cut.connectivity(), [&](Index h, Index slot) {
      const auto& value = values[slot];
      if constexpr (!has_normal_v<std::decay_t<decltype(value)>>)
        map_.set_vector(h, value);
      else {
        map_.set_vector(h, value.normal);
        if constexpr (goes_with_roundness_v<Map>) {
          const auto key = map_.access().halfedge_at(h);
          auto whole = get_whole(map_.map(), key);
          whole.roundness = value.roundness;
          put_whole(map_.map(), key, whole);
        }
      }
    });
  }
  void commit() { map_.commit(); }

private:
  Undoable_map<Access, Map, Halfedge_of_mesh> map_;
};

// of a map without normals of corners
struct Nothing_of_corners
{
  static constexpr bool takes_corners = false, takes_wedges = false;

  template <class Access, class Map>
  Nothing_of_corners(const Access&, const Level_connectivity&, const Map&)
  {}
  void commit() {}
};

// the map of vertices that takes the normals of a map, and the object that takes the normals of its corners
template <class Access, class Map, bool is_of_halfedges = has_corner_normals_v<Access, Map>>
struct Normal_writers
{
  using Vertex_map = Map;
  using Corner_writer = Nothing_of_corners;
  static Vertex_map vertex_map(const Map& map) { return map; }
};
template <class Access, class Map>
struct Normal_writers<Access, Map, true>
{
  using Vertex_map = Not_given;
  using Corner_writer = Corner_normal_writer<Access, Map>;
  static Vertex_map vertex_map(const Map&) { return {}; }
};

// Normals of corners, without storing a normal for each corner of the refined mesh. Normals of the control mesh are read from
// `corners`. Normals of the refined mesh go to `vertices`, from the first wedge of a vertex of several wedges. All wedges of
// such vertices go to `wedges`, with their roundness if `corners` have one and the half-edges that they begin at, clockwise. A border vertex's first wedge that begins at an edge that is no crease is not listed.
template <class Corner_map, class Vertex_map_>
struct Wedge_normals
{
  using Vertex_map = Vertex_map_;
  using key_type = typename boost::property_traits<Corner_map>::key_type;
  using value_type = typename boost::property_traits<Vertex_map>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  using Of_wedge = decltype(get_whole(std::declval<const Corner_map&>(), std::declval<key_type>()));
  using List = std::vector<std::pair<key_type, Of_wedge>>;

  Corner_map corners;
  Vertex_map vertices;
  List* wedges;

  friend value_type get(const Wedge_normals& n, const key_type& h) { return get(n.corners, h); }
};

template <class Corner_map, class Vertex_map>
inline constexpr bool is_of_estimate_v<Wedge_normals<Corner_map, Vertex_map>> =
  is_of_estimate_v<Corner_map>;
template <class Corner_map, class Vertex_map>
inline constexpr bool goes_with_roundness_v<Wedge_normals<Corner_map, Vertex_map>> =
  goes_with_roundness_v<Corner_map>;
template <class Corner_map, class Vertex_map, class Key>
auto get_whole(const Wedge_normals<Corner_map, Vertex_map>& n, const Key& h)
{
  return get_whole(n.corners, h);
}

// The normals of a map for the mesh without edges whose sharpness is less than 1: the same normals if they are given.
template <class Map>
const Map& normals_without_fractions(const Map& map)
{
  return map;
}
template <class Corner_map, class Vertex_map>
auto normals_without_fractions(const Wedge_normals<Corner_map, Vertex_map>& n)
{
  return normals_without_fractions(n.corners);
}

// Lists the wedges; they are nobody's until commit() is called.
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
      for (const Crease_halfedge& e : creases.ends_of(star)) {
        if (!creases.edge(e).has_after(e.side)) continue;
        const auto wedge = star.wedge(creases.edge(e).after[e.side]);
        const auto& of_wedge = (value + std::ptrdiff_t(wedge))->second;
        const Coordinates<FT, 3>& n = of_wedge.normal;
        wedges_.emplace_back(access_.halfedge_at(creases.halfedge(e)),
                             typename Map::Of_wedge{Normal(n[0], n[1], n[2])});
        if constexpr (goes_with_roundness_v<Map>)
          wedges_.back().second.roundness = of_wedge.roundness;
      }
    }
  }
  void commit() noexcept { map_.wedges->swap(wedges_); }

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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_SLOT_NORMALS_H
