// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// As Instances.h, for tests of limits, the command and its tests.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_LIMIT_INSTANCES_H
#define CGAL_PN_SUBDIVISION_3_TEST_LIMIT_INSTANCES_H

#include "Instances.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>

#include <Eigen/Dense>

namespace test_instances {

template <class Scheme>
void limits(const Scheme& scheme)
{
  Mesh mesh;
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>().first;
  const auto at = mesh.add_property_map<Mesh::Vertex_index, PN::Limit_point<Kernel>>().first;
  PN::limit_points(mesh, scheme, at, params::vertex_normal_map(normals));
  PN::limit_points(mesh, scheme, at,
                   PN::parameters::surface_normals(true).vertex_normal_map(normals));
  PN::limit_points(mesh, PN::linear(scheme), at);
}

template <class Scheme>
void interpolations(const Scheme& scheme)
{
  Mesh mesh;
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>().first;
  PN::interpolate_limit_points(mesh, scheme, params::vertex_normal_map(normals));
}

inline void all_limits()
{
  limits(PN::CatmullClark_scheme());
  limits(PN::Loop_scheme());
  interpolations(PN::CatmullClark_scheme());
}

} // namespace test_instances

#endif // CGAL_PN_SUBDIVISION_3_TEST_LIMIT_INSTANCES_H
