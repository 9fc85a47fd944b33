// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What tests of interpolation run, with the control normals of normal_map(). It is compiled once for the
// schemes that are listed in interpolation_runs_*.cpp: that costs more than all that is done with it.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_RUNS_H
#define CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_RUNS_H

#include "Limit_cases.h"
#include "Options.h"

namespace interpolation_cases {

namespace PN = CGAL::PN_subdivision_3;
using limit_cases::Limits;
using Options = test_options::Limit_interpolation_options<>;
using Report = PN::Limit_interpolation;
using Chosen = Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>;

template <class Scheme>
struct Interpolation_runs
{
  static Report interpolate(Surface_mesh& mesh, const Scheme& scheme, const Options& options);
};

template <class Scheme>
struct Further_interpolation_runs
{
  static Report some(Surface_mesh& mesh, const Scheme& scheme,
                     const test_options::Limit_interpolation_options<Chosen>& options);
  static Report in_parallel(Surface_mesh& mesh, const Scheme& scheme, const Options& options);
  static void natural_normals(Surface_mesh& mesh, const Scheme& scheme);
};

// the distance of a point from the limit surface of the mesh, sought about a vertex
template <class Scheme>
struct Distance_runs
{
  static double from_limit(Surface_mesh& mesh, const Scheme& scheme, const reference::Vector& point,
                           std::size_t vertex);
};

template <class Scheme>
struct Limit_runs
{
  static Limits at(Surface_mesh& mesh, const Scheme& scheme,
                   const test_options::Limit_options& options);
  // subdivides the mesh; limits and curvatures there
  static Limits refined(Surface_mesh& mesh, const Scheme& scheme, unsigned rounds);
};

template <class Scheme>
Limits limits(Surface_mesh& mesh, const Scheme& scheme, const test_options::Limit_options& options)
{
  return Limit_runs<Scheme>::at(mesh, scheme, options);
}

} // namespace interpolation_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_RUNS_H
