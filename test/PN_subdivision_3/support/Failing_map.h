// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Property maps of which a call fails, as a user's may.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_FAILING_MAP_H
#define CGAL_PN_SUBDIVISION_3_TEST_FAILING_MAP_H

#include <boost/property_map/property_map.hpp>

#include <atomic>
#include <stdexcept>

namespace failing_maps {

struct User_failure : std::runtime_error
{
  User_failure()
    : std::runtime_error("the user's map fails")
  {}
};

// How many calls of put(), and of get() if these count, do what they should. The one after these fails, and no other, or all
// that follow, too.
struct Calls_left
{
  explicit Calls_left(long n, bool gets_count = false)
    : number(n)
    , counts_gets(gets_count)
  {}
  void count()
  {
    const long left = number--;
    if (left == 0 || (fails_for_good && left < 0)) throw User_failure();
  }

  std::atomic<long> number;
  bool counts_gets;
  bool fails_for_good = false;
};

template <class Map>
struct Failing_map
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  friend value_type get(const Failing_map& m, const key_type& k)
  {
    if (m.left->counts_gets) m.left->count();
    using boost::get;
    return get(m.map, k);
  }
  friend void put(const Failing_map& m, const key_type& k, const value_type& x)
  {
    m.left->count();
    using boost::put;
    put(m.map, k, x);
  }

  Map map;
  Calls_left* left;
};

template <class Map>
Failing_map<Map> failing(const Map& map, Calls_left& left)
{
  return {map, &left};
}

} // namespace failing_maps

#endif // CGAL_PN_SUBDIVISION_3_TEST_FAILING_MAP_H
