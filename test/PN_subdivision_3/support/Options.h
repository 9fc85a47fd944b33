// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Options as structs, of which a test changes one after the other, and the named parameters that say the same.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_OPTIONS_H
#define CGAL_PN_SUBDIVISION_3_TEST_OPTIONS_H

#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>

namespace test_options {

namespace of_call = CGAL::PN_subdivision_3::parameters;

struct Limit_options : CGAL::PN_subdivision_3::internal::Limit_options
{
  auto pack() const
  {
    return of_call::shared(of_call::tolerance(tolerance)
                             .points(points)
                             .normal_tolerance(normal_tolerance)
                             .max_depth(max_depth)
                             .surface_normals(surface_normals)
                             .curve_normals(curve_normals)
                             .curvatures(curvatures)
                             .rounds_done(rounds_done));
  }
};
using Curve_limit_options = Limit_options;

template <class VertexMap = CGAL::PN_subdivision_3::internal::All_vertices>
struct Limit_interpolation_options : CGAL::PN_subdivision_3::internal::Interpolation_options
{
  auto pack() const
  {
    return of_call::shared(of_call::interpolation_mode(mode)
                             .interpolation_normals(normals)
                             .free_vertices(free)
                             .tolerance(tolerance)
                             .max_depth(max_depth)
                             .max_steps(max_steps)
                             .vertex_is_interpolated_map(vertices));
  }
  VertexMap vertices = VertexMap();
};

struct Limit_prescription_options : CGAL::PN_subdivision_3::internal::Interpolation_options
{
  auto pack() const
  {
    return of_call::shared(of_call::tolerance(tolerance)
                             .max_depth(max_depth)
                             .rings(rings)
                             .curvature_tolerance(curvature_tolerance)
                             .max_curvature_steps(max_curvature_steps));
  }
};

// attributes that a test hands on before they are a parameter
template <class... Items>
CGAL::PN_subdivision_3::internal::Attributes<Items...> attributes(const Items&... items)
{
  return {std::tuple<Items...>(items...)};
}

} // namespace test_options

#endif // CGAL_PN_SUBDIVISION_3_TEST_OPTIONS_H
