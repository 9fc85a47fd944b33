// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ORIGIN_MAP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ORIGIN_MAP_H

#include <CGAL/PN_subdivision_3/Control_element.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Carried_attributes.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Map_values.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A map that gets where elements come from: a Control_element, or the number of the first control face. What it
// had is put back if it can be read.
template <class Access, class Map, class Keys>
class Origin_map : public Origin_values
{
public:
  Origin_map(const Access& access, Map map, std::size_t number)
    : map_(access, map, first_indices(number))
  {}

  void begin(std::size_t) override { map_.begin(); }
  void set(Index element, const Control_element& origin, [[maybe_unused]] Index face) override
  {
    if constexpr (std::is_same_v<Value, Control_element>)
      map_.set(element, origin);
    else
      map_.set(element, static_cast<Value>(face));
  }
  void keep() noexcept override { map_.keep(); }

private:
  using Value = std::decay_t<typename boost::property_traits<Map>::value_type>;

  Restored_map<Access, Map, Keys> map_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ORIGIN_MAP_H
