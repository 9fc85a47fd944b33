// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_TESSELLATE_SURFACE_H
#define PN_SUBDIVIDE_TESSELLATE_SURFACE_H

#include "io/Report.h"
#include "surface/Surface.h"
#include "surface/control_mesh.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <CGAL/PN_limit_surface_3/tessellation/Tessellation_result.h>
#include <CGAL/PN_subdivision_3/attributes.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace pn_subdivide {

struct Surface_options;

// --chord and --chord-bound: throws Usage_error if they are wrong.
std::optional<Box_length> parse_chord(const Surface_options& options);
// Throws Usage_error if --chord does not go with the other options.
void require_options_for_tessellation(const Surface_options& options);

// What the library tells of one.
struct Tessellation
{
  double bound = 0;
  bool reached = true;
  CGAL::PN_subdivision_3::Tessellation_result::Obstacle obstacle =
    CGAL::PN_subdivision_3::Tessellation_result::Obstacle::none;
  std::size_t triangles = 0;
  unsigned depth = 0;
  std::size_t worst_face = 0;
  std::array<double, 3> worst_place{};
  bool is_proven = false;
};

// The surface becomes triangles between points of its limit surface, of which these are no farther than `chord`, as is estimated or
// proved. With
// normals of vertices, with creases of corners; without creases and control data. Passes on the library's exceptions.
Tessellation tessellate_surface(Surface& surface, const Scheme_choice& scheme,
                                const std::optional<Crease_maps>& creases, double chord,
                                bool is_proven, unsigned threads,
                                CGAL::PN_subdivision_3::Attribute_table& attributes);

// Says what was reached, and warns if that is not what was asked for.
void report_tessellation(const Tessellation& tessellation, double chord, const std::string& output,
                         Report& report);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_TESSELLATE_SURFACE_H
