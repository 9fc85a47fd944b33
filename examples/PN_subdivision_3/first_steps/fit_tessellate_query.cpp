// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A surface through the points of a mesh, its triangles to a tolerance, and its point closest to the origin.
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/Limit_surface_queries.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace PN = CGAL::PN_subdivision_3;

int main(int argc, char** argv)
{
  Mesh mesh, triangles;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  PN::interpolate_limit_points(mesh, PN::CatmullClark_scheme());
  PN::tessellate(mesh, PN::CatmullClark_scheme(), 0.01, triangles);
  const PN::Limit_surface surface(mesh, PN::CatmullClark_scheme());
  std::cout << PN::Limit_surface_queries(surface).closest_point(CGAL::ORIGIN).point << '\n';
  return CGAL::IO::write_polygon_mesh(argv[2], triangles) ? 0 : 1;
}
