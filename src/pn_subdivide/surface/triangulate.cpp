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

using Halfedge = Surface::Halfedge_index;

// New half-edges are behind the old ones. Those that end at a corner of an old face lie between the
// two old ones there.
std::vector<Halfedge> old_corners(const Surface& surface, Surface::size_type old_halfedges)
{
  std::vector<Halfedge> result(surface.number_of_halfedges());
  for (Surface::size_type i = 0; i < old_halfedges; ++i) {
    const Halfedge h(i);
    result[i] = h;
    if (surface.is_border(h)) continue;
    for (Halfedge g = surface.opposite(surface.next(h)); g >= Halfedge(old_halfedges);
         g = surface.opposite(surface.next(g)))
      result[g] = h;
  }
  return result;
}

} // namespace

Triangulation triangulate(Surface& surface)
{
  Triangulation result;
  for (const Surface::Face_index f : surface.faces())
    if (surface.degree(f) > 3) ++result.split_faces;
  if (result.split_faces == 0) return result;

  const Surface::size_type old_halfedges = surface.number_of_halfedges();
  CGAL::Polygon_mesh_processing::triangulate_faces(surface);
  result.old_corner = old_corners(surface, old_halfedges);
  if (const std::optional<Corner_normal_map> normals = corner_normals_of(surface))
    for (const Halfedge h : surface.halfedges()) (*normals)[h] = (*normals)[result.old_corner[h]];
  for (const Surface::Face_index f : surface.faces())
    if (surface.degree(f) > 3)
      throw Error("face " + std::to_string(std::size_t(f)) + " with " +
                  std::to_string(surface.degree(f)) +
                  " vertices cannot be split into triangles: it has no area or crosses itself");
  return result;
}

} // namespace pn_subdivide
