// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits of tagged meshes.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_CREASED_LIMIT_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_CREASED_LIMIT_CASES_H

#include "Options.h"
#include "Random_creases.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/Surface_mesh.h>

namespace creased_limit_cases {

using namespace tagged_meshes;
using Mesh = CGAL::Surface_mesh<Point_3>;

inline test_options::Limit_options close(double tolerance)
{
  test_options::Limit_options options;
  options.tolerance = tolerance;
  options.max_depth = 40;
  return options;
}

template <class Any_mesh, class Scheme, class Concurrency_tag = CGAL::Sequential_tag>
PN::Limit_report to_limit(Tagged<Any_mesh>& t, const Scheme& scheme, unsigned rounds,
                          const test_options::Limit_options& options)
{
  return PN::subdivide_to_limit<Concurrency_tag>(
    t.mesh, scheme,
    PN::parameters::join(options.pack(), np::number_of_iterations(rounds)
                                           .edge_is_constrained_map(t.sharp)
                                           .vertex_is_constrained_map(t.corners)
                                           .vertex_normal_map(t.normals)));
}

// the same with the roundness of the vertices
template <class Any_mesh, class Scheme>
PN::Limit_report to_round_limit(Tagged<Any_mesh>& t, const Scheme& scheme, unsigned rounds,
                                const test_options::Limit_options& options)
{
  return PN::subdivide_to_limit(
    t.mesh, scheme,
    PN::parameters::join(options.pack(), PN::parameters::vertex_roundness_map(t.roundness)
                                           .number_of_iterations(rounds)
                                           .edge_is_constrained_map(t.sharp)
                                           .vertex_is_constrained_map(t.corners)
                                           .vertex_normal_map(t.normals)));
}

// the limits at the control vertices, after some rounds: points, and the normals of all corners
struct Limits
{
  std::vector<Vector> points;
  std::vector<std::vector<Vector>> normals;
  PN::Limit_report report;
};

inline Vector vector(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}
inline Vector vector(const Vector_3& p)
{
  return {p.x(), p.y(), p.z()};
}

template <class Scheme>
Limits limits(const Control& control, const Scheme& scheme, unsigned rounds,
              const test_options::Limit_options& options)
{
  Tagged<Mesh> t(control);
  Limits result;
  result.report = to_limit(t, PN::internal::with_border(scheme, control.border), rounds, options);
  for (std::size_t i = 0; i < control.points.size(); ++i) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
    result.points.push_back(vector(t.mesh.point(v)));
    result.normals.emplace_back();
    if (t.mesh.is_isolated(v)) continue;
    for (const auto h : t.mesh.halfedges_around_target(t.mesh.halfedge(v)))
      if (!t.mesh.is_border(h)) result.normals.back().push_back(vector(get(t.normals, h)));
  }
  return result;
}

// the greatest distance of the points, and of any normal from the nearest one of the other limits
inline std::pair<double, double> difference(const Limits& a, const Limits& b)
{
  Real points = 0, normals = 0;
  for (std::size_t v = 0; v < a.points.size(); ++v) {
    points = (std::max)(points, (a.points[v] - b.points[v]).norm());
    for (const Vector& n : a.normals[v]) {
      Real least = std::numeric_limits<Real>::infinity();
      for (const Vector& m : b.normals[v]) least = (std::min)(least, Real((n - m).norm()));
      normals = (std::max)(normals, least);
    }
  }
  return {double(points), double(normals)};
}

// random nets with creases, corners, darts and one or the other border
inline Control random_net(int seed)
{
  std::mt19937 random(static_cast<unsigned>(seed));
  Control c = seed % 2 == 0 ? random_creases::patch() : random_creases::box();
  random_creases::perturb(c, random);
  c.border = std::array{Border::surface, Border::curve, Border::corners,
                        Border::fixed}[static_cast<std::size_t>(seed / 2 % 4)];
  random_creases::tag(c, random, 0.15, {infinity});
  if (seed % 3 == 0) c.sharp_vertices.clear();
  random_creases::give_normals(c, random);
  return c;
}

// the surface of the part that the face lies on and whose normal it has, about; none of a face
// without an area
inline const Surface* surface_of(const Part& part, const Tagged<Mesh>& t, Mesh::Face_index f)
{
  Vector area = Vector::Zero(), mean = Vector::Zero();
  for (const auto h : t.mesh.halfedges_around_face(t.mesh.halfedge(f))) {
    const Vector p = vector(t.mesh.point(t.mesh.source(h)));
    area += p.cross(vector(t.mesh.point(t.mesh.target(h))));
    mean += p / Real(t.mesh.degree(f));
  }
  if (!(area.norm() > 1e-9)) return nullptr;
  area.normalize();
  // a face that is folded over lies on its surface, too
  const auto deviation = [&](const Surface& s) {
    Real greatest = (std::min)((s.normal(mean) - area).norm(), (s.normal(mean) + area).norm());
    for (const auto v : t.mesh.vertices_around_face(t.mesh.halfedge(f)))
      greatest = (std::max)(greatest, s.distance(vector(t.mesh.point(v))));
    return greatest;
  };
  return &*std::min_element(
    part.surfaces.begin(), part.surfaces.end(),
    [&](const Surface& a, const Surface& b) { return deviation(a) < deviation(b); });
}

} // namespace creased_limit_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_CREASED_LIMIT_CASES_H
