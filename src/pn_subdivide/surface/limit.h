// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_LIMIT_H
#define PN_SUBDIVIDE_LIMIT_H

#include "surface/Scheme.h"
#include "surface/Surface.h"
#include "surface/creases.h"

#include <CGAL/PN_subdivision_3/limit_points.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <utility>

// Each has a source file of its own, because a call for every scheme takes long to compile.

namespace pn_subdivide {

using Limit_report = CGAL::PN_subdivision_3::Limit_report;
using Limit_options = CGAL::PN_subdivision_3::Limit_options;
using Limit_point = CGAL::PN_subdivision_3::Limit_point<Kernel>;

// A map of limits that hands each to a function, so that none is kept that is not wanted.
class Limit_map
{
public:
  using key_type = Surface::Vertex_index;
  using value_type = Limit_point;
  using reference = void;
  using category = boost::writable_property_map_tag;
  using Take_limit = std::function<void(key_type, const Limit_point&)>;

  explicit Limit_map(Take_limit take)
    : take_(std::move(take))
  {}

  friend void put(const Limit_map& map, key_type v, const value_type& limit)
  {
    map.take_(v, limit);
  }

private:
  Take_limit take_;
};

Limit_report linear_limits(const Surface& surface, const Scheme& scheme, const Limit_map& limits,
                           const Limit_options& options);

Limit_report limits_with_normals(const Surface& surface, Normal_map normals, const Scheme& scheme,
                                 const Limit_map& limits, const Limit_options& options);

// The schemes must be different and have the same host.
Limit_report limits_with_normal_scheme(const Surface& surface, Normal_map normals,
                                       const Scheme& scheme, const Scheme& normal_scheme,
                                       const Limit_map& limits, const Limit_options& options);

// The same with creases, of a mesh that is changed: it gets the limit points and the normals that are asked for,
// by corners; with a linear scheme, only normals of the surface. The schemes must have rules for creases.
Limit_report move_to_linear_limits(Surface& surface, Corner_normal_map normals,
                                   const Scheme& scheme, const Crease_maps& creases,
                                   const Limit_options& options);
Limit_report move_to_limits_with_normals(Surface& surface, Corner_normal_map normals,
                                         const Scheme& scheme, const Crease_maps& creases,
                                         const Limit_options& options);
Limit_report move_to_limits_with_normal_scheme(Surface& surface, Corner_normal_map normals,
                                               const Scheme& scheme, const Scheme& normal_scheme,
                                               const Crease_maps& creases,
                                               const Limit_options& options);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LIMIT_H
