// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_MESH_H
#define PN_SUBDIVIDE_OUTPUT_MESH_H

#include "io/Mesh_data.h"
#include "surface/Output_normals.h"
#include "surface/Surface.h"
#include "surface/creases.h"

#include <optional>
#include <vector>

namespace pn_subdivide {

// Control normals that are written beside others, because these have taken their place in the surface.
struct Kept_normals
{
  std::vector<Triple> of_vertices, of_corners;
  std::vector<double> roundness_of_corners;
};

// The control normals of the surface; those of corners only where vertices have several.
Kept_normals kept_normals(const Surface& surface, const Wedge_list& wedges = {});

// What is written of the surface, which has control normals or those of its limit, or none; `control` are those
// that the limit has replaced. The surface is without creases and perhaps normals afterwards.
Mesh_data output_mesh(Surface& surface, std::optional<Crease_maps>& creases,
                      const Wedge_list& of_wedges, const Output_normals& normals,
                      Kept_normals control);

// The same of a mesh that is neither refined nor moved.
void put_control_normals(Mesh_data& mesh, const Output_normals& normals);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_MESH_H
