// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASE_MAPS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASE_MAPS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/No_constraint_map.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// of a value of a map of constraints: true is infinitely sharp
template <class Value>
double sharpness_of(const Value& value)
{
  if constexpr (std::is_same_v<Value, bool>)
    return value ? infinite_sharpness : 0;
  else
    return double(CGAL::to_double(value));
}

// of a key of such a map
template <class Map, class Key>
double sharpness_in(const Map& map, const Key& key)
{
  using Value = std::decay_t<typename boost::property_traits<Map>::value_type>;
  return sharpness_of(static_cast<Value>(get(map, key))); // bits have references of their own
}

template <class Name>
double checked_sharpness(double s, const Name& name)
{
  if (!(s >= 0))
    throw std::invalid_argument(
      "PN_subdivision_3: the sharpness of " + name() + " is " +
      (s < 0 ? "negative" : "not a number") +
      ": make it 0 where the surface is smooth, positive where it is sharp");
  return s;
}

// The constraints of the edges or vertices of a mesh: read before the first round, written for the
// refined elements if the map can be written, and put back unless they are kept.
//
// Element says what the key of an index is, and how it is called.
template <class Access, class Map, class Element>
class Constraints
{
public:
  using Index = Level_connectivity::Index;

  Constraints(const Access& access, Map map, Index number)
    : access_(access)
    , map_(map)
  {
    if constexpr (is_constraint_map_v<Map>)
      for (Index i = 0; i < number; ++i) old_.push_back(get(map_, Element::at(access_, i)));
  }
  ~Constraints()
  {
    if constexpr (is_writable)
      if (is_changed_) put_back();
  }
  Constraints(const Constraints&) = delete;
  Constraints& operator=(const Constraints&) = delete;

  // 0 if there is no map
  Index number_of_old() const { return static_cast<Index>(old_.size()); }

  double sharpness([[maybe_unused]] Index i) const
  {
    if constexpr (is_constraint_map_v<Map>)
      return checked_sharpness(sharpness_of(Value(old_[i])),
                               [&] { return Element::name(access_, i); });
    else
      return 0;
  }

  // Puts the constraints of `number` refined elements. `constraints` has some of them, in the order of
  // the elements: (element, (old element that it is a part of, sharpness)). All others are smooth.
  void put_refined(
    [[maybe_unused]] Index number,
    [[maybe_unused]] const std::vector<std::pair<Index, std::pair<Index, double>>>& constraints)
  {
    if constexpr (is_writable) {
      is_changed_ = true;
      auto next = constraints.begin();
      for (Index i = 0; i < number; ++i) {
        if (next != constraints.end() && next->first == i) {
          const Value old = old_[next->second.first];
          put(map_, Element::at(access_, i), value(next->second.second, old));
          ++next;
        } else if (i >= old_.size() || !(old_[i] == Value(0)))
          put(map_, Element::at(access_, i), Value(0));
      }
    }
  }

  void keep() { is_changed_ = false; }

private:
  template <class Any_map, bool = is_constraint_map_v<Any_map>>
  struct Traits
  {
    using Value = int;
    static constexpr bool is_writable = false;
  };
  template <class Any_map>
  struct Traits<Any_map, true>
  {
    using Value = typename boost::property_traits<Any_map>::value_type;
    static constexpr bool is_writable =
      std::is_convertible_v<typename boost::property_traits<Any_map>::category,
                            boost::writable_property_map_tag>;
  };
  using Value = std::decay_t<typename Traits<Map>::Value>;
  static constexpr bool is_writable = Traits<Map>::is_writable;

  // what is sharp for ever keeps its value
  static Value value(double sharpness, const Value& old)
  {
    return sharpness == infinite_sharpness ? old : Value(sharpness);
  }

  void put_back() noexcept
  {
    for (Index i = 0; i < old_.size(); ++i) try {
        put(map_, Element::at(access_, i), Value(old_[i]));
      } catch (...) {
      }
  }

  const Access& access_;
  Map map_;
  std::vector<Value> old_;
  bool is_changed_ = false;
};

struct Edge_of_mesh
{
  template <class Access>
  static auto at(const Access& access, Level_connectivity::Index e)
  {
    return access.edge_at(e);
  }
  template <class Access>
  static std::string name(const Access& access, Level_connectivity::Index e)
  {
    return "the edge of " + access.halfedge_name(2 * e);
  }
};

struct Vertex_of_mesh
{
  template <class Access>
  static auto at(const Access& access, Level_connectivity::Index v)
  {
    return access.vertex(v);
  }
  template <class Access>
  static std::string name(const Access& access, Level_connectivity::Index v)
  {
    return access.vertex_name(v);
  }
};

template <class Access, class Map>
using Edge_constraints = Constraints<Access, Map, Edge_of_mesh>;
template <class Access, class Map>
using Vertex_constraints = Constraints<Access, Map, Vertex_of_mesh>;

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASE_MAPS_H
