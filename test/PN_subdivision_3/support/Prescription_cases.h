// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes with prescribed limit data.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_PRESCRIPTION_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_PRESCRIPTION_CASES_H

#include "Interpolation_cases.h"
#include "Options.h"

#include <optional>

namespace interpolation_cases {

using Index = Surface_mesh::Vertex_index;
using Curvature = PN::Prescribed_curvature<Kernel>;

constexpr double degree = 0.017453292519943295;

inline double angle(const Kernel::Vector_3& a, const Kernel::Vector_3& b)
{
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

struct Prescription
{
  template <class T>
  using Map = Surface_mesh::Property_map<Index, std::optional<T>>;

  Surface_mesh mesh;
  Map<Kernel::Point_3> points;
  Map<Kernel::Vector_3> normals;
  Map<Curvature> curvatures;
  test_options::Limit_prescription_options options;

  explicit Prescription(const Control_mesh& control)
    : mesh(to_surface_mesh(control))
    , points(mesh.add_property_map<Index, std::optional<Kernel::Point_3>>("v:p").first)
    , normals(mesh.add_property_map<Index, std::optional<Kernel::Vector_3>>("v:n").first)
    , curvatures(mesh.add_property_map<Index, std::optional<Curvature>>("v:c").first)
  {}
};

// compiled once, as Interpolation_runs
template <class Scheme>
struct Prescription_runs
{
  static Report solve(Prescription& p, const Scheme& scheme);
};
template <class Scheme>
struct Curvature_runs
{
  static Report solve(Prescription& p, const Scheme& scheme);
  // The second fundamental form of the limit at a vertex, positive where the surface bends towards its
  // normal, and the normal.
  static std::pair<Eigen::Matrix3d, Eigen::Vector3d> form(Surface_mesh& mesh, const Scheme& scheme,
                                                          unsigned vertex);
};

} // namespace interpolation_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_PRESCRIPTION_CASES_H
