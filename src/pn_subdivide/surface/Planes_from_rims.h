// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLANES_FROM_RIMS_H
#define PN_SUBDIVIDE_PLANES_FROM_RIMS_H

#include "io/Mesh_data.h"
#include "io/Report.h"
#include "surface/Output_normals.h"
#include "surface/Recognized_part.h"
#include "surface/Surface.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pn_subdivide {

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
  std::vector<std::array<Mesh_data::Index, 3>> triangles_;
  std::vector<std::size_t> segment_of_triangle_;
  std::size_t replaced_planes_ = 0, kept_planes_ = 0, replaced_faces_ = 0, kept_faces_ = 0;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLANES_FROM_RIMS_H
