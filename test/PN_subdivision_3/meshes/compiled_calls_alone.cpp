// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A source of test_compiled_calls.cpp that is not linked to the libraries: its macros are undefined. The kernel is another one, so that
// functions of users are not shared.

#include "Mesh_cases.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Surface_mesh.h>

std::vector<mesh_cases::Triple> limits_of_headers(bool is_cube)
{
  namespace PN = CGAL::PN_subdivision_3;
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  static_assert(!PN::internal::is_linked_to_library);
  CGAL::Surface_mesh<Point> mesh;
  mesh_cases::build(is_cube ? mesh_cases::cube() : mesh_cases::tetrahedron(), mesh);
  const auto limits = mesh.add_property_map<CGAL::SM_Vertex_index, Point>("v:limit").first;
  const auto np = PN::parameters::limit_point_map(limits);
  if (is_cube)
    PN::limit_points(mesh, PN::CatmullClark_scheme(), np);
  else
    PN::limit_points(mesh, PN::Loop_scheme(), np);
  return mesh_cases::values(mesh, limits);
}
