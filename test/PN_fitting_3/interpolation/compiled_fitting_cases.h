// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What test_compiled_fitting.cpp and its source that is not linked to the libraries do alike.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_COMPILED_FITTING_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_COMPILED_FITTING_CASES_H

#include "Mesh_cases.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_fitting_3/prescribe_limit_data.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <vector>

namespace compiled_fitting_cases {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;

struct Interpolated
{
  std::vector<mesh_cases::Triple> points;
  PN::Limit_interpolation report;
};

// points that interpolate a mesh whose first face has creases about it, or is smooth
template <class Scheme>
Interpolated interpolated_with_creases(const mesh_cases::Soup& soup, const Scheme& scheme,
                                       bool is_sharp)
{
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  mesh_cases::build(soup, mesh);
  auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, bool>("e:sharp", false).first;
  for (const auto h : halfedges_around_face(halfedge(*faces(mesh).begin(), mesh), mesh))
    sharp[edge(h, mesh)] = is_sharp;
  const auto report = PN::interpolate_limit_points(
    mesh, scheme,
    PN::parameters::interpolation_mode(PN::Limit_interpolation::Mode::strict)
      .edge_is_constrained_map(sharp));
  return {mesh_cases::values(mesh, mesh.points()), report};
}

// a mesh the limit of which has its first vertex moved, with the normal there turned
template <class Scheme>
std::vector<mesh_cases::Triple> prescribed(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  using Vertex = CGAL::SM_Vertex_index;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  mesh_cases::build(soup, mesh);
  auto points = mesh.add_property_map<Vertex, std::optional<Kernel::Point_3>>("v:p").first;
  auto normals = mesh.add_property_map<Vertex, std::optional<Kernel::Vector_3>>("v:n").first;
  const Vertex v = *vertices(mesh).begin();
  points[v] = mesh.point(v) + Kernel::Vector_3(0.25, 0, 0.125);
  normals[v] = Kernel::Vector_3(-1, -1, -2);
  PN::prescribe_limit_data(
    mesh, scheme, PN::parameters::prescribed_point_map(points).prescribed_normal_map(normals));
  return mesh_cases::values(mesh, mesh.points());
}

// points and normals that interpolate a mesh in three ways
template <class Scheme>
std::vector<mesh_cases::Triple> interpolated(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  using Mode = PN::Limit_interpolation::Mode;
  using Normals = PN::Limit_interpolation::Normals;
  std::vector<mesh_cases::Triple> all;
  const auto interpolate = [&](Mode mode, Normals which, bool is_estimated) {
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    mesh_cases::build(soup, mesh);
    auto normals =
      mesh.add_property_map<CGAL::SM_Vertex_index, Kernel::Vector_3>("v:n", {0, 0, 0}).first;
    const auto np = PN::parameters::interpolation_mode(mode).interpolation_normals(which);
    if (is_estimated)
      PN::interpolate_limit_points(mesh, scheme, np);
    else
      PN::interpolate_limit_points(mesh, scheme, np.vertex_normal_map(normals));
    for (const auto& x : mesh_cases::values(mesh, mesh.points())) all.push_back(x);
    for (const auto& x : mesh_cases::values(mesh, normals)) all.push_back(x);
  };
  interpolate(Mode::strict, Normals::given, true);
  interpolate(Mode::slide, Normals::natural, false);
  interpolate(Mode::strict, Normals::given, false);
  return all;
}

} // namespace compiled_fitting_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_COMPILED_FITTING_CASES_H
