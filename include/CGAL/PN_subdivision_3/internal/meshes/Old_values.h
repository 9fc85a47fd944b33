// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_OLD_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_OLD_VALUES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// \name Elements
// what the key of an index is, and how it is called
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

struct Halfedge_of_mesh
{
  template <class Access>
  static auto at(const Access& access, Level_connectivity::Index h)
  {
    return access.halfedge_at(h);
  }
  template <class Access>
  static std::string name(const Access& access, Level_connectivity::Index h)
  {
    return access.halfedge_name(h);
  }
};

template <class Map>
constexpr bool is_writable_map_v =
  std::is_convertible_v<typename boost::property_traits<Map>::category,
                        boost::writable_property_map_tag>;

// The values that a map has for the old elements, to be put back.
template <class Map, class Element>
class Old_values
{
public:
  using Index = Level_connectivity::Index;
  using Value = std::decay_t<typename boost::property_traits<Map>::value_type>;

  template <class Access>
  Old_values(const Access& access, std::size_t number, Map map)
    : map_(map)
  {
    values_.reserve(number);
    for (Index i = 0; i < number; ++i) values_.push_back(get(map_, Element::at(access, i)));
  }

  Index size() const { return static_cast<Index>(values_.size()); }
  Value operator[](Index i) const { return values_[i]; }

  // a map that throws here too keeps what it has, as does one that is only read
  template <class Access>
  void put_back([[maybe_unused]] const Access& access) noexcept
  {
    if constexpr (is_writable_map_v<Map>)
      for (Index i = 0; i < values_.size(); ++i) try {
          put(map_, Element::at(access, i), Value(values_[i]));
        } catch (...) {
        }
  }

private:
  Map map_;
  std::vector<Value> values_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_OLD_VALUES_H
