// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "surface/Surface.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <string>

namespace pn_subdivide {

std::size_t triangulate(Surface& surface)
{
  std::size_t polygons = 0;
  for (const Surface::Face_index f : surface.faces())
    if (surface.degree(f) > 3) ++polygons;
  if (polygons == 0) return 0;

  CGAL::Polygon_mesh_processing::triangulate_faces(surface);
  for (const Surface::Face_index f : surface.faces())
    if (surface.degree(f) > 3)
      throw Error("face " + std::to_string(std::size_t(f)) + " with " +
                  std::to_string(surface.degree(f)) +
                  " vertices cannot be split into triangles: it has no area or crosses itself");
  return polygons;
}

} // namespace pn_subdivide
