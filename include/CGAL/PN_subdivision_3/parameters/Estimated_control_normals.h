// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_PARAMETERS_ESTIMATED_CONTROL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_PARAMETERS_ESTIMATED_CONTROL_NORMALS_H

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// a value of each key, which need not be known in advance: of numbers as keys in an array
template <class Key, class Value>
class Values_of_keys
{
public:
  Value& operator[](const Key& key)
  {
    if constexpr (are_numbers) {
      const std::size_t i = key;
      if (i >= values_.size()) values_.resize(i + 1);
      return values_[i];
    } else
      return values_[key];
  }
  Value get(const Key& key) const
  {
    if constexpr (are_numbers) {
      const std::size_t i = key;
      return i < values_.size() ? values_[i] : Value();
    } else {
      const auto it = values_.find(key);
      return it == values_.end() ? Value() : it->second;
    }
  }

private:
  static constexpr bool are_numbers = std::is_convertible_v<Key, std::size_t>;

  std::conditional_t<are_numbers, std::vector<Value>, std::unordered_map<Key, Value>> values_;
};

template <class Kernel>
struct Normal_and_roundness
{
  typename Kernel::Vector_3 normal{0, 0, 0};
  typename Kernel::FT roundness{1};
  bool is_estimated = false; // and tells nothing of the tangents of creases
};

// What functions read and write: a normal that is put here leaves the roundness, which counts if it goes with the map.
template <class Key, class Kernel, bool with_roundness, bool are_estimated = false>
struct Normals_of_estimate
{
  static constexpr bool goes_with_roundness = with_roundness;

  using Values = Values_of_keys<Key, Normal_and_roundness<Kernel>>;
  /// a vertex, or a half-edge for the corner at its target.
  using key_type = Key;
  /// a vector.
  using value_type = typename Kernel::Vector_3;
  /// a vector, by value.
  using reference = value_type;
  /// the map can be read and written.
  using category = boost::read_write_property_map_tag;

  std::shared_ptr<Values> values;

  Normal_and_roundness<Kernel> whole(const Key& key) const { return values->get(key); }
  void put_whole(const Key& key, const Normal_and_roundness<Kernel>& whole) const
  {
    (*values)[key] = whole;
  }
  friend value_type get(const Normals_of_estimate& map, const Key& key)
  {
    return map.values->get(key).normal;
  }
  friend void put(const Normals_of_estimate& map, const Key& key, const value_type& n)
  {
    auto& value = (*map.values)[key];
    value.normal = n;
    value.is_estimated = are_estimated;
  }
};

template <class Key, class Kernel>
struct Roundness_of_estimate
{
  using Values = Values_of_keys<Key, Normal_and_roundness<Kernel>>;
  using key_type = Key;
  using value_type = typename Kernel::FT;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  std::shared_ptr<Values> values;

  friend value_type get(const Roundness_of_estimate& map, const Key& key)
  {
    return map.values->get(key).roundness;
  }
  friend void put(const Roundness_of_estimate& map, const Key& key, const value_type& w)
  {
    (*map.values)[key].roundness = w;
  }
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

Control normals that know how round the surface is at each of them, as `estimate_control_normals()` returns them: a property map for
`vertex_normal_map`, of vertices or of half-edges (normals of corners). The functions of this package read both from it, and refine both.

Who puts a normal says where the surface goes: its roundness becomes 1. A `vertex_roundness_map` or `roundness` beside the map counts in
place of its own roundness, which then stays as it is.

Copies share their values, as those of property maps do; `clone()` does not. The values do not belong to the mesh: other keys than those
that were put have no control normal, and `collect_garbage()` of the mesh, which renumbers them, does not move them.

\tparam Key a vertex descriptor or half-edge descriptor, that can be hashed or converted to an index
\tparam Kernel has the `Vector_3` of the normals and the `FT` of the roundness
*/
template <class Key, class Kernel>
class Estimated_control_normals
{
  using Value = internal::Normal_and_roundness<Kernel>;
  using Values = internal::Values_of_keys<Key, Value>;

public:
  /// a vertex, or a half-edge for the corner at its target.
  using key_type = Key;
  /// a vector.
  using value_type = typename Kernel::Vector_3;
  /// a vector, by value.
  using reference = value_type;
  /// the map can be read and written.
  using category = boost::read_write_property_map_tag;

  /// no normals, and roundness 1.
  Estimated_control_normals()
    : values_(std::make_shared<Values>())
  {}

  /// the same with values of its own, for a copy of the mesh.
  Estimated_control_normals clone() const
  {
    Estimated_control_normals other;
    *other.values_ = *values_;
    return other;
  }

  /// the roundness, a property map of the same keys that can be read and written.
  auto roundness_map() const { return internal::Roundness_of_estimate<Key, Kernel>{values_}; }

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
    (*all.values_)[key] = Value{n};
  }

  /// \cond SKIP_IN_MANUAL
  template <bool goes_with_roundness, bool are_estimated = false>
  auto normals() const
  {
    return internal::Normals_of_estimate<Key, Kernel, goes_with_roundness, are_estimated>{values_};
  }
  /// \endcond

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

// what is read and written of any map of normals
template <bool goes_with_roundness, bool are_estimated = false, class Map>
auto normals_of(const Map& map)
{
  if constexpr (Is_estimate<Map>::value)
    return map.template normals<goes_with_roundness, are_estimated>();
  else
    return map;
}

// whether a map has a Normal_and_roundness of each key, of which the roundness counts or not
template <class Map, class = void>
constexpr bool is_of_estimate_v = false;
template <class Map>
inline constexpr bool is_of_estimate_v<Map, std::void_t<decltype(Map::goes_with_roundness)>> = true;

template <class Map, class = void>
constexpr bool goes_with_roundness_v = false;
template <class Map>
inline constexpr bool goes_with_roundness_v<Map, std::enable_if_t<Map::goes_with_roundness>> = true;

// all that a map has of a key
template <class Map, class Key>
auto get_whole(const Map& map, const Key& key)
{
  if constexpr (is_of_estimate_v<Map>)
    return map.whole(key);
  else
    return typename boost::property_traits<Map>::value_type(get(map, key));
}
template <class Map, class Key, class Whole>
void put_whole(Map& map, const Key& key, const Whole& whole)
{
  if constexpr (is_of_estimate_v<Map>)
    map.put_whole(key, whole);
  else
    put(map, key, whole);
}

} // namespace internal
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_PARAMETERS_ESTIMATED_CONTROL_NORMALS_H
