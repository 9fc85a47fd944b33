// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A mesh of points becomes a surface for a renderer: points on the limit surface, and its normals.
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  const auto np = PN::parameters::surface_normals(true).limit_normal_map(normals);
  PN::subdivide_to_limit(mesh, PN::CatmullClark_scheme(), np.number_of_iterations(3));
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1; // PLY files have the normals
}
