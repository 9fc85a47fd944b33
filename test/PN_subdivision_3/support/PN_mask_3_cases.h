// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Control meshes with normals on spheres, for the tests of PN_mask_3.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_PN_MASK_3_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_PN_MASK_3_CASES_H

#include "Mesh_cases.h"
#include "Scheme_description.h"

#include <boost/property_map/property_map.hpp>

#include <map>
#include <memory>

using test_meshes::Control_mesh;
using test_meshes::Triple;

// A mesh with a normal map.
template <class Mesh_>
struct Control
{
  using Mesh = Mesh_;
  using Point_map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using Vector = typename Kernel::Vector_3;
  using Normals = std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, Vector>;

  Mesh mesh;
  std::shared_ptr<Normals> store = std::make_shared<Normals>();
  boost::associative_property_map<Normals> normals{*store};

  explicit Control(const Control_mesh& control)
  {
    mesh_cases::build(control, mesh);
    mesh_cases::put_normals(control.normals, mesh, normals);
  }
  auto point_normals()
  {
    return CGAL::PN_subdivision_3::Zipped_point_normal_map(get(CGAL::vertex_point, mesh), normals);
  }
};

// Triangles with interior valences from 3 on, or a pentagon, quads and triangles. Open: without two neighboring faces.
template <class Scheme>
Control_mesh control_mesh(bool closed)
{
  using namespace test_meshes;
  Control_mesh mesh = Scheme::triangles ? with_centers(bipyramid(7), 14) : house(5);
  if (!closed)
    for (const int f : {9, 7}) mesh.faces.erase(mesh.faces.begin() + f);
  return mesh;
}

// with normals of any length
inline Control_mesh on_sphere(Control_mesh mesh, double radius, double length = 1)
{
  mesh.normals.clear();
  for (Triple& p : mesh.points) {
    const Triple n = test_meshes::unit(p);
    p = {radius * n[0], radius * n[1], radius * n[2]};
    mesh.normals.push_back({length * n[0], length * n[1], length * n[2]});
  }
  return mesh;
}

template <class Scheme, class Control>
void subdivide_pn(Control& control, unsigned int rounds)
{
  const auto map = control.point_normals();
  Scheme::host(control.mesh, Scheme::mask(control.mesh, map),
               CGAL::parameters::vertex_point_map(map).number_of_iterations(rounds));
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_PN_MASK_3_CASES_H
