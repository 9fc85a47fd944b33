// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ESTIMATED_CONTROL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_ESTIMATED_CONTROL_NORMALS_H

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// a value of each key, which need not be known in advance: of numbers as keys in an array
template <class Key, class Value_, bool are_numbers = std::is_convertible_v<Key, std::size_t>>
class Values_of_keys
{
public:
  using Value = Value_;

  Value& operator[](const Key& key) { return values_[key]; }
  Value get(const Key& key) const
  {
    const auto it = values_.find(key);
    return it == values_.end() ? Value() : it->second;
  }

private:
  std::unordered_map<Key, Value> values_;
};
template <class Key, class Value_>
class Values_of_keys<Key, Value_, true>
{
public:
  using Value = Value_;

  Value& operator[](const Key& key)
  {
    const std::size_t i = key;
    if (i >= values_.size()) values_.resize(i + 1);
    return values_[i];
  }
  Value get(const Key& key) const
  {
    const std::size_t i = key;
    return i < values_.size() ? values_[i] : Value();
  }

private:
  std::vector<Value> values_;
};

template <class Kernel>
struct Normal_and_roundness
{
  typename Kernel::Vector_3 normal{0, 0, 0};
  typename Kernel::FT roundness{1};
};

// the property map of a member of values
template <class Key, class T, class Values, T Values::Value::*member>
struct Member_of_values
{
  using key_type = Key;
  using value_type = T;
  using reference = T;
  using category = boost::read_write_property_map_tag;

  std::shared_ptr<Values> values;

  friend T get(const Member_of_values& map, const Key& key) { return map.values->get(key).*member; }
  friend void put(const Member_of_values& map, const Key& key, const T& x)
  {
    (*map.values)[key].*member = x;
  }
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

Control normals that know how round the surface is, as `estimate_control_normals()` returns them: a property map for
`vertex_normal_map`, of vertices or of half-edges (normals of corners). The functions of this package read both from it, and refine both.

Who puts a normal says where the surface goes: its roundness becomes 1. A `vertex_roundness_map` or `roundness` beside the map counts in
place of its own roundness, which then stays as it is.

Copies share their values, as those of property maps do. These do not belong to the mesh: they grow by what is put, and other keys have
the zero vector, "no control normal", and roundness 1. Vertices that the mesh renumbers, by `collect_garbage()`, have to be estimated again.

\tparam Key a vertex descriptor or half-edge descriptor, that can be hashed or converted to an index
\tparam Kernel has the `Vector_3` of the normals and the `FT` of the roundness
*/
template <class Key, class Kernel>
class Estimated_control_normals
{
  using Value = internal::Normal_and_roundness<Kernel>;
  using Values = internal::Values_of_keys<Key, Value>;

public:
  using key_type = Key;
  using value_type = typename Kernel::Vector_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  /// a property map of the same keys, which can be read and written.
  using Roundness_map =
    internal::Member_of_values<Key, typename Kernel::FT, Values, &Value::roundness>;
  /// a property map of the normals alone: one that is put leaves the roundness.
  using Normal_map = internal::Member_of_values<Key, value_type, Values, &Value::normal>;

  /// no normals, and roundness 1.
  Estimated_control_normals()
    : values_(std::make_shared<Values>())
  {}

  /// the roundness.
  Roundness_map roundness_map() const { return {values_}; }
  /// the normals alone.
  Normal_map normal_map() const { return {values_}; }

  /// a normal, to be read.
  const value_type operator[](const key_type& key) const { return values_->get(key).normal; }

  /// a normal.
  friend value_type get(const Estimated_control_normals& all, const key_type& key)
  {
    return all[key];
  }
  /// sets a normal, and the roundness to 1.
  friend void put(const Estimated_control_normals& all, const key_type& key, const value_type& n)
  {
    Value& value = (*all.values_)[key];
    value.normal = n;
    value.roundness = 1;
  }

private:
  std::shared_ptr<Values> values_;
};

namespace internal {

template <class Map>
struct Is_estimate : std::false_type
{
  using key_type = void;
};
template <class Key, class Kernel>
struct Is_estimate<Estimated_control_normals<Key, Kernel>> : std::true_type
{
  using key_type = Key;
};

// Normals of corners, beside which none has its own roundness: what the functions here read and write. Of vertices they take
// the two maps of the estimate.
template <class Estimate>
struct Normals_with_roundness
{
  using key_type = typename Estimate::key_type;
  using value_type = typename Estimate::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  Estimate estimate;

  auto roundness_map() const { return estimate.roundness_map(); }

  friend value_type get(const Normals_with_roundness& map, const key_type& key)
  {
    return get(map.estimate, key);
  }
  friend void put(const Normals_with_roundness& map, const key_type& key, const value_type& n)
  {
    put(map.estimate.normal_map(), key, n);
  }
};

template <class Map>
constexpr bool has_own_roundness_v = false;
template <class Estimate>
inline constexpr bool has_own_roundness_v<Normals_with_roundness<Estimate>> = true;

// what a map of normals has of a key, with its own roundness
template <class Map, class Key>
auto get_whole(const Map& map, const Key& key)
{
  typename boost::property_traits<Map>::value_type n = get(map, key);
  if constexpr (has_own_roundness_v<Map>)
    return std::make_pair(n, get(map.roundness_map(), key));
  else
    return n;
}
template <class Map, class Key, class Whole>
void put_whole(const Map& map, const Key& key, const Whole& whole)
{
  if constexpr (has_own_roundness_v<Map>) {
    put(map, key, whole.first);
    put(map.roundness_map(), key, whole.second);
  } else
    put(map, key, whole);
}

// a map in which normals are put without a word about the roundness
template <class Map>
auto normals_alone(const Map& map)
{
  if constexpr (Is_estimate<Map>::value)
    return map.normal_map();
  else
    return map;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_ESTIMATED_CONTROL_NORMALS_H
