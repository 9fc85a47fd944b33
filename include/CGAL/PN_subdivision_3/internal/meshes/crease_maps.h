// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASE_MAPS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASE_MAPS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// of a value of a map of constraints: true is infinitely sharp, and so is the largest integer
template <class Value>
double sharpness_of(const Value& value)
{
  if constexpr (std::is_same_v<Value, bool>)
    return value ? infinite_sharpness : 0;
  else if constexpr (std::is_integral_v<Value>)
    return value == (std::numeric_limits<Value>::max)() ? infinite_sharpness : double(value);
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

// the value of what is infinitely sharp, see sharpness_of()
template <class Value>
Value sharp_for_ever()
{
  if constexpr (std::numeric_limits<Value>::has_infinity)
    return std::numeric_limits<Value>::infinity();
  else
    return (std::numeric_limits<Value>::max)();
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
template <class Access, class Map, class Element>
class Constraints
{
public:
  using Index = Level_connectivity::Index;

  Constraints(const Access& access, Map map, Index number)
    : access_(access)
    , map_(map)
    , old_(access, number, map)
  {}
  ~Constraints()
  {
    if (is_changed_) old_.put_back(access_);
  }
  Constraints(const Constraints&) = delete;
  Constraints& operator=(const Constraints&) = delete;

  Index number_of_old() const { return old_.size(); }

  double sharpness(Index i) const
  {
    return checked_sharpness(sharpness_of(Value(old_[i])),
                             [&] { return Element::name(access_, i); });
  }

  // Puts the constraints of `number` refined elements. `constraints` has some of them, in the order of
  // the elements: (element, (old element that it is a part of, sharpness)). All others are smooth.
  void put_refined(
    [[maybe_unused]] Index number,
    [[maybe_unused]] const std::vector<std::pair<Index, std::pair<Index, double>>>& constraints)
  {
    if constexpr (is_writable_map_v<Map>) {
      const Index end = are_new_ones_smooth(number) ? old_.size() : number;
      is_changed_ = true;
      Index i = 0;
      for (const auto& c : constraints) {
        put_smooth(i, (std::min)(c.first, end));
        put(map_, Element::at(access_, c.first), value(c.second.second, old_[c.second.first]));
        i = c.first + 1;
      }
      put_smooth(i, end);
    }
  }

  void keep() { is_changed_ = false; }

private:
  using Value = typename Old_values<Map, Element>::Value;

  // what is sharp forever keeps its value, and so does what is beyond the integers that `double` knows
  static Value value(double sharpness, const Value& old)
  {
    if (sharpness == infinite_sharpness) return old;
    if constexpr (std::is_integral_v<Value>)
      if (sharpness >= double((std::numeric_limits<Value>::max)())) return old;
    return Value(sharpness);
  }

  // before anything is put
  bool are_new_ones_smooth([[maybe_unused]] Index number) const
  {
    if constexpr (has_one_new_value_v<Map>)
      return number > old_.size() && get(map_, Element::at(access_, old_.size())) == Value(0);
    else
      return false;
  }

  void put_smooth(Index begin, Index end)
  {
    Index i = begin;
    for (; i < end && i < old_.size(); ++i)
      if (!(old_[i] == Value(0))) put(map_, Element::at(access_, i), Value(0));
    for (; i < end; ++i) put(map_, Element::at(access_, i), Value(0));
  }

  const Access& access_;
  Map map_;
  Old_values<Map, Element> old_;
  bool is_changed_ = false;
};

template <class Access, class Element>
class Constraints<Access, No_constraint_map, Element>
{
public:
  using Index = Level_connectivity::Index;

  Constraints(const Access&, No_constraint_map, Index) {}
  Index number_of_old() const { return 0; }
  double sharpness(Index) const { return 0; }
  void put_refined(Index, const std::vector<std::pair<Index, std::pair<Index, double>>>&) {}
  void keep() {}
};

template <class Access, class Map>
using Edge_constraints = Constraints<Access, Map, Edge_of_mesh>;
template <class Access, class Map>
using Vertex_constraints = Constraints<Access, Map, Vertex_of_mesh>;

// The tangents of creases in a map of half-edges: read before the first round, written for the refined
// half-edges if the map can be written, and put back unless they are kept.
template <class FT, class Access, class Map>
class Crease_tangents
{
public:
  using Index = Level_connectivity::Index;

  Crease_tangents(const Access& access, const Level_connectivity& level, Map map)
    : access_(access)
    , map_(map)
    , old_(access, level.number_of_halfedges(), map)
  {}
  ~Crease_tangents()
  {
    if (is_changed_) old_.put_back(access_);
  }
  Crease_tangents(const Crease_tangents&) = delete;
  Crease_tangents& operator=(const Crease_tangents&) = delete;

  void read(Creases<FT>& creases) const
  {
    for (Crease_edge<FT>& e : creases.edges)
      for (Index side = 0; side < 2; ++side)
        e.tangent_from[side] = checked_tangent(e.halfedge(side));
  }

  // of all half-edges, those without a crease get zero
  void put_refined([[maybe_unused]] const Creases<FT>& creases,
                   [[maybe_unused]] Index number_of_edges)
  {
    if constexpr (is_writable_map_v<Map>) {
      is_changed_ = true;
      auto crease = creases.edges.begin();
      for (Index e = 0; e < number_of_edges; ++e) {
        const bool is_crease = crease != creases.edges.end() && crease->edge == e;
        for (Index side = 0; side < 2; ++side) {
          const auto h = access_.halfedge_at(2 * e + side);
          if (is_crease) {
            const Coordinates<FT, 3>& t = crease->tangent_from[side];
            put(map_, h, Vector(t[0], t[1], t[2]));
          } else
            put(map_, h, Vector(0, 0, 0));
        }
        if (is_crease) ++crease;
      }
    }
  }

  void keep() { is_changed_ = false; }

private:
  using Vector = typename Old_values<Map, Halfedge_of_mesh>::Value;

  Coordinates<FT, 3> checked_tangent(Index h) const
  {
    const Coordinates<FT, 3> t = coordinates_3<FT>(old_[h]);
    const auto name = [&] { return access_.halfedge_name(h); };
    check_finite<FT, 3>(t, "tangent", name);
    const FT longest = FT(1) + Unit_normal_traits<FT>::unit_tolerance();
    if (CGAL::certainly(is_greater(dot(t, t), longest)))
      throw std::invalid_argument("PN_subdivision_3: the tangent of " + name() +
                                  " is longer than 1: give unit vectors, or zero where the tangent "
                                  "is to be made");
    if (is_shorter_than_tangents(t) && !is_zero(t))
      throw std::invalid_argument(
        "PN_subdivision_3: the tangent of " + name() +
        " is shorter than 1e-6, as of a map that has not been set: give unit vectors, and "
        "CGAL::NULL_VECTOR where the tangent is to be made");
    return t;
  }

  static bool is_zero(const Coordinates<FT, 3>& t)
  {
    return std::all_of(t.begin(), t.end(), [](const FT& x) { return CGAL::certainly(x == FT(0)); });
  }

  const Access& access_;
  Map map_;
  Old_values<Map, Halfedge_of_mesh> old_;
  bool is_changed_ = false;
};

template <class FT, class Access>
class Crease_tangents<FT, Access, No_tangent_map>
{
public:
  Crease_tangents(const Access&, const Level_connectivity&, No_tangent_map) {}
  void read(Creases<FT>&) const {}
  void put_refined(const Creases<FT>&, Level_connectivity::Index) {}
  void keep() {}
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASE_MAPS_H
