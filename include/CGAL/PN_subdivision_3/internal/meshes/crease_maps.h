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
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
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
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// the sharpness by a value of a map of constraints: true is infinitely sharp, and so is the largest integer
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

// the sharpness of a key of such a map
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
// refined elements if the map can be written, and put back without commit().
template <class Access, class Map, class Element>
class Constraints
{
public:
  using Index = Level_connectivity::Index;

  Constraints(const Access& access, Map map, Index number)
    : map_(access, map, number)
  {}

  Index number_of_old() const { return static_cast<Index>(map_.old().size()); }

  double sharpness([[maybe_unused]] Index i) const
  {
    if constexpr (is_there_v<Map>)
      return checked_sharpness(sharpness_of(Value(map_.old()[i])),
                               [&] { return Element::name(map_.access(), i); });
    else
      return 0;
  }

  // Puts the constraints of `number` refined elements. `constraints` has some of them, in the order of
  // the elements: (element, (old element that it is a part of, sharpness)). All other elements are smooth.
  void put_refined(
    [[maybe_unused]] Index number,
    [[maybe_unused]] const std::vector<std::pair<Index, std::pair<Index, double>>>& constraints)
  {
    if constexpr (is_writable_map_v<Map>) {
      const Index end = are_new_ones_smooth(number) ? number_of_old() : number;
      map_.begin();
      Index i = 0;
      for (const auto& c : constraints) {
        put_smooth(i, (std::min)(c.first, end));
        map_.set(c.first, value(c.second.second, map_.old()[c.second.first]));
        i = c.first + 1;
      }
      put_smooth(i, end);
    }
  }

  void commit() { map_.commit(); }

private:
  using Undoable = Undoable_map<Access, Map, Element>;
  using Value = typename Undoable::Value;

  // an infinitely sharp element keeps its value, and so does a value beyond the integers that `double` knows
  static Value value(double sharpness, const Value& old)
  {
    if (sharpness == infinite_sharpness) return old;
    if constexpr (std::is_integral_v<Value>)
      if (sharpness >= double((std::numeric_limits<Value>::max)())) return old;
    return Value(sharpness);
  }

  // asked before anything is put
  bool are_new_ones_smooth([[maybe_unused]] Index number) const
  {
    if constexpr (has_one_new_value_v<Map>)
      return number > number_of_old() &&
             get(map_.map(), Element::at(map_.access(), number_of_old())) == Value(0);
    else
      return false;
  }

  void put_smooth(Index begin, Index end)
  {
    Index i = begin;
    for (; i < end && i < number_of_old(); ++i)
      if (!(map_.old()[i] == Value(0))) map_.set(i, Value(0));
    for (; i < end; ++i) map_.set(i, Value(0));
  }

  Undoable map_;
};

template <class Access, class Map>
using Edge_constraints = Constraints<Access, Map, Edge_of_mesh>;
template <class Access, class Map>
using Vertex_constraints = Constraints<Access, Map, Vertex_of_mesh>;

// The tangents of creases in a map of half-edges: read before the first round, written for the refined
// half-edges if the map can be written, and put back without commit().
template <class FT, class Access, class Map>
class Crease_tangents
{
public:
  using Index = Level_connectivity::Index;

  Crease_tangents(const Access& access, const Level_connectivity& level, Map map)
    : map_(access, map, level.number_of_halfedges())
  {}

  void read([[maybe_unused]] Creases<FT>& creases) const
  {
    if constexpr (is_readable_v<Map>)
      for (Crease_edge<FT>& e : creases.edges)
        for (Index side = 0; side < 2; ++side)
          e.tangent_from[side] = checked_tangent(e.halfedge(side));
  }

  // puts the tangents of all half-edges; half-edges without a crease get zero
  void put_refined([[maybe_unused]] const Creases<FT>& creases,
                   [[maybe_unused]] Index number_of_edges)
  {
    if constexpr (is_writable_map_v<Map>) {
      map_.begin();
      auto crease = creases.edges.begin();
      for (Index e = 0; e < number_of_edges; ++e) {
        const bool is_crease = crease != creases.edges.end() && crease->edge == e;
        for (Index side = 0; side < 2; ++side)
          map_.set_vector(2 * e + side,
                          is_crease ? crease->tangent_from[side] : zero_vector<FT, 3>());
        if (is_crease) ++crease;
      }
    }
  }

  void commit() { map_.commit(); }

private:
  Coordinates<FT, 3> checked_tangent(Index h) const
  {
    const Coordinates<FT, 3> t = coordinates_3<FT>(map_.old()[h]);
    const auto name = [&] { return map_.access().halfedge_name(h); };
    check_finite<FT, 3>(t, "tangent", name);
    const FT longest = FT(1) + Unit_normal_traits<FT>::unit_tolerance();
    if (CGAL::certainly(is_greater(dot(t, t), longest)))
      throw std::invalid_argument("PN_subdivision_3: the tangent of " + name() +
                                  " is longer than 1: give unit vectors, or zero where the tangent "
                                  "is to be made");
    if (is_shorter_than_tangents(t) && !are_certainly_equal(t, zero_vector<FT, 3>()))
      throw std::invalid_argument(
        "PN_subdivision_3: the tangent of " + name() +
        " is shorter than 1e-6, as of a map that has not been set: give unit vectors, and "
        "CGAL::NULL_VECTOR where the tangent is to be made");
    return t;
  }

  Undoable_map<Access, Map, Halfedge_of_mesh> map_;
};

// Refuses what is still sharp after the rounds, but not for ever.
template <class FT, class Access>
void require_sharp_for_ever(const Access& access, const Creases<FT>& creases, unsigned rounds)
{
  const auto require = [&](double s, Function_ref<std::string()> name) {
    if (s == infinite_sharpness || s <= rounds) return;
    std::ostringstream message;
    message << "PN_subdivision_3: the sharpness of " << name() << " is " << s
            << ", and limits are known only of what is smooth or sharp forever: ";
    const double missing = std::ceil(s) - rounds;
    message << "subdivide by " << missing << (missing == 1 ? " more round" : " more rounds")
            << ", or make it infinite";
    throw std::invalid_argument(message.str());
  };
  for (const Crease_edge<FT>& e : creases.edges)
    require(e.sharpness, [&] { return Edge_of_mesh::name(access, e.edge); });
  for (const Crease_star& star : creases.stars)
    require(star.sharpness, [&] { return access.vertex_name(star.vertex); });
}
template <class FT, class Access>
void require_sharp_for_ever(const Access&, No_creases, unsigned)
{}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASE_MAPS_H
