// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A proof that a round of Loop subdivision keeps a sphere, in exact numbers with one square root.
// clang-format off
#include <CGAL/Gmpq.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/sqrt_extension_normals.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
using Kernel = CGAL::Simple_cartesian<CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq, CGAL::Tag_true>>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
int main() {
  Mesh mesh; // four rational points of the sphere: the last number is the denominator of the others
  CGAL::make_tetrahedron(Mesh::Point(2, 2, 1, 3), {-2, -1, 2, 3}, {1, -2, -2, 3}, {-2, 2, -1, 3}, mesh);
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for (auto v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
  const auto np = CGAL::parameters::vertex_normal_map(normals);
  PN::Loop_subdivision(mesh, np);
  const auto d = PN::mesh_deviation(mesh, Kernel::Sphere_3(CGAL::ORIGIN, 1), np);
  return d.number_of_points == 10 && certainly(d.points_are_on_shape) ? 0 : 1; // else d.advice says why
}
