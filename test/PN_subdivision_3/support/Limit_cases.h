// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits of control meshes as plain data.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_LIMIT_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_LIMIT_CASES_H

#include "Options.h"
#include "Scheme_runs.h"
#include "reference/Limit.h"

#include <CGAL/PN_limit_surface_3/limit_points.h>

namespace limit_cases {

namespace PN = CGAL::PN_subdivision_3;
using Limit = PN::Limit_point<Kernel>;

struct Limits
{
  std::vector<Limit> at;
  PN::Limit_report report;
};

inline test_options::Limit_options close(double tolerance, double normal_tolerance = HUGE_VAL)
{
  test_options::Limit_options options;
  options.tolerance = tolerance;
  options.normal_tolerance = normal_tolerance;
  options.surface_normals = true;
  options.max_depth = 40;
  return options;
}

// at the vertices, with the control normals of normal_map()
template <class Tag = CGAL::Sequential_tag, class Scheme>
Limits limits(Surface_mesh& mesh, const Scheme& scheme, const test_options::Limit_options& options)
{
  Limits result;
  const auto map = mesh.add_property_map<Surface_mesh::Vertex_index, Limit>("v:limit").first;
  result.report = PN::limit_points<Tag>(
    mesh, scheme, map,
    PN::parameters::join(options.pack(), CGAL::parameters::vertex_normal_map(normal_map(mesh))));
  for (auto v : mesh.vertices()) result.at.push_back(map[v]);
  return result;
}

inline reference::Vector to_vector(const Kernel::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}
inline reference::Vector to_vector(const Kernel::Vector_3& p)
{
  return {p.x(), p.y(), p.z()};
}

inline bool is_finite(const Limit& l)
{
  for (double x : {l.point.x(), l.point.y(), l.point.z(), l.control_normal.x(),
                   l.control_normal.y(), l.control_normal.z(), l.surface_normal.x(),
                   l.surface_normal.y(), l.surface_normal.z(), l.error, l.normal_error})
    if (!std::isfinite(x)) return false;
  return true;
}

// the limit at a vertex by many rounds of the reference rules
template <class Description>
reference::Limit brute_force(const test_meshes::Control_mesh& control, int v, bool linear)
{
  // enough that the rules at the vertex are right, and that it decides on them
  const int rings = Description::is_interpolatory ? 5 : 3;
  const int rounds = Description::is_interpolatory ? 24 : 44;
  const auto [vertices, faces] = reference::cut_out(control.faces, v, 8);
  reference::Patch patch{faces, {}};
  for (int w : vertices) {
    const auto &p = control.points[std::size_t(w)], &n = control.normals[std::size_t(w)];
    patch.values.points.emplace_back(p[0], p[1], p[2]);
    patch.values.normals.emplace_back(n[0], n[1], n[2]);
  }
  return reference::limit_by_rounds(
    patch, [](const auto& list, unsigned round) { return Description::refine(list, round); },
    &Description::finish_round, rounds, rings, linear);
}

} // namespace limit_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_LIMIT_CASES_H
