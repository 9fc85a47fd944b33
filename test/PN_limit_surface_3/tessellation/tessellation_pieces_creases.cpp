// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Tessellations in pieces of parts with creases and borders.

#include "Crease_shapes.h"
#include "Tagged_meshes.h"
#include "Tessellation_piece_cases.h"

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using tessellation_piece_cases::expect_same;

TEST(TessellationPieces, Creases)
{
  for (const crease_shapes::Part& part :
       {crease_shapes::capped_cylinder(crease_shapes::uneven(7)), crease_shapes::half_ball(),
        crease_shapes::octant(), crease_shapes::lens()}) {
    const auto data = part.control();
    tagged_meshes::Tagged<Surface_mesh> control(data);
    expect_same(control.mesh, PN::CatmullClark_scheme(), 0.01,
                PN::parameters::border(data.border)
                  .vertex_normal_map(control.normals)
                  .edge_is_constrained_map(control.sharp)
                  .vertex_is_constrained_map(control.corners),
                false, {1, 3, 8});
  }
}

} // namespace
