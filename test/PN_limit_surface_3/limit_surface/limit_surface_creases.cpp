// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Limit surfaces of parts with creases and borders, whose surfaces are known.

#include "Crease_shapes.h"
#include "Surface_checks.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/Surface_mesh.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

TEST(LimitSurface, Parts)
{
  for (crease_shapes::Part part : {crease_shapes::capped_cylinder(crease_shapes::uneven(7)),
                                   crease_shapes::half_ball(), crease_shapes::octant()}) {
    part.place();
    const auto data = part.control();
    tagged_meshes::Tagged<Mesh> control(data);
    const PN::Limit_surface surface(control.mesh, PN::CatmullClark_scheme(),
                                    PN::parameters::border(data.border)
                                      .tolerance(5e-3)
                                      .vertex_normal_map(control.normals)
                                      .edge_is_constrained_map(control.sharp)
                                      .vertex_is_constrained_map(control.corners));
    const auto places = surface_checks::grid_places(surface, [](auto) { return 3; });
    const auto is_end = [](double x) { return std::fmod(x, 1) == 0; };
    auto place = places.begin();
    for (const auto& s : surface.evaluate(places)) {
      // only vertices may be irregular in all rounds, whatever half-edges the creases are cut at
      const bool is_corner = is_end(place->u) && is_end(place->v);
      EXPECT_TRUE(is_corner || s.derivatives == 2)
        << place->face << " " << place->u << " " << place->v;
      ++place;
      crease_shapes::Real least = crease_shapes::infinity;
      for (const auto& of : part.surfaces)
        least = (std::min)(least, of.distance({s.point.x(), s.point.y(), s.point.z()}));
      EXPECT_LE(double(least), 1e-9);
    }
  }
}

} // namespace
