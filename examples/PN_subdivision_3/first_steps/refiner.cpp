// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A surface that follows one point: only what depends on it is computed again.
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace PN = CGAL::PN_subdivision_3;

int main(int argc, char** argv)
{
  Mesh control, fine;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], control)) return 1;
  const auto rounds = CGAL::parameters::number_of_iterations(3);
  PN::Surface_refiner refiner(control, PN::CatmullClark_scheme(), rounds);
  refiner.build_mesh(fine);
  refiner.set_point(Mesh::Vertex_index(0), CGAL::ORIGIN);
  refiner.update();
  refiner.update_mesh(fine);
  return CGAL::IO::write_polygon_mesh(argv[2], fine) ? 0 : 1;
}
