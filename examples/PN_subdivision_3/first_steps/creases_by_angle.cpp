// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Edges at which faces meet at more than 40 degrees stay sharp.
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace PN = CGAL::PN_subdivision_3;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp").first;
  PN::detect_creases(mesh, 40, sharp);
  const auto np = CGAL::parameters::edge_is_constrained_map(sharp);
  auto normals = PN::estimate_control_normals(mesh, np); // of corners, with their roundness
  PN::CatmullClark_subdivision(mesh, np.vertex_normal_map(normals).number_of_iterations(3));
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1;
}
