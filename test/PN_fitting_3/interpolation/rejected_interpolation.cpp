// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Calls that must not compile, as in rejected_arguments.cpp.

#include <CGAL/PN_fitting_3/prescribe_limit_data.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

void reject(Mesh& mesh)
{
  const auto normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("normals").first;
  const auto curvatures =
    mesh.add_property_map<Vertex, std::optional<PN::Prescribed_curvature<Kernel>>>("c").first;

  PN::interpolate_limit_points(mesh, PN::Loop_scheme::Transfer(),
                               params::vertex_normal_map(normals));
  // expected: interpolation is not known for schemes that transfer curvature

  PN::interpolate_limit_points(mesh, PN::Sqrt3_scheme(), params::vertex_normal_map(normals));
  // expected: interpolation is not known for this scheme

  PN::prescribe_limit_data(
    mesh, PN::linear(PN::Loop_scheme()),
    PN::parameters::prescribed_curvature_map(curvatures).vertex_normal_map(normals));
  // expected: curvature is prescribed by the control normals too, and linear

  PN::prescribe_limit_data(mesh, PN::Loop_scheme(),
                           PN::parameters::prescribed_curvature_map(curvatures));
  // expected: prescribed curvatures change the control normals: give a
}
