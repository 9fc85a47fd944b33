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

namespace {

// New half-edges are behind the old ones. Those that end at a corner of an old face lie between the
// two old ones there.
void give_normals_to_diagonals(const Surface& surface, Surface::size_type old_halfedges)
{
  const std::optional<Corner_normal_map> normals = corner_normals_of(surface);
  if (!normals) return;
  for (Surface::size_type i = 0; i < old_halfedges; ++i) {
    const Surface::Halfedge_index h(i);
    if (surface.is_border(h)) continue;
    for (auto g = surface.opposite(surface.next(h)); g >= Surface::Halfedge_index(old_halfedges);
         g = surface.opposite(surface.next(g)))
      (*normals)[g] = (*normals)[h];
  }
}

} // namespace

std::size_t triangulate(Surface& surface)
{
  std::size_t polygons = 0;
  for (const Surface::Face_index f : surface.faces())
    if (surface.degree(f) > 3) ++polygons;
  if (polygons == 0) return 0;

  const Surface::size_type old_halfedges = surface.number_of_halfedges();
  CGAL::Polygon_mesh_processing::triangulate_faces(surface);
  give_normals_to_diagonals(surface, old_halfedges);
  for (const Surface::Face_index f : surface.faces())
    if (surface.degree(f) > 3)
      throw Error("face " + std::to_string(std::size_t(f)) + " with " +
                  std::to_string(surface.degree(f)) +
                  " vertices cannot be split into triangles: it has no area or crosses itself");
  return polygons;
}

} // namespace pn_subdivide
