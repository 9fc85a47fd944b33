// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_UNDOABLE_MAP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_UNDOABLE_MAP_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/Estimated_control_normals.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The kinds of elements of a mesh: their keys in maps, their number, the key of an index, and the name of an element.
struct Vertex_of_mesh
{
  using Index = Level_connectivity::Index;

  template <class Mesh>
  using Descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  static auto number(const Level_size& size) { return static_cast<std::size_t>(size.vertices); }
  static constexpr auto at = [](const auto& access, Index v) { return access.vertex(v); };
  static constexpr auto name = [](const auto& access, Index v) { return access.vertex_name(v); };
};

struct Halfedge_of_mesh
{
  using Index = Level_connectivity::Index;

  template <class Mesh>
  using Descriptor = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  static auto number(const Level_size& size) { return static_cast<std::size_t>(size.halfedges()); }
  static constexpr auto at = [](const auto& access, Index h) { return access.halfedge_at(h); };
};

struct Edge_of_mesh
{
  using Index = Level_connectivity::Index;

  template <class Mesh>
  using Descriptor = typename boost::graph_traits<Mesh>::edge_descriptor;
  static auto number(const Level_size& size) { return static_cast<std::size_t>(size.edges); }
  static constexpr auto at = [](const auto& access, Index e) { return access.edge_at(e); };
  static constexpr auto name = [](const auto& access, Index e) {
    return "the edge of " + access.halfedge_name(2 * e);
  };
};

struct Face_of_mesh
{
  template <class Mesh>
  using Descriptor = typename boost::graph_traits<Mesh>::face_descriptor;
  static auto number(const Level_size& size) { return static_cast<std::size_t>(size.faces); }
  static constexpr auto at = [](const auto& access, Level_connectivity::Index f) {
    return access.face_at(f);
  };
};

// the half-edges that have a face
inline std::vector<Level_connectivity::Index> corners_of(const Level_connectivity& level)
{
  std::vector<Level_connectivity::Index> result;
  result.reserve(static_cast<std::size_t>(level.size().corners));
  for (Level_connectivity::Index h = 0; h < level.number_of_halfedges(); ++h)
    if (!level.is_border(h)) result.push_back(h);
  return result;
}

// \name Maps
// the placeholder of a map that is not given can be neither read nor written

template <class Map, class Tag, class = void>
constexpr bool has_category_v = false;
template <class Map, class Tag>
inline constexpr bool
  has_category_v<Map, Tag, std::void_t<typename boost::property_traits<Map>::category>> =
    std::is_convertible_v<typename boost::property_traits<Map>::category, Tag>;
template <class Map>
constexpr bool is_readable_v = has_category_v<Map, boost::readable_property_map_tag>;
template <class Map>
constexpr bool is_writable_map_v = has_category_v<Map, boost::writable_property_map_tag>;

// the type of the value that a map has for a key, see get_whole()
template <class Map, bool has_more = is_of_estimate_v<Map>, class = void>
struct Whole_of_map
{
  using type = std::nullptr_t;
};
template <class Map>
struct Whole_of_map<Map, false, std::void_t<typename boost::property_traits<Map>::value_type>>
{
  using type = std::decay_t<typename boost::property_traits<Map>::value_type>;
};
template <class Map>
struct Whole_of_map<Map, true>
{
  using type =
    decltype(get_whole(std::declval<const Map&>(), std::declval<typename Map::key_type>()));
};

// A user's map, and its old values for elements that are there already: unless commit() is called, the map gets the old
// values back. A map that cannot be read has no old values.
template <class Access, class Map, class Element>
class Undoable_map
{
public:
  using Index = Level_connectivity::Index;
  using Value = typename Whole_of_map<Map>::type;

  // remembers the values of the first elements
  Undoable_map(const Access& access, Map map, [[maybe_unused]] std::size_t number = 0)
    : access_(access)
    , map_(map)
  {
    if constexpr (is_readable_v<Map>) {
      old_.reserve(number);
      for (Index i = 0; i < number; ++i) old_.push_back(get_whole(map_, Element::at(access_, i)));
    }
  }
  // remembers the values of some elements
  Undoable_map(const Access& access, Map map, [[maybe_unused]] const std::vector<Index>& elements)
    : access_(access)
    , map_(map)
  {
    if constexpr (is_readable_v<Map>) {
      elements_.reserve(elements.size());
      old_.reserve(elements.size());
      for (const Index i : elements) remember(i);
    }
  }
  ~Undoable_map()
  {
    if constexpr (is_writable_map_v<Map>)
      for (Index i = 0; is_changed_ && i < old_.size(); ++i) try {
          put_whole(map_, Element::at(access_, elements_.empty() ? i : elements_[i]),
                    Value(old_[i]));
        } catch (...) { // the element keeps the new value
        }
  }
  Undoable_map(const Undoable_map&) = delete;
  Undoable_map& operator=(const Undoable_map&) = delete;

  const Access& access() const { return access_; }
  const Map& map() const { return map_; }
  // the old values by their positions: the numbers of the elements if these are the first elements
  const std::vector<Value>& old() const { return old_; }

  // to be called before the first element is set
  void begin() { is_changed_ = true; }
  template <class T>
  void set(Index i, const T& value) const
  {
    put(map_, Element::at(access_, i), value);
  }
  template <class Vector>
  void set_vector(Index i, const Vector& v) const
  {
    set(i, typename boost::property_traits<Map>::value_type(v[0], v[1], v[2]));
  }
  // sets one more element, and remembers its old value
  template <class Vector>
  void change_vector(Index i, const Vector& v)
  {
    remember(i);
    begin();
    set_vector(i, v);
  }
  void commit() noexcept { is_changed_ = false; }

private:
  void remember(Index i)
  {
    elements_.push_back(i);
    old_.push_back(get_whole(map_, Element::at(access_, i)));
  }

  const Access& access_;
  mutable Map map_;             // put() of some maps is not const
  std::vector<Index> elements_; // empty if these are the first elements
  std::vector<Value> old_;
  bool is_changed_ = false;
};

// Removes the elements that a mesh gets, unless commit() is called.
template <class Access>
class Growth
{
public:
  explicit Growth(Access& access)
    : access_(access)
  {}
  ~Growth()
  {
    if (!is_committed_) access_.shrink();
  }
  Growth(const Growth&) = delete;
  Growth& operator=(const Growth&) = delete;
  void commit() { is_committed_ = true; }

private:
  Access& access_;
  bool is_committed_ = false;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_UNDOABLE_MAP_H
