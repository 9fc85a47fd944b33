// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A certificate: refined points of a sphere are within 8 units of the last place from it. Only the result, an interval, is rounded.
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/reproduction.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1.);
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for (auto v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
  PN::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3).vertex_normal_map(normals));
  const Kernel::Sphere_3 sphere(CGAL::ORIGIN, 1);
  return PN::mesh_deviation(mesh, sphere).distance.sup() <= 0x8p-52 ? 0 : 1;
}
