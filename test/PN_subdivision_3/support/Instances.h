// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What many tests instantiate alike, for the precompiled header that they share: with clang++ it is compiled once, and no
// test compiles it again (cmake/PN_joined_tests.cmake). Nothing here is ever called, and no test needs it.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_INSTANCES_H
#define CGAL_PN_SUBDIVISION_3_TEST_INSTANCES_H

#include "Crease_levels.h"

#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace test_instances {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Scheme>
void rounds(const Scheme& scheme)
{
  Mesh mesh;
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>().first;
  PN::subdivide(mesh, scheme, params::number_of_iterations(1).vertex_normal_map(normals));
  PN::subdivide(mesh, PN::linear(scheme), params::number_of_iterations(1));
}

template <class Scheme>
void creased_rounds(const Scheme& scheme)
{
  Mesh mesh;
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>().first;
  const auto sharpness = mesh.add_property_map<Mesh::Edge_index, double>().first;
  PN::subdivide(
    mesh, scheme,
    params::number_of_iterations(1).vertex_normal_map(normals).edge_is_constrained_map(sharpness));
  PN::subdivide(mesh, PN::linear(scheme),
                params::number_of_iterations(1).edge_is_constrained_map(sharpness));
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>().first;
  PN::subdivide(
    mesh, scheme,
    params::number_of_iterations(1).vertex_normal_map(normals).edge_is_constrained_map(sharp));
}

template <class Scheme>
void crease_runs(const Scheme& scheme)
{
  const crease_levels::Control control;
  crease_levels::Crease_run<double, Scheme>(control, scheme).refine();
  crease_levels::Crease_run<double, PN::Linear_scheme<Scheme>>(control, PN::linear(scheme))
    .refine();
  const Mesh mesh;
  PN::Surface_refiner(mesh, scheme, params::number_of_iterations(1)).update();
}

inline void all_rounds()
{
  rounds(PN::CatmullClark_scheme());
  rounds(PN::Loop_scheme());
  creased_rounds(PN::CatmullClark_scheme());
  creased_rounds(PN::Loop_scheme());
  crease_runs(PN::CatmullClark_scheme());
  crease_runs(PN::Loop_scheme());
  rounds(PN::Any_scheme(PN::Loop_scheme()));
}

} // namespace test_instances

#endif // CGAL_PN_SUBDIVISION_3_TEST_INSTANCES_H
