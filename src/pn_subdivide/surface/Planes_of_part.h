// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLANES_OF_PART_H
#define PN_SUBDIVIDE_PLANES_OF_PART_H

#include "io/Mesh_data.h"
#include "io/Report.h"
#include "surface/Recognized_part.h"
#include "surface/Surface.h"
#include "surface/output_mesh.h"
#include "surface/surface_schemes.h"

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pn_subdivide {

// The segments of the faces.
struct Segment_map
{
  using key_type = Face;
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
                    const Scheme_choice& scheme, unsigned levels) const;

  // How many have rims that cross or touch each other, which those of the control mesh do not. `segments`: of the faces.
  std::size_t number_of_crossed(const Surface& refined, const std::vector<double>& segments) const;

private:
  std::vector<bool> crossed(const Surface& surface, const std::vector<double>& segments) const;

  Surface control_; // its points
  const Recognized_part& part_;
  std::vector<bool> was_crossed_;
};

struct Surface_options;

// --planes rims: throws Usage_error if it does not go with the other options.
void require_options_for_planes(const Surface_options& options);

// Whether planes become triangles between their rims: where that is asked for, and with --sharp surfaces where the result is
// no control data and has been refined.
bool takes_planes_from_rims(const Surface_options& options, const Output_normals& normals);

// Planes of a refined mesh, triangulated anew from their rims.
class Planes_from_rims
{
public:
  // segments: of the faces
  Planes_from_rims(const Surface& surface, const std::vector<double>& segments,
                   const Recognized_part& part);

  // Puts the triangles in the place of the planes' faces, behind all others; vertices inside planes go. Corners have what their
  // vertices had there. `mesh`: of the surface, with its attributes.
  void put_into(Mesh_data& mesh) const;
  bool replaces(std::size_t segment) const { return is_replaced_[segment]; }

  // Notes what was done, and warns of planes that keep their faces.
  void report(const std::string& output, Report& report) const;

private:
  std::vector<std::size_t> segment_; // of the old faces
  std::vector<bool> is_replaced_;    // the segment
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<std::size_t> segment_of_triangle_;
  std::size_t replaced_planes_ = 0, kept_planes_ = 0, replaced_faces_ = 0;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLANES_OF_PART_H
