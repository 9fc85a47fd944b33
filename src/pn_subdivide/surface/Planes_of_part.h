// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLANES_OF_PART_H
#define PN_SUBDIVIDE_PLANES_OF_PART_H

#include "surface/Recognized_part.h"
#include "surface/Surface.h"
#include "surface/surface_schemes.h"

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace pn_subdivide {

// The segments of the faces.
struct Segment_map
{
  using key_type = Surface::Face_index;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  friend std::size_t get(const Segment_map& map, key_type f) { return (*map.segments)[f]; }
  const std::vector<std::size_t>* segments;
};

// The planes of a part, as the control mesh has them, for what becomes of them.
class Planes_of_part
{
public:
  Planes_of_part(const Surface& control, const Recognized_part& part);

  // Masks move vertices inside a plane by vertices beyond its rims, and fold it there. They go where they are when control faces
  // are divided evenly, moved as the rims are: harmonically. `parents`: the control faces of the faces.
  void place_inside(Surface& refined, const std::vector<double>& parents,
                    const Scheme_choice& scheme, unsigned levels, unsigned threads) const;

  // How many have rims that cross or touch each other, which those of the control mesh do not. `segments`: of the faces.
  std::size_t number_of_crossed(const Surface& refined, const std::vector<double>& segments) const;

private:
  bool is_plane(std::size_t segment) const;
  std::vector<bool> crossed(const Surface& surface, const std::vector<double>& segments) const;

  Surface control_; // its points
  const Recognized_part& part_;
  std::vector<bool> was_crossed_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLANES_OF_PART_H
